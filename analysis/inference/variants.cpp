#include "analysis/inference/variants.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <stdexcept>
#include <utility>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/design.hpp"
#include "analysis/inference/estimand.hpp"
#include "analysis/inference/judged_study.hpp"
#include "analysis/inference/make_study.hpp"
#include "analysis/inference/margin.hpp"
#include "analysis/inference/method.hpp"
#include "analysis/inference/not_finite.hpp"
#include "analysis/inference/outcomes.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/inference/variant_differences.hpp"
#include "analysis/statistics/quantile.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

constexpr const char* name_of_a = "A";
constexpr const char* name_of_b = "B";

// Metrics if none is named: for poses the orientation error too.
std::vector<Metric> by_default(std::span<const VariantStudy> studies) {
  std::vector<Metric> result = compared_metrics();
  const auto is_of_poses = [](const VariantStudy& of) { return of.study.facts.pose; };
  if (std::ranges::any_of(studies, is_of_poses)) result.insert(result.begin() + 1, Metric::orientation_error_deg);
  return result;
}

// The named metrics, in the order given, each once.
std::vector<Metric> chosen(std::span<const std::string> names) {
  const std::vector<Metric> all = all_metrics();
  const auto column = [](Metric metric) { return name_of(metric); };
  std::vector<Metric> result;
  for (const std::string& name : names) {
    const auto found = std::ranges::find(all, name, column);
    if (found == all.end()) {
      std::vector<std::string_view> known;
      for (const Metric metric : all) known.push_back(name_of(metric));
      throw std::invalid_argument(
          fmt::format("unknown metric \"{}\" (there are: {})", name.substr(0, 100), fmt::join(known, ", ")));
    }
    if (std::ranges::find(result, *found) == result.end()) result.push_back(*found);
  }
  return result;
}

std::invalid_argument refused(std::string_view what) {
  return std::invalid_argument(
      fmt::format("cannot compare A and B: they have {}; run both with the same robot, path and seed", what));
}

std::string place_of(std::span<const double> metres) {
  std::vector<std::string> texts;
  for (const double value : metres) texts.push_back(fmt::format("{:.4g}", 100 * value));
  return fmt::format("{} cm", fmt::join(texts, " "));
}

int complete_runs(const StudyResults& study, const std::string& solver) {
  for (const SolverCounts& count : counts(study)) {
    if (count.solver == solver) return count.complete_runs;
  }
  return 0;
}

// Refuses different targets or starts at any place that both have solved. In chained solves only the first start of a
// run counts: the others depend on the solver.
void refuse_other_tasks(const StudyResults& study, std::string_view label) {
  for (const char* side : {name_of_a, name_of_b}) {
    if (complete_runs(study, side) > 0) continue;
    throw std::invalid_argument(
        fmt::format("{} has no complete run of {}, so there is nothing to compare", side, label));
  }
  const std::span<const Solve> of_b = solves_of(study, name_of_b);
  bool is_shared = false;
  for (const Solve& one : solves_of(study, name_of_a)) {
    const Solve* const other = solve_at(of_b, {one.run, one.point});
    if (other == nullptr) continue;
    is_shared = true;
    const Problem asked = problem_of(study, one), asked_other = problem_of(study, *other);
    if (!same_target(asked, asked_other)) {
      throw refused(fmt::format("different targets (run {}, point {}: {} and {})", one.run, one.point,
                                place_of(asked.target_position_m), place_of(asked_other.target_position_m)));
    }
    if ((one.point == 1 || study.facts.starts_anew()) && !same_start(asked, asked_other)) {
      throw refused(fmt::format("different start configurations (run {}, point {})", one.run, one.point));
    }
  }
  if (!is_shared) throw refused("different targets (they have no run in common)");
}

// Refuses different arms of one name: users may give two files the same name.
void refuse_other_arm(const Variant& a, const Variant& b) {
  const nlohmann::json one = facts_of(a.study.definition).arm, other = facts_of(b.study.definition).arm;
  if (!one.is_object() || !other.is_object()) return;
  for (const char* part : {"links", "base", "tool"}) {
    if (one.value(part, nlohmann::json()) == other.value(part, nlohmann::json())) continue;
    throw refused(fmt::format("arms of one name, whose {} differ", part));
  }
}

// Passes on the solves of both sides as those of the solvers "A" and "B".
class Reader {
 public:
  explicit Reader(StudyMaker& maker) : maker_(maker) {}

  // Sessions of the store that solved the label.
  std::vector<Session> read(const Variant& variant, const std::string& name) {
    std::map<std::int64_t, std::int64_t> used;  // by the sessions' numbers in the study of both
    int points = 0;
    variant.each_solve([&](SolveRecord solve) {
      if (robot_.empty()) robot_ = solve.robot;
      if (solve.robot != robot_) throw refused(fmt::format("different robots ({} and {})", robot_, solve.robot));
      points = std::max(points, solve.point);
      solve.solver = name;
      solve.session = used.try_emplace(solve.session, std::ssize(sessions_) + std::ssize(used) + 1).first->second;
      maker_.add(solve);
    });
    if (points_ > 0 && points > 0 && points != points_) {
      throw refused(fmt::format("different targets ({} and {} points per run)", points_, points));
    }
    points_ = points;
    std::vector<Session> result;
    for (const Session& session : variant.sessions) {
      const auto found = used.find(session.id);
      if (found == used.end()) continue;
      result.push_back(session);
      sessions_.push_back(session);
      sessions_.back().id = found->second;
    }
    return result;
  }

  const std::vector<Session>& sessions() const { return sessions_; }

 private:
  std::vector<Session> sessions_;
  StudyMaker& maker_;
  std::string robot_;
  int points_ = 0;
};

// A metric with its observations, which are tested at several levels.
struct Examined {
  MetricComparison* row = nullptr;
  Observations observations = {};
  AnalysisPlan plan = {};

  void test(double level) {
    row->level = level;
    // The bootstrap resolves no smaller level, and 1 - level must be below 1.
    constexpr double least_level = 1e-6;
    if (level < least_level) {
      row->contrast.relation = Relation::undecided;
      return;
    }
    plan.significance = level;
    row->contrast = tested(observations, plan).contrasts.front();
  }
};

std::string not_finite_words(const Observations& observations, std::string_view observation) {
  std::vector<std::string> parts;
  for (const Group& group : observations.groups) {
    const std::size_t lost = count_not_finite(group);
    if (lost > 0)
      parts.push_back(fmt::format("{} of {} {}s of {}", lost, group.values.size(), observation, group.name));
  }
  return parts.empty() ? "" : fmt::format("not finite: {}", fmt::join(parts, ", "));
}

// Settles metrics that need no test. Returns those left to test.
std::vector<Examined> examine(const VariantStudy& of, std::span<const Metric> metrics, VariantComparison& comparison) {
  const StudyResults& study = of.study;
  std::vector<Examined> open;
  comparison.metrics.reserve(metrics.size());
  for (const Metric metric : metrics) {
    const std::vector<Estimand> planned = estimands_of(study, metric);
    const Estimand average = average_estimand(metric);
    const bool has_average = std::ranges::find(planned, average) != planned.end();
    const Estimand estimand = has_average ? average : planned.front();
    MetricComparison& row = comparison.metrics.emplace_back(MetricComparison{.metric = metric, .estimand = estimand});
    const Observations observed = observations(study, metric, estimand);
    row.scale = observed.scale;
    if (metric == Metric::solved && !std::isfinite(tolerance_cm(study)))
      comparison.notes.push_back(words_of(Doubt{.kind = DoubtKind::no_tolerance}));
    for (const auto* notes : {&observed.counting, &observed.notes})
      std::ranges::copy(*notes, std::back_inserter(comparison.notes));
    const auto group = [&](const char* name) { return std::ranges::find(observed.groups, name, &Group::name); };
    const Doubts& why_not =
        info_of(metric).kind == Kind::time && !of.times_differ.empty() ? of.times_differ : observed.flaws;
    if (!why_not.empty() || group(name_of_a) == observed.groups.end() || group(name_of_b) == observed.groups.end()) {
      row.is_compared = false;
      const auto has_nobody = [&](const Solve& solve) { return solve.counted_by == CountedBy::nobody; };
      row.is_counted = metric != Metric::evaluations || std::ranges::none_of(study.solves, has_nobody);
      row.remark = row.is_counted ? "see below" : "nobody counted";
      std::ranges::move(list_of(why_not), std::back_inserter(comparison.notes));
      continue;
    }
    try {
      check_margin(observed, study.plan);
    } catch (const std::invalid_argument& no_margin) {
      row.is_compared = false;
      row.remark = no_margin.what();
      continue;
    }
    row.observation = observed.blocks.empty() || observed.block_noun == "runs" ? "run" : "target";
    const Observations finite = of_finite(observed);
    const auto mean_of = [&](const char* name) {
      const double of_values = mean(std::ranges::find(finite.groups, name, &Group::name)->values);
      return observed.scale == ValueScale::log10 ? std::pow(10, of_values) : of_values;
    };
    row.n_a = static_cast<int>(group(name_of_a)->values.size());
    row.n_b = static_cast<int>(group(name_of_b)->values.size());
    row.mean_a = mean_of(name_of_a);
    row.mean_b = mean_of(name_of_b);
    if (comparison.design.empty()) {
      comparison.design = observed.blocks.empty()
                              ? fmt::format("Independent runs, {} of A and {} of B: one observation is {}.", row.n_a,
                                            row.n_b, observed.replicate)
                              : fmt::format("{} pairs of {}s: one observation is {}; a pair is {}.", row.n_a,
                                            row.observation, observed.replicate, observed.block);
    }
    row.remark = not_finite_words(observed, row.observation);
    const AnalysisPlan judged = feasible(study.plan, observed);
    if (is_fact(observed.groups.front(), observed.groups.back())) {
      row.contrast = tested(observed, judged).contrasts.front();
      row.remark = observed.groups.front().bits > 0
                       ? "equal bit for bit"
                       : "all runs of each are equal: a fact of these targets, without a test";
    } else {
      open.push_back({.row = &row, .observations = observed, .plan = judged});
      row.is_by_ranks = compares(judged.test) == Compares::ranks;
    }
  }
  return open;
}

// Holm (Scandinavian J. Statistics 6 (1979) 65): the smallest p is tested at significance / m, the next at
// significance / (m - 1), and so on until one is not below. The others are left at the level of that one.
void decide(std::vector<Examined>& all, double significance, const LevelOf& level_of) {
  if (all.empty()) return;
  const auto m = static_cast<double>(all.size());
  for (Examined& each : all) each.test(level_of(significance / m));
  std::vector<Examined*> order;
  for (Examined& each : all) order.push_back(&each);
  const auto p_of = [](const Examined* each) {
    const double p = each->row->contrast.p;
    return std::isnan(p) ? 2.0 : p;
  };
  std::ranges::stable_sort(order, {}, p_of);
  double left = m;
  for (Examined* each : order) {
    if (const double level = level_of(significance / left); level > each->row->level) each->test(level);
    if (p_of(each) < each->row->level) --left;
  }
}

// "Solves without an answer: none of A's 16; 3 of B's 16 (crashed 1, timed_out 2)."; empty if every solve has one.
std::string failures_note(const StudyResults& study) {
  std::vector<std::string> sides;
  int all = 0;
  for (const SolverCounts& count : counts(study)) {
    int failures = 0;
    std::vector<std::string> kinds;
    for (const Status status : shown_statuses(study)) {
      if (!is_without_answer(status) || count.of(status) == 0) continue;
      failures += count.of(status);
      kinds.push_back(fmt::format("{} {}", name_of(status), count.of(status)));
    }
    all += failures;
    sides.push_back(failures == 0 ? fmt::format("none of {}'s {}", count.solver, count.solves)
                                  : fmt::format("{} of {}'s {} ({})", failures, count.solver, count.solves,
                                                fmt::join(kinds, ", ")));
  }
  return all == 0 ? "" : fmt::format("Solves without an answer: {}.", fmt::join(sides, "; "));
}

// Says how many observations a decision takes; empty if there are as many already.
std::string what_would_show(const MetricComparison& row) {
  const auto& [value, low, high] = row.contrast.runs_to_decide;
  const double least = std::isfinite(low) ? low : value;
  if (!(least > std::min(row.n_a, row.n_b))) return "";
  const bool is_range = std::isfinite(high) && high > least && high < 100 * least;
  return is_range ? fmt::format("a difference of the margin takes {:.0f} to {:.0f} {}s", least, high, row.observation)
                  : fmt::format("a difference of the margin takes at least {:.0f} {}s", least, row.observation);
}

void add_remark(MetricComparison& row, const std::string& remark) {
  if (!remark.empty()) row.remark += (row.remark.empty() ? "" : "; ") + remark;
}

void add_remarks(MetricComparison& row, double significance) {
  if (row.contrast.is_fact || !row.is_compared) return;
  const Finding& contrast = row.contrast;
  if (contrast.relation == Relation::undefined || !contrast.why.empty()) {
    const bool is_strict = row.level < significance && contrast.relation == Relation::undecided;
    return add_remark(row, contrast.why + (is_strict ? fmt::format(", at the level {:.3g}", row.level) : ""));
  }
  if (contrast.relation == Relation::undecided) {
    if (contrast.p >= row.level && contrast.p < significance) {
      add_remark(row, fmt::format("{} by itself, but not among all of this comparison",
                                  contrast.ahead < 0 ? "better" : "worse"));
    }
    return add_remark(row, what_would_show(row));
  }
  if (contrast.relation == Relation::better || row.is_by_ranks) return;
  add_remark(row, rare_failures_words(std::min(row.n_a, row.n_b), fmt::format("{}s", row.observation), row.level));
}

}  // namespace

bool is_regression(const MetricComparison& metric) {
  return metric.contrast.relation == Relation::better && metric.contrast.is_beyond_margin();
}

bool is_open(const MetricComparison& metric) {
  if (!metric.is_compared) return metric.is_counted;
  const Finding& contrast = metric.contrast;
  return contrast.relation == Relation::undecided || contrast.relation == Relation::undefined ||
         (contrast.relation == Relation::better && !contrast.is_within_margin() && !contrast.is_beyond_margin());
}

std::vector<Variant> variants(const Store& store, const StudyEntry& study) {
  const std::vector<Session> sessions = store.sessions();
  std::vector<Variant> result;
  for (const Series& series : study.series) {
    StudyEntry alone = study;
    alone.series = {series};
    result.push_back({.study = study,
                      .series = series,
                      .sessions = sessions,
                      .each_solve = [&store, alone](const std::function<void(SolveRecord)>& take) {
                        store.each_of_study(alone, take);
                      }});
  }
  return result;
}

VariantStudy study_of_both(const Variant& a, const Variant& b, const AnalysisPlan& plan) {
  refuse_other_arm(a, b);
  StudyEntry entry = a.study;
  entry.series = {a.series, b.series};
  entry.series[0].label = name_of_a;
  entry.series[1].label = name_of_b;
  StudyMaker maker(entry);
  Reader reader(maker);
  const std::vector<Session> of_a = reader.read(a, name_of_a), of_b = reader.read(b, name_of_b);
  VariantStudy result{.label = a.series.label == b.series.label
                                   ? b.series.label
                                   : fmt::format("{} against {}", b.series.label, a.series.label),
                      .study = maker.finish(reader.sessions()),
                      .times_differ = why_times_differ(of_a, of_b),
                      .differences = differences(a, of_a, b, of_b)};
  AnalysisPlan& judged = result.study.plan;
  judged.control.clear();
  judged.margin = plan.margin;
  judged.margin_cm = plan.margin_cm;
  judged.significance = plan.significance;
  judged.power = plan.power;
  judged.estimands = plan.estimands;
  refuse_other_tasks(result.study, a.series.label);
  return result;
}

std::vector<VariantComparison> compare_variants(std::span<const VariantStudy> studies,
                                                std::span<const std::string> metrics, const LevelOf& level_of) {
  const std::vector<Metric> asked = metrics.empty() ? by_default(studies) : chosen(metrics);
  std::vector<VariantComparison> result(studies.size());
  std::vector<Examined> open;
  for (std::size_t i = 0; i < studies.size(); ++i) {
    result[i].label = studies[i].label;
    std::ranges::move(examine(studies[i], asked, result[i]), std::back_inserter(open));
  }
  const double significance = studies.empty() ? not_defined : studies.front().study.plan.significance;
  decide(open, significance, level_of);
  for (std::size_t i = 0; i < studies.size(); ++i) {
    for (MetricComparison& row : result[i].metrics) add_remarks(row, significance);
    std::vector<std::string>& notes = result[i].notes;
    notes.push_back(failures_note(studies[i].study));
    notes.push_back(studies[i].differences);
    std::vector<std::string> once;
    for (std::string& note : notes) {
      if (std::ranges::find(once, note) == once.end()) once.push_back(std::move(note));
    }
    notes = std::move(once);
  }
  return result;
}

}  // namespace ikbench::inference
