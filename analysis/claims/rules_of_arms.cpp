#include "analysis/claims/rules_of_arms.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>

#include "analysis/inference/text.hpp"

namespace ikbench::claims {

using namespace inference;
using namespace report;

namespace {

bool is_solved_here(const Rate& rate) { return rate.ours.undefined.empty(); }

// All rates of one arm belong to one number of iterations, which is not printed. So a rate depends on that number only
// if it can be the other's, too.
bool shares_iterations(const Rate& one, const Rate& other) {
  return one.first > 0 && (other.first == 0 || (one.first <= other.last && other.first <= one.last));
}

Claim rate_claim(const Case& of, const RatesOfArm& arm, const Rate& rate) {
  const auto others = [&](const Rate& other) { return is_solved_here(other) && other.solver != rate.solver; };
  const auto other = std::ranges::find_if(arm.rates, others);
  const bool has_other = other != arm.rates.end(), holds = rate.is_as_printed();
  const bool depends = !holds && rate.first > 0 && (!has_other || shares_iterations(rate, *other));
  const auto [estimate, low, high, undefined] = rate.ours;
  Claim claim = of.begun();
  claim.id = fmt::format("{}-{}-{}", of.entry.id, rate.solver, arm.arm);
  claim.statement =
      filled(of.entry.sentence,
             {{"solver", rate.solver}, {"arm", arm.arm}, {"share", fmt::format("{:.2f} %", 100 * rate.printed)}});
  claim.verdict = holds ? Verdict::holds : depends ? Verdict::depends : Verdict::fails;
  claim.number = fmt::format("{:.1f} against {:.2f} %", 100 * estimate, 100 * rate.printed);
  claim.evidence = {fmt::format("Here {:.1f} % are solved in {} iterations ({} interval {:.1f} to {:.1f} %).",
                                100 * estimate, arm.iterations, percent(of.file.rates.level), 100 * low, 100 * high)};
  if (holds) return claim;
  if (rate.first > 0) {
    claim.evidence.push_back(fmt::format(
        "It is the printed share within {} to {} iterations{}", rate.first, rate.last,
        depends ? ". " + of.entry.note
                : fmt::format(", but the other rate on this arm takes {} to {}.", other->first, other->last)));
  }
  const auto reason = of.entry.reasons.find(fmt::format("{} on the {}", rate.solver, arm.arm));
  if (reason != of.entry.reasons.end()) claim.evidence.push_back(reason->second);
  return claim;
}

}  // namespace

std::vector<Claim> rate_as_printed(const Case& of) {
  std::vector<Claim> claims;
  for (const RatesOfArm& arm : solve_rates(of.reported, of.file.rates)) {
    for (const Rate& rate : arm.rates) {
      if (is_solved_here(rate)) claims.push_back(rate_claim(of, arm, rate));
    }
  }
  return claims;
}

namespace {

// The compared solver that solves most; null if none is solved here.
const Rate* best_rival(const RatesOfArm& arm, const ClaimEntry& entry) {
  const Rate* best = nullptr;
  for (const Rate& rate : arm.rates) {
    const bool is_rival = entry.against.empty() ? rate.solver != entry.solver : rate.solver == entry.against;
    if (!is_rival || !is_solved_here(rate)) continue;
    if (best == nullptr || rate.ours.estimate > best->ours.estimate) best = &rate;
  }
  return best;
}

// The verdict of the printed table on all of its arms, also those without solves here.
Verdict printed_more(const Case& of) {
  const RatesPlan& plan = of.file.rates;
  const results::CsvTable table = printed_table(plan.paper, plan.table);
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const double own = table.number(row, plan.columns.at(of.entry.solver));
    for (const auto& [solver, column] : plan.columns) {
      const bool is_rival = of.entry.against.empty() ? solver != of.entry.solver : solver == of.entry.against;
      if (is_rival && !(own > table.number(row, column))) return Verdict::fails;
    }
  }
  return Verdict::holds;
}

}  // namespace

std::vector<Claim> solves_more(const Case& of) {
  const std::string& solver = of.entry.solver;
  Claim claim = of.begun();
  claim.printed = printed_more(of);
  std::vector<std::string> more, open, fewer;
  const std::vector<RatesOfArm> arms = solve_rates(of.reported, of.file.rates);
  for (const RatesOfArm& arm : arms) {
    const auto own = std::ranges::find(arm.rates, solver, &Rate::solver);
    const Rate* const rival = best_rival(arm, of.entry);
    if (rival == nullptr || own == arm.rates.end() || !is_solved_here(*own)) continue;
    const Relation relation = judge(arm.study->evidence(Metric::solved), solver, rival->solver).relation;
    auto& list = relation == Relation::better ? more : relation == Relation::worse ? fewer : open;
    list.push_back(fmt::format("{} ({} to {})", arm.arm, percent(rival->ours.estimate), percent(own->ours.estimate)));
  }
  if (more.empty() && open.empty() && fewer.empty()) {
    claim.verdict = Verdict::untested;
    claim.evidence = {fmt::format("{} is not among the solvers.", solver)};
    return {claim};
  }
  claim.verdict = !fewer.empty() ? Verdict::fails : !open.empty() ? Verdict::undecided : Verdict::holds;
  claim.number = fmt::format("on {} of {} arms", more.size(), arms.size());
  for (const auto& [words, list] :
       {std::pair("More are solved", more), std::pair("Not decided", open), std::pair("Fewer are solved", fewer)}) {
    if (!list.empty()) claim.evidence.push_back(fmt::format("{}: {}.", words, fmt::join(list, ", ")));
  }
  return {claim};
}

}  // namespace ikbench::claims
