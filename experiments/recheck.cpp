#include "experiments/recheck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "experiments/redrawn_tasks.hpp"
#include "numerics/json.hpp"
#include "numerics/units.hpp"
#include "results/digest.hpp"
#include "robots/spherical_wrist.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;
using namespace results;

// Not in the unnamed namespace, since Recheck::Looking has it as a member.
class Findings {
 public:
  void add(const char* column, const SolveRecord& solve, const std::string& what) {
    Finding& finding = of_column_[column];
    if (finding.solves++ == 0) {
      finding.first = fmt::format("{}, run {}, point {}, session {}: {}", solve.solver, solve.run, solve.point,
                                  solve.session, what);
    }
  }
  // Expects the same number up to rounding, or no number twice. An arm from a URDF file was verified by its origins and
  // axes, but the store has its table, which may be 1e-9 m and rad off.
  void expect(const char* column, const SolveRecord& solve, double stored, double computed, double rounding = 1e-8) {
    const bool is_same = std::isfinite(computed) ? std::abs(stored - computed) <= rounding * (1 + std::abs(computed))
                                                 : !std::isfinite(stored);
    if (!is_same) add(column, solve, fmt::format("{} is stored, {} follows from the answer", stored, computed));
  }
  void expect_at_least(const char* column, const SolveRecord& solve, double stored, double least) {
    if (!(stored >= least) || !std::isfinite(stored))
      add(column, solve, fmt::format("{} is stored, {} or more is possible", stored, least));
  }

  std::vector<std::string> sentences() const {
    std::vector<std::string> all;
    for (const auto& [column, finding] : of_column_)
      all.push_back(fmt::format("Damaged: {} of {} solve{} (first: {}).", column, finding.solves,
                                finding.solves == 1 ? "" : "s", finding.first));
    return all;
  }

 private:
  struct Finding {
    std::int64_t solves = 0;
    std::string first;
  };
  std::map<std::string, Finding> of_column_;
};

namespace {

Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

void look_at_counts(const SolveRecord& solve, Findings& found) {
  found.expect_at_least("evaluations", solve, static_cast<double>(solve.evaluations), 0);
  found.expect_at_least("iterations", solve, static_cast<double>(solve.iterations), 0);
  const std::vector<double>& at = solve.improved_at;
  const bool is_course = std::ranges::all_of(at, [](double count) { return count >= 1 && std::isfinite(count); }) &&
                         std::ranges::is_sorted(at) && at.size() == solve.improved_to_cm.size();
  if (!is_course) found.add("improved_at", solve, "not growing numbers of evaluations, each with an error");
  found.expect_at_least("seconds", solve, solve.seconds, 0);
  found.expect_at_least("cpu_seconds", solve, solve.cpu_seconds, 0);
  found.expect_at_least("repeats", solve, static_cast<double>(solve.repeats), 1);
  found.expect_at_least("smallest_seconds", solve, solve.smallest_seconds, 0);
  constexpr double fastest =
      1e-9;  // [s] an evaluation: a few operations of any processor; forward kinematics takes tens
  if (solve.counted_by == CountedBy::suite && solve.evaluations >= 100 &&
      solve.seconds < fastest * static_cast<double>(solve.evaluations)) {
    found.add("seconds", solve, "less than 1 ns an evaluation, which no processor can do");
  }
  if (solve.smallest_seconds > solve.seconds) found.add("smallest_seconds", solve, "larger than the median");
  found.expect_at_least("interruptions", solve, solve.interruptions, 0);
  found.expect_at_least("largest_seconds", solve, solve.largest_seconds, solve.seconds);
}

void look_at_status(const SolveRecord& solve, const Verification& computed, Requirement requirement, Findings& found) {
  const bool is_silent = solve.counted_by != CountedBy::suite && std::isnan(solve.claimed_error_cm);
  requirement.claimed_error = is_silent ? computed.position_error : solve.claimed_error_cm * centimetre;
  const bool stayed =
      solve.answer_rad == solve.start_rad && (requirement.limits_are_enforced || is_without_answer(solve.status));
  // The store has no refused answers and no claims about whole poses.
  if ((stays(solve.status) && stayed) || solve.status == Status::claimed_but_wrong) return;
  const Status follows =
      solve.stop_reason == StopReason::not_finite ? Status::not_finite : judge(computed, requirement);
  const bool is_in_order = follows == Status::ok || follows == Status::tolerance_missed;
  const bool is_over_budget = is_in_order && is_over(solve, requirement.budget);
  if (solve.status == follows || (solve.status == Status::over_budget && is_over_budget)) return;
  found.add("status", solve,
            fmt::format("{} is stored, {} follows from the answer", name_of(solve.status), name_of(follows)));
}

}  // namespace

// The same for all solves of a study.
struct Checked {
  const Robot& arm;
  const Requirement& requirement;
};

namespace {

void look_at_answer(const Checked& checked, const SolveRecord& solve, Findings& found) {
  const Robot& arm = checked.arm;
  const auto joints = static_cast<std::size_t>(arm.joints());
  if (solve.target_position_m.size() != 3 || solve.target_rotation.size() != 9 || solve.start_rad.size() != joints ||
      solve.answer_rad.size() != joints) {
    found.add("answer_rad", solve, fmt::format("not the sizes of an arm with {} joints", joints));
    return;
  }
  const Pose target = target_of(solve);
  const Verification computed = verify(arm, target, vector_of(solve.start_rad), vector_of(solve.answer_rad));
  found.expect("position_error_cm", solve, solve.position_error_cm, computed.position_error / centimetre, 1e-7);
  found.expect("orientation_error", solve, solve.orientation_error, computed.orientation_error);
  found.expect("variation_deg", solve, solve.variation_deg, computed.variation / degree);
  found.expect("largest_move_deg", solve, solve.largest_move_deg, computed.largest_move / degree);
  found.expect("limit_violation_deg", solve, solve.limit_violation_deg, computed.limit_violation / degree);
  look_at_status(solve, computed, checked.requirement, found);
  const bool is_reached_stored = solve.reached_position_m.size() == 3;
  if (!is_reached_stored) found.add("reached_position_m", solve, "not three numbers");
  for (Eigen::Index i = 0; is_reached_stored && i < 3; ++i) {
    found.expect("reached_position_m", solve, solve.reached_position_m[static_cast<std::size_t>(i)],
                 computed.reached[i]);
  }
  found.expect("variation_m", solve, solve.variation_m, computed.variation_m);
  found.expect("limit_violation_m", solve, solve.limit_violation_m, computed.limit_violation_m);
}

}  // namespace

Pose target_of(const SolveRecord& solve) {
  Pose target = Pose::Identity();
  target.translation() = vector_of(solve.target_position_m);
  target.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(solve.target_rotation.data());
  return target;
}

Requirement requirement_of(const StudyEntry& entry) {
  const auto definition = numerics::parsed_json(entry.definition);
  const auto number = [&](const char* pointer) {
    const nlohmann::json::json_pointer at(pointer);
    return definition.contains(at) && definition[at].is_number() ? definition[at].get<double>() : 0.0;
  };
  const auto is = [&](const char* key, const char* value) {
    return definition.contains(key) && definition[key] == value;
  };
  return {.tolerance = number("/stop/tolerance_cm") * centimetre,
          .angle_tolerance = number("/stop/tolerance_deg") * degree,
          .orientation_is_exact = is("search", "wrist"),
          .limits_are_enforced = is("limits", "enforced"),
          .budget = {number("/stop/seconds"), number("/stop/evaluations")}};
}

struct Recheck::Looking {
  explicit Looking(const StudyEntry& entry) : arm(stored_arm(entry.definition)), requirement(requirement_of(entry)) {
    const auto definition = numerics::parsed_json(entry.definition);
    is_from_urdf = definition.is_object() && definition.contains("urdf");
    if (arm) checked.emplace(*arm, requirement);
    if (arm) asked.emplace(entry, *arm);
  }

  void look_at_digest(const SolveRecord& solve) {
    if (solve.digest != 0 && solve.digest != digest_of(solve))
      found.add("digest", solve, "the solve was changed since it was written");
  }
  void look_at_question(const SolveRecord& solve) {
    const char* const column = asked ? asked->differing_column(solve) : nullptr;
    if (column != nullptr) found.add(column, solve, "it is not what the definition of the study gives");
  }

  const std::optional<Robot> arm;
  const Requirement requirement;
  bool is_from_urdf = false;
  std::optional<Checked> checked = {};  // from `arm` and `requirement`
  std::optional<RedrawnTasks> asked = {};
  bool has_solves = false;
  Findings found = {};
};

Recheck::Recheck(const StudyEntry& entry) : looking_(std::make_unique<Looking>(entry)) {}
Recheck::~Recheck() = default;

void Recheck::look_at(const SolveRecord& solve) {
  looking_->has_solves = true;
  looking_->look_at_digest(solve);
  looking_->look_at_question(solve);
  look_at_counts(solve, looking_->found);
  if (looking_->checked) look_at_answer(*looking_->checked, solve, looking_->found);
}

std::vector<std::string> Recheck::damages() const {
  std::vector<std::string> sentences = looking_->found.sentences();
  // The table of a calibrated URDF arm may be longer than arm files allow; then the checks that need an arm are skipped
  // without a complaint.
  if (!looking_->arm && looking_->has_solves && !looking_->is_from_urdf) {
    sentences.push_back("The arm in the definition cannot be read, so errors and moves were not computed again.");
  }
  return sentences;
}

}  // namespace ikbench::experiments
