#include "analysis/inference/design.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

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

// A foreign store may be wrong.
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

std::vector<Block> layout(const StudyResults& study, Blocks blocks) {
  const std::vector<int> runs = common_runs(study);
  std::vector<Block> result;
  if (blocks == Blocks::path_targets && !runs.empty()) {
    for (int point = 1; point <= study.points; ++point) {
      Block block{.name = fmt::format("point {}", point), .places = {}};
      for (const int run : runs) block.places.emplace_back(run, point);
      result.push_back(std::move(block));
    }
  } else if (blocks == Blocks::runs) {
    for (const int run : runs) {
      Block block{.name = fmt::format("run {}", run), .places = {}};
      for (int point = 1; point <= study.points; ++point) block.places.emplace_back(run, point);
      result.push_back(std::move(block));
    }
  } else if (blocks == Blocks::drawn_targets) {
    for (const int run : runs) {
      for (int point = 1; point <= study.points; ++point) {
        result.push_back({.name = fmt::format("run {}, point {}", run, point), .places = {{run, point}}});
      }
    }
  }
  return result;
}

namespace {

// `average`: the average of several solves: "mean", "geometric mean", "share".
std::string replicate_of(const StudyResults& study, Unit unit, std::string_view average) {
  if (unit == Unit::point) return "one point of a run";
  return study.points == 1 ? "the only solve of a run"
                           : fmt::format("the {} of a run over its {} points", average, study.points);
}

std::string replicate_of(const StudyResults& study, Blocks blocks, std::string_view average) {
  if (blocks == Blocks::runs) return replicate_of(study, Unit::run, average);
  if (blocks == Blocks::drawn_targets) return "the only solve of a target";
  const std::size_t runs = common_runs(study).size();
  return runs == 1 ? "the only solve of a target" : fmt::format("the {} of a target over {} runs", average, runs);
}

std::string block_of(Blocks blocks) {
  if (blocks == Blocks::runs) return "a run with its own random targets, the same for all solvers";
  if (blocks == Blocks::drawn_targets) return "a random target, the same for all solvers";
  return "a target of the path, which all solvers start from the same configuration";
}

Observations without_groups(const Quantity& quantity) {
  return {.name = quantity.name,
          .quantity = quantity.text,
          .unit = quantity.unit,
          .better = quantity.better,
          .scale = quantity.scale,
          .counting = quantity.notes};
}

void fill_blocks(Observations& result, const StudyResults& study, const std::vector<Block>& blocks,
                 const Quantity& quantity) {
  for (const Block& block : blocks) result.blocks.push_back(block.name);
  for (const std::string& solver : study.solvers) {
    const std::span<const Solve> solves = solves_of(study, solver);
    Group group{.name = solver, .place = place_of(study, solver)};
    for (const Block& block : blocks) {
      std::vector<const Solve*> run;
      for (const Place& place : block.places) run.push_back(solve_at(solves, place));
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
  if (estimand != Estimand::mean) {
    for (Group& group : result.groups) group.decades = 0;
    return;
  }
  const ValueOf counted = counted_value(study, metric);
  for (Group& group : result.groups) {
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
  for (std::size_t i = 0; i < result.groups.size(); ++i) {
    Group& group = result.groups[i];
    for (std::size_t other = 0; other < i && group.bits == 0; ++other) {
      Group& earlier = result.groups[other];
      if (std::ranges::equal(earlier.values, group.values, is_same_value) &&
          have_same_bits(study, metric, earlier.name, group.name)) {
        group.bits = earlier.bits = other + 1;
      }
    }
  }
}

void add_notes(Observations& result, const StudyResults& study, Metric metric) {
  std::ranges::move(notes_of_not_finite(result.groups), std::back_inserter(result.notes));
  if (info_of(metric).kind != Kind::time) return;
  if (Doubts doubts = timing_doubts(study); !doubts.empty()) result.flaws = std::move(doubts);
}

// A note on solvers that repeat themselves; empty if none does.
std::string copies_note(const std::vector<Sample>& samples) {
  std::vector<std::string> names;
  for (const Sample& sample : samples) {
    if (sample.equal_runs > 0) names.push_back(fmt::format("{} ({} runs)", one_line(sample.solver), sample.equal_runs));
  }
  if (names.empty()) return "";
  return fmt::format(
      "Equal runs are one observation: {} gave the same answers in every run, to the last bit. So the value on these "
      "targets is known without chance: two such values are compared without a test, and the runs of another solver by "
      "the sign test. To say something of other targets, give every run targets of its own (path.kind = \"random\"), or "
      "start every solve from the same configuration (start = \"initial\"), so that a target is an observation.",
      fmt::join(names, ", "));
}

// Finds imports that lack a run which the other solvers share: blocks of all solvers would lose that run.
std::set<std::string_view> partial_imports(const StudyResults& study) {
  const auto is_other = [&](std::string_view solver) { return !is_imported(study, solver); };
  const auto number = std::ranges::count_if(study.solvers, is_other);
  std::set<std::string_view> found;
  if (number < 2 || number == std::ssize(study.solvers)) return found;
  const auto runs = common_runs(of_solvers(study, is_other));
  for (const std::string& solver : study.solvers) {
    const auto is_this = [&](std::string_view name) { return name == solver; };
    if (is_imported(study, solver) && !std::ranges::includes(common_runs(of_solvers(study, is_this)), runs))
      found.insert(solver);
  }
  return found;
}

}  // namespace

Doubts why_not_blocked(const StudyResults& study) {
  if (const std::set<std::string_view> partial = partial_imports(study); !partial.empty())
    return why_not_blocked(of_solvers(study, [&](std::string_view solver) { return !partial.contains(solver); }));
  const Blocks blocks = blocks_of(study);
  if (blocks == Blocks::none) {
    return {{study.facts.path.empty() ? DoubtKind::no_path_for_blocks : DoubtKind::chained_solves}};
  }
  if (!were_given_the_same(study, blocks)) return {{DoubtKind::other_targets}};
  const std::size_t count = layout(study, blocks).size();
  if (count > 1) return {};
  return {{count == 0 ? DoubtKind::no_common_run : DoubtKind::single_block}};
}

std::optional<Observations> blocked_observations(const StudyResults& study, Metric metric, Estimand estimand) {
  if (const std::set<std::string_view> partial = partial_imports(study); !partial.empty()) {
    const auto is_kept = [&](std::string_view solver) { return !partial.contains(solver); };
    std::optional<Observations> result = blocked_observations(of_solvers(study, is_kept), metric, estimand);
    if (result) {
      result->notes.push_back(fmt::format(
          "Left out: {}, imported without runs that the others have. ikbench compare compares two solvers over the runs "
          "that both have.",
          one_line(fmt::format("{}", fmt::join(partial, ", ")))));
    }
    return result;
  }
  if (!why_not_blocked(study).empty()) return std::nullopt;
  const Blocks blocks = blocks_of(study);
  const Quantity quantity = quantity_of(study, metric, estimand);
  Observations result = without_groups(quantity);
  result.replicate = replicate_of(study, blocks, quantity.average);
  result.block = block_of(blocks);
  result.block_noun = blocks == Blocks::runs ? "runs" : "targets";
  fill_blocks(result, study, layout(study, blocks), quantity);
  add_decades(result, study, metric, estimand);
  add_bits(result, study, metric);
  add_notes(result, study, metric);
  return result;
}

Observations observations(const StudyResults& study, Metric metric, Estimand estimand) {
  if (const Doubts without = left_out(study, metric); is_comparable(study, metric) && !without.empty()) {
    Observations result = observations(compared_in(study, metric), metric, estimand);
    result.notes.push_back(words_of(without));
    return result;
  }
  const Unit unit = study.plan.unit;
  if (unit == Unit::run) {
    if (std::optional<Observations> blocked = blocked_observations(study, metric, estimand)) return std::move(*blocked);
  }
  const Quantity quantity = quantity_of(study, metric, estimand);
  Observations result = without_groups(quantity);
  result.replicate = replicate_of(study, unit, quantity.average);
  if (unit == Unit::point) result.flaws = {{DoubtKind::points_as_observations}};
  if (unit == Unit::run) result.notes.push_back(words_of(why_not_blocked(study)));
  std::vector<Sample> all = samples(study, quantity.value);
  result.notes.push_back(copies_note(all));
  for (Sample& sample : all) {
    if (sample.incomplete_runs > 0) {
      result.notes.push_back(fmt::format("{}: {} of its runs lack points and give no observation.", sample.solver,
                                         sample.incomplete_runs));
    }
    const int copies = sample.values.size() == 1 ? sample.equal_runs : 0;
    const std::size_t place = place_of(study, sample.solver);
    result.groups.push_back(
        {.name = std::move(sample.solver), .values = std::move(sample.values), .copies = copies, .place = place});
  }
  std::erase(result.notes, "");
  add_decades(result, study, metric, estimand);
  add_bits(result, study, metric);
  add_notes(result, study, metric);
  return result;
}

Observations observations(const StudyResults& study, Metric metric) {
  return observations(study, metric, average_estimand(metric));
}

}  // namespace ikbench::inference
