#include "experiments/targets.hpp"

#include <fmt/format.h>

#include <map>
#include <stdexcept>
#include <utility>

#include "base/csv.hpp"
#include "base/json.hpp"
#include "base/number.hpp"
#include "numerics/random.hpp"
#include "robots/urdf.hpp"

namespace ikbench::experiments {

namespace {

constexpr std::size_t part_of_targets = 1 << 20;  // bytes that are written at a time

void refuse_chain(const results::StudySpec& study) {
  if (study.is_chained())
    throw std::invalid_argument(fmt::format(
        "{} has start = \"previous\": each solve begins at the solver's own answer, so there are no targets "
        "to answer elsewhere; expected another start",
        study.name));
}

std::string header_of_targets(const std::vector<std::string>& joints) {
  std::vector<std::string> cells{"run", "point", "target", "x", "y", "z", "qx", "qy", "qz", "qw"};
  for (const std::string& joint : joints) cells.push_back("start_" + joint);
  std::string text;
  base::append_csv_row(text, cells);
  return text;
}

void append_target(std::string& text, std::pair<int, int> place, const Pose& target, const Configuration& start) {
  Eigen::Quaterniond turned(target.linear());
  if (turned.w() < 0) turned.coeffs() = -turned.coeffs();
  text += fmt::format("{},{},{}", place.first, place.second, target_digest(target, start));
  const auto append_all = [&](const auto& values) {
    for (const double value : values) {
      text += ',';
      base::append(text, value);
    }
  };
  append_all(target.translation());
  append_all(turned.coeffs());  // x, y, z, w
  append_all(start);
  text += '\n';
}

// Returns the names of a stored arm's joints, which its URDF file gave.
std::vector<std::string> stored_joint_names(const results::StoredStudy& study, std::size_t joints) {
  const base::Json arm = base::parsed_json(study.definition.arm);
  std::vector<std::string> names;
  for (std::size_t j = 0; j < joints; ++j) {
    const base::Json link = arm.contains("links") && j < arm["links"].size() ? arm["links"][j] : base::Json();
    const bool has_name = link.contains("name") && link["name"].is_string();
    names.push_back(has_name ? link["name"].get<std::string>() : fmt::format("joint_{}", j + 1));
  }
  return names;
}

}  // namespace

std::string target_digest(const Pose& target, const Configuration& start) {
  std::string text;
  const auto append_exact = [&](double value) {
    base::append(text, value + 0.0);  // a store keeps no sign of a zero
    text += ' ';
  };
  for (const double value : target.matrix().reshaped()) append_exact(value);
  for (const double value : start) append_exact(value);
  return fmt::format("{:016x}", numerics::Key(0).with(text).value());
}

std::vector<Configuration> all_starts_of_run(const Study& study, const Robot& arm, int run) {
  std::vector<Configuration> starts = starts_of_run(study, arm, run);
  if (starts.empty()) starts.assign(static_cast<std::size_t>(study.path->points()), study.initial);
  return starts;
}

void write_targets(const Study& study, const base::Write& write) {
  refuse_chain(study);
  const Robot arm = robot_of(study);
  std::string text = header_of_targets(robots::joint_names(arm));
  for (int run = 1; run <= study.runs; ++run) {
    const std::vector<Pose> targets = targets_of_run(study, arm, run);
    const std::vector<Configuration> starts = all_starts_of_run(study, arm, run);
    for (std::size_t i = 0; i < targets.size(); ++i) {
      append_target(text, {run, static_cast<int>(i) + 1}, targets[i], starts[i]);
      if (text.size() < part_of_targets) continue;
      write(text);
      text.clear();
    }
  }
  write(text);
}

void write_targets(const results::Store& store, const results::StoredStudy& study, const base::Write& write) {
  refuse_chain(study.definition);
  std::map<std::pair<int, int>, std::string> rows;
  std::size_t joints = 0;
  store.for_each_in_study(study, [&](const results::SolveRecord& solve) {
    joints = solve.start_rad.size();
    std::string& row = rows[{solve.run, solve.point}];
    if (!row.empty() || solve.target_position_m.size() != 3 || solve.target_rotation.size() != 9) return;
    Pose target = Pose::Identity();
    target.translation() = Eigen::Map<const Eigen::Vector3d>(solve.target_position_m.data());
    target.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(solve.target_rotation.data());
    const Configuration start = Eigen::Map<const Eigen::VectorXd>(solve.start_rad.data(), std::ssize(solve.start_rad));
    append_target(row, {solve.run, solve.point}, target, start);
  });
  if (rows.empty())
    throw std::invalid_argument(fmt::format("study {} has no solve yet, so its targets are not stored", study.name));
  write(header_of_targets(stored_joint_names(study, joints)));
  for (const auto& [place, row] : rows) write(row);
}

}  // namespace ikbench::experiments
