#include "analysis/inference/variant_design.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <stdexcept>
#include <string_view>

#include "analysis/inference/estimand.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

// Of the complete runs.
std::vector<Observed> observed(const StudyResults& study, Blocks blocks) {
  std::vector<Observed> result;
  for (Block& block : layout(study, blocks)) {
    Observed one{.name = std::move(block.name), .solves = {}};
    for (const Place& place : block.places) one.solves.push_back(solve_at(study.solves, place));
    result.push_back(std::move(one));
  }
  return result;
}

std::string place_of(std::span<const double> metres) {
  std::vector<std::string> texts;
  for (const double value : metres) texts.push_back(fmt::format("{:.4g}", 100 * value));
  return fmt::format("{} cm", fmt::join(texts, " "));
}

// first: of a run that starts each solve where the one before ended, only the first start is given.
enum class Starts { first, all };

// In what two runs were not given the same to do; empty where they were.
struct Given {
  const StudyResults& study;
  const Observed& run;
};
std::string difference_in_task(const Given& a, const Given& b, Starts starts) {
  const std::string &robot = a.study.gathered->robot, &other_robot = b.study.gathered->robot;
  if (robot != other_robot) return fmt::format("different robots ({} and {})", robot, other_robot);
  for (std::size_t i = 0; i < a.run.solves.size(); ++i) {
    const Solve &one = *a.run.solves[i], &other = *b.run.solves[i];
    const Problem asked = problem_of(a.study, one), asked_other = problem_of(b.study, other);
    if (!same_target(asked, asked_other)) {
      return fmt::format("different targets (run {} and {}, point {}: {} and {})", one.run, other.run, one.point,
                         place_of(asked.target_position_m), place_of(asked_other.target_position_m));
    }
    if ((i == 0 || starts == Starts::all) && !same_start(asked, asked_other)) {
      return fmt::format("different start configurations (run {} and {}, point {})", one.run, other.run, one.point);
    }
  }
  return "";
}

// Both in the order that they have.
void keep_common(std::vector<Observed>& a, std::vector<Observed>& b) {
  const auto names = [](const std::vector<Observed>& observed) {
    std::set<std::string> result;
    for (const Observed& one : observed) result.insert(one.name);
    return result;
  };
  const auto in_a = names(a), in_b = names(b);
  std::erase_if(a, [&](const Observed& one) { return !in_b.contains(one.name); });
  std::erase_if(b, [&](const Observed& one) { return !in_a.contains(one.name); });
}

std::invalid_argument refused(std::string_view what) {
  return std::invalid_argument(
      fmt::format("cannot compare A and B: they have {}; run both with the same robot, path and seed", what));
}

Starts starts_of(const Variant& a, const Variant& b) {
  const auto is_chained = [](const Variant& side) {
    const Blocks blocks = blocks_of(side.study);
    return blocks == Blocks::none || blocks == Blocks::runs;
  };
  return is_chained(a) && is_chained(b) ? Starts::first : Starts::all;
}

// As the study has it, but a store may be old, or say what is not so: where the runs have targets of their own, runs
// are pairs at least. A single target is no sample; its runs are.
Blocks pairs_of(const Variant& a, bool is_fixed) {
  const Blocks said = blocks_of(a.study);
  if (!is_fixed) return said == Blocks::drawn_targets ? said : Blocks::runs;
  return said == Blocks::path_targets && a.study.points == 1 ? Blocks::none : said;
}

bool is_fixed(const StudyResults& study, const std::vector<Observed>& runs, Starts starts) {
  return std::ranges::all_of(runs, [&](const Observed& run) {
    return difference_in_task({study, runs.front()}, {study, run}, starts).empty();
  });
}

void refuse_other_tasks(const Given& a, const Given& b, Starts starts) {
  if (const std::string what = difference_in_task(a, b, starts); !what.empty()) throw refused(what);
}

std::string observation_of(const VariantDesign& design, int points) {
  if (design.pairs == Blocks::path_targets && (design.runs_of_a > 1 || design.runs_of_b > 1)) {
    const std::string runs = design.runs_of_a == design.runs_of_b
                                 ? fmt::format("the {} runs of each", design.runs_of_a)
                                 : fmt::format("the {} runs of A and the {} of B", design.runs_of_a, design.runs_of_b);
    return fmt::format("one observation is the mean (of times the median) of a target over {}", runs);
  }
  if (design.pairs == Blocks::path_targets || design.pairs == Blocks::drawn_targets) {
    return "one observation is the only solve of a target";
  }
  return points == 1
             ? "one observation is the only solve of a run"
             : fmt::format("one observation is the mean (of times the median) of a run over its {} points", points);
}

}  // namespace

VariantDesign variant_design(const Variant& a, const Variant& b) {
  std::vector<Observed> runs_of_a = observed(a.study, Blocks::runs), runs_of_b = observed(b.study, Blocks::runs);
  for (const Variant* side : {&a, &b}) {
    if (!(side == &a ? runs_of_a : runs_of_b).empty()) continue;
    throw std::invalid_argument(fmt::format("{} has no complete run of {}, so there is nothing to compare",
                                            side == &a ? "A" : "B", side->series.label));
  }
  if (a.study.points != b.study.points) {
    throw refused(fmt::format("different targets ({} and {} points per run)", a.study.points, b.study.points));
  }
  const Starts starts = starts_of(a, b);
  const bool is_one_path = is_fixed(a.study, runs_of_a, starts) && is_fixed(b.study, runs_of_b, starts);
  VariantDesign design{.pairs = pairs_of(a, is_one_path)};
  if (is_one_path) refuse_other_tasks({a.study, runs_of_a.front()}, {b.study, runs_of_b.front()}, starts);
  if (design.pairs == Blocks::runs || design.pairs == Blocks::drawn_targets) {
    keep_common(runs_of_a, runs_of_b);
    if (runs_of_a.empty()) throw refused("different targets (every run has its own, and they have no run in common)");
    for (std::size_t i = 0; i < runs_of_a.size(); ++i)
      refuse_other_tasks({a.study, runs_of_a[i]}, {b.study, runs_of_b[i]}, starts);
  }
  design.runs_of_a = static_cast<int>(runs_of_a.size());
  design.runs_of_b = static_cast<int>(runs_of_b.size());
  if (design.pairs == Blocks::none || design.pairs == Blocks::runs) {
    design.a = std::move(runs_of_a);
    design.b = std::move(runs_of_b);
  } else {
    design.a = observed(a.study, design.pairs);
    design.b = observed(b.study, design.pairs);
    keep_common(design.a, design.b);
  }
  return design;
}

std::string sentence_of(const VariantDesign& design, int points) {
  const std::string observation = observation_of(design, points);
  const std::size_t pairs = design.a.size();
  switch (design.pairs) {
    case Blocks::runs:
      return fmt::format("{} pairs of runs, {}: every run has its own targets, the same for A and B.", pairs,
                         observation);
    case Blocks::drawn_targets:
      return fmt::format(
          "{} pairs of targets, {}: every run has its own targets, the same for A and B, each solved from the same "
          "configuration.",
          pairs, observation);
    case Blocks::path_targets:
      return fmt::format("{} pairs of targets, {}: A and B solve each target of the path from the same configuration.",
                         pairs, observation);
    case Blocks::none:
      break;
  }
  return fmt::format(
      "Independent runs, {} of A and {} of B, {}: all runs have the same targets, so runs of A and B do not form "
      "pairs.",
      design.a.size(), design.b.size(), observation);
}

std::vector<double> values_of(const StudyResults& study, const std::vector<Observed>& observed, Metric metric,
                              double limit) {
  std::vector<double> result;
  const ValueOf counted = counted_value(study, metric, limit);
  for (const Observed& one : observed) {
    if (is_of_run(metric)) {
      const bool counts = !is_penalised(study, metric) ||
                          std::ranges::find(one.solves, results::Status::ok, &Solve::status) != one.solves.end();
      result.push_back(counts ? value_of(study, one.solves, metric) : statistics::not_defined);
      continue;
    }
    std::vector<double> values;
    for (const Solve* solve : one.solves) values.push_back(counted(*solve));
    result.push_back(average_of(metric)(values));
  }
  return result;
}

bool has_same_bits(const StudyResults& of_a, const StudyResults& of_b, const VariantDesign& design, Metric metric) {
  const auto is_same_value = [](double one, double other) {
    return std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other) ||
           (std::isnan(one) && std::isnan(other));
  };
  const auto is_same = [&](const Solve* a, const Solve* b) {
    return is_same_value(value_of(of_a, *a, metric), value_of(of_b, *b, metric));
  };
  return std::ranges::equal(design.a, design.b, [&](const Observed& a, const Observed& b) {
    return a.name == b.name &&
           (is_of_run(metric) ? is_same_value(value_of(of_a, a.solves, metric), value_of(of_b, b.solves, metric))
                              : std::ranges::equal(a.solves, b.solves, is_same));
  });
}

}  // namespace ikbench::inference
