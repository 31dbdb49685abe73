#include "analysis/report_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "analysis/descriptive.hpp"
#include "analysis/paper_tables.hpp"
#include "analysis/published_numbers.hpp"
#include "analysis/text.hpp"
#include "analysis/welch.hpp"
#include "results/published.hpp"

namespace ikbench {
namespace {

// A solver with observations here and a printed mean.
struct Pair {
  std::string solver;
  Description ours;
  double printed;
};

// In the printed order, the smallest first.
std::vector<Pair> pairs(const std::vector<Comparison>& rows, Metric metric) {
  std::vector<Pair> result;
  for (const Comparison& row : rows) {
    if (row.metric != metric || !std::isfinite(row.paper_mean) || row.ours.n == 0) continue;
    result.push_back({row.solver, row.ours, row.paper_mean});
  }
  std::ranges::stable_sort(result, {}, &Pair::printed);
  return result;
}

// A mean that is not defined, for an answer that is not finite, ranks as the worst.
double rank_of(const Pair& pair) {
  return std::isfinite(pair.ours.mean) ? pair.ours.mean : std::numeric_limits<double>::infinity();
}

std::string short_number(double value) { return std::isfinite(value) ? rounded_number(value, 3) : "not defined"; }

// The printed ranking against ours: holds when all stand in the same order, in part when at least the first is the
// same.
std::optional<Finding> ranking(const std::vector<Comparison>& rows, Metric metric, std::string_view what,
                               std::string_view unit) {
  const std::vector<Pair> printed = pairs(rows, metric);
  if (printed.size() < 2) return std::nullopt;
  std::vector<Pair> ours = printed;
  std::ranges::stable_sort(ours, {}, rank_of);
  int all = 0, in_order = 0;
  for (std::size_t i = 0; i < printed.size(); ++i) {
    for (std::size_t j = i + 1; j < printed.size(); ++j) {
      ++all;
      if (rank_of(printed[i]) < rank_of(printed[j])) ++in_order;
    }
  }
  std::string order, list;
  for (const Pair& pair : printed) order += (order.empty() ? "" : " < ") + pair.solver;
  for (const Pair& pair : ours) {
    list += fmt::format("{}{} {} {}", list.empty() ? "" : ", ", pair.solver, short_number(pair.ours.mean), unit);
  }
  const bool same_first = ours.front().solver == printed.front().solver;
  return Finding{.claim = fmt::format("{}: {}", what, order),
                 .verdict = in_order == all ? Verdict::holds
                            : same_first    ? Verdict::in_part
                                            : Verdict::does_not_hold,
                 .evidence = fmt::format("Here: {}. {} of {} pairs stand in the printed order; first is {}{}.", list,
                                         in_order, all, ours.front().solver, same_first ? ", as printed" : ""),
                 .table = "table-3"};
}

std::optional<Finding> most_accurate(const std::vector<Comparison>& rows) {
  std::vector<Pair> all = pairs(rows, Metric::position_error_cm);
  if (all.size() < 2 || all.front().solver != time_reference) return std::nullopt;
  const Pair first = all.front();
  std::ranges::stable_sort(all, {}, rank_of);
  const bool holds = all.front().solver == first.solver;
  const Pair& other = holds ? all[1] : all.front();
  return Finding{
      .claim = fmt::format("{} is the most accurate", first.solver),
      .verdict = holds ? Verdict::holds : Verdict::does_not_hold,
      .evidence = fmt::format("Mean position error {} cm (printed {}); {} comes to {} cm, {} times as much.",
                              short_number(first.ours.mean), short_number(first.printed), other.solver,
                              short_number(other.ours.mean), short_number(other.ours.mean / first.ours.mean)),
      .table = "table-3"};
}

// The paper's solver moves the joints less than another: by Welch's test over run means, since two means always differ.
struct Contrast {
  Verdict verdict;
  std::string evidence;
};
Contrast contrast(const Pair& reference, const Pair& other, Unit unit) {
  const WelchTest test = welch({.mean = reference.ours.mean, .std = reference.ours.std, .n = reference.ours.n},
                               {.mean = other.ours.mean, .std = other.ours.std, .n = other.ours.n});
  const bool known = unit == Unit::run && std::isfinite(test.p);
  const Verdict verdict = !known || test.p >= significance        ? Verdict::undecided
                          : reference.ours.mean < other.ours.mean ? Verdict::holds
                                                                  : Verdict::does_not_hold;
  return {verdict, fmt::format("{} {} deg{}", other.solver, short_number(other.ours.mean),
                               known ? fmt::format(" (p = {})", rounded_number(test.p, 2)) : "")};
}

std::vector<Finding> variation(const std::vector<Comparison>& rows, Unit unit) {
  const std::vector<Pair> all = pairs(rows, Metric::variation_deg);
  if (all.size() < 2 || all.front().solver != time_reference) return {};
  const Pair& reference = all.front();
  const std::string ours = fmt::format("{} moves the joints by {} deg a point (printed {}); ", reference.solver,
                                       short_number(reference.ours.mean), short_number(reference.printed));
  const std::string_view how =
      unit == Unit::run ? " Welch's test over run means." : " Points of one run depend on each other: no test.";
  const Contrast nearest = contrast(reference, all[1], unit);
  std::vector<Finding> result{
      {.claim = fmt::format("{} moves the joints less than {}", reference.solver, all[1].solver),
       .verdict = nearest.verdict,
       .evidence = fmt::format("{}{}; printed {}.{}", ours, nearest.evidence, short_number(all[1].printed), how),
       .table = "table-3"}};
  if (all.size() == 2) return result;
  Verdict worst = Verdict::holds;
  std::string list;
  for (std::size_t i = 2; i < all.size(); ++i) {
    const Contrast other = contrast(reference, all[i], unit);
    worst = std::max(worst, other.verdict);
    list += (list.empty() ? "" : ", ") + other.evidence;
  }
  result.push_back({.claim = fmt::format("{} moves the joints less than the other solvers", reference.solver),
                    .verdict = worst,
                    .evidence = fmt::format("{}{}.{}", ours, list, how),
                    .table = "table-3"});
  return result;
}

std::optional<Finding> solvers_differ(const StudyResults& study, Unit unit) {
  constexpr std::array<Metric, 3> metrics{Metric::position_error_cm, Metric::variation_deg, Metric::seconds};
  std::string list;
  int alike = 0;
  for (const Metric metric : metrics) {
    if (!comparable_printed_anova(study, metric, unit)) return std::nullopt;
    const AnovaTable table = anova(study, metric, unit).table;
    if (!std::isfinite(table.p)) return std::nullopt;
    if (table.p >= significance) ++alike;
    list += fmt::format("{}{} F = {}, p = {}", list.empty() ? "" : "; ", name_of(metric), short_number(table.F),
                        rounded_number(table.p, 2));
  }
  return Finding{.claim = "The solvers differ in error, variation and time (ANOVA)",
                 .verdict = alike == 0   ? Verdict::holds
                            : alike == 3 ? Verdict::does_not_hold
                                         : Verdict::in_part,
                 .evidence = list + ".",
                 .table = "table-4"};
}

std::optional<Finding> inside_limits(const StudyResults& study) {
  for (const SolverCounts& count : counts(study)) {
    if (count.solver != time_reference || count.solves == 0) continue;
    return Finding{.claim = fmt::format("{}'s answers are inside the joint limits (Eq. 4)", count.solver),
                   .verdict = count.outside_limits == 0 ? Verdict::holds : Verdict::does_not_hold,
                   .evidence = count.outside_limits == 0
                                   ? fmt::format("All of {} are.", count.solves)
                                   : fmt::format("{} of {} are not, the worst joint by {} deg.", count.outside_limits,
                                                 count.solves, short_number(count.worst_outside_deg)),
                   .table = "status"};
  }
  return std::nullopt;
}

bool has_table(const StudyResults& study, std::string_view name) {
  const auto tables = published::tables(study.published);
  return std::ranges::find(tables, name) != tables.end();
}

// Table 7's first row. Twenty targets a second is real time.
std::optional<Finding> real_time(const StudyResults& study) {
  constexpr double real_time_ms = 50, near_cm = 0.1;
  std::vector<double> milliseconds;
  int reached = 0;
  for (const SolveRecord& solve : study.solves) {
    if (solve.solver != "12 bats") continue;
    milliseconds.push_back(1000 * solve.seconds);
    if (solve.position_error_cm <= near_cm) ++reached;
  }
  if (milliseconds.empty() || !has_table(study, "table-7")) return std::nullopt;
  const double slowest = std::ranges::max(milliseconds);
  const bool all_reached = reached == static_cast<int>(milliseconds.size());
  return Finding{
      .claim = "With 12 bats IK-BA answers in real time",
      .verdict = slowest >= real_time_ms ? Verdict::does_not_hold
                 : all_reached           ? Verdict::holds
                                         : Verdict::in_part,
      .evidence = fmt::format("{} ms a target, the slowest {} ms (printed mean {} ms, on another machine; real time is "
                              "below {} ms); {} of {} targets within {} cm.",
                              short_number(mean(milliseconds)), short_number(slowest),
                              published::table(study.published, "table-7").number(0, "mean_ms"), real_time_ms, reached,
                              milliseconds.size(), near_cm),
      .table = "table-7"};
}

// Table 8: how near the circle's points are reached, against the mean of the printed errors.
std::optional<Finding> circle(const StudyResults& study) {
  if (!study.name.ends_with("-dobot") || study.solves.empty() || !has_table(study, "table-8")) return std::nullopt;
  const CsvTable table = published::table(study.published, "table-8");
  std::vector<double> printed, ours;
  for (std::size_t row = 0; row < table.rows.size(); ++row) printed.push_back(table.number(row, "error_cm"));
  for (const SolveRecord& solve : study.solves) ours.push_back(solve.position_error_cm);
  return Finding{.claim = "IK-BA leads the Dobot Magician along a circle to rounding error",
                 .verdict = mean(ours) <= 2 * mean(printed) ? Verdict::holds : Verdict::does_not_hold,
                 .evidence = fmt::format("Mean error {} cm over {} points (printed errors: {} cm on average).",
                                         short_number(mean(ours)), ours.size(), short_number(mean(printed))),
                 .table = "table-8"};
}

// Times that were taken among other work decide nothing.
std::optional<Finding> comparable_times(const StudyResults& study, std::optional<Finding> finding) {
  const std::string note = timing_note(study);
  if (!finding || note.empty()) return finding;
  finding->verdict = Verdict::undecided;
  finding->evidence += ' ' + note;
  return finding;
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  constexpr std::array<std::string_view, 4> names{"holds", "in part", "undecided", "does not hold"};
  return names[static_cast<std::size_t>(verdict)];
}

std::string tally(const std::vector<Finding>& findings) {
  const auto count = [&](Verdict verdict) { return std::ranges::count(findings, verdict, &Finding::verdict); };
  std::string text = fmt::format("Of {} findings {} hold here", findings.size(), count(Verdict::holds));
  if (count(Verdict::in_part) > 0) text += fmt::format(", {} in part", count(Verdict::in_part));
  if (count(Verdict::does_not_hold) > 0) text += fmt::format(", {} not", count(Verdict::does_not_hold));
  if (count(Verdict::undecided) > 0) text += fmt::format("; {} cannot be decided", count(Verdict::undecided));
  return text + '.';
}

std::vector<Finding> findings(const StudyResults& study, const std::vector<StudyResults>& companions, Unit unit) {
  std::vector<Finding> result;
  const auto add = [&](std::optional<Finding> finding) {
    if (finding) result.push_back(std::move(*finding));
  };
  const std::vector<Comparison> rows = compare(study, unit);
  const auto is_printed = [](const Comparison& row) { return std::isfinite(row.paper_mean); };
  if (std::ranges::any_of(rows, is_printed)) {
    add(most_accurate(rows));
    add(ranking(rows, Metric::position_error_cm, "Accuracy", "cm"));
    for (Finding& finding : variation(rows, unit)) result.push_back(std::move(finding));
    add(comparable_times(study, ranking(rows, Metric::seconds, "Computing time", "s")));
    add(solvers_differ(study, unit));
    add(inside_limits(study));
  }
  add(comparable_times(study, real_time(study)));
  add(circle(study));
  for (const StudyResults& companion : companions) {
    add(comparable_times(companion, real_time(companion)));
    add(circle(companion));
  }
  return result;
}

}  // namespace ikbench
