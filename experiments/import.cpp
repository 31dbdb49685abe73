#include "experiments/import.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

#include "experiments/import_rows.hpp"
#include "experiments/recheck.hpp"
#include "experiments/study.hpp"
#include "numerics/functions.hpp"
#include "numerics/json.hpp"
#include "numerics/random.hpp"
#include "numerics/units.hpp"
#include "solvers/bounds.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;
using namespace results;

namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

std::vector<double> numbers_of(const Eigen::VectorXd& values) { return {values.begin(), values.end()}; }

Eigen::VectorXd joints_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

// The study into which solves are imported, with the targets and starts of its stored solves.
class ReceivingStudy {
 public:
  ReceivingStudy(const Store& store, const std::string& name) : entry_(store.study(name)), arm_(arm_in(entry_)) {
    requirement_ = requirement_of(entry_);
    requirement_.orientation_is_exact = false;  // no wrist of ours completed the answers
    const auto definition = numerics::parsed_json(entry_.definition);
    is_chained_ = definition.value("start", "previous") == "previous";
    is_wrapped_ = definition.value("wrap", "no") == "into_limits";
    if (definition.contains("analysis")) plan_ = numerics::text_of(definition["analysis"]);
    for (SolveRecord& solve : store.solves(name)) {
      if (solve.timing == Timing::imported) continue;
      points_ = std::max(points_, solve.point);
      const std::pair place(solve.run, solve.point);
      solves_.try_emplace(place, std::move(solve));
    }
    if (solves_.empty())
      throw std::invalid_argument(fmt::format("study '{}' has no solves, and so no targets; run it first", name));
  }

  const StudyEntry& entry() const { return entry_; }
  const Robot& arm() const { return arm_; }
  const std::string& plan() const { return plan_; }
  int points() const { return points_; }
  bool is_chained() const { return is_chained_; }

  // A stored solve of the same run and point; std::invalid_argument if there is none.
  const SolveRecord& at(const ImportedRow& row) const {
    const auto found = solves_.find({row.run, row.point});
    if (found != solves_.end()) return found->second;
    throw std::invalid_argument(
        fmt::format("{}: run {}, point {} is not among the solves of study '{}'; expected runs 1 "
                    "to {} and points 1 to {}",
                    row.where, row.run, row.point, entry_.name, solves_.rbegin()->first.first, points_));
  }

  // Verifies the row's answer into `record`; without an answer the arm stays at `start`.
  void verify_into(SolveRecord& record, const ImportedRow& row, const Eigen::VectorXd& start) const {
    const Pose target = target_of(record);
    Eigen::VectorXd answer = row.answer.empty() ? start : joints_of(row.answer);
    for (Eigen::Index j = 0; is_wrapped_ && j < answer.size(); ++j) {
      if (arm_.chain.links()[static_cast<std::size_t>(j)].joint != Joint::slides)
        answer[j] = solvers::turned_inside(answer[j], arm_.limits.lower[j], arm_.limits.upper[j]);
    }
    Verification verified = verify(arm_, target, start, answer);
    Requirement asked = requirement_;
    asked.claimed_error = verified.position_error;  // the file's error may have few digits
    record.status = row.answer.empty() ? Status::declined : judge(verified, asked);
    if (stays(record.status)) {
      answer = start;
      verified = verify(arm_, target, start, answer);
    }
    record.start_rad = numbers_of(start);
    record.answer_rad = numbers_of(answer);
    write_verified(verified, record);
  }

 private:
  static Robot arm_in(const StudyEntry& entry) {
    if (std::optional<Robot> arm = stored_arm(entry.definition)) return std::move(*arm);
    throw std::invalid_argument(fmt::format("study '{}': its arm cannot be read from the store", entry.name));
  }

  StudyEntry entry_;
  Robot arm_;
  Requirement requirement_;
  bool is_chained_ = true, is_wrapped_ = false;
  std::string plan_ = "{}";
  int points_ = 0;
  std::map<std::pair<int, int>, SolveRecord> solves_;  // by run and point
};

void check_target(const ImportedRow& row, const SolveRecord& asked) {
  for (std::size_t i = 0; i < row.target_position_m.size(); ++i) {
    if (std::abs(row.target_position_m[i] - asked.target_position_m.at(i)) <= 1e-6) continue;
    throw std::invalid_argument(fmt::format(
        "{}: target_position_m_{} is {}, but the target of run {}, point {} has {}; expected solves of this study's targets",
        row.where, i + 1, row.target_position_m[i], row.run, row.point, asked.target_position_m[i]));
  }
}

SolveRecord record_of(const ImportedRow& row, const ReceivingStudy& asked) {
  const SolveRecord& other = asked.at(row);
  check_target(row, other);
  const double half_angle = row.orientation_error_deg.value_or(not_known) * degree / 2;
  return {.study = other.study,
          .robot = other.robot,
          .solver = row.label,
          .run = row.run,
          .point = row.point,
          .target_position_m = other.target_position_m,
          .target_rotation = other.target_rotation,
          .position_error_cm = row.position_error_cm.value_or(not_known),
          .claimed_error_cm = not_known,
          .orientation_error = std::sqrt(8.0 / 3) * sin_cos(half_angle).sine,  // ||R - Rd|| / ||Rd||
          .variation_deg = not_known,
          .largest_move_deg = not_known,
          .limit_violation_deg = not_known,
          .evaluations = row.evaluations.value_or(0),
          .stop_reason = StopReason::finished,
          .status = Status::not_verified,
          .seconds = row.seconds.value_or(not_known),
          .cpu_seconds = not_known,
          .timing = Timing::imported,
          .smallest_seconds = not_known,
          .largest_seconds = not_known,
          .interruptions = not_known,
          .variation_m = not_known,
          .limit_violation_m = not_known,
          .transport_seconds = not_known,
          .counted_by = row.evaluations ? CountedBy::solver : CountedBy::nobody};
}

// The rows of one solver by run and point. check_whole checks that every run has all its points.
using Places = std::map<std::pair<int, int>, const ImportedRow*>;

void check_whole(const Places& places, int points) {
  std::map<int, int> of_run;
  for (const auto& [place, row] : places) ++of_run[place.first];
  for (const auto& [place, row] : places) {
    if (of_run[place.first] == points) continue;
    int missing = 1;
    while (places.contains({place.first, missing})) ++missing;
    throw std::invalid_argument(fmt::format(
        "{}: run {} of {} has no point {}; expected all {} points of a run (a row without an answer where the "
        "solver gave none)",
        row->where, place.first, row->label, missing, points));
  }
}

std::vector<SolveRecord> records_of(const Places& places, const ReceivingStudy& asked, ImportedSolver& told) {
  const bool has_answers = std::ranges::any_of(places, [](const auto& each) { return !each.second->answer.empty(); });
  std::vector<SolveRecord> records;
  for (const auto& [place, row] : places) {
    SolveRecord& record = records.emplace_back(record_of(*row, asked));
    const bool has_error = row->position_error_cm.has_value();
    if (row->answer.empty() && has_error == has_answers) {
      throw std::invalid_argument(fmt::format(
          "{}: {}", row->where,
          has_answers ? "an error, but no answer, where other rows have answers; expected an answer, or neither"
                      : "neither an answer nor an error; expected position_error_cm, that of the arm at rest where the "
                        "solver gave no answer"));
    }
    ++told.solves;
    if (!has_answers) continue;
    const bool follows = asked.is_chained() && place.second > 1;
    const std::vector<double>& start = follows ? records[records.size() - 2].answer_rad : asked.at(*row).start_rad;
    asked.verify_into(record, *row, joints_of(start));
    row->answer.empty() ? ++told.without_answer : ++told.verified;
    if (has_error && !row->answer.empty()) {
      const double apart = std::abs(*row->position_error_cm - record.position_error_cm);
      told.largest_mistake_cm = std::max(told.largest_mistake_cm, stays(record.status) ? 0 : apart);
    }
  }
  return records;
}

Series series_of(const StudyEntry& entry, const ImportRequest& request, const std::string& label) {
  const auto hash = [](const Key& key) { return fmt::format("{:016x}", key.value()); };
  const Key configuration = Key(0).with("imported").with(entry.name).with(entry.definition).with(label);
  return {.key = hash(configuration) + before_source + hash(Key(0).with(request.digest)),
          .label = label,
          .algorithm = std::string(imported_algorithm),
          .options = numerics::text_of(nlohmann::json{{"file", request.source}})};
}

std::int64_t begin_session(Store& store, const ImportRequest& request, const ReceivingStudy& asked,
                           const std::vector<SolveRecord>& records) {
  std::map<std::string, std::string> session{{"command", request.command},
                                             {"imported", request.source},
                                             {"imported_sha256", request.digest},
                                             {"analysis", asked.plan()}};
  // An unknown processor keeps reports from comparing these times with ours.
  if (std::ranges::any_of(records, [](const SolveRecord& each) { return std::isfinite(each.seconds); }))
    session["cpu"] = fmt::format("unknown, imported from {}", request.source);
  return store.begin_session(session);
}

}  // namespace

Imported import_solves(Store& store, const ImportRequest& request) {
  const ReceivingStudy asked(store, request.study);
  const ImportedRows read =
      read_imported_rows(request.text, request.source, request.label, joint_units(asked.arm().chain));
  std::vector<std::pair<std::string, Places>> solvers;  // in the file's order
  for (const ImportedRow& row : read.rows) {
    auto solver = std::ranges::find(solvers, row.label, &std::pair<std::string, Places>::first);
    if (solver == solvers.end()) solver = solvers.insert(solvers.end(), {row.label, {}});
    const auto [earlier, is_new] = solver->second.try_emplace({row.run, row.point}, &row);
    if (!is_new) {
      throw std::invalid_argument(fmt::format("{}: run {}, point {} of {} is there already ({}); expected each once",
                                              row.where, row.run, row.point, row.label, earlier->second->where));
    }
  }
  StudyEntry entry = asked.entry();
  Imported imported{.solvers = {}, .unread = read.unread};
  std::vector<SolveRecord> all;
  for (const auto& [label, places] : solvers) {
    const auto same = std::ranges::find(entry.series, label, &Series::label);
    if (same != entry.series.end() && !is_imported(*same)) {
      throw std::invalid_argument(
          fmt::format("{}: the study has a solver named '{}' of its own; expected another name: "
                      "--label, or the column `solver`",
                      places.begin()->second->where, label));
    }
    for (const auto& [place, row] : places) asked.at(*row);
    check_whole(places, asked.points());
    ImportedSolver& told = imported.solvers.emplace_back(ImportedSolver{.label = label});
    std::vector<SolveRecord> records = records_of(places, asked, told);
    const Series series = series_of(entry, request, label);
    for (SolveRecord& record : records) record.series = series.key;
    if (same != entry.series.end()) {
      *same = series;
    } else {
      entry.series.push_back(series);
    }
    told.is_stored_already = store.series_of_configuration(configuration_of(series.key)).contains(series.key);
    if (!told.is_stored_already) std::ranges::move(records, std::back_inserter(all));
  }
  if (!all.empty()) {
    const std::int64_t session = begin_session(store, request, asked, all);
    for (SolveRecord& record : all) record.session = session;
    store.append(all);
  }
  store.save_study(entry);
  return imported;
}

}  // namespace ikbench::experiments
