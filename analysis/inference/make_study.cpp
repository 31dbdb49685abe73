#include "analysis/inference/make_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "analysis/inference/analysis_plan.hpp"
#include "analysis/inference/comparable.hpp"
#include "analysis/inference/study_facts.hpp"
#include "numerics/json.hpp"

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

// A whole number of the definition; 0 if missing.
int defined_number(const StudyEntry& study, const nlohmann::json& of, const char* key, int most) {
  const auto found = of.is_object() ? of.find(key) : of.end();
  if (found == of.end() || !found->is_number_integer()) return 0;
  const auto value = found->get<double>();  // a double also holds numbers beyond every integer
  if (value > most) {
    throw std::invalid_argument(fmt::format("study '{}': {} {}; expected at most {}", study.name, key, value, most));
  }
  return value < 0 ? 0 : static_cast<int>(value);
}

StudyResults of_entry(const StudyEntry& entry) {
  const auto json = numerics::parsed_json(entry.definition);
  const auto path = json.is_object() ? json.find("path") : json.end();
  StudyResults study{.name = entry.name,
                     .runs = defined_number(entry, json, "runs", most_runs),
                     .points = defined_number(entry, json, "points", most_points),
                     .plan = plan_of(entry),
                     .facts = facts_of(json, entry.definition)};
  if (study.points == 0 && path != json.end()) study.points = defined_number(entry, *path, "points", most_points);
  const auto is_of_task = [](const std::string& departure) { return departure == "robot" || departure == "path.kind"; };
  StudyFacts& facts = study.facts;
  if (std::ranges::any_of(facts.departures, is_of_task)) study.departed_from = std::exchange(facts.published, "");
  for (const Series& series : entry.series) study.solvers.push_back(series.label);
  return study;
}

// Adds facts of the sessions that solved the study.
void add_sessions(StudyResults& study, const std::vector<Series>& series, const std::vector<Session>& sessions) {
  const std::vector<std::int64_t>& used = study.solve_data->sessions;
  std::vector<Session> solving;
  std::ranges::copy_if(sessions, std::back_inserter(solving),
                       [&](const Session& each) { return std::ranges::find(used, each.id) != used.end(); });
  study.cpus = machines_of(solving);
  for (const Series& one : series) {
    const bool is_of_library = std::ranges::any_of(
        solving, [&](const Session& each) { return each.environment.contains("library." + one.algorithm); });
    if (is_of_library || !text_option(one.options, "process").empty()) {
      study.external.push_back(one.label);
    }
  }
}

// Orders solves by solver, run and point. Solvers keep the study's order, others follow by first solve.
void sort(std::vector<SolveRecord>& solves, const std::vector<std::string>& solvers) {
  std::map<std::string, std::size_t> place;
  for (const std::string& solver : solvers) place.try_emplace(solver, place.size());
  for (const SolveRecord& solve : solves) place.try_emplace(solve.solver, place.size());
  std::ranges::stable_sort(
      solves, {}, [&](const SolveRecord& solve) { return std::tuple(place.at(solve.solver), solve.run, solve.point); });
}

}  // namespace

StudyMaker::StudyMaker(const StudyEntry& entry, std::size_t solves) : study_(of_entry(entry)), series_(entry.series) {
  solves_.reserve(solves);
}

void StudyMaker::check(const SolveRecord& record) const {
  const auto refuse = [&](const std::string& what) {
    throw std::invalid_argument(fmt::format("study '{}', solver '{}': run {}, point {}{}", study_.name, record.solver,
                                            record.run, record.point, what));
  };
  if (record.run < 1 || record.run > most_runs || record.point < 1 || record.point > most_points) {
    refuse(fmt::format("; expected runs 1 to {} and points 1 to {}", most_runs, most_points));
  }
  for (const std::vector<double>* list : {&record.answer_rad, &record.start_rad, &record.target_position_m,
                                          &record.target_rotation, &record.reached_position_m}) {
    if (list->size() > most_joints) {
      refuse(fmt::format(" has a list of {} numbers; expected at most {}", list->size(), most_joints));
    }
  }
}

std::uint16_t StudyMaker::number_of(const std::string& solver) {
  if (!solves_.empty() && study_.solvers[solves_.back().solver] == solver) return solves_.back().solver;
  const auto found = std::ranges::find(study_.solvers, solver);
  const auto number = static_cast<std::uint16_t>(found - study_.solvers.begin());
  if (found != study_.solvers.end()) return number;
  study_.solvers.push_back(solver);
  if (study_.solvers.size() > most_solvers) {
    throw std::invalid_argument(
        fmt::format("study '{}' has more than {} solvers; expected no more", study_.name, most_solvers));
  }
  return number;
}

void StudyMaker::add(const SolveRecord& record) {
  check(record);
  const std::uint16_t solver = number_of(record.solver);
  if (!solves_.empty()) {
    const Solve& last = solves_.back();
    const std::tuple before{last.solver, last.run, last.point}, here{solver, record.run, record.point};
    if (before == here) {
      throw std::invalid_argument(fmt::format("study '{}', solver '{}': run {}, point {} appears twice; expected once",
                                              study_.name, record.solver, record.run, record.point));
    }
    if (here < before) throw std::logic_error("solves are not passed on by solver, run and point");
  }
  study_.runs = std::max(study_.runs, record.run);
  study_.points = std::max(study_.points, record.point);
  solves_.push_back(condensed(record, solver));
}

StudyResults StudyMaker::finish(const std::vector<Session>& sessions) {
  const auto solvers = static_cast<std::int64_t>(study_.solvers.size());
  if (const std::int64_t expected = std::int64_t{study_.runs} * study_.points; expected * solvers > most_solves) {
    throw std::invalid_argument(
        fmt::format("study '{}' has {} runs of {} points by {} solvers; expected at most {} solves", study_.name,
                    study_.runs, study_.points, solvers, most_solves));
  }
  end_run();
  data_.labels = study_.solvers;
  data_.of_solver.resize(study_.solvers.size());
  data_.problems.forget_index();
  study_.solves = SolveList(std::move(solves_));
  study_.solve_data = std::make_shared<const SolveData>(std::move(data_));
  add_sessions(study_, series_, sessions);
  return std::move(study_);
}

StudyResults make_study(const StudyEntry& entry, std::vector<SolveRecord> solves,
                        const std::vector<Session>& sessions) {
  std::vector<std::string> labels;
  for (const Series& series : entry.series) labels.push_back(series.label);
  sort(solves, labels);
  StudyMaker maker(entry);
  for (const SolveRecord& solve : solves) maker.add(solve);
  return maker.finish(sessions);
}

StudyResults make_study(std::string name, std::vector<SolveRecord> solves) {
  return make_study(StudyEntry{.name = std::move(name), .definition = {}, .series = {}}, std::move(solves));
}

StudyResults read_study(const Store& store, const StudyEntry& entry) {
  StudyMaker maker(entry, static_cast<std::size_t>(store.solves_of(entry.series)));
  store.each_of_study(entry, [&](const SolveRecord& solve) { maker.add(solve); });
  return maker.finish(store.sessions());
}

}  // namespace ikbench::inference
