#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "analysis/compare/observations.hpp"
#include "numerics/names.hpp"

namespace ikbench::compare {

namespace {

std::string names_of(const std::vector<std::string>& who) {
  constexpr std::size_t most = 4;
  if (who.size() > most)
    return fmt::format("{} and {} more", fmt::join(who.begin(), who.begin() + 3, ", "), who.size() - 3);
  return fmt::format("{}", fmt::join(who, ", "));
}

}  // namespace

std::string words_of(const Doubt& doubt) {
  const std::string who = names_of(doubt.who), &what = doubt.what;
  const std::string of_whom = who.empty() ? "" : fmt::format(" ({})", who);
  const std::string share = fmt::format("{:.0f} of {:.0f}", doubt.count, doubt.of);
  const std::string in_solves = doubt.of > 0 ? fmt::format(" in {} solves", share) : "";
  switch (doubt.kind) {
    case DoubtKind::runs_missing:
      return fmt::format("{} {}{}", share, what.empty() ? "runs missing or without some targets" : what, of_whom);
    case DoubtKind::incomplete:
      return fmt::format("{} {}: no verdict on {}; write inf for no answer, or drop them", share, what, who);
    case DoubtKind::without_answer:
      return what.empty() ? fmt::format("{} solves gave no answer{}", share, of_whom)
                          : fmt::format("no answer in {} {}{}", share, what, of_whom);
    case DoubtKind::claimed_but_wrong:
      return fmt::format("{} solves claimed an error that is wrong, and do not count as solved ({})", share, who);
    case DoubtKind::outside_limits:
      return fmt::format("{} answers outside the joint limits ({})", share, who);
    case DoubtKind::budgets_differ:
    case DoubtKind::counted_otherwise:
      return fmt::format("{} ({})", what, who);
    case DoubtKind::times_not_comparable:
      return fmt::format("times{} are not compared: {}{}", who.empty() ? "" : " of " + who, what, in_solves);
    case DoubtKind::seconds_decide:
      return fmt::format("results of {} are not compared, since seconds end solves: {}{}", who, what, in_solves);
    case DoubtKind::out_of_reach:
      return fmt::format("{} targets of a run out of reach, so no solver can solve them", share);
    case DoubtKind::few_decide_mean:
      return fmt::format("few values decide the mean {} of {}: nothing is called better by it", what, who);
    case DoubtKind::plan_changed:
      return fmt::format("the plan was changed after {} solves were made{}: {}", share, of_whom, what);
    case DoubtKind::repeats_itself:
      return fmt::format("{} gave the same {} {:.0f} {}, {}", who, what.empty() ? "answers in all" : what, doubt.count,
                         what.empty() ? "runs" : "times",
                         doubt.of > 0 ? "or its spread was rounded away: not tested" : "which count as one");
    case DoubtKind::other_version:
      return fmt::format("ignored: {} of another version ({})", numerics::counted(std::llround(doubt.count), "solves"),
                         who);
  }
  return {};
}

}  // namespace ikbench::compare
