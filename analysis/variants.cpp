#include "analysis/variants.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <stdexcept>

#include "analysis/variant_differences.hpp"

namespace ikbench {
namespace {

struct Run {
  int number;
  std::vector<const SolveRecord*> solves;  // in the order of the path
};

// Without those of which points are missing.
std::vector<Run> complete_runs(const StudyResults& study) {
  std::map<int, std::vector<const SolveRecord*>> by_number;
  for (const SolveRecord& solve : study.solves) by_number[solve.run].push_back(&solve);
  std::vector<Run> runs;
  for (auto& [number, solves] : by_number) {
    if (static_cast<int>(solves.size()) != study.points) continue;
    std::ranges::sort(solves, {}, &SolveRecord::point);
    runs.push_back({.number = number, .solves = std::move(solves)});
  }
  return runs;
}

std::string place_of(const std::vector<double>& metres) {
  std::vector<std::string> texts;
  for (const double value : metres) texts.push_back(fmt::format("{:.4g}", 100 * value));
  return fmt::format("{} cm", fmt::join(texts, " "));
}

// In what two runs were not given the same to do; empty where they were. Of one run that starts each solve where the
// one before ended, only the first start is given.
std::string difference_in_task(const Run& a, const Run& b) {
  for (std::size_t i = 0; i < a.solves.size(); ++i) {
    const SolveRecord &one = *a.solves[i], &other = *b.solves[i];
    if (one.robot != other.robot) return fmt::format("another robot ({} and {})", one.robot, other.robot);
    if (one.target_position_m != other.target_position_m || one.target_rotation != other.target_rotation) {
      return fmt::format("other targets (run {} and {}, point {}: {} and {})", a.number, b.number, one.point,
                         place_of(one.target_position_m), place_of(other.target_position_m));
    }
  }
  return a.solves.front()->start_rad == b.solves.front()->start_rad ? "" : "another configuration to start from";
}

struct Design {
  std::vector<Run> a;
  std::vector<Run> b;
  bool paired = false;
};

// Both are in the order of their numbers.
void keep_common(Design& design) {
  const auto keep = [](std::vector<Run>& runs, const std::vector<Run>& others) {
    std::erase_if(runs,
                  [&](const Run& run) { return !std::ranges::binary_search(others, run.number, {}, &Run::number); });
  };
  keep(design.a, design.b);
  keep(design.b, design.a);
}

Design design_of(const Variant& a, const Variant& b) {
  const auto refused = [](std::string_view what) {
    return std::invalid_argument(fmt::format(
        "A and B cannot be compared: they were given {}; run both with the same robot, path and seed", what));
  };
  Design design{.a = complete_runs(a.study), .b = complete_runs(b.study)};
  for (const Variant* side : {&a, &b}) {
    if (!(side == &a ? design.a : design.b).empty()) continue;
    throw std::invalid_argument(fmt::format("{} has no complete run of {}; there is nothing to compare",
                                            side == &a ? "A" : "B", side->series.label));
  }
  if (a.study.points != b.study.points) {
    throw refused(fmt::format("other targets ({} and {} points a run)", a.study.points, b.study.points));
  }
  const auto is_fixed = [](const std::vector<Run>& runs) {
    return std::ranges::all_of(runs, [&](const Run& run) { return difference_in_task(runs.front(), run).empty(); });
  };
  if (is_fixed(design.a) && is_fixed(design.b)) {
    const std::string what = difference_in_task(design.a.front(), design.b.front());
    if (!what.empty()) throw refused(what);
    return design;
  }
  keep_common(design);
  design.paired = true;
  if (design.a.empty()) throw refused("other targets (they have no run in common, and each run has its own)");
  for (std::size_t i = 0; i < design.a.size(); ++i) {
    if (const std::string what = difference_in_task(design.a[i], design.b[i]); !what.empty()) throw refused(what);
  }
  return design;
}

std::string sentence_of(const Design& design, int points) {
  const std::string observation = points == 1
                                      ? "one observation is a run's only solve"
                                      : fmt::format("one observation is a run's mean over its {} points", points);
  if (design.paired) {
    return fmt::format("{} pairs of runs, {}: run by run both have the same targets, and every run has its own.",
                       design.a.size(), observation);
  }
  return fmt::format(
      "Independent runs, {} of A and {} of B, {}: every run has the same targets, so "
      "that no run of A belongs to one of B.",
      design.a.size(), design.b.size(), observation);
}

std::vector<double> means(const std::vector<Run>& runs, const ComparedMetric& metric) {
  std::vector<double> result;
  for (const Run& run : runs) {
    std::vector<double> values;
    for (const SolveRecord* solve : run.solves) values.push_back(metric.value(*solve));
    result.push_back(mean(values));
  }
  return result;
}

bool has_same_bits(const Design& design, const ComparedMetric& metric) {
  const auto is_same = [&](const SolveRecord* a, const SolveRecord* b) {
    const double one = metric.value(*a), other = metric.value(*b);
    return std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other) ||
           (std::isnan(one) && std::isnan(other));
  };
  return std::ranges::equal(design.a, design.b, [&](const Run& a, const Run& b) {
    return a.number == b.number && std::ranges::equal(a.solves, b.solves, is_same);
  });
}

// In the order in which they were asked for, once each.
std::vector<const ComparedMetric*> chosen(std::span<const std::string> names) {
  std::vector<const ComparedMetric*> result;
  if (names.empty()) {
    for (const ComparedMetric& metric : compared_metrics) result.push_back(&metric);
  }
  for (const std::string& name : names) {
    const auto* const found = std::ranges::find(compared_metrics, name, &ComparedMetric::name);
    if (found == compared_metrics.end()) {
      std::vector<std::string_view> known;
      for (const ComparedMetric& metric : compared_metrics) known.push_back(metric.name);
      throw std::invalid_argument(
          fmt::format("unknown metric \"{}\" (there are: {})", name.substr(0, 100), fmt::join(known, ", ")));
    }
    if (std::ranges::find(result, found) == result.end()) result.push_back(found);
  }
  return result;
}

void note_missing_runs(VariantComparison& comparison, const Variant& side, std::string_view name, std::size_t used) {
  if (const auto all = static_cast<std::size_t>(side.study.runs); used < all) {
    comparison.notes.push_back(
        fmt::format("{}: {} of {} runs are left out: not there, with points missing, or without a partner.", name,
                    all - used, all));
  }
}

}  // namespace

std::vector<Variant> variants(const Store& store, const StudyEntry& study) {
  std::map<std::string, std::vector<SolveRecord>> solves;
  for (SolveRecord& solve : store.solves(study.name)) solves[solve.solver].push_back(std::move(solve));
  const std::vector<Session> sessions = store.sessions();
  std::vector<Variant> result;
  for (const Series& series : study.series) {
    StudyEntry alone = study;
    alone.series = {series};
    Variant variant{.series = series, .study = make_study(alone, std::move(solves[series.label]))};
    std::set<std::int64_t> used;
    for (const SolveRecord& solve : variant.study.solves) used.insert(solve.session);
    for (const Session& session : sessions) {
      if (used.contains(session.id)) variant.sessions.push_back(session);
    }
    result.push_back(std::move(variant));
  }
  return result;
}

VariantComparison compare_variants(const Variant& a, const Variant& b, std::span<const std::string> metrics,
                                   const MarginQuestion& question) {
  const std::vector<const ComparedMetric*> asked = chosen(metrics);
  const Design design = design_of(a, b);
  VariantComparison comparison{.label = a.series.label == b.series.label
                                            ? b.series.label
                                            : fmt::format("{} against {}", b.series.label, a.series.label),
                               .paired = design.paired,
                               .design = sentence_of(design, a.study.points)};
  const std::string why_not_timed = why_times_differ(a, b);
  for (const ComparedMetric* metric : asked) {
    const std::vector<double> of_a = means(design.a, *metric), of_b = means(design.b, *metric);
    const bool is_time = metric->name == "seconds";
    comparison.metrics.push_back(compare_metric({.metric = *metric,
                                                 .a = of_a,
                                                 .b = of_b,
                                                 .paired = design.paired,
                                                 .same_bits = has_same_bits(design, *metric),
                                                 .tests = static_cast<int>(asked.size()),
                                                 .not_compared = is_time && !why_not_timed.empty() ? "see below" : ""},
                                                question));
    const std::string note = why_not_timed.empty() ? other_sessions_note(a, b) : why_not_timed;
    if (is_time && !note.empty()) comparison.notes.push_back(note);
  }
  decide(comparison.metrics, question);
  note_missing_runs(comparison, a, "A", design.a.size());
  note_missing_runs(comparison, b, "B", design.b.size());
  comparison.notes.push_back(differences(a, b));
  return comparison;
}

}  // namespace ikbench
