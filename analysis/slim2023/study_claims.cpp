#include "analysis/slim2023/study_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/design.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/slim2023/claim_comparison.hpp"
#include "analysis/slim2023/published_numbers.hpp"
#include "analysis/statistics/equal_variances.hpp"
#include "analysis/statistics/p_adjust.hpp"

namespace ikbench::slim2023 {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace report;

namespace {

// Whether the study is held against the printed Table 3 and has the claim's solver and another.
bool has_solver(const StudyResults& study, const ClaimEntry& entry) {
  const std::vector<Pair> all = pairs(study, Metric::position_error_cm);
  return all.size() >= 2 && std::ranges::find(all, entry.solver, &Pair::solver) != all.end();
}

}  // namespace

std::optional<Claim> least_at_each_point(const Reported& reported, const ClaimEntry& entry) {
  const StudyResults& study = reported.study;
  if (!has_solver(study, entry)) return std::nullopt;
  std::map<std::string, int> first;  // at so many points
  std::vector<std::vector<double>> means;
  for (const std::string& solver : study.solvers) {
    means.push_back(figures::averages_by_point(study, solver, entry.metrics.front()));
    first[solver] = 0;
  }
  const auto points = static_cast<std::size_t>(study.points);
  for (std::size_t point = 0; point < points; ++point) {
    std::vector<std::string> least;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t s = 0; s < means.size(); ++s) {
      const double mean = point < means[s].size() ? means[s][point] : not_defined;
      if (mean < smallest) least.clear();
      if (mean <= smallest) least.push_back(study.solvers[s]);
      if (mean < smallest) smallest = mean;
    }
    if (least.size() == 1) ++first[least.front()];  // a tie is nobody's
  }
  Claim claim = begun(entry);
  claim.table = "figure-6";
  const int own = first[entry.solver];
  claim.verdict = own == study.points ? Verdict::holds : 2 * own > study.points ? Verdict::in_part : Verdict::fails;
  claim.number = fmt::format("{} of {} points", own, study.points);
  std::vector<std::string> words;
  for (const std::string& solver : study.solvers) {
    if (first[solver] > 0) words.push_back(fmt::format("{} at {}", solver, first[solver]));
  }
  claim.evidence = fmt::format("The smallest error, averaged over the runs: {} of {} points.", listed(words), points);
  return claim;
}

namespace {

// Which of two groups has the smaller spread, by a test whose p-values are corrected for the others.
struct Spread {
  std::string other;
  double own, others, p;
};

Found found_of(std::vector<Spread>& spreads, const AnalysisPlan& plan) {
  std::vector<double> p;
  for (const Spread& spread : spreads) p.push_back(spread.p);
  p = adjusted(p, Correction::holm);
  Found found;
  for (std::size_t i = 0; i < spreads.size(); ++i) {
    spreads[i].p = p[i];
    const bool smaller = spreads[i].own < spreads[i].others;
    found.add(relation_of({.p_better = smaller ? p[i] : 1, .p_worse = smaller ? 1 : p[i]}, plan.significance));
  }
  return found;
}

std::string spread_words(const std::vector<Spread>& spreads, const std::string& solver) {
  std::string list = fmt::format("{} {} cm", solver, short_number(spreads.front().own));
  for (const Spread& spread : spreads) {
    list += fmt::format(", {} {}{}", spread.other, short_number(spread.others), in_brackets(spread.p));
  }
  return list;
}

}  // namespace

std::optional<Claim> least_spread(const Reported& reported, const ClaimEntry& entry) {
  const StudyResults& study = reported.study;
  const Metric metric = entry.metrics.front();
  if (!has_solver(study, entry) || study.plan.unit == Unit::point) return std::nullopt;
  std::map<std::string, std::vector<double>> values;
  for (Sample& sample : samples(study, metric)) values[sample.solver] = std::move(sample.values);
  const std::vector<Pair> all = pairs(study, metric);
  const Pair own = *std::ranges::find(all, entry.solver, &Pair::solver);
  std::vector<Spread> here, printed;
  for (const Pair& other : all) {
    if (other.solver == own.solver) continue;
    const std::array<std::vector<double>, 2> two{values[own.solver], values[other.solver]};
    const std::array<GroupSummary, 2> in_print{own.printed, other.printed};
    here.push_back({other.solver, own.ours.std, other.ours.std, brown_forsythe(two).p});
    printed.push_back({other.solver, own.printed.std, other.printed.std, bartlett_from_summaries(in_print).p});
  }
  Claim claim = begun(entry);
  claim.verdict = verdict_on(found_of(here, study.plan));
  claim.printed = verdict_on(found_of(printed, study.plan));
  const Spread& nearest = std::ranges::min(here, {}, &Spread::others);
  claim.number = fmt::format("{} cm, {} {}", short_number(own.ours.std), nearest.other, short_number(nearest.others));
  claim.evidence = fmt::format(
      "Standard deviation of the run means: {}. Printed: {}. p-values: Brown-Forsythe test of each pair, printed: "
      "Bartlett's; after Holm.",
      spread_words(here, own.solver), spread_words(printed, own.solver));
  return claim;
}

namespace {

// The mean absolute second difference of the joints' angles along each complete run [deg].
std::vector<double> second_differences_deg(const StudyResults& study, const std::string& solver) {
  std::vector<double> means;
  for (const RunShape& shape : study.gathered->shapes) {
    if (study.gathered->labels[shape.solver] == solver && shape.points == study.points)
      means.push_back(shape.mean_bend_deg);
  }
  return means;
}

// The largest move of a joint from one point to the next, averaged over each complete run [deg].
std::vector<double> largest_moves_deg(const StudyResults& study, const std::string& solver) {
  for (const Sample& sample : samples(study, averaged([](const Solve& solve) { return solve.largest_move_deg; }))) {
    if (sample.solver == solver) return sample.values;
  }
  return {};
}

}  // namespace

std::optional<Claim> smoothest(const Reported& reported, const ClaimEntry& entry) {
  const StudyResults& study = reported.study;
  if (!has_solver(study, entry) || study.plan.unit == Unit::point || study.points < 3) return std::nullopt;
  const std::array<std::pair<std::string_view, std::vector<double> (*)(const StudyResults&, const std::string&)>, 2>
      measures{{{"Mean second difference of an angle along the path", second_differences_deg},
                {"Mean of the largest move of a joint", largest_moves_deg}}};
  Claim claim = begun(entry);
  claim.table = "figure-9";
  std::vector<Verdict> verdicts;
  for (const auto& [words, values_of] : measures) {
    Observations observed{.name = "smoothness", .quantity = fmt::format("{} [deg]", words)};
    for (const std::string& solver : study.solvers) observed.groups.push_back({solver, values_of(study, solver)});
    if (std::ranges::any_of(observed.groups, [](const Group& group) { return group.values.empty(); }))
      return std::nullopt;
    const Evidence found = tested(observed, feasible(study.plan, observed));
    const Against ours = against(found, entry.solver);
    verdicts.push_back(verdict_on(ours.found));
    claim.evidence +=
        fmt::format("{}: {} {} deg, {} {}; found smaller than {} of {} others, larger than {}. ", words, entry.solver,
                    short_number(ours.own_mean), ours.nearest, short_number(ours.nearest_mean), ours.found.better,
                    ours.found.all(), ours.found.worse);
    if (claim.number.empty()) {
      claim.number =
          fmt::format("{} deg, {} {}", short_number(ours.own_mean), ours.nearest, short_number(ours.nearest_mean));
    }
  }
  claim.verdict = verdict_on(verdicts);
  claim.evidence += "Figure 9 prints no number.";
  return claim;
}

std::optional<Claim> inside_limits(const Reported& reported, const ClaimEntry& entry) {
  if (!has_solver(reported.study, entry)) return std::nullopt;
  const std::vector<SolverCounts> all = counts(reported.study);
  const SolverCounts& count = *std::ranges::find(all, entry.solver, &SolverCounts::solver);
  Claim claim = begun(entry);
  claim.table = "status";
  claim.verdict = count.outside_limits == 0 ? Verdict::holds : Verdict::fails;
  claim.number = fmt::format("{} of {} outside", count.outside_limits, count.solves);
  claim.evidence = count.outside_limits == 0
                       ? fmt::format("All {} are.", count.solves)
                       : fmt::format("{} of {} are not; the worst joint is outside by {} deg.", count.outside_limits,
                                     count.solves, short_number(count.worst_outside_deg));
  return claim;
}

std::optional<Claim> has_effect(const Reported& reported, const ClaimEntry& entry) {
  const JudgedStudy* const without = companion_of(reported, entry);
  if (without == nullptr || !has_solver(reported.study, entry)) return std::nullopt;
  const std::span<const Solve> others = solves_of(*without, entry.solver);
  std::size_t shared = 0, changed = 0;
  for (const Solve& solve : solves_of(reported.study, entry.solver)) {
    const Solve* const other = solve_at(others, {solve.run, solve.point});
    if (other == nullptr) continue;
    ++shared;
    changed += has_same_answer(solve, *other) ? 0 : 1;
  }
  if (shared == 0) return std::nullopt;
  Claim claim = begun(entry);
  claim.number = fmt::format("{} of {} answers change", changed, shared);
  if (changed == 0) {
    claim.verdict = Verdict::fails;
    claim.evidence = fmt::format(
        "All {} answers are the same to the last bit with f_max = 0: Equations 5, 7 and 13 have no effect, because Eq. 14 "
        "overwrites what Eq. 7 moved.",
        shared);
    return claim;
  }
  const Metric metric = entry.metrics.front();
  std::array<GroupSummary, 2> means;
  for (std::size_t i = 0; i < means.size(); ++i) {
    for (const Sample& sample : samples(i == 0 ? static_cast<const StudyResults&>(reported.study) : *without, metric)) {
      if (sample.solver == entry.solver) means[i] = summarise(sample.values);
    }
  }
  const Judgement found = judge(MeanPair{means[0], means[1], info_of(metric).better}, reported.study.plan);
  Found of;
  of.add(found.relation);
  claim.verdict = verdict_on(of);
  claim.evidence = fmt::format("{} of {} answers change without it. {}: {} {} with, {} without{}.", changed, shared,
                               inference::capitalised(info_of(metric).name), short_number(means[0].mean),
                               info_of(metric).unit, short_number(means[1].mean), in_brackets(found.p));
  return claim;
}

std::optional<Claim> singularities(const Reported& reported, const ClaimEntry& entry) {
  constexpr std::array<std::pair<std::size_t, std::string_view>, 2> joints{
      {{3, "a stretched elbow"}, {5, "an aligned wrist"}}};
  if (!has_solver(reported.study, entry)) return std::nullopt;
  Claim claim = begun(entry);
  claim.verdict = Verdict::untested;
  claim.table = "";
  claim.evidence = entry.decides;
  const SolverFacts& of = gathered_of(reported.study, entry.solver);
  if (of.joints.size() != 7) return claim;
  for (const auto& [joint, words] : joints) {
    const auto& [answers, near, nearest_deg] = of.joints[joint];
    claim.evidence += fmt::format(" {} of {} answers are within {} deg of {} (the nearest: {} deg).", near, answers,
                                  Straight::near_deg, words, short_number(nearest_deg));
  }
  return claim;
}

}  // namespace ikbench::slim2023
