#include "analysis/report/claims.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "analysis/report/words.hpp"

namespace ikbench::report {

using namespace fmt::literals;

namespace {

constexpr std::array<Verdict, 7> in_order{Verdict::holds,     Verdict::in_part,  Verdict::depends,     Verdict::fails,
                                          Verdict::undecided, Verdict::untested, Verdict::incomparable};

// "2 hold in part"
std::string counted(Verdict verdict, std::ptrdiff_t count) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 7> words{
      {{"holds", "hold"},
       {"holds in part", "hold in part"},
       {"is undecided", "are undecided"},
       {"fails", "fail"},
       {"depends on the interpretation", "depend on the interpretation"},
       {"is untestable", "are untestable"},
       {"is not comparable", "are not comparable"}}};
  const auto& [one, several] = words[static_cast<std::size_t>(verdict)];
  return fmt::format("{} {}", count, count == 1 ? one : several);
}

// "holds in 61 %, fails in 30 % (of those that fit: 90 %, 4 %)"
std::string answers_in(const ClaimShares& of) {
  const bool is_known = std::isfinite(of.fitting_holds);
  return fmt::format("holds in {}, fails in {}{}", share_words(of.holds), share_words(of.fails),
                     is_known ? fmt::format(" (of those that fit: {}, {})", share_words(of.fitting_holds),
                                            share_words(of.fitting_fails))
                              : "");
}

// Share of the interpretations with that verdict; "holds in part" counts as undecided.
double share_of(Verdict verdict, const ClaimShares& of) {
  return verdict == Verdict::holds ? of.holds : verdict == Verdict::fails ? of.fails : of.undecided;
}

void join(Claim& claim, const ClaimShares& of) {
  if (claim.verdict == Verdict::untested) return;
  claim.evidence.push_back(of.sentence.empty() ? fmt::format(words::over_interpretations, "answers"_a = answers_in(of),
                                                             "undecided"_a = share_words(of.undecided))
                                               : of.sentence);
  if (share_of(claim.verdict, of) >= clear_share) return;
  claim.evidence.front() =
      fmt::format(words::by_default, "verdict"_a = name_of(claim.verdict), "evidence"_a = claim.evidence.front());
  claim.verdict = Verdict::depends;
  claim.depends_on = of.decided_by;
  if (claim.depends_on.empty()) claim.depends_on.emplace_back("what is left open");
  claim.number = answers_in(of);
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  constexpr std::array<std::string_view, 7> names{"holds",   "holds in part",         "undecided",     "fails",
                                                  "depends", "cannot be tested here", "not comparable"};
  return names[static_cast<std::size_t>(verdict)];
}

std::string verdict_words(const Claim& claim) {
  const std::string name(name_of(claim.verdict));
  if (claim.depends_on.empty()) return name;
  return fmt::format("{} on {}{}", name, claim.depends_on.front(), claim.depends_on.size() == 1 ? "" : " etc.");
}

std::string evidence_text(const Claim& claim) { return fmt::format("{}", fmt::join(claim.evidence, " ")); }

Table claims_table(const std::vector<Claim>& claims, std::string name, std::string caption) {
  Table table{.name = std::move(name),
              .caption = std::move(caption),
              .columns = {"claim", "here", "printed", "number", "stated in", "evidence"}};
  for (const Claim& claim : claims) {
    table.rows.push_back({claim.statement, verdict_words(claim),
                          claim.printed ? Cell(std::string(name_of(*claim.printed))) : Cell(), claim.number,
                          claim.section.empty() ? Cell() : Cell(claim.section), evidence_text(claim)});
  }
  return table;
}

Table verdict_table(const std::vector<Claim>& claims) {
  constexpr std::array<std::string_view, 7> names{"holds",   "in part",  "undecided",   "fails",
                                                  "depends", "untested", "incomparable"};
  const auto word = [&](Verdict verdict) { return std::string(names[static_cast<std::size_t>(verdict)]); };
  const auto text = [](const std::string& of) { return of.empty() ? Cell() : Cell(of); };
  Table table{.name = "verdict",
              .caption = "The claims",
              .columns = {"here", "printed", "number", "claim", "id", "by", "section", "depends_on"}};
  for (const Claim& claim : claims) {
    table.rows.push_back({word(claim.verdict), claim.printed ? Cell(word(*claim.printed)) : Cell(), text(claim.number),
                          claim.statement, text(claim.id), claim.by == Claimant::paper ? "paper" : "us",
                          text(claim.section), text(fmt::format("{}", fmt::join(claim.depends_on, ", ")))});
  }
  return table;
}

std::vector<Claim> claims_by(Claimant by, const std::vector<Claim>& claims) {
  std::vector<Claim> result;
  std::ranges::copy_if(claims, std::back_inserter(result), [by](const Claim& claim) { return claim.by == by; });
  return result;
}

std::string tally(const std::vector<Claim>& claims) {
  const std::vector<Claim> all = claims_by(Claimant::paper, claims);
  std::vector<std::string> parts;
  for (const Verdict verdict : in_order) {
    const auto count = std::ranges::count(all, verdict, &Claim::verdict);
    if (count > 0) parts.push_back(counted(verdict, count));
  }
  std::string text = fmt::format("Of {} claim{}", all.size(), all.size() == 1 ? "" : "s");
  for (std::size_t i = 0; i < parts.size(); ++i) {
    text += (i > 0 && i + 1 == parts.size() ? " and " : ", ") + parts[i];
  }
  const auto is_printed = [](const Claim& claim) { return claim.printed.has_value(); };
  if (const auto printed = std::ranges::count_if(all, is_printed); printed > 0) {
    text +=
        fmt::format(". As printed, {} of {} hold", std::ranges::count(all, Verdict::holds, &Claim::printed), printed);
  }
  return text + '.';
}

std::string share_words(double share) {
  if (share > 0 && share < 0.005) return "under 1 %";
  if (share < 1 && share > 0.995) return "over 99 %";
  return fmt::format("{:.0f} %", 100 * share);
}

void join(std::vector<Claim>& claims, std::span<const ClaimShares> shares) {
  for (Claim& claim : claims) {
    const auto of = std::ranges::find(shares, claim.id, &ClaimShares::id);
    if (of != shares.end()) join(claim, *of);
  }
}

}  // namespace ikbench::report
