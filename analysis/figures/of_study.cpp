#include "analysis/figures/of_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "analysis/figures/map.hpp"
#include "analysis/judge/statistics/omnibus.hpp"
#include "analysis/judge/statistics/pair_data.hpp"
#include "base/names.hpp"
#include "base/units.hpp"

namespace ikbench::figures {

using namespace judge;
using namespace base;
using results::SolveRecord;

namespace {

constexpr std::string_view error = "position_error_cm", motion = "variation_deg", time = "seconds";

// Returns whether the targets of a study have an order.
bool is_path(const StudyResults& study) {
  return !study.definition.draws_targets && study.definition.points > 1 && !study.definition.is_grid();
}

std::string observation_of(const StudyResults& study, const Metric& metric) {
  const results::StudyDefinition& definition = study.definition;
  const std::string_view average = uses_medians(metric) ? "median" : "mean";
  if (definition.compares_runs()) return definition.points == 1 ? "one run" : fmt::format("the {} of one run", average);
  const bool is_solved_again = definition.runs > 1 && !definition.draws_targets;
  return is_solved_again ? fmt::format("one target, as the {} of its runs", average) : "one target";
}

std::string caption_of_boxes(std::string_view quantity, std::string_view observation) {
  return fmt::format(
      "Distribution of {}. Each dot is {}; boxes show quartiles and median, whiskers the smallest and largest value.",
      quantity, observation);
}

// Makes a figure of boxes; nullopt if solvers solved different targets, so that their values cannot be compared.
std::optional<Figure> boxes_of(const JudgedStudy& judged, std::string_view column, const Look& look) {
  const JudgedMetric* const values = find_metric(judged, column);
  if (values == nullptr || is_conditional_on_success(values->samples)) return std::nullopt;
  const Metric& metric = metric_named(column);
  const About about =
      about_of(judged.study, metric, caption_of_boxes(metric.name, observation_of(judged.study, metric)));
  return boxes(about, box_rows(is_time_metric(metric) ? make_samples_by_target(judged.study, metric) : values->samples,
                               drawn_unit(judged.study, metric.unit), drawn_solvers(judged.study, look), look));
}

// Returns the solvers whose values of a metric, or its cost per success, are not compared. Returns all solvers if no
// values are compared. A solver that solved nothing counts as compared.
std::vector<std::string> not_compared(const JudgedStudy& judged, std::string_view column) {
  const auto metric = std::ranges::find_if(judged.metrics, [&](const JudgedMetric& each) {
    return each.samples.quantity_kind == metric_named(column).quantity_kind && !is_proportion(each.samples);
  });
  if (metric == judged.metrics.end()) return judged.study.labels;
  const auto has_warning = [&](const Group& group) {  // a group with several reasons has only the first
    return std::ranges::any_of(metric->samples.warnings, [&](const Warning& warning) {
      return warning.kind != WarningKind::dominated_by_few &&
             (warning.solvers.empty() || std::ranges::count(warning.solvers, group.name) > 0);
    });
  };
  std::vector<std::string> without;
  for (const Group& group : metric->samples.groups) {
    const auto* const sample = excluded(group);
    const bool is_missing = sample && sample->reason != ExclusionReason::nothing_solved && sample->values.empty();
    if (is_missing || has_warning(group)) without.push_back(group.name);
  }
  return without;
}

// The parts of a figure that shows which share of attempts succeeded within a cost.
struct ShareFigure {
  About about;
  std::string y_axis;
  std::vector<std::string> not_compared = {};  // solvers to leave out
  double dashed = nowhere;                     // a cost that matters; NaN: none
};

// Makes a figure of shares; nullopt if fewer than two solvers are left. `cost` returns NaN for an attempt that failed.
std::optional<Figure> shares_of(const StudyResults& study, ShareFigure figure, const Look& look, auto cost) {
  std::vector<std::string> solvers = drawn_solvers(study, look, true), left_out;
  for (const std::string& solver : figure.not_compared)
    if (std::erase(solvers, solver) > 0) left_out.push_back(look.names.at(solver));
  if (!left_out.empty() && solvers.size() < 2) return std::nullopt;  // nothing to compare with
  if (!left_out.empty())
    figure.about.caption +=
        fmt::format(" Left out: {}, whose {} cannot be compared.", names_of(left_out), figure.about.quantity);
  std::vector<Successes> rows;
  for (const std::string& solver : solvers) {
    Successes& row = rows.emplace_back(Successes{.label = look.names.at(solver), .style = look.lines.at(solver)});
    for (const SolveSummary& solve : study.of(solver)) {
      ++row.attempts;
      if (const double value = cost(solve); !std::isnan(value)) row.costs.push_back(value);
    }
  }
  return shares(figure.about, figure.y_axis, rows, figure.dashed);
}

std::optional<Figure> solved_by(const JudgedStudy& judged, std::string_view column, std::string_view cost,
                                const Look& look) {
  const StudyResults& study = judged.study;
  const Metric& metric = metric_named(column);
  const double factor = drawn_unit(study, metric.unit).factor;
  const auto cost_of = [&](const SolveSummary& solve) {
    const bool is_solved = study.definition.has_tolerance() && solve.status == results::Status::ok;
    return is_solved ? factor * std::max(metric.value(solve, study), metric.floor) : nowhere;
  };
  return shares_of(study,
                   {.about = about_of(study, metric, fmt::format("Share of targets solved within {}.", cost)),
                    .y_axis = "targets solved",
                    .not_compared = not_compared(judged, column)},
                   look, cost_of);
}

std::pair<Average, std::string_view> average_that_decides(const StudyResults& study) {
  const bool are_means = study.definition.plan.test == results::AnalysisPlan::Test::means;
  return are_means ? std::pair(Average::mean, "mean") : std::pair(Average::median, "median");
}

std::optional<Figure> by_point_of(const JudgedStudy& judged, std::string_view column, const Look& look) {
  if (!is_path(judged.study)) return std::nullopt;
  const auto [average, name] = average_that_decides(judged.study);
  const Metric& metric = metric_named(column);
  const std::string caption =
      fmt::format("{} {} at each point of the path.", name == "mean" ? "Mean" : "Median", metric.name);
  return curves(about_of(judged.study, metric, caption), {.title = "point"},
                by_point(judged.study, column, look, average));
}

// Makes a figure of times; nullopt unless the times of all solvers are compared.
std::optional<Figure> if_timed(decltype(boxes_of)* of, const JudgedStudy& judged, const Look& look) {
  return not_compared(judged, time).empty() ? of(judged, time, look) : std::nullopt;
}

std::string first_points(const StudyResults& study) {
  return study.definition.points > max_plotted ? fmt::format(" Only the first {} points are drawn.", max_plotted) : "";
}

std::optional<Figure> error_shares(const JudgedStudy& judged, const Look& look) {
  const StudyResults& study = judged.study;
  const Metric& metric = metric_named(error);
  const auto [unit, factor] = drawn_unit(study, metric.unit);
  const double tolerance = factor * study.definition.stop.tolerance_cm();
  if (tolerance <= factor * metric.floor) return std::nullopt;  // errors below the floor have no line
  const About about =
      about_of(study, metric,
               fmt::format("Share of targets within a position error{}, up to 1000 times the tolerance (dashed).",
                           study.definition.has_direction() ? ", whatever the orientation" : ""));
  const auto error_of = [&, scale = factor](const SolveSummary& solve) {
    return has_answer(solve) ? scale * std::max(solve.position_error_cm, metric.floor) : nowhere;
  };
  return shares_of(study, {.about = about, .y_axis = "targets", .dashed = tolerance}, look, error_of);
}

std::optional<Figure> metric_boxes(const JudgedStudy& judged, const Look& look) {
  const std::string& column = judged.study.definition.plan.metric;
  const bool is_drawn = column == error || column == time || column == motion;
  // No metric is found if the plan names none, or a number of the study's check.
  const auto metric = std::ranges::find(metrics(), column, &Metric::column);
  const bool has_boxes = metric != metrics().end() && metric->kind != MetricKind::success_rate;
  return is_drawn || !has_boxes ? std::nullopt : boxes_of(judged, column, look);
}

std::optional<Figure> error_by_iteration(const JudgedStudy& judged, const Look& look) {
  const auto [average, name] = average_that_decides(judged.study);
  return curves(about_of(judged.study, metric_named(error),
                         fmt::format("{} position error after each iteration.", name == "mean" ? "Mean" : "Median")),
                {.title = "iteration"}, by_iteration(judged.study, look, average));
}

const JudgedMetric& deciding(const JudgedStudy& judged) { return judged.metrics[judged.primary]; }

// Returns the look without solvers of another machine, whose targets and angles are not in the store.
Look of_this_machine(const StudyResults& study, Look look) {
  std::erase_if(look.style.solvers, [&](const std::string& solver) { return study.imported.has(solver); });
  return look;
}

std::optional<Figure> path(const JudgedStudy& judged, const Look& look) {
  if (!is_path(judged.study)) return std::nullopt;
  return path_of(judged.study, of_this_machine(judged.study, look), 1, "." + first_points(judged.study));
}

std::optional<Figure> joints(const JudgedStudy& judged, const Look& look) {
  const StudyResults& study = judged.study;
  if (!is_path(study)) return std::nullopt;
  return joints({"", "Joint angles along the path, first run of each solver. Dashed: limits." + first_points(study)},
                joint_rows(study, of_this_machine(study, look)));
}

// Returns the targets from those that most of these solvers solve. Of targets that as many solve, those of the first
// solvers come first.
std::vector<std::size_t> easiest_first(const SolvedTargets& all, const std::vector<std::size_t>& solvers) {
  std::vector<std::size_t> order(all.targets.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t first, std::size_t second) {
    if (all.targets[first].solvers != all.targets[second].solvers)
      return all.targets[first].solvers > all.targets[second].solvers;
    const auto differs = [&](std::size_t solver) { return all.solves(solver, first) != all.solves(solver, second); };
    const auto where = std::ranges::find_if(solvers, differs);
    return where != solvers.end() && all.solves(*where, first);
  });
  return order;
}

std::optional<Figure> targets(const JudgedStudy& judged, const Look& look) {
  const SolvedTargets& all = judged.targets;
  if (!all.is_complete || !do_solvers_differ(all) || judged.study.definition.is_grid()) return std::nullopt;
  const std::vector<std::string> shown = drawn_solvers(judged.study, look);
  std::vector<std::size_t> solvers;
  for (const std::string& name : shown)
    solvers.push_back(static_cast<std::size_t>(std::ranges::find(all.solvers, name) - all.solvers.begin()));
  const std::vector<std::size_t> order = easiest_first(all, solvers);
  std::vector<SolvedRow> rows;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    SolvedRow& row = rows.emplace_back(SolvedRow{.label = look.names.at(shown[i]), .style = look.lines.at(shown[i])});
    for (const std::size_t target : order) row.is_solved.push_back(all.solves(solvers[i], target));
  }
  const auto unsolved =
      static_cast<std::size_t>(std::ranges::count(all.targets, std::size_t{0}, &SolvedTarget::solvers));
  std::string caption =
      fmt::format("Targets that each solver solves{}, from those that most solvers solve; right: their number.",
                  all.are_repeated ? " in at least one run" : "");
  if (unsolved > 0) caption += fmt::format(" Grey: solved by none ({}).", unsolved);
  return solved_rows({"", caption, "targets"}, rows, order.size() - unsolved);
}

// The figures of a study, in the order of the report.
constexpr KindOfFigure all_kinds[]{
    {"map", "if the targets are a grid: where each solver solves them", map_of},
    {"overview", "position error against joint motion",
     [](auto& judged, auto& look) { return overview_of(judged, look, [](Dot&) {}); }},
    {"error-boxes", "position error of each solver",
     [](auto& judged, auto& look) { return boxes_of(judged, error, look); }},
    {"error-shares", "with a tolerance: share of targets reached within an error", error_shares},
    {"time-boxes", "time of each solver, where motion-boxes are drawn and all times are compared",
     [](auto& judged, auto& look) { return if_timed(boxes_of, judged, look); }},
    {"motion-boxes", "without a tolerance, or with start = \"previous\": the joint motion of each solver",
     [](auto& judged, auto& look) { return boxes_of(judged, motion, look); }},
    {"metric-boxes", "the plan's metric, if no other figure shows it", metric_boxes},
    {"error-by-iteration", "if solves have a trace: median error, or mean error if the plan compares means",
     error_by_iteration},
    {"error-by-point", "along a path: median error, or mean error if the plan compares means",
     [](auto& judged, auto& look) { return by_point_of(judged, error, look); }},
    {"motion-by-point", "along a path: joint motion",
     [](auto& judged, auto& look) { return by_point_of(judged, motion, look); }},
    {"time-by-point", "along a path: time",
     [](auto& judged, auto& look) { return if_timed(by_point_of, judged, look); }},
    {"solved-by-evaluations", "with a tolerance: share of targets solved within a number of evaluations",
     [](auto& judged, auto& look) { return solved_by(judged, "evaluations", "a number of evaluations", look); }},
    {"solved-by-time", "with a tolerance, if times are compared: share of targets solved within a time",
     [](auto& judged, auto& look) { return solved_by(judged, time, "a time", look); }},
    {"targets", "with a tolerance, where solvers solve different targets: which targets each solver solves", targets},
    {"ranks",
     "3 solvers or more, compared by ranks, without a control: mean ranks; bars join pairs without a difference",
     [](auto& judged, auto& look) { return ranks_of(deciding(judged), drawn_solvers(judged.study, look), look); }},
    {"differences", "if pairs are tested and not all are equal: their intervals and verdicts",
     [](auto& judged, auto& look) {
       return differences_of(deciding(judged), drawn_unit(judged.study, deciding(judged).samples.unit),
                             drawn_solvers(judged.study, look), look);
     }},
    {"path", "targets and arm along a path", path},
    {"joints", "joint angles along a path", joints},
};

}  // namespace

std::optional<Figure> overview_of(const JudgedStudy& judged, const Look& look,
                                  const std::function<void(Dot&)>& add_printed) {
  const JudgedMetric *const errors = find_metric(judged, error), *const motions = find_metric(judged, motion);
  if (errors == nullptr || motions == nullptr || is_conditional_on_success(motions->samples)) return std::nullopt;
  const std::string average = motions->plan.test == results::AnalysisPlan::Test::means ? "mean" : "median";
  const auto value = [](const JudgedMetric& metric, const std::string& solver) {
    return average_of(metric, index_of(metric.samples, solver));
  };
  std::vector<Dot> dots;
  const double factor = drawn_unit(judged.study, errors->samples.unit).factor;
  for (const std::string& solver : drawn_solvers(judged.study, look)) {
    Dot& dot = dots.emplace_back(Dot{.label = solver,
                                     .style = look.lines.at(solver),
                                     .x = value(*motions, solver),
                                     .y = factor * value(*errors, solver)});
    add_printed(dot);
    dot.label = look.names.at(solver);
  }
  About about = about_of(judged.study, metric_named(error),
                         fmt::format("{} position error against joint motion; the lower left is best.",
                                     average == "mean" ? "Mean" : "Median"));
  about.quantity = fmt::format("{} {}", average, about.quantity);
  return overview(about, average + " joint motion [deg]", dots);
}

namespace {

// The pairs that a figure of differences shows. The better solver is the first, but a control is always the second.
struct ShownPairs {
  std::vector<Comparison> pairs;
  bool is_only_first = false;  // true: there are too many pairs, so only those of the first solver are shown
};

ShownPairs shown_pairs(const JudgedMetric& metric, const std::vector<std::string>& shown) {
  const auto place = [&](const std::string& name) { return std::ranges::find(shown, name) - shown.begin(); };
  const auto places = [&](const Comparison& pair) { return std::minmax({place(pair.first), place(pair.second)}); };
  ShownPairs result{.pairs = metric.comparisons};
  std::erase_if(result.pairs, [&](const Comparison& pair) {
    return verdict_of(pair) == Verdict::not_tested || places(pair).second == std::ssize(shown);
  });
  result.is_only_first = result.pairs.size() > most_drawn_pairs && metric.plan.control.empty();
  if (result.is_only_first)
    std::erase_if(result.pairs, [&](const Comparison& pair) { return places(pair).first != 0; });
  std::ranges::stable_sort(result.pairs, {}, places);
  for (Comparison& pair : result.pairs)
    pair = better_first(pair, metric.plan.control, place(pair.second) < place(pair.first));
  return result;
}

double drawn_factor(EffectScale scale, const DrawnUnit& unit) {
  switch (scale) {
    case EffectScale::ratio:
      return 1;
    case EffectScale::share:
      return 100;
    case EffectScale::difference:
      return unit.factor;
  }
  return 1;
}

std::string drawn_name(bool are_shares, const DrawnUnit& unit, bool are_ratios) {
  if (are_ratios) return "";
  return are_shares ? "points" : unit.name;
}

// The labels of a figure of differences. A solver that is in all pairs is named above the rows, not in each row.
struct PairLabels {
  const Look& look;
  bool is_first_shared, is_second_shared;

  PairLabels(const std::vector<Comparison>& pairs, const Look& of) : look(of) {
    is_first_shared = is_shared(pairs, &Comparison::first);
    is_second_shared = is_shared(pairs, &Comparison::second);
  }
  static bool is_shared(const std::vector<Comparison>& pairs, std::string Comparison::*name) {
    return pairs.size() > 1 && std::ranges::count(pairs, pairs.front().*name, name) == std::ssize(pairs);
  }
  static const char* sign(const Comparison& pair) { return pair.scale == EffectScale::ratio ? "/" : "-"; }

  std::string of_row(const Comparison& pair) const {
    const std::string &first = look.names.at(pair.first), &second = look.names.at(pair.second);
    if (is_first_shared) return second;
    if (is_second_shared) return first;
    const char joint = character_count(first + second) > 30 ? '\n' : ' ';
    return fmt::format("{} {}{}{}", first, sign(pair), joint, second);
  }
  // Returns the row above the others; nullopt if no solver is in all pairs.
  std::optional<IntervalRow> head(const std::vector<Comparison>& pairs) const {
    if (!is_first_shared && !is_second_shared) return std::nullopt;
    const Comparison& pair = pairs.front();
    return IntervalRow{.label = fmt::format("{} {} {}", is_first_shared ? look.names.at(pair.first) : "…",
                                            sign(pairs.back()), is_second_shared ? look.names.at(pair.second) : "…"),
                       .verdict = is_first_shared ? "the first is" : ""};
  }
};

IntervalRow interval_row(const Comparison& pair, const DrawnUnit& unit, const PairLabels& labels) {
  IntervalRow row{.label = labels.of_row(pair)};
  const double factor = drawn_factor(pair.scale, unit);
  if (const std::optional<EffectEstimate>& estimate = pair.estimate) {
    row.estimate = factor * estimate->value;
    if (estimate->interval) {
      row.low = factor * estimate->interval->low;
      row.high = factor * estimate->interval->high;
    }
  }
  const Verdict verdict = verdict_of(pair);
  row.verdict = name_of(verdict);
  if (is_difference(verdict)) row.style = labels.look.lines.at(verdict == Verdict::better ? pair.first : pair.second);
  return row;
}

}  // namespace

std::optional<Figure> differences_of(const JudgedMetric& metric, const DrawnUnit& unit,
                                     const std::vector<std::string>& shown, const Look& look) {
  const MetricSamples& samples = metric.samples;
  const auto [pairs, is_only_first] = shown_pairs(metric, shown);
  if (std::ranges::all_of(pairs, all_values_equal)) return std::nullopt;  // also if there are no pairs
  const PairLabels labels(pairs, look);
  std::vector<IntervalRow> rows;
  if (const std::optional<IntervalRow> head = labels.head(pairs)) rows.push_back(*head);
  for (const Comparison& pair : pairs) rows.push_back(interval_row(pair, unit, labels));
  const bool are_ratios = pairs.back().scale == EffectScale::ratio;
  const std::string effect = fmt::format("{} of {}", are_ratios ? "ratio" : "difference", samples.quantity);
  const std::string intervals = are_by_closed_tests(pairs) ? "without intervals, which closed tests do not have"
                                                           : "with intervals that hold for all pairs at once";
  return differences(
      {.name = "differences",
       .caption = fmt::format("Pairwise {}, {}. Right: the verdict on the first solver.{}", effect, intervals,
                              is_only_first ? fmt::format(" Only pairs with {} are drawn.", shown.front()) : ""),
       .quantity = effect,
       .unit = drawn_name(is_proportion(samples), unit, are_ratios)},
      rows, are_ratios);
}

namespace {

// Returns the metric on the blocks that all groups have, since mean ranks need common blocks. The verdicts are those on
// all blocks.
JudgedMetric on_common_blocks(JudgedMetric metric) {
  MetricSamples& samples = metric.samples;
  if (!samples.is_paired || is_conditional_on_success(samples)) return metric;
  std::vector<Group*> groups;
  std::set<std::vector<int>> blocks;
  for (Group& group : samples.groups) {
    const Sample* const sample = sample_of(group);
    if (sample == nullptr || sample->values.empty()) continue;
    groups.push_back(&group);
    blocks.insert(sample->blocks);
  }
  if (blocks.size() < 2) return metric;
  keep_common_blocks(groups);
  std::vector<Comparison> common = compare_pairs(samples, metric.plan);
  const ComparisonTable table(metric);
  for (Comparison& comparison : common) {
    const Comparison* const whole = table.find(comparison.first_index, comparison.second_index);
    const auto* const whole_test = whole ? std::get_if<TestResult>(&whole->result) : nullptr;
    auto* const test = std::get_if<TestResult>(&comparison.result);
    if (test && whole_test) test->verdict = whole_test->verdict;
  }
  metric.comparisons = std::move(common);
  return metric;
}

// A pair with a known share of cases in which the second solver is better.
struct RankedPair {
  const Comparison* comparison;
  double behind;  // share of values in which the second is better, equal values count half
};
using RankedPairs = std::map<std::pair<std::string_view, std::string_view>, RankedPair>;  // in either order

// Returns the share of values in which the first solver is better, where equal values count half; nullopt if the share
// is not known.
std::optional<double> share_ahead(const Comparison& comparison, Better better) {
  if (const auto* const tested = std::get_if<TestResult>(&comparison.result))
    return tested->dominance ? std::optional(tested->dominance->a12()) : std::nullopt;
  if (!std::holds_alternative<DeterministicResult>(comparison.result)) return std::nullopt;
  const double excess = comparison.estimate->value - null_value(comparison.scale);
  if (excess == 0) return 0.5;
  return (excess > 0) == (better == Better::larger) ? 1 : 0;
}

RankedPairs ranked_pairs(const JudgedMetric& metric) {
  RankedPairs pairs;
  for (const Comparison& comparison : metric.comparisons) {
    const std::optional<double> ahead = share_ahead(comparison, metric.samples.better);
    if (!ahead) continue;
    pairs[{comparison.first, comparison.second}] = {&comparison, 1 - *ahead};
    pairs[{comparison.second, comparison.first}] = {&comparison, *ahead};
  }
  return pairs;
}

// The solvers of a figure of ranks, each of which has a known pair with each other one, and the solvers without.
struct RankedSolvers {
  std::vector<std::string> solvers, without;
};

RankedSolvers ranked_solvers(const RankedPairs& pairs, const std::vector<std::string>& shown) {
  const auto is_known = [&](const std::string& name, const std::vector<std::string>& others) {
    return std::ranges::all_of(others, [&](const std::string& other) { return pairs.contains({name, other}); });
  };
  RankedSolvers ranked;
  for (const std::string& name : shown) {
    const auto has_share = [&](const std::string& other) { return pairs.contains({name, other}); };
    const bool is_ranked = std::ranges::any_of(shown, has_share) && is_known(name, ranked.solvers);
    (is_ranked ? ranked.solvers : ranked.without).push_back(name);
  }
  return ranked;
}

// The rows of a figure of ranks, and the blocks that all pairs have in common.
struct RankRows {
  std::vector<RankRow> rows = {};
  bool have_all_blocks = false;
  std::size_t n = 0;  // blocks, if all pairs have them
};

RankRows rank_rows(const MetricSamples& samples, const RankedPairs& pairs, const std::vector<std::string>& solvers,
                   const Look& look) {
  RankRows ranked{.have_all_blocks = samples.is_paired};
  for (const std::string& name : solvers) {
    ranked.n = values_of(samples.groups[index_of(samples, name)]).size();
    RankRow row{.label = look.names.at(name), .style = look.lines.at(name), .place = 1};
    for (const std::string& other : solvers) {
      if (other == name) continue;
      const auto& [comparison, behind] = pairs.at({name, other});
      row.place += behind;
      if (is_difference(verdict_of(*comparison))) row.apart.push_back(look.names.at(other));
      const auto* const tested = std::get_if<TestResult>(&comparison->result);
      ranked.have_all_blocks &= tested && static_cast<std::size_t>(tested->n) == ranked.n;
    }
    ranked.rows.push_back(std::move(row));
  }
  std::ranges::stable_sort(ranked.rows, {}, &RankRow::place);
  return ranked;
}

}  // namespace

namespace {

// Returns " Friedman's test of all: p = 0.002." for these solvers; empty if there is no such test.
std::string friedman_text(MetricSamples samples, const std::vector<std::string>& solvers) {
  std::erase_if(samples.groups, [&](const Group& group) { return std::ranges::count(solvers, group.name) == 0; });
  const std::vector<OmnibusTest> tests = friedman(samples);
  if (tests.empty()) return "";
  const double p = tests.front().p;
  return fmt::format(" Friedman's test of all {}: p {}.", samples.groups.size(),
                     p < 0.0001 ? "< 0.0001" : fmt::format("= {:.2g}", p));
}

}  // namespace

std::optional<Figure> ranks_of(const JudgedMetric& judged, const std::vector<std::string>& shown, const Look& look) {
  const JudgedMetric metric = on_common_blocks(judged);
  const MetricSamples& samples = metric.samples;
  const bool are_shares = is_proportion(samples);
  if (metric.plan.test == results::AnalysisPlan::Test::means && !are_shares) return std::nullopt;
  const RankedPairs pairs = ranked_pairs(metric);
  const auto [solvers, without] = ranked_solvers(pairs, shown);
  if (solvers.size() < 3) return std::nullopt;
  const auto [rows, have_all_blocks, n] = rank_rows(samples, pairs, solvers, look);
  About about{.name = "ranks", .quantity = "mean rank of " + samples.quantity};
  about.caption =
      fmt::format("Mean ranks of {} {}; 1 is best. Bars join pairs without a significant difference (adjusted p < {}).",
                  samples.quantity,
                  have_all_blocks ? fmt::format("in {} blocks", n)
                                  : "expected from one value of each solver (1 plus the others' A12)",
                  metric.plan.significance);
  // The critical difference does not allow for ties, and shares of one trial are nearly all tied.
  const bool has_ruler = have_all_blocks && !are_shares && metric.plan.significance == 0.05;
  const double ruler = has_ruler ? critical_difference(solvers.size(), n) : nowhere;
  if (ruler > 0)
    about.caption += fmt::format(
        " CD: Nemenyi's critical difference, {:.3g} (p < 0.05), only for orientation: bars do not depend on it.",
        ruler);
  about.caption += have_all_blocks ? friedman_text(samples, solvers) : "";
  if (!without.empty())
    about.caption += fmt::format(" Left out, because not compared with all: {}.", names_of(without));
  return ranks(about, rows, ruler);
}

Figure path_of(const StudyResults& study, const Look& look, std::size_t arms, const std::string& more) {
  const std::string solver = drawn_solvers(study, look).front();
  const std::span<const SolveRecord> solves = study.first_run_of(solver);
  const auto corner_of = [](std::span<const double> metres) {
    return metres.size() == 3 ? Corner(Corner::Map(metres.data()) / centimetre) : Corner::Constant(nowhere);
  };
  PathRows rows{.targets = {}, .reached_label = "reached by " + look.names.at(solver), .style = look.lines.at(solver)};
  const std::optional<robots::Robot> arm = robots::stored_arm(study.definition.arm);
  const std::size_t every = std::max<std::size_t>(1, (solves.size() + arms - 1) / arms);
  for (std::size_t i = 0; i < solves.size(); ++i) {
    const SolveRecord& solve = solves[i];
    rows.targets.push_back(corner_of(solve.target_position_m));
    rows.reached.push_back(corner_of(solve.reached_position_m));
    const SolveSummary& summary = study.of(solver)[i];
    if (summary.missed_deadline || summary.exceeds_velocity) rows.late_or_too_fast.push_back(rows.targets.back());
    const Eigen::Map<const Eigen::VectorXd> q(solve.answer_rad.data(),
                                              static_cast<Eigen::Index>(solve.answer_rad.size()));
    if (i % every != 0 || !arm || q.size() != arm->joints() || !q.allFinite()) continue;
    rows.arms.emplace_back(fmt::format("arm at point {}", solve.point), corners_of(*arm, q));
  }
  if (study.definition.path == "circle" && std::ssize(solves) == study.definition.points) {  // the curve is closed
    rows.targets.push_back(rows.targets.front());
    rows.reached.push_back(rows.reached.front());
  }
  return path({"", fmt::format("Targets, and the positions that {} reached in its first run{}", solver, more)}, rows);
}

std::vector<Figure> of_file(const std::vector<JudgedMetric>& metrics, const Look& look) {
  std::vector<Figure> all;
  const JudgedMetric& first = metrics.front();
  std::vector<std::string> shown = look.style.solvers;
  if (shown.empty())
    for (const std::size_t i : display_order(first, metrics)) shown.push_back(first.samples.groups[i].name);
  for (const JudgedMetric& metric : metrics) {
    const MetricSamples& samples = metric.samples;
    if (is_proportion(samples) && trials_per_value(samples) == 1) continue;
    const std::string number = all.empty() ? "" : fmt::format("-{}", all.size() + 1);
    const About about{.name = "boxes" + number,
                      .caption = caption_of_boxes(samples.quantity, "one value"),
                      .quantity = samples.quantity,
                      .unit = samples.unit,
                      .is_share = is_proportion(samples)};
    if (auto figure = boxes(about, box_rows(samples, {samples.unit}, shown, look))) all.push_back(std::move(*figure));
  }
  for (auto figure : {ranks_of(first, shown, look), differences_of(first, {first.samples.unit}, shown, look)}) {
    if (figure) all.push_back(std::move(*figure));
  }
  return all;
}

std::vector<std::string> not_compared_in_time(const JudgedStudy& judged) { return not_compared(judged, time); }

std::span<const KindOfFigure> kinds_of_figures() { return all_kinds; }

std::vector<Figure> of_study(const JudgedStudy& judged, const Look& look) {
  std::vector<Figure> all;
  if (drawn_solvers(judged.study, look).empty()) return all;
  for (const KindOfFigure& kind : all_kinds) {
    if (std::optional<Figure> figure = kind.of(judged, look)) {
      figure->name = kind.name;
      all.push_back(std::move(*figure));
    }
  }
  return all;
}

}  // namespace ikbench::figures
