#include "analysis/papers/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "analysis/judge/statistics/omnibus.hpp"
#include "analysis/papers/repeated.hpp"
#include "analysis/show/text.hpp"
#include "base/names.hpp"

namespace ikbench::papers {

using namespace judge;
using show::number_text;

namespace {

using Names = std::vector<std::string>;

bool has(const Names& names, std::string_view name) { return std::ranges::find(names, name) != names.end(); }

// Returns the study that the claim is about; null if the study was not repeated.
const JudgedStudy* part_of(const Claim& claim, const Repeated& repeated) {
  return claim.study.empty() ? &repeated.study() : repeated.part(claim.study);
}

// Returns the name of a rival among the claim's solvers. A rival that has the name of one of them is named with its
// study.
std::string name_of_rival(const std::string& name, const Claim& claim) {
  return has(claim.solvers, name) ? fmt::format("{} of {}", name, claim.study) : name;
}
bool is_rival(const std::string& name, const Claim& claim) {
  if (claim.against.empty()) return !has(claim.solvers, name);
  return std::ranges::any_of(
      claim.against, [&](const std::string& rival) { return name == rival || name == name_of_rival(rival, claim); });
}

// Judges a metric by itself. The family of a claim is the pairs of its metric, because the claim says nothing about
// further metrics of the plan.
JudgedMetric judged_in(const JudgedStudy& study, const Metric& metric) {
  return judge::judge(make_samples(study.study, metric), study.study.definition.plan);
}

// Returns the metric with only the claim's solvers and their rivals. Empty if one of these solvers or all rivals are
// missing, or if a group has no values.
std::optional<JudgedMetric> about(const Claim& claim, JudgedMetric judged) {
  std::vector<Group>& groups = judged.samples.groups;
  for (std::size_t i = groups.size(); i-- > 0;) {
    if (has(claim.solvers, groups[i].name) || is_rival(groups[i].name, claim)) continue;
    groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(i));
    judged.descriptives.erase(judged.descriptives.begin() + static_cast<std::ptrdiff_t>(i));
  }
  const auto is_there = [&](const std::string& name) { return std::ranges::count(groups, name, &Group::name) > 0; };
  const bool has_own = std::ranges::all_of(claim.solvers, is_there) && groups.size() > claim.solvers.size();
  const bool has_all =
      std::ranges::all_of(judged.descriptives, [](const Descriptives& descriptives) { return descriptives.n > 0; });
  return has_own && has_all ? std::optional(std::move(judged)) : std::nullopt;
}

// Returns a metric of the claim's solvers and their rivals, each from its study; empty as `about` says.
std::optional<JudgedMetric> judged_here(const Claim& claim, const Repeated& repeated, const Metric& metric) {
  const JudgedStudy* const part = part_of(claim, repeated);
  if (part == nullptr) return {};
  const JudgedStudy* const own = claim.from == From::others ? &repeated.study() : part;
  const JudgedStudy* const others = claim.from == From::solvers ? &repeated.study() : part;
  JudgedMetric judged = judged_in(*own, metric);
  if (own != others) {  // no report compares solvers of two studies
    MetricSamples& all = judged.samples;
    std::erase_if(all.groups, [&](const Group& group) { return !has(claim.solvers, group.name); });
    MetricSamples theirs = judged_in(*others, metric).samples;
    for (Group& group : theirs.groups) {
      if (!is_rival(group.name, claim)) continue;
      group.name = name_of_rival(group.name, claim);
      all.groups.push_back(std::move(group));
    }
    all.is_paired = false;
    for (Group& group : all.groups)
      if (auto* const measured = std::get_if<Sample>(&group.sample)) measured->blocks.clear();
    judged = judge::judge(std::move(all), judged.plan);
  }
  if (claim.of == Of::means) return about(claim, std::move(judged));
  JudgedMetric spread = judge::judge(deviations(judged.samples), judged.plan);
  for (std::size_t i = 0; i < spread.descriptives.size(); ++i) spread.descriptives[i].mean = judged.descriptives[i].sd;
  return about(claim, std::move(spread));
}

double mean_of(const JudgedMetric& judged, std::string_view solver) {
  return judged.descriptives[index_of(judged.samples, solver)].mean;
}

// Returns the mean as text: "at most 1e-06" if the mean is within the tolerance, which ends solves.
std::string mean_words(const JudgedMetric& judged, const std::string& solver) {
  const Group& group = judged.samples.groups[index_of(judged.samples, solver)];
  const double mean = mean_of(judged, solver);
  if (missing_in(group) > 0) return "not known";
  return (group.tolerance > 0 && mean <= group.tolerance ? "at most " : "") + number_text(mean);
}

// Returns the solvers that are not `own`, in the order of their means, the smallest first.
Names rivals_of(const JudgedMetric& judged, const Names& own) {
  Names rivals;
  for (const Group& group : judged.samples.groups)
    if (!has(own, group.name)) rivals.push_back(group.name);
  std::ranges::stable_sort(rivals, {}, [&](const std::string& name) { return mean_of(judged, name); });
  return rivals;
}

// Returns the rivals of another study that give the same answers as the claim's solver, bit for bit.
Names same_there(const Claim& claim, const Repeated& repeated) {
  Names same;
  const JudgedStudy* const part = part_of(claim, repeated);
  if (claim.from != From::others || part == nullptr) return same;
  const std::span<const SolveSummary> ours = repeated.study().study.of(claim.solvers.front());
  for (const std::string& rival : part->study.labels)
    if (is_rival(rival, claim) && are_identical(ours, part->study.of(rival))) same.push_back(rival);
  return same;
}

Verdict verdict_of_difference(const Interval& difference) {
  if (difference.low > 0) return Verdict::better;
  return difference.high < 0 ? Verdict::worse : Verdict::inconclusive;
}

// Judges the claim that a solver solves a larger share than the best rival on each arm. The interval of the difference
// decides, because programs were asked for other poses.
JudgedClaims solves_most(const Claim& claim, const Repeated& repeated) {
  JudgedClaim result{claim};
  Tally tally;
  const std::vector<RateColumn> columns = rates_of(repeated);
  const auto own = std::ranges::find(columns, claim.solvers.front(), &RateColumn::name);
  for (const Rate& rate : own == columns.end() ? std::vector<Rate>() : own->rates) {
    const Rate* best = nullptr;
    for (const RateColumn& column : columns)
      for (const Rate& each : column.rates)
        if (has(claim.against, column.name) && each.row == rate.row && (!best || best->ours < each.ours)) best = &each;
    if (best == nullptr) continue;
    const Interval difference =
        newcombe_interval({.share = rate.ours / 100, .n = rate.n}, {.share = best->ours / 100, .n = best->n},
                          repeated.study().study.definition.plan.significance);
    tally.add(verdict_of_difference(difference));
  }
  if (tally.all() == 0) return {};
  result.holds = holds_of(tally);
  if (tally.better + tally.worse > 0) result.number = fmt::format("on {} of {} arms", tally.better, tally.all());
  return {result};
}

JudgedClaims better(const Claim& claim, const Repeated& repeated) {
  const Names& own = claim.solvers;
  JudgedClaim result{claim};
  std::vector<Holds> here;
  const Names same = same_there(claim, repeated);
  for (const Metric* metric : claim.metrics) {
    const std::optional<JudgedMetric> ours = judged_here(claim, repeated, *metric);
    if (!ours) return {};
    Names rivals = rivals_of(*ours, own), means;
    for (const std::string& rival : same) std::erase(rivals, name_of_rival(rival, claim));
    here.insert(here.end(), same.size(), Holds::fails);
    Tally tally;
    for (const std::string& solver : own)
      for (const std::string& rival : rivals) tally.add(verdict_between(*ours, solver, rival));
    if (!rivals.empty()) here.push_back(holds_of(tally));
    if (!result.number.empty()) continue;
    for (const std::string& solver : own) means.push_back(mean_words(*ours, solver));
    const std::string& unit = ours->samples.unit;
    result.number = (claim.of == Of::spread ? "sd " : "") + show::listed(means) + (unit.empty() ? "" : ' ' + unit);
    if (rivals.empty()) continue;
    result.rival = fmt::format("{} {}", rivals[0], mean_words(*ours, rivals[0]));
    result.number += ", " + result.rival;
  }
  result.holds = holds_of(here);
  if (!same.empty())
    result.evidence = fmt::format("There every answer of {} is the same, bit for bit.", show::listed(same));
  return {result};
}

// Returns the verdict over all metrics: better if a solver is worse in no metric and better in one or more.
Verdict verdict_of_metrics(const Tally& metrics) {
  if (metrics.worse > 0) return Verdict::worse;
  if (metrics.better > 0) return Verdict::better;
  return metrics.untested == metrics.all() ? Verdict::not_tested : Verdict::inconclusive;
}

JudgedClaims ahead(const Claim& claim, const Repeated& repeated) {
  const std::string& solver = claim.solvers.front();
  std::vector<JudgedMetric> here;
  for (const Metric* metric : claim.metrics) {
    std::optional<JudgedMetric> ours = judged_here(claim, repeated, *metric);
    if (!ours) return {};
    here.push_back(std::move(*ours));
  }
  Tally tally;
  for (const std::string& rival : rivals_of(here.front(), {solver})) {
    Tally of_metrics;
    for (const JudgedMetric& judged : here) of_metrics.add(verdict_between(judged, solver, rival));
    tally.add(verdict_of_metrics(of_metrics));
  }
  JudgedClaim result{claim};
  result.holds = holds_of(tally);
  result.number = fmt::format("beats {} of {}", tally.better, base::counted(tally.all(), "solvers"));
  return {result};
}

JudgedClaims differ(const Claim& claim, const Repeated& repeated) {
  std::vector<Holds> here;
  const double significance = repeated.study().study.definition.plan.significance;
  for (const Metric* metric : claim.metrics) {
    const std::optional<JudgedMetric> ours = judged_here(claim, repeated, *metric);
    if (!ours) return {};
    const auto all = anova(ours->samples);
    if (all.empty())
      here.push_back(Holds::not_tested);
    else
      here.push_back(all[0].p < significance ? Holds::holds : Holds::inconclusive);
  }
  JudgedClaim result{claim};
  result.holds = holds_of(here);
  result.number = fmt::format("{} of {} differ", std::ranges::count(here, Holds::holds), here.size());
  return {result};
}

// Judges the claim that all errors are rounding: at most ten times the spacing of doubles at the farthest target.
JudgedClaims at_rounding(const Claim& claim, const Repeated& repeated) {
  const JudgedStudy* const judged = part_of(claim, repeated);
  const std::string& solver = claim.solvers.front();
  if (judged == nullptr || judged->study.of(solver).empty()) return {};
  JudgedClaim result{claim};
  double farthest_cm = 0;
  for (const results::SolveRecord& solve : judged->study.first_run_of(solver)) {
    const std::vector<double>& at = solve.target_position_m;
    farthest_cm = std::max(farthest_cm, 100 * std::hypot(at[0], at[1], at[2]));
  }
  std::vector<double> errors;
  for (const SolveSummary& solve : judged->study.of(solver)) errors.push_back(solve.position_error_cm);
  const double most = 10 * std::numeric_limits<double>::epsilon() * farthest_cm;
  const double largest = *std::ranges::max_element(errors), mean = summarise(errors).mean;
  if (largest <= most)
    result.holds = Holds::holds;
  else
    result.holds = mean <= most ? Holds::in_part : Holds::fails;
  result.number = fmt::format("mean {} cm", number_text(mean));
  result.evidence = fmt::format("The largest is {} cm; ten times the spacing of doubles is {} cm there.",
                                number_text(largest), number_text(most));
  return {result};
}

Holds repeats_printed(const Rate& rate) {
  if (rate.sign() == "x") return Holds::fails;
  return rate.sign() == "~" ? Holds::holds : Holds::inconclusive;
}

// Returns a claim per solver, over all arms, or per printed column: the numbers are as printed.
JudgedClaims as_printed(const Claim& claim, const Repeated& repeated) {
  JudgedClaims judged;
  const bool is_of_arms = repeated.paper.rates.is_of_arms();
  for (const auto& [name, rates] : rates_of(repeated)) {
    if (rates.empty()) continue;
    std::vector<Holds> repeats;
    repeats.reserve(rates.size());
    for (const Rate& rate : rates) repeats.push_back(repeats_printed(rate));
    JudgedClaim& result = judged.emplace_back(JudgedClaim{claim});
    result.id = fmt::format("{}-{}", claim.id, name);
    result.sentence = fmt::format(fmt::runtime(claim.sentence), fmt::arg("solver", name));
    result.holds = holds_of(repeats);
    if (std::ranges::count(repeats, Holds::inconclusive) < std::ssize(repeats))
      result.number =
          fmt::format("{} {} of {} {}", is_of_arms ? "on" : "for", std::ranges::count(repeats, Holds::holds),
                      repeats.size(), is_of_arms ? "arms" : "solvers");
  }
  return judged;
}

// The printed column is that of the program in `against`, otherwise that of the claim's program.
JudgedClaims as_counted(const Claim& claim, const Repeated& repeated) {
  const std::string& program = claim.solvers.front();
  const std::vector<CountedArm> arms =
      counted_arms(repeated, program, claim.against.empty() ? program : claim.against.front());
  if (arms.empty()) return {};
  JudgedClaim result{claim};
  std::vector<Holds> here;
  Names unanswered;
  for (const CountedArm& arm : arms) {
    here.push_back(arm.is_as_printed() ? Holds::holds : Holds::fails);
    if (arm.unanswered > 0) unanswered.push_back(fmt::format("{} of {} on {}", arm.unanswered, arm.poses, arm.arm));
  }
  result.holds = holds_of(here);
  result.number = fmt::format("{} of {} arms", std::ranges::count(here, Holds::holds), here.size());
  if (!unanswered.empty())
    result.evidence = fmt::format("Poses without an answer, left out: {}.", show::listed(unanswered));
  return {result};
}

constexpr Rule all_rules[]{{"better", better},
                           {"ahead", ahead},
                           {"differ", differ},
                           {"at_rounding", at_rounding, false},
                           {"as_printed", as_printed, false},
                           {"solves_most", solves_most, false},
                           {"as_counted", as_counted, false}};

}  // namespace

std::string_view name_of(Holds holds) {
  constexpr std::array<std::string_view, 5> names{"holds", "holds in part", "fails", "inconclusive", "not tested"};
  return names[static_cast<std::size_t>(holds)];
}

std::string interpretations_text(std::int64_t interpretations, std::int64_t seeds) {
  const std::string text = base::counted(interpretations, "interpretations");
  return seeds == 1 ? text : fmt::format("{} with {} seeds each ({})", text, seeds, interpretations * seeds);
}

std::span<const Rule> rules() { return all_rules; }

void Tally::add(Verdict verdict) {
  switch (verdict) {
    case Verdict::better:
      ++better;
      break;
    case Verdict::worse:
      ++worse;
      break;
    case Verdict::not_tested:
      ++untested;
      break;
    case Verdict::equivalent:
    case Verdict::inconclusive:
      ++open;
      break;
  }
}

Holds holds_of(const Tally& tally) {
  if (tally.worse > 0) return Holds::fails;
  if (tally.better > 0 && tally.better == tally.all()) return Holds::holds;
  return tally.better + tally.open > 0 ? Holds::inconclusive : Holds::not_tested;
}

Holds holds_of(const std::vector<Holds>& parts) {
  const auto has_any = [&](Holds part) { return std::ranges::find(parts, part) != parts.end(); };
  const auto all_are = [&](Holds part) { return std::ranges::count(parts, part) == std::ssize(parts); };
  if (has_any(Holds::in_part) || (has_any(Holds::holds) && has_any(Holds::fails))) return Holds::in_part;
  return all_are(parts.front()) ? parts.front() : Holds::inconclusive;
}

MetricSamples deviations(MetricSamples samples) {
  for (Group& group : samples.groups) {
    const double median = describe(group).median;
    if (auto* const measured = std::get_if<Sample>(&group.sample))
      for (double& value : measured->values) value = std::abs(value - median);
  }
  return samples;
}

Verdict verdict_between(const JudgedMetric& judged, std::string_view first, std::string_view second) {
  const Comparison* const comparison = find_comparison(judged, first, second);
  if (comparison == nullptr) return Verdict::not_tested;
  return comparison->first == first ? verdict_of(*comparison) : reversed(verdict_of(*comparison));
}

}  // namespace ikbench::papers
