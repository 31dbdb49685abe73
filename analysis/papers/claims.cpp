#include "analysis/papers/claims.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "analysis/show/text.hpp"
#include "base/names.hpp"

namespace ikbench::papers {

using namespace judge;

namespace {

bool holds_only_by_default(const JudgedClaim& claim) {
  return claim.holds == Holds::holds && claim.in_readings.fail > claim.in_readings.hold;
}

std::vector<JudgedClaim> grouped(std::vector<JudgedClaim> claims, bool are_ours) {
  std::erase_if(claims, [=](const JudgedClaim& claim) { return claim.is_ours != are_ours; });
  std::ranges::stable_sort(
      claims, {}, [](const JudgedClaim& claim) { return std::pair(claim.holds, holds_only_by_default(claim)); });
  return claims;
}

bool is_counted(const JudgedClaim& claim) { return claim.in_readings.all() > 0; }

// Returns the word for a verdict. A claim that holds in the default interpretation, but fails in more interpretations
// than it holds in, only holds by default.
std::string verdict_text(const JudgedClaim& claim) {
  const std::string name(name_of(claim.holds));
  return holds_only_by_default(claim) ? name + " by default" : name;
}

show::Tone tone_of(const JudgedClaim& claim) {
  if (holds_only_by_default(claim)) return show::Tone::neutral;
  if (claim.holds == Holds::holds) return show::Tone::good;
  return claim.holds == Holds::fails ? show::Tone::bad : show::Tone::neutral;
}

std::string remark_text(const JudgedClaim& claim) {
  if (claim.section.empty()) return claim.evidence;
  return claim.section + (claim.evidence.empty() ? "." : ". ") + claim.evidence;
}

show::Table claims_table(const std::vector<JudgedClaim>& claims, bool are_ours) {
  show::Table table{.name = are_ours ? "questions" : "claims",
                    .caption = are_ours ? "What the paper does not say" : "What the paper says",
                    .columns = show::named_columns({"verdict", "claim", "ours", "interpretations", "remark"}),
                    .is_of_study = false};
  table.columns.back().role = show::ColumnRole::machine_only;
  const auto in_readings = [&](const InReadings& of) {
    if (of.all() > 0) return fmt::format("{} hold, {} fail, {} inconclusive", of.hold, of.fail, of.open);
    return std::string(std::ranges::any_of(claims, is_counted) ? "not counted" : "");
  };
  for (const JudgedClaim& claim : claims) {
    table.rows.push_back({show::VerdictCell{verdict_text(claim), tone_of(claim)}, claim.sentence,
                          show::text_cell(claim.number), in_readings(claim.in_readings), remark_text(claim)});
  }
  return table;
}

}  // namespace

std::vector<JudgedClaim> judged_claims(const Repeated& repeated, const std::map<std::string, InReadings>& in_readings) {
  std::vector<JudgedClaim> all;
  for (const Claim& claim : repeated.paper.claims) {
    JudgedClaims parts = claim.rule ? claim.rule->verdict(claim, repeated) : JudgedClaims();
    if (parts.empty() && !claim.is_ours) parts.push_back({claim, Holds::not_tested, "", "", claim.decides});
    for (JudgedClaim& judged : parts) {
      if (!claim.note.empty()) judged.evidence.insert(0, claim.note + (judged.evidence.empty() ? "" : " "));
      if (const auto counts = in_readings.find(judged.id); counts != in_readings.end())
        judged.in_readings = counts->second;
      all.push_back(std::move(judged));
    }
  }
  return all;
}

const JudgedClaim* claim_named(const std::vector<JudgedClaim>& claims, std::string_view id) {
  const auto found = std::ranges::find(claims, id, &JudgedClaim::id);
  return found == claims.end() ? nullptr : &*found;
}

show::Blocks beginning(const Paper& paper, const std::vector<std::string>& sentences, const show::Table& table) {
  show::Blocks blocks{show::Heading{sentences.front()}};
  for (std::size_t i = 1; i < sentences.size(); ++i) blocks.emplace_back(sentences[i]);
  blocks.emplace_back(table);
  blocks.emplace_back(fmt::format("{} Not reproduced: {}.", paper.citation, paper.not_repeated));
  return blocks;
}

show::Blocks claims_section(const std::vector<JudgedClaim>& claims) {
  show::Blocks blocks;
  for (const bool are_ours : {false, true}) {
    const std::vector<JudgedClaim> group = grouped(claims, are_ours);
    if (group.empty()) continue;
    blocks.emplace_back(show::Heading{are_ours ? "Our own questions" : "The claims"});
    blocks.emplace_back(claims_table(group, are_ours));
  }
  return blocks;
}

std::string screen(const std::vector<std::string>& sentences, const show::Table& table,
                   const std::vector<JudgedClaim>& claims) {
  std::string text, last;  // the verdict that was written last
  const auto add = [&](const std::string& words, const std::string& first = "") {
    const std::string indent(std::max<std::size_t>(2, first.size()), ' ');
    text += show::wrapped_paragraph(words, indent, first);
  };
  for (const std::string& sentence : sentences) add(sentence);
  text += fmt::format("\n{}\n{}\n", table.caption, show::to_text(table));
  std::vector<std::vector<std::string>> rows;
  if (const auto one = std::ranges::find_if(claims, is_counted); one != claims.end())
    add(fmt::format("Claims; in brackets: hold / fail / inconclusive in {}",
                    interpretations_text(one->in_readings.all() / one->in_readings.seeds, one->in_readings.seeds)));
  rows.push_back({fmt::format("{:16}", "verdict"), "claim", "ours"});
  std::vector<std::string> not_tested;  // sentences
  for (const JudgedClaim& claim : grouped(claims, false)) {
    if (claim.holds == Holds::not_tested) {
      not_tested.push_back(claim.sentence);
      continue;
    }
    const std::string verdict = verdict_text(claim);
    const bool is_new = std::exchange(last, verdict) != verdict;
    const InReadings& of = claim.in_readings;
    rows.push_back({is_new ? verdict : "", claim.sentence,
                    claim.number + (of.all() == 0 ? "" : fmt::format(" ({}/{}/{})", of.hold, of.fail, of.open))});
  }
  text += show::align_columns(rows, 2);
  if (!not_tested.empty())
    add(fmt::format("{}", fmt::join(not_tested, "; ")), fmt::format("{:18}", name_of(Holds::not_tested)));
  return text;
}

}  // namespace ikbench::papers
