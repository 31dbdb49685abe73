#include "analysis/inference/study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <stdexcept>
#include <tuple>

#include "analysis/inference/analysis_plan.hpp"
#include "analysis/inference/definition.hpp"
#include "analysis/inference/machines.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "numerics/number.hpp"

namespace ikbench::inference {

using namespace numerics;
using namespace results;
using namespace statistics;

namespace {

constexpr int most_runs = 1'000'000;
constexpr int most_points = 100'000;
constexpr std::size_t most_solvers = 1000;
constexpr std::size_t most_joints = 64;
constexpr std::int64_t most_solves = 100'000'000;

// A whole number of the definition, at the top or inside one of its parts; 0 where it does not say.
int defined_number(const std::string& study, const nlohmann::json& definition, const char* key, int most) {
  const auto read = [&](const nlohmann::json& object) {
    const auto found = object.find(key);
    if (found == object.end() || !found->is_number_integer()) return 0;
    const double value = found->get<double>();  // also where it is beyond every integer
    if (value > most) {
      throw std::invalid_argument(fmt::format("study '{}': {} {}; expected at most {}", study, key, value, most));
    }
    return value < 0 ? 0 : static_cast<int>(value);
  };
  if (!definition.is_object()) return 0;
  if (const int top = read(definition)) return top;
  for (const auto& part : definition) {
    if (!part.is_object()) continue;
    if (const int inside = read(part)) return inside;
  }
  return 0;
}

void check_and_count(StudyResults& study) {
  std::set<std::tuple<std::string, int, int>> seen;
  for (const SolveRecord& solve : study.solves) {
    if (solve.run < 1 || solve.run > most_runs || solve.point < 1 || solve.point > most_points) {
      throw std::invalid_argument(
          fmt::format("study '{}', solver '{}': run {}, point {}; expected runs 1 to {} and points 1 to {}", study.name,
                      solve.solver, solve.run, solve.point, most_runs, most_points));
    }
    if (!seen.emplace(solve.solver, solve.run, solve.point).second) {
      throw std::invalid_argument(fmt::format("study '{}', solver '{}': run {}, point {} appears twice; expected once",
                                              study.name, solve.solver, solve.run, solve.point));
    }
    if (solve.answer_rad.size() > most_joints) {
      throw std::invalid_argument(
          fmt::format("study '{}', solver '{}': run {}, point {} has {} joints; expected at most {}", study.name,
                      solve.solver, solve.run, solve.point, solve.answer_rad.size(), most_joints));
    }
    if (std::ranges::find(study.solvers, solve.solver) == study.solvers.end()) study.solvers.push_back(solve.solver);
    study.runs = std::max(study.runs, solve.run);
    study.points = std::max(study.points, solve.point);
    if (study.solvers.size() > most_solvers) {
      throw std::invalid_argument(
          fmt::format("study '{}' has more than {} solvers; expected no more", study.name, most_solvers));
    }
  }
  const auto solvers = static_cast<std::int64_t>(study.solvers.size());
  if (const std::int64_t expected = std::int64_t{study.runs} * study.points; expected * solvers > most_solves) {
    throw std::invalid_argument(
        fmt::format("study '{}' has {} runs of {} points by {} solvers; expected at most {} solves", study.name,
                    study.runs, study.points, solvers, most_solves));
  }
}

// The solves of one solver, by run, in the order of their points.
std::map<int, std::vector<const SolveRecord*>> runs_of(const StudyResults& study, const std::string& solver) {
  std::map<int, std::vector<const SolveRecord*>> runs;
  for (const SolveRecord& solve : study.solves) {
    if (solve.solver == solver) runs[solve.run].push_back(&solve);
  }
  for (auto& [number, run] : runs) std::ranges::sort(run, {}, &SolveRecord::point);
  return runs;
}

TaskFacts task_of(const Definition& definition) {
  const std::string search = definition.text("/search");
  TaskFacts facts{
      .is_path = !definition.draws_targets(), .orientation = search != "all_joints", .pose = search == "pose"};
  for (std::size_t joint = 0; joint < most_joints; ++joint) {
    if (definition.text(fmt::format("/arm/links/{}/joint", joint)) == "slides") facts.slides.insert(joint);
  }
  return facts;
}

// The solvers of which not all evaluations were counted.
std::set<std::string_view> uncounted(const StudyResults& study) {
  std::set<std::string_view> found;
  for (const SolveRecord& solve : study.solves) {
    if (solve.counted_by == CountedBy::nobody) found.insert(solve.solver);
  }
  return found;
}

bool complete(const std::vector<const SolveRecord*>& run, const StudyResults& study) {
  return static_cast<int>(run.size()) == study.points;
}

}  // namespace

StudyResults make_study(const StudyEntry& entry, std::vector<SolveRecord> solves,
                        const std::vector<Session>& sessions) {
  const auto definition = nlohmann::json::parse(entry.definition, nullptr, false);
  StudyResults study{.name = entry.name,
                     .runs = defined_number(entry.name, definition, "runs", most_runs),
                     .points = defined_number(entry.name, definition, "points", most_points),
                     .plan = plan_of(entry),
                     .definition = entry.definition,
                     .solves = std::move(solves)};
  study.title = Definition(entry.definition).text("/title");
  study.published = Definition(entry.definition).text("/published");
  study.task = task_of(Definition(entry.definition));
  if (definition.is_object() && definition.contains("departures") && definition["departures"].is_array()) {
    for (const auto& departure : definition["departures"]) {
      if (departure.is_string()) study.departures.push_back(departure.get<std::string>());
    }
  }
  for (const Series& series : entry.series) study.solvers.push_back(series.label);
  std::set<std::int64_t> used;
  for (const SolveRecord& solve : study.solves) used.insert(solve.session);
  std::vector<Session> solving;
  std::ranges::copy_if(sessions, std::back_inserter(solving),
                       [&](const Session& each) { return used.contains(each.id); });
  study.cpus = machines_of(solving);
  for (const Series& series : entry.series) {
    const Definition options(series.options);
    const bool is_of_library = std::ranges::any_of(
        solving, [&](const Session& each) { return each.environment.contains("library." + series.algorithm); });
    if (is_of_library || !options.text("/process").empty() || !options.text("/shared_object").empty())
      study.outside.push_back(series.label);
  }
  for (const Session& session : solving) {
    const auto stolen = session.environment.find("stolen_seconds");
    const auto seconds = stolen != session.environment.end() ? number_from(stolen->second) : std::nullopt;
    if (seconds) study.stolen_seconds = (std::isnan(study.stolen_seconds) ? 0 : study.stolen_seconds) + *seconds;
  }
  check_and_count(study);
  return study;
}

StudyResults make_study(std::string name, std::vector<SolveRecord> solves) {
  StudyResults study{.name = std::move(name), .solves = std::move(solves)};
  check_and_count(study);
  return study;
}

bool enforces_limits(const StudyResults& study) { return Definition(study.definition).text("/limits") == "enforced"; }

double tolerance_cm(const StudyResults& study) {
  const double tolerance = Definition(study.definition).number("/stop/tolerance_cm");
  return tolerance > 0 ? tolerance : not_defined;
}

double deadline_seconds(const StudyResults& study) {
  const Definition definition(study.definition);
  const double deadline = definition.number("/deadline_ms") / 1000, stop = definition.number("/stop/seconds");
  return deadline > 0 ? deadline : stop > 0 ? stop : not_defined;
}

std::vector<Sample> samples(const StudyResults& study, Metric metric) {
  std::vector<Sample> result = samples(study, [&](Run run) { return value_of(study, run, metric); });
  if (metric != Metric::evaluations) return result;
  const std::set<std::string_view> without = uncounted(study);
  for (Sample& sample : result) {
    if (without.contains(sample.solver)) sample.values.clear();
  }
  return result;
}

OfRun averaged(ValueOf value_of, Average average) {
  return [value_of = std::move(value_of), average](Run run) {
    std::vector<double> values;
    for (const SolveRecord* solve : run) values.push_back(value_of(*solve));
    return average(values);
  };
}

std::vector<Sample> samples(const StudyResults& study, const OfRun& value_of) {
  std::vector<Sample> result;
  for (const std::string& solver : study.solvers) {
    Sample sample{.solver = solver};
    for (const auto& [number, run] : runs_of(study, solver)) {
      if (study.plan.unit == Unit::point) {
        for (const SolveRecord* const& solve : run) sample.values.push_back(value_of(Run(&solve, 1)));
      } else if (complete(run, study)) {
        sample.values.push_back(value_of(run));
      } else {
        ++sample.incomplete_runs;
      }
    }
    result.push_back(std::move(sample));
  }
  return result;
}

Average average_of(Metric metric) { return info_of(metric).kind == Kind::time ? median : mean; }

std::string_view average_name(Metric metric) { return info_of(metric).kind == Kind::time ? "median" : "mean"; }

double average_in(const Description& of, Metric metric) {
  return info_of(metric).kind == Kind::time ? of.median : of.mean;
}

std::vector<SolverCounts> counts(const StudyResults& study) {
  std::vector<SolverCounts> result;
  for (const std::string& solver : study.solvers) {
    SolverCounts count{.solver = solver, .expected = std::int64_t{study.runs} * study.points};
    for (const auto& [number, run] : runs_of(study, solver)) {
      ++(complete(run, study) ? count.complete_runs : count.incomplete_runs);
      for (const SolveRecord* solve : run) {
        ++count.solves;
        ++count.by_status[static_cast<std::size_t>(solve->status)];
        ++count.by_timing[static_cast<std::size_t>(solve->timing)];
        if (solve->limit_violation_deg > 0 || solve->limit_violation_m > 0) ++count.outside_limits;
        count.worst_outside_deg = std::max(count.worst_outside_deg, solve->limit_violation_deg);
      }
    }
    result.push_back(count);
  }
  return result;
}

std::vector<Status> shown_statuses(const StudyResults& study) {
  std::vector<Status> shown;
  for (std::size_t i = 0; i < status_names.size(); ++i) {
    const auto status = static_cast<Status>(i);
    const bool occurred = std::ranges::find(study.solves, status, &SolveRecord::status) != study.solves.end();
    if (occurred || status <= Status::not_finite) shown.push_back(status);
  }
  return shown;
}

StudyResults counted(StudyResults study) {
  const std::set<std::string_view> views = uncounted(study);
  const std::set<std::string, std::less<>> without(views.begin(), views.end());
  std::erase_if(study.solves, [&](const SolveRecord& solve) { return without.contains(solve.solver); });
  std::erase_if(study.solvers, [&](const std::string& solver) { return without.contains(solver); });
  if (without.contains(study.plan.control)) study.plan.control.clear();
  return study;
}

std::string uncounted_note(const StudyResults& study) {
  const std::set<std::string_view> without = uncounted(study);
  return without.empty() ? ""
                         : fmt::format("Nobody counted the evaluations of {}.",
                                       one_line(fmt::format("{}", fmt::join(without, ", "))));
}

std::vector<std::string> status_notes(const StudyResults& study) {
  std::vector<int> by_status(status_names.size());
  const std::vector<Status> shown = shown_statuses(study);
  int solves = 0;
  std::int64_t expected = 0;
  int incomplete_runs = 0;
  for (const SolverCounts& count : counts(study)) {
    for (std::size_t i = 0; i < by_status.size(); ++i) by_status[i] += count.by_status[i];
    solves += count.solves;
    expected += count.expected;
    incomplete_runs += count.incomplete_runs;
  }
  std::string note = fmt::format("Solves: {} of {} expected; by status:", solves, expected);
  for (const Status status : shown) {
    note += fmt::format("{} {} {}", status == shown.front() ? "" : ",", name_of(status),
                        by_status[static_cast<std::size_t>(status)]);
  }
  std::vector<std::string> notes{note + "."};
  if (solves < expected) {
    notes.push_back(
        fmt::format("The study is incomplete. Runs with missing points: {}; they have no mean, and only complete runs "
                    "are observations.",
                    incomplete_runs));
  }
  if (by_status[static_cast<std::size_t>(Status::refused)] > 0) {
    notes.push_back(
        "A refused answer leaves the arm where it was: the error that counts is the one it has there, and its "
        "variation "
        "is 0.");
  }
  if (std::ranges::any_of(shown, is_without_answer)) {
    notes.push_back(
        "A program that crashed, timed out, broke the protocol or declined gave no answer: the arm stays where it was, "
        "and the error that counts is the one it has there. Such a solve has no time, no evaluations and no move: in "
        "these it ranks last.");
  }
  if (by_status[static_cast<std::size_t>(Status::not_finite)] > 0) {
    notes.push_back(
        "Answers that are not finite are not left out: a run that has one has no mean error, ranks as the worst in "
        "median "
        "and quartiles, and leaves the mean, standard deviation and maximum of its solver not defined.");
  }
  return notes;
}

namespace {

// Whether a solve that is recorded as clean took longer than it had the processor. A program may wait for much else, so
// that of its solves this is the time for which it waited for a processor, without what messages cost in any case.
bool is_disturbed(const SolveRecord& solve) {
  constexpr double most = 0.1;  // waited, by the time without
  if (solve.timing == Timing::process)
    return solve.waited_seconds > most * solve.seconds + solve.round_trips * solve.transport_seconds;
  return solve.timing == Timing::clean && solve.seconds > (1 + most) * solve.cpu_seconds && solve.cpu_seconds > 0;
}

struct Disturbed {
  std::ptrdiff_t solves = 0, timed = 0;
};

Disturbed disturbed(const StudyResults& study) {
  const auto is_timed = [](const SolveRecord& solve) {
    return solve.timing == Timing::clean || solve.timing == Timing::process;
  };
  return {std::ranges::count_if(study.solves, is_disturbed), std::ranges::count_if(study.solves, is_timed)};
}

// Where solves end by their wall time, more than times depend on the machine.
std::string and_errors(const StudyResults& study) {
  return Definition(study.definition).number("/stop/seconds") > 0
             ? " Solves end by their wall time, so that errors depend on that too."
             : "";
}

}  // namespace

bool times_were_disturbed(const StudyResults& study) {
  const Disturbed found = disturbed(study);
  return found.solves > 1 && 10 * found.solves > found.timed;
}

std::string timing_note(const StudyResults& study) {
  const auto timed = [&](Timing how) { return std::ranges::count(study.solves, how, &SolveRecord::timing); };
  const auto parallel = timed(Timing::parallel), debug = timed(Timing::debug_build);
  if (parallel + debug > 0) {
    return fmt::format(
        "Times are not comparable: of {} solves, {} ran in parallel with others and {} in a debug build.{}",
        study.solves.size(), parallel, debug, and_errors(study));
  }
  if (std::string note = cpu_note(study.cpus); !note.empty()) return note + and_errors(study);
  if (!times_were_disturbed(study)) return "";
  const Disturbed found = disturbed(study);
  return fmt::format(
      "Times are not comparable: {} of {} solves took more than 1.1 times their CPU time{}, so other programs were "
      "running.{}",
      found.solves, found.timed, timed(Timing::process) > 0 ? ", or waited as long for a processor" : "",
      and_errors(study));
}

std::string transport_note(const StudyResults& study) {
  std::vector<std::string> found;
  for (const std::string& solver : study.solvers) {
    std::vector<double> shares;
    for (const SolveRecord& solve : study.solves) {
      const double transport = solve.round_trips * solve.transport_seconds;
      if (solve.solver == solver && transport >= 0 && solve.seconds > 0) shares.push_back(transport / solve.seconds);
    }
    if (!shares.empty() && median(shares) >= 0.5) found.push_back(one_line(solver));
  }
  return found.empty() ? ""
                       : fmt::format("At least half of the time of {} is transport: messages to the program and back.",
                                     fmt::join(found, ", "));
}

std::string evaluation_note(const StudyResults& study) {
  const bool has_both = !study.outside.empty() && study.outside.size() < study.solvers.size();
  if (!has_both || !times_are_comparable(study)) return "";
  return fmt::format(
      "Times depend on how candidates are evaluated: built-in swarms evaluate many at once, which costs less each; {} "
      "(library, program or shared object) may evaluate one by one.",
      one_line(fmt::format("{}", fmt::join(study.outside, ", "))));
}

std::string cpu_note(const std::set<std::string>& cpus) {
  return cpus.size() < 2
             ? ""
             : fmt::format("Times are not comparable: they come from different machines ({}).", fmt::join(cpus, ", "));
}

bool times_are_comparable(const StudyResults& study) { return timing_note(study).empty(); }

bool is_comparable(const StudyResults& study, Metric metric) {
  return info_of(metric).kind != Kind::time || times_are_comparable(study);
}

}  // namespace ikbench::inference
