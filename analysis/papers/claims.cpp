#include "analysis/papers/claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "analysis/papers/rules.hpp"
#include "analysis/show/text.hpp"

namespace ikbench::papers {

using namespace compare;

namespace {

constexpr std::array<std::string_view, 6> verdicts{"holds",       "holds in part",  "fails",
                                                   "not decided", "not comparable", "not tested"};

std::vector<JudgedClaim> grouped(const std::vector<JudgedClaim>& claims, bool are_ours) {
  std::vector<JudgedClaim> group;
  std::ranges::copy_if(claims, std::back_inserter(group),
                       [=](const JudgedClaim& claim) { return claim.is_ours == are_ours; });
  std::ranges::stable_sort(group, {}, &JudgedClaim::holds);
  return group;
}

show::Table claims_table(const std::vector<JudgedClaim>& claims, std::string name, std::string caption) {
  show::Table table{.name = std::move(name),
                    .caption = std::move(caption),
                    .columns = {{"verdict"}, {"claim"}, {"where"}, {"number"}, {"printed"}, {"all readings"}, {"why"}}};
  const auto cell = [](std::string text) { return text.empty() ? show::Cell() : show::Cell(std::move(text)); };
  for (const JudgedClaim& claim : claims) {
    table.rows.push_back({std::string(name_of(claim.holds)), claim.sentence, cell(claim.section), cell(claim.number),
                          cell(claim.printed ? std::string(name_of(*claim.printed)) : ""), cell(shares_words(claim)),
                          cell(claim.evidence)});
  }
  return table;
}

}  // namespace

std::string_view name_of(Holds holds) { return verdicts[static_cast<std::size_t>(holds)]; }

void Shares::operator+=(const Shares& more) {
  holds += more.holds;
  fails += more.fails;
  undecided += more.undecided;
}

std::vector<JudgedClaim> judged_claims(const Repeated& of, const std::vector<SharesOfClaim>& shares) {
  const StudyResults& study = of.study.study;
  std::vector<JudgedClaim> all;
  for (const Claim& claim : of.paper.claims) {
    const Rule* const rule = rule_named(claim.rule);
    Found found = rule ? rule->judge({claim, of}) : Found();
    const bool is_of_many = claim.sentence.find('{') != std::string::npos;
    if (found.empty() && !claim.is_ours && !is_of_many && is_of_means(of.paper, study)) {
      found.push_back(begun(claim));
      found.back().evidence = claim.decides;
    }
    for (JudgedClaim& judged : found) {
      if (!claim.note.empty()) judged.evidence += ' ' + claim.note;
      if (const auto own = std::ranges::find(shares, judged.id, &SharesOfClaim::id); own != shares.end())
        judged.shares = *own;
      all.push_back(std::move(judged));
    }
  }
  // What another study could test is no fault of the paper.
  if (!study.definition.departures.empty() || !study.definition.missing_solvers.empty())
    std::erase_if(all, [](const JudgedClaim& claim) { return claim.holds == Holds::not_tested; });
  return all;
}

const JudgedClaim* claim_named(const std::vector<JudgedClaim>& claims, std::string_view id) {
  const auto found = std::ranges::find(claims, id, &JudgedClaim::id);
  return found == claims.end() ? nullptr : &*found;
}

std::string percent(double share) {
  if (share > 0 && share < 0.005) return "< 1 %";
  if (share < 1 && share > 0.995) return "> 99 %";
  return fmt::format("{:.0f} %", 100 * share);
}

std::string shares_words(const JudgedClaim& claim) {
  if (!claim.shares || claim.shares->all.all() == 0) return "";
  const auto words = [](const Shares& of) {
    return fmt::format("holds in {}, fails in {}", percent(of.holds / of.all()), percent(of.fails / of.all()));
  };
  const Shares& near = claim.shares->near;
  return words(claim.shares->all) +
         (near.all() > 0 ? fmt::format(" (of those that fit the print: {})", words(near)) : "");
}

show::Blocks claims_section(const std::vector<JudgedClaim>& claims) {
  show::Blocks blocks;
  for (const bool are_ours : {false, true}) {
    const std::vector<JudgedClaim> group = grouped(claims, are_ours);
    if (group.empty()) continue;
    blocks.emplace_back(show::Heading{are_ours ? "Our own questions" : "The claims"});
    blocks.emplace_back(are_ours ? claims_table(group, "questions", "Questions that the paper does not answer")
                                 : claims_table(group, "claims", "What the paper claims, and what is found here"));
  }
  return blocks;
}

std::string screen(const std::vector<std::string>& sentences, const show::Table& table,
                   const std::vector<JudgedClaim>& claims, const std::vector<std::string>& rest) {
  std::string text;
  for (const std::string& sentence : sentences) text += sentence + '\n';
  if (!table.rows.empty()) text += '\n' + show::to_text(table);
  for (const bool are_ours : {false, true}) {
    std::vector<std::vector<std::string>> rows;
    std::optional<Holds> last;
    for (const JudgedClaim& claim : grouped(claims, are_ours)) {
      if (last != claim.holds)
        rows.push_back({fmt::format("{}{}", are_ours ? "our questions, " : "", name_of(claim.holds))});
      last = claim.holds;
      const std::string shares =
          claim.shares ? fmt::format("all readings: {}", percent(claim.shares->all.holds / claim.shares->all.all()))
                       : "";
      rows.push_back({"  " + show::shortened(claim.sentence, 56), claim.number, shares});
    }
    if (!rows.empty()) text += '\n' + show::aligned(rows);
  }
  if (!rest.empty()) text += '\n';
  for (const std::string& line : rest) text += show::one_line(line) + '\n';
  return text;
}

}  // namespace ikbench::papers
