#include "analysis/figures/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "base/units.hpp"

namespace ikbench::figures {

using namespace judge;
using namespace base;
using results::SolveRecord;

namespace {

constexpr std::size_t most_iterations = 200;  // drawn

CurveRow row_at(double x, const std::vector<double>& values, Average average) {
  const judge::Descriptives all = judge::describe_values(values);
  if (average == Average::mean) return {.x = x, .y = all.mean};
  if (values.size() == 1) return {.x = x, .y = all.median};
  return {.x = x, .y = all.median, .low = all.lower_quartile, .high = all.upper_quartile};
}

}  // namespace

About about_of(const StudyResults& study, const Metric& metric, std::string caption) {
  const auto [unit, factor] = drawn_unit(study, metric.unit);
  if (const std::string calls = timed_calls_text(study); is_time_metric(metric) && !calls.empty())
    caption += fmt::format(" Times: {}.", calls);
  return {"", std::move(caption), std::string(metric.name), unit, factor * metric.resolution};
}

std::vector<std::string> drawn_solvers(const StudyResults& study, const Look& look, bool as_lines) {
  std::vector<std::string> shown = look.style.solvers.empty() ? study.labels : look.style.solvers;
  std::erase_if(shown, [&](const std::string& solver) { return study.of(solver).empty(); });
  if (as_lines && shown.size() > most_lines)
    std::ranges::stable_sort(shown, {}, [&](auto& solver) { return std::ranges::count(look.own, solver) == 0; });
  return shown;
}

DrawnUnit drawn_unit(const StudyResults& study, std::string_view unit) {
  if (unit == "s") return {"ms", 1000};
  if (unit == "cm" && study.definition.published.empty()) return {"mm", 10};
  return {std::string(unit), 1};
}

std::vector<BoxRow> box_rows(const judge::MetricSamples& samples, const DrawnUnit& unit,
                             const std::vector<std::string>& shown, const Look& look) {
  std::vector<BoxRow> rows;
  for (const std::string& name : shown) {
    const Group& group = samples.groups[index_of(samples, name)];
    const judge::Descriptives all = describe(group);
    const std::span<const double> values = values_of(group);
    BoxRow& row = rows.emplace_back(
        BoxRow{.label = look.names.at(name), .style = look.lines.at(name), .values = {values.begin(), values.end()}});
    row.box = {all.smallest, all.lower_quartile, all.median, all.upper_quartile, all.largest};
    for (double& value : row.values) value *= unit.factor;
    for (double& value : row.box) value *= unit.factor;
    if (const auto infinite = std::ranges::count(row.values, INFINITY); infinite > 0)
      row.remark = fmt::format("no answer in {}", infinite);
    if (values.empty())
      row.remark = "no value";
    else if (missing_in(group) > 0)
      row.remark += fmt::format("{}{} missing", row.remark.empty() ? "" : ", ", missing_in(group));
  }
  return rows;
}

std::vector<Line> by_point(const StudyResults& study, std::string_view column, const Look& look, Average average) {
  const Metric& metric = metric_named(column);
  const double factor = drawn_unit(study, metric.unit).factor;
  std::vector<Line> all;
  for (const std::string& solver : drawn_solvers(study, look, true)) {
    if (std::ranges::none_of(study.of(solver), has_answer)) continue;
    std::map<int, std::vector<double>> values;
    for (const SolveSummary& solve : study.of(solver)) {
      const double value = factor * metric.value(solve, study);
      if (std::isfinite(value)) values[solve.point].push_back(value);
    }
    Line& line = all.emplace_back(Line{.label = look.names.at(solver), .style = look.lines.at(solver)});
    for (const auto& [point, of_point] : values) line.rows.push_back(row_at(point, of_point, average));
  }
  return all;
}

std::vector<Line> by_iteration(const StudyResults& study, const Look& look, Average average) {
  const double factor = drawn_unit(study, "cm").factor;
  std::size_t longest = 0;
  for (const SolveRecord& solve : study.plotted) longest = std::max(longest, solve.trace_cm.size());
  const std::size_t n = std::min(longest, most_iterations);
  std::vector<Line> all;
  for (const std::string& solver : drawn_solvers(study, look, true)) {
    Line& line = all.emplace_back(Line{.label = look.names.at(solver), .style = look.lines.at(solver)});
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = n == 1 ? 0 : k * (longest - 1) / (n - 1);
      std::vector<double> values;
      for (const SolveRecord& solve : study.plotted) {
        const std::vector<double>& trace = solve.trace_cm;
        if (solve.label != solver || trace.empty()) continue;
        const double value = factor * trace[std::min(i, trace.size() - 1)];
        if (std::isfinite(value)) values.push_back(value);
      }
      if (!values.empty()) line.rows.push_back(row_at(static_cast<double>(i + 1), values, average));
    }
  }
  return all;
}

std::vector<Corner> corners_of(const robots::Robot& arm, const Eigen::VectorXd& q) {
  std::vector<Corner> corners{{0, 0, 0}};
  const auto add = [&](const Eigen::Vector3d& at) { corners.emplace_back(at / centimetre); };
  robots::Description joints;  // from the base to the corner
  for (const robots::DescribedJoint& joint : arm.description) {
    joints.push_back(joint);
    add(robots::pose_of(joints, q).translation());
  }
  if (joints.empty()) {
    add(arm.chain.base().position);
    std::vector<robots::DhLink> links;
    for (const robots::DhLink& link : arm.chain.links()) {
      links.push_back(link);
      for (const double along_x : {0.0, link.a}) {
        links.back().a = along_x;
        add(robots::Chain(links, arm.chain.base(), {}).position(q.head(static_cast<Eigen::Index>(links.size()))));
      }
    }
    add(arm.chain.position(q));
  }
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());  // a length of 0 is no corner
  return corners;
}

JointRows joint_rows(const StudyResults& study, const Look& look) {
  JointRows all;
  const std::optional<robots::Robot> arm = robots::stored_arm(study.definition.arm);
  if (!arm) return all;
  std::vector<std::size_t> turning;
  for (std::size_t joint = 0; joint < arm->chain.links().size(); ++joint) {
    const auto j = static_cast<Eigen::Index>(joint);
    if (arm->chain.slides(j)) continue;
    turning.push_back(joint);
    all.columns.push_back({fmt::format("{}{}", turning.size() == 1 ? "joint " : "", joint + 1),
                           arm->limits.lower[j] / degree, arm->limits.upper[j] / degree});
  }
  for (const std::string& solver : drawn_solvers(study, look, true)) {
    JointRow row{.label = look.names.at(solver), .style = look.lines.at(solver)};
    for (const SolveRecord& solve : study.first_run_of(solver)) {
      std::vector<double>& angles = row.angles_deg.emplace_back();
      for (const std::size_t joint : turning)
        angles.push_back(joint < solve.answer_rad.size() ? solve.answer_rad[joint] / degree : nowhere);
    }
    all.rows.push_back(std::move(row));
  }
  return all;
}

}  // namespace ikbench::figures
