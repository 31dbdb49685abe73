#include "analysis/inference/design.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/estimand.hpp"
#include "analysis/inference/not_finite.hpp"
#include "analysis/inference/study_facts.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/statistics/quantile.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

// Runs that are complete for every solver.
std::vector<int> common_runs(const StudyResults& study) {
  std::vector<std::int64_t> counts(static_cast<std::size_t>(study.runs) + 1);
  for (const Solve& solve : study.solves) ++counts[static_cast<std::size_t>(solve.run)];
  const std::int64_t all = std::int64_t{study.points} * static_cast<std::int64_t>(study.solvers.size());
  std::vector<int> runs;
  for (int run = 1; run <= study.runs; ++run) {
    if (counts[static_cast<std::size_t>(run)] == all) runs.push_back(run);
  }
  return runs;
}

// Returns whether the solvers had the same targets and, unless a run is a block, the same starts. A foreign store may
// be wrong.
bool were_given_the_same(const StudyResults& study, Blocks blocks) {
  const std::vector<const Solve*> places = places_of(study);
  return std::ranges::all_of(study.solvers, [&](const std::string& solver) {
    auto first = places.begin();
    return std::ranges::all_of(solves_of(study, solver), [&](const Solve& solve) {
      while ((*first)->run != solve.run || (*first)->point != solve.point) ++first;
      const Problem asked = problem_of(study, solve), other = problem_of(study, **first);
      return same_target(asked, other) && (blocks == Blocks::runs || same_start(asked, other));
    });
  });
}

}  // namespace

Blocks blocks_of(const StudyResults& study) {
  const bool starts_anew = study.facts.starts_anew();
  if (study.facts.draws_targets) return starts_anew ? Blocks::drawn_targets : Blocks::runs;
  if (study.facts.path.empty()) return Blocks::none;
  return starts_anew || study.points == 1 ? Blocks::path_targets : Blocks::none;
}

const Solve* solve_at(std::span<const Solve> solves, const Place& place) {
  const auto place_in = [](const Solve& solve) { return Place(solve.run, solve.point); };
  const auto found = std::ranges::lower_bound(solves, place, {}, place_in);
  return found == solves.end() || place_in(*found) != place ? nullptr : &*found;
}

namespace {

// The places whose solves make one value, by block of the runs that are complete for all solvers. A block is a place
// with 0 for all runs or all points. None for Blocks::none.
std::map<Place, std::vector<Place>> layout(const StudyResults& study, Blocks blocks) {
  std::map<Place, std::vector<Place>> result;
  if (blocks == Blocks::none) return result;
  for (const int run : common_runs(study)) {
    for (int point = 1; point <= study.points; ++point) {
      const int of_run = blocks == Blocks::path_targets ? 0 : run, of_point = blocks == Blocks::runs ? 0 : point;
      result[{of_run, of_point}].emplace_back(run, point);
    }
  }
  return result;
}

std::string block_name(const Place& block) {
  const auto& [run, point] = block;
  if (run == 0) return fmt::format("point {}", point);
  return point == 0 ? fmt::format("run {}", run) : fmt::format("run {}, point {}", run, point);
}

// One observation in words. `average`: the average of several solves: "mean", "geometric mean", "share".
std::string replicate_of(const StudyResults& study, Blocks blocks, std::string_view average) {
  if (blocks == Blocks::drawn_targets) return "the only solve of a target";
  if (blocks == Blocks::path_targets) {
    const std::size_t runs = common_runs(study).size();
    return runs == 1 ? "the only solve of a target" : fmt::format("the {} of a target over {} runs", average, runs);
  }
  return study.points == 1 ? "the only solve of a run"
                           : fmt::format("the {} of a run over its {} points", average, study.points);
}

std::string block_of(Blocks blocks) {
  if (blocks == Blocks::runs) return "a run with its own random targets, the same for all solvers";
  if (blocks == Blocks::drawn_targets) return "a random target, the same for all solvers";
  return "a target of the path, which all solvers start from the same configuration";
}

void fill_blocks(Observations& result, const StudyResults& study, Blocks kind, const Quantity& quantity) {
  const std::map<Place, std::vector<Place>> blocks = layout(study, kind);
  result.block = block_of(kind);
  result.block_noun = kind == Blocks::runs ? "runs" : "targets";
  for (const auto& [block, places] : blocks) result.blocks.push_back(block_name(block));
  for (const std::string& solver : study.solvers) {
    const std::span<const Solve> solves = solves_of(study, solver);
    Group group{.name = solver, .style = style_of(study, solver)};
    for (const auto& [block, places] : blocks) {
      std::vector<const Solve*> run;
      for (const Place& place : places) run.push_back(solve_at(solves, place));
      group.values.push_back(quantity.value(run));
    }
    result.groups.push_back(std::move(group));
  }
  const std::size_t runs = common_runs(study).size();
  if (const auto all = static_cast<std::size_t>(study.runs); runs < all) {
    result.notes.push_back(
        fmt::format("Left out: {} of {} runs, because they are not complete for all solvers.", all - runs, all));
  }
}

// Only single solves show if the worst cases decide a mean.
void add_decades(Observations& result, const StudyResults& study, Metric metric, Estimand estimand) {
  if (is_of_run(metric)) return;
  const ValueOf counted = counted_value(study, metric);
  for (Group& group : result.groups) {
    group.decades = 0;
    if (estimand != Estimand::mean) continue;
    std::vector<double> values;
    for (const Solve& solve : solves_of(study, group.name)) {
      const double value = counted(solve), least = info_of(metric).rounding;
      values.push_back(value < least ? least : value);
    }
    group.decades = decades(values);
  }
}

bool is_same_value(double one, double other) {
  return std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other) ||
         (std::isnan(one) && std::isnan(other));
}

// Returns whether every solve has the same value in both, and some solve has a number. Shares need equal errors too:
// different solves may all succeed.
bool have_same_bits(const StudyResults& study, Metric metric, const std::string& first, const std::string& second) {
  const std::span<const Solve> one = solves_of(study, first), other = solves_of(study, second);
  const auto value = [&](const Solve& solve) { return value_of(study, solve, metric); };
  const auto is_same = [&](const Solve& a, const Solve& b) {
    return a.run == b.run && a.point == b.point && is_same_value(value(a), value(b));
  };
  return std::ranges::equal(one, other, is_same) &&
         std::ranges::any_of(one, [&](const Solve& solve) { return std::isfinite(value(solve)); }) &&
         (info_of(metric).kind != Kind::share || have_same_bits(study, Metric::position_error_cm, first, second));
}

// Finds the groups with the same bits. Where tolerances differ, equal solves are not judged alike.
void add_bits(Observations& result, const StudyResults& study, Metric metric) {
  if (is_of_run(metric)) return;
  mark_same_bits(result.groups, [&](const Group& one, const Group& other) {
    return std::ranges::equal(one.values, other.values, is_same_value) &&
           have_same_bits(study, metric, one.name, other.name);
  });
}

// Takes a solver's runs or points. Tells of solvers that repeat themselves or lack points.
void fill_samples(Observations& result, const StudyResults& study, const Quantity& quantity) {
  std::vector<std::string> repeating, incomplete;
  for (const Sample& sample : samples(study, quantity.value)) {
    const std::string name = one_line(sample.solver);
    if (sample.equal_runs > 0) repeating.push_back(fmt::format("{} ({} runs)", name, sample.equal_runs));
    if (sample.incomplete_runs > 0) {
      incomplete.push_back(
          fmt::format("{}: {} of its runs lack points and give no observation.", name, sample.incomplete_runs));
    }
    result.groups.push_back({.name = sample.solver,
                             .values = sample.values,
                             .copies = sample.values.size() == 1 ? sample.equal_runs : 0,
                             .style = style_of(study, sample.solver)});
  }
  if (!repeating.empty()) {
    result.notes.push_back(fmt::format(
        "Equal runs are one observation: {} gave the same answers in every run, to the last bit. So the value on these "
        "targets is known without chance: two such values are compared without a test, and the runs of another solver "
        "by the sign test. To say something of other targets, give every run targets of its own (path.kind = "
        "\"random\"), or start every solve from the same configuration (start = \"initial\"), so that a target is an "
        "observation.",
        fmt::join(repeating, ", ")));
  }
  std::ranges::move(incomplete, std::back_inserter(result.notes));
}

}  // namespace

Doubts why_not_blocked(const StudyResults& study) {
  const Blocks blocks = blocks_of(study);
  if (blocks == Blocks::none) {
    return {{study.facts.path.empty() ? DoubtKind::no_path_for_blocks : DoubtKind::chained_solves}};
  }
  if (!were_given_the_same(study, blocks)) return {{DoubtKind::other_targets}};
  const std::size_t count = layout(study, blocks).size();
  if (count > 1) return {};
  return {{count == 0 ? DoubtKind::no_common_run : DoubtKind::single_block}};
}

namespace {

// `unblocked` says why there are no blocks; empty where there are.
Observations made(const StudyResults& study, Metric metric, Estimand estimand, Blocks blocks, const Doubts& unblocked) {
  const bool are_runs = study.plan.unit == Unit::run;
  const Quantity quantity = quantity_of(study, metric, estimand);
  Observations result = quantity.described;
  result.replicate = are_runs ? replicate_of(study, blocks, quantity.average) : "one point of a run";
  if (blocks != Blocks::none) {
    fill_blocks(result, study, blocks, quantity);
  } else {
    if (!are_runs) result.flaws = {{DoubtKind::points_as_observations}};
    if (are_runs && !unblocked.empty()) result.notes.push_back(words_of(unblocked));
    fill_samples(result, study, quantity);
  }
  add_decades(result, study, metric, estimand);
  add_bits(result, study, metric);
  std::ranges::move(notes_of_not_finite(result.groups), std::back_inserter(result.notes));
  if (info_of(metric).kind == Kind::time) {
    if (Doubts doubts = timing_doubts(study); !doubts.empty()) result.flaws = std::move(doubts);
  }
  return result;
}

}  // namespace

Observations observations(const StudyResults& study, Metric metric, Estimand estimand) {
  if (const Doubts without = left_out(study, metric); is_comparable(study, metric) && !without.empty()) {
    Observations result = observations(compared_in(study, metric), metric, estimand);
    result.notes.push_back(words_of(without));
    return result;
  }
  const bool are_runs = study.plan.unit == Unit::run;
  const Doubts unblocked = why_not_blocked(study);
  return made(study, metric, estimand, are_runs && unblocked.empty() ? blocks_of(study) : Blocks::none, unblocked);
}

Observations observations(const StudyResults& study, Metric metric) {
  return observations(study, metric, average_estimand(metric));
}

}  // namespace ikbench::inference
