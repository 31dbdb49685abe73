#include "analysis/report/study_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <utility>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/design.hpp"
#include "analysis/inference/estimand.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/inference/times.hpp"
#include "analysis/inference/trials.hpp"
#include "analysis/report/summary.hpp"
#include "analysis/report/words.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/proportion.hpp"
#include "analysis/statistics/quantile.hpp"
#include "numerics/json.hpp"

namespace ikbench::report {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace fmt::literals;

namespace {

void add_notes(Table& table, const StudyResults& study) {
  table.notes.emplace_back(study.plan.unit == Unit::point ? words::points : words::means_and_medians);
  for (std::string& note : status_notes(study)) table.notes.push_back(std::move(note));
}

void add_timing_notes(Table& table, const StudyResults& study) {
  const Doubts doubts = times_doubts(study) + outlier_doubts(study);
  std::ranges::move(list_of(doubts), std::back_inserter(table.notes));
}

// Adds a row per solver: the average of its observations of each metric.
void add_averages(Table& table, const StudyResults& study, std::span<const Metric> metrics,
                  const std::vector<Cell>& before) {
  const std::size_t first = table.rows.size();
  for (const std::string& solver : study.solvers) {
    table.rows.push_back(before);
    table.rows.back().emplace_back(solver);
  }
  for (const Metric metric : metrics) {
    std::size_t row = first;
    for (const Sample& sample : samples(study, metric)) {
      table.rows[row++].emplace_back(average_in(statistics::describe(sample.values), metric));
    }
  }
}

Cell count(std::int64_t number) { return number; }

void leave_out_test(Table& table) {
  for (const char* name : {"F", "p"}) {
    const auto column = std::ranges::find(table.columns, name) - table.columns.begin();
    for (auto& row : table.rows) row[static_cast<std::size_t>(column)] = {};
  }
}

}  // namespace

Table results_table(const StudyResults& study, std::span<const Metric> metrics) {
  Table table{.name = "results",
              .caption = "What was reached",
              .columns = {"algorithm", "metric", "mean", "median", "std", "max", "min"}};
  for (const Metric metric : metrics) {
    for (const Sample& sample : samples(study, metric)) {
      const Description of = statistics::describe(sample.values);
      table.rows.push_back(
          {sample.solver, Id{std::string(name_of(metric))}, of.mean, of.median, of.std, of.max, of.min});
    }
  }
  add_notes(table, study);
  if (std::isfinite(tolerance_cm(study))) table.notes.push_back(fmt::format(words::as_measured, "penalty"_a = penalty));
  add_timing_notes(table, study);
  return table;
}

Table baselines_table(const JudgedStudies& studies) {
  const std::vector<Metric> metrics = reported_metrics();
  Table table{.name = "baselines",
              .caption = "Averages of other studies with the same targets",
              .columns = {"study", "algorithm"}};
  for (const Metric metric : metrics) table.columns.push_back(std::string(name_of(metric)));
  for (const StudyResults& study : studies) {
    add_averages(table, study, metrics, {study.name});
    for (const std::string& note : list_of(times_doubts(study))) table.notes.push_back(study.name + ": " + note);
  }
  return table;
}

StudyAnova anova(const StudyResults& study, Metric metric) {
  StudyAnova result;
  std::vector<std::vector<double>> groups;
  for (Sample& sample : samples(study, metric)) {
    const Description description = statistics::describe(sample.values);
    if (description.n == 0 || description.not_finite > 0) {
      result.left_out.push_back(fmt::format(words::anova_without, "solver"_a = sample.solver,
                                            "lost"_a = description.not_finite, "n"_a = description.n));
    } else {
      groups.push_back(std::move(sample.values));
    }
  }
  result.table = statistics::anova(groups);
  return result;
}

std::array<std::vector<Cell>, 3> anova_cells(const AnovaTable& table) {
  const auto df = [](double number) { return count(static_cast<std::int64_t>(number)); };
  return {{{table.ss_between, df(table.df), table.ms_between, table.statistic, PValue{table.p}},
           {table.ss_within, df(table.df_within), table.ms_within, {}, {}},
           {table.ss_total, df(table.df + table.df_within), {}, {}, {}}}};
}

Table anova_table(const StudyResults& study, Metric metric) {
  Table table{.name = fmt::format("anova-{}", info_of(metric).slug),
              .caption = fmt::format("One-way ANOVA of the {}", quantity(metric)),
              .columns = {"source", "SS", "df", "MS", "F", "p"}};
  const bool is_judged = is_comparable(study, metric);
  const StudyAnova ours = anova(is_judged ? compared_in(study, metric) : study, metric);
  const auto cells = anova_cells(ours.table);
  for (std::size_t i = 0; i < anova_sources.size(); ++i) {
    std::vector<Cell>& row = table.rows.emplace_back(1, std::string(anova_sources[i]));
    row.insert(row.end(), cells[i].begin(), cells[i].end());
  }
  if (!is_judged) leave_out_test(table);
  if (is_judged && !ours.table.undefined.empty())
    table.notes.push_back(fmt::format(words::anova_undefined, "why"_a = ours.table.undefined));
  table.notes.insert(table.notes.end(), ours.left_out.begin(), ours.left_out.end());
  add_notes(table, study);
  if (!is_judged) table.notes.push_back(fmt::format(words::anova_not_judged, "why"_a = words_of(timing_doubts(study))));
  if (is_judged) std::ranges::move(list_of(left_out(study, metric)), std::back_inserter(table.notes));
  return table;
}

Table solved_table(const StudyResults& study) {
  const double level = 1 - study.plan.significance;
  const Trials trials = trials_of(study);
  Table table{.name = "solved",
              .caption = "Share of solves with the status ok",
              .columns = {"algorithm", "solves", "solved", "share", fmt::format("{} interval", percent(level))}};
  const std::vector<std::uint32_t> targets = target_numbers(study);
  for (const SolverCounts& solver : counts(study)) {
    std::set<std::uint32_t> own_targets;
    for (const Solve& solve : solves_of(study, solver.solver)) {
      own_targets.insert(targets[static_cast<std::size_t>(&solve - study.solves.data())]);
    }
    const auto independent = trials == Trials::runs      ? solver.complete_runs + solver.incomplete_runs
                             : trials == Trials::targets ? static_cast<int>(own_targets.size())
                                                         : solver.solves;
    const int solved = solver.of(Status::ok);
    const Estimate share = wilson_of_mean(static_cast<double>(solved) / solver.solves, independent, level);
    table.rows.push_back(
        {solver.solver, count(solver.solves), count(solved), share.value, Range{share.low, share.high}});
  }
  table.notes.emplace_back(words::solved);
  if (trials != Trials::solves) {
    table.notes.push_back(fmt::format(words::trials, "trial"_a = trials == Trials::runs ? "run" : "target"));
  }
  table.notes.emplace_back(words::wilson);
  return table;
}

Table times_table(const StudyResults& study) {
  constexpr double ms_per_second = 1000;
  const double deadline = deadline_seconds(study);
  const bool says_solved = std::isfinite(deadline) && std::isfinite(tolerance_cm(study));
  Table table{.name = "times",
              .caption = "Computing times of all solves",
              .columns = {"algorithm", "median_ms", "p95_ms", "p99_ms", "longest_ms", "over_deadline"}};
  if (says_solved) table.columns.push_back("solved_in_time");
  for (const std::string& solver : study.solvers) {
    std::vector<double> seconds;
    std::int64_t in_time = 0;
    for (const Solve& solve : solves_of(study, solver)) {
      seconds.push_back(value_of(study, solve, Metric::seconds));
      in_time += solve.status == Status::ok && solve.seconds <= deadline ? 1 : 0;
    }
    const std::vector<double> ranked = ranked_values(seconds);
    std::vector<Cell> row{solver};
    for (const double p : {0.5, 0.95, 0.99, 1.0}) {
      row.emplace_back(ms_per_second * quantile(ranked, p, QuantileType{study.plan.quartiles}));
    }
    const auto late = std::ranges::count_if(seconds, [&](double time) { return !(time <= deadline); });
    row.push_back(std::isfinite(deadline) && !seconds.empty()
                      ? Cell(static_cast<double>(late) / static_cast<double>(seconds.size()))
                      : Cell());
    if (says_solved) row.emplace_back(static_cast<double>(in_time) / static_cast<double>(seconds.size()));
    table.rows.push_back(std::move(row));
  }
  table.notes.emplace_back(words::percentiles);
  if (std::isfinite(deadline)) {
    table.notes.push_back(fmt::format(words::deadline, "deadline"_a = rounded_number(ms_per_second * deadline, 6)));
  }
  add_timing_notes(table, study);
  return table;
}

Table status_table(const StudyResults& study) {
  Table table{.name = "status",
              .caption = "From planned solves to observations, checked by the independent verifier",
              .columns = {"algorithm", "planned", "not_solved"},
              .notes = status_notes(study)};
  const std::vector<Status> statuses = shown_statuses(study);
  for (const Status status : statuses) table.columns.push_back(std::string(name_of(status)));
  table.columns.insert(table.columns.end(), {"observations", "outside_limits", "worst_outside_deg"});
  const Observations analysed = observations(study, Metric::position_error_cm);
  for (const SolverCounts& solver : counts(study)) {
    std::vector<Cell> row{solver.solver, solver.expected, std::max<std::int64_t>(0, solver.expected - solver.solves)};
    for (const Status status : statuses) row.push_back(count(solver.of(status)));
    const Group* const group = group_named(analysed.groups, solver.solver);
    row.push_back(count(group == nullptr ? 0 : static_cast<std::int64_t>(group->values.size())));
    row.push_back(count(solver.outside_limits));
    row.emplace_back(solver.worst_outside_deg);
    table.rows.push_back(std::move(row));
  }
  table.notes.emplace_back(words::statuses);
  add_timing_notes(table, study);
  return table;
}

namespace {

bool has_solver(const StudyResults& study, const std::string& solver) {
  return std::ranges::find(study.solvers, solver) != study.solvers.end();
}

double mean_of_sample(const std::vector<Sample>& samples, const std::string& solver) {
  return statistics::describe(std::ranges::find(samples, solver, &Sample::solver)->values).mean;
}

// Mean over the answers that are not refused. After a refused answer the arm stays, so its variation is 0.
double accepted_mean(const StudyResults& study, const std::string& solver, double Solve::*value) {
  std::vector<double> values;
  for (const Solve& solve : solves_of(study, solver)) {
    if (!stays(solve.status)) values.push_back(solve.*value);
  }
  return statistics::describe(values).mean;
}

Table table_of(const JudgedStudy& free, const JudgedStudy& enforced) {
  Table table{.name = "limits",
              .caption = "Results with enforced joint limits",
              .columns = {"algorithm", "study", "limits", "mean_position_error_cm", "mean_accepted_error_cm",
                          "mean_variation_deg", "mean_accepted_variation_deg", "outside_limits"}};
  std::set<Status> statuses;
  for (const JudgedStudy* study : {&free, &enforced}) {
    for (const Status status : shown_statuses(*study)) statuses.insert(status);
  }
  for (const Status status : statuses) table.columns.push_back(std::string(name_of(status)));
  for (const auto& [study, other, limits] :
       {std::tuple(&free, &enforced, "recorded"), std::tuple(&enforced, &free, "enforced")}) {
    const std::vector<Sample> errors = samples(*study, Metric::position_error_cm),
                              variations = samples(*study, Metric::variation_deg);
    for (const SolverCounts& count : counts(*study)) {
      const std::string& solver = count.solver;
      if (!has_solver(*other, solver)) continue;
      std::vector<Cell>& row = table.rows.emplace_back(std::vector<Cell>{
          solver, study->name, std::string(limits), mean_of_sample(errors, solver),
          accepted_mean(*study, solver, &Solve::position_error_cm), mean_of_sample(variations, solver),
          accepted_mean(*study, solver, &Solve::variation_deg), std::int64_t{count.outside_limits}});
      for (const Status status : statuses) row.emplace_back(std::int64_t{count.of(status)});
    }
    const Sentence leader = leader_sentence(*study, Metric::position_error_cm, Estimand::mean);
    table.notes.push_back(fmt::format("{}: {}", limits, words_of(leader)));
    for (const std::string& note : status_notes(*study)) table.notes.push_back(study->name + ": " + note);
  }
  table.notes.emplace_back(words::limits);
  return table;
}

}  // namespace

std::optional<Table> limits_table(const JudgedStudies& studies) {
  if (studies.empty()) return std::nullopt;
  const JudgedStudy& reported = studies.front();
  for (const JudgedStudy& other : studies) {
    const bool in_common =
        std::ranges::any_of(reported.solvers, [&](const std::string& solver) { return has_solver(other, solver); });
    if (other.facts.enforces_limits == reported.facts.enforces_limits || !in_common) continue;
    return other.facts.enforces_limits ? table_of(reported, other) : table_of(other, reported);
  }
  return std::nullopt;
}

namespace {

using SortedJson = nlohmann::json;

std::string text_of_json(const SortedJson& value) {
  return value.is_string() ? value.get<std::string>() : numerics::text_of(value);
}

// One row per value: path.kind, helix.
void add_values(std::vector<std::vector<Cell>>& rows, const SortedJson& value, const std::vector<Cell>& before,
                const std::string& path) {
  if (value.is_object() && !value.empty()) {
    for (const auto& [key, inner] : value.items()) {
      add_values(rows, inner, before, path.empty() ? key : fmt::format("{}.{}", path, key));
    }
    return;
  }
  std::vector<Cell> row = before;
  row.emplace_back(path);
  row.emplace_back(value.is_object() ? std::string() : text_of_json(value));
  rows.push_back(std::move(row));
}

// Text that is no JSON is shown as it stands.
SortedJson parsed(const std::string& text) {
  SortedJson value = numerics::parsed_json(text);
  return value.is_discarded() ? SortedJson(text) : value;
}

// Turns the command of a part into that of the whole study: removes the part and its folder.
std::string of_whole(const std::string& command) {
  static const std::regex part(R"( (?:'--(?:shard|out)=[^']*'|--(?:shard|out)[= ](?:'[^']*'|\\.|[^\s'\\])+))");
  return std::regex_replace(command, part, "");
}

}  // namespace

Table definition_table(const StudyEntry& entry) {
  Table table{.name = "definition", .caption = "Definition of the study", .columns = {"setting", "value"}};
  add_values(table.rows, parsed(entry.definition), {}, "");
  return table;
}

Table options_table(const StudyEntry& entry) {
  Table table{
      .name = "options", .caption = "Options of the solvers", .columns = {"solver", "algorithm", "option", "value"}};
  for (const Series& series : entry.series) {
    add_values(table.rows, parsed(series.options), {series.label, series.algorithm}, "");
  }
  return table;
}

Table plan_table(const StudyEntry& entry, const AnalysisPlan& used, std::vector<std::string> notes) {
  Table table{.name = "analysis-plan",
              .caption = "How the study is judged",
              .columns = {"method", "value", "meaning"},
              .notes = std::move(notes)};
  for (const auto& [field, text, meaning] : values_of(used)) table.rows.push_back({field, text, meaning});
  if (const std::string given = changes_between(plan_of(entry), used); !given.empty()) {
    table.notes.push_back(fmt::format(words::plan_changed, "changes"_a = given));
  }
  return table;
}

Table environment_table(const StudyResults& study, const std::vector<Session>& sessions) {
  Table table{.name = "environment", .caption = "Environment", .columns = {"fact", "value", "sessions"}};
  const SolvesOfSessions solves = solves_of_sessions(study);
  std::map<std::pair<std::string, std::string>, std::string> where;  // (fact, value) to its sessions
  for (const Session& session : sessions) {
    if (!solves.contains(session.id)) continue;
    for (const auto& fact : session.environment) {
      std::string& list = where[fact];
      list += fmt::format("{}{}", list.empty() ? "" : ", ", session.id);
    }
  }
  for (const auto& [fact, list] : where) table.rows.push_back({fact.first, fact.second, list});
  std::string note = "Solves by session:";
  for (const auto& [session, count] : solves) note += fmt::format(" {} ({})", session, count);
  table.notes.push_back(note + ".");
  return table;
}

std::string command_of(const StudyResults& study, const std::vector<Session>& sessions) {
  std::int64_t last = 0;
  for (const auto& [session, count] : solves_of_sessions(study)) last = std::max(last, session);
  for (const Session& session : sessions) {
    const auto command = session.environment.find("command");
    if (session.id != last || command == session.environment.end()) continue;
    return session.environment.contains("shard") ? of_whole(command->second) : command->second;
  }
  return "";
}

bool same_targets(const StudyResults& a, const StudyResults& b) {
  const auto place = [](const Solve* solve) { return std::pair(solve->run, solve->point); };
  const std::vector<const Solve*> places = places_of(a);
  bool met = false;
  for (const Solve& solve : b.solves) {
    const auto found = std::ranges::lower_bound(places, place(&solve), {}, place);
    if (found == places.end() || place(*found) != place(&solve)) continue;
    if (!same_target(problem_of(a, **found), problem_of(b, solve))) return false;
    met = true;
  }
  return met && a.points == b.points;
}

}  // namespace ikbench::report
