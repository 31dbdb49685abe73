#include "analysis/slim2023/circle.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "analysis/figures/axis.hpp"
#include "analysis/figures/figure_parts.hpp"
#include "analysis/figures/study_figures.hpp"
#include "analysis/inference/study_facts.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/slim2023/published_numbers.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "numerics/number.hpp"
#include "numerics/units.hpp"

namespace ikbench::slim2023 {

using namespace numerics;
using namespace results;
using namespace statistics;
using namespace inference;
using namespace figures;
using namespace report;

namespace {

constexpr double printed_rounding_deg = 0.05;         // of an angle that is printed to 0.1 deg
constexpr double printed_mean_error_cm = 2.1196e-14;  // Sec. 6, in the text
constexpr std::size_t angles_of_table = 4;
constexpr std::size_t compared_angles = 3;  // theta4 is printed equal to theta1

using Angles = std::array<double, angles_of_table>;

// theta4 turns the tool about the vertical; if the study's arm has no such joint, it is theta1, as in the paper.
Angles angles_of(const SolveRecord& solve) {
  Angles result;
  for (std::size_t i = 0; i < angles_of_table; ++i) {
    const double angle = i < solve.answer_rad.size() ? solve.answer_rad[i] : not_defined;
    result[i] = angle / degree;
  }
  if (solve.answer_rad.size() == 3) result[3] = result[0];
  return result;
}

struct Row {
  int point = 0;
  Angles ours;
  double error_cm = not_defined;
  std::optional<PrintedPosture> printed = {};
  std::size_t within = 0;             // of the compared angles
  double largest_difference_deg = 0;  // not_defined if one of ours is
};

std::vector<Row> rows_of(const StudyResults& study) {
  const std::vector<PrintedPosture> printed = printed_table_8(study.facts.published);
  std::vector<Row> rows;
  for (const auto& [point, solve] : first_run(study, study.solvers.empty() ? "" : study.solvers.front())) {
    Row row{.point = point, .ours = angles_of(*solve), .error_cm = solve->position_error_cm};
    const auto same = std::ranges::find(printed, point, &PrintedPosture::point);
    if (same != printed.end()) {
      row.printed = *same;
      for (std::size_t i = 0; i < compared_angles; ++i) {
        const double difference = std::abs(row.ours[i] - same->angles_deg[i]);
        if (difference <= printed_rounding_deg + 1e-9) ++row.within;
        row.largest_difference_deg =
            std::isfinite(difference) ? std::max(row.largest_difference_deg, difference) : not_defined;
      }
    }
    rows.push_back(row);
  }
  return rows;
}

std::string verdict(const std::vector<Row>& rows, std::size_t printed_points) {
  std::size_t within = 0, solved = 0;
  double largest = 0;
  std::string others;
  for (const Row& row : rows) {
    if (!row.printed) continue;
    ++solved;
    within += row.within;
    largest = std::isfinite(row.largest_difference_deg) ? std::max(largest, row.largest_difference_deg) : not_defined;
    if (row.within < compared_angles) others += fmt::format("{}{}", others.empty() ? "" : ", ", row.point);
  }
  const std::size_t printed = printed_points * compared_angles;
  std::string text = fmt::format(
      "{} of the {} printed angles (without theta4 = theta1) agree with ours within {} deg, the rounding of the "
      "printed digits",
      within == printed ? "All" : fmt::to_string(within), printed, printed_rounding_deg);
  if (solved > 0) {
    text += std::isfinite(largest) ? fmt::format("; the largest difference is {} deg", rounded_number(largest, 2))
                                   : "; some of our angles are not finite";
  }
  if (!others.empty()) text += "; points with an angle that does not agree: " + others;
  if (solved < printed_points) text += fmt::format("; unsolved points: {}", printed_points - solved);
  return text + ".";
}

// Compares the printed errors with the mean in the text, and names the one misprint that would explain the difference.
std::string printed_errors_note(const std::vector<PrintedPosture>& printed) {
  std::vector<double> errors;
  for (const PrintedPosture& posture : printed) errors.push_back(posture.error_cm);
  const double printed_mean = mean(errors);
  std::string text = fmt::format("The mean of the printed errors is {} cm; the paper's text says {} cm.",
                                 rounded_number(printed_mean, 3), printed_mean_error_cm);
  const auto largest = std::ranges::max_element(errors);
  const auto point = printed[static_cast<std::size_t>(largest - errors.begin())].point;
  const double as_printed = *largest;
  *largest /= 10;
  return text + fmt::format(" With {} instead of {} cm at point {} it would be {} cm.", *largest, as_printed, point,
                            rounded_number(mean(errors), 4));
}

bool is_table_8(const StudyResults& study) {
  return is_circle(study) && !printed_table_8(study.facts.published).empty();
}

}  // namespace

bool is_circle(const StudyResults& study) { return study.facts.path == "circle"; }

std::optional<Table> table_8(const StudyResults& study) {
  if (!is_table_8(study)) return std::nullopt;
  Table table{.name = "table-8",
              .caption = "joint angles and position error along the circle",
              .columns = {"point"},
              .number = 8};
  for (const char* prefix : {"", "paper_"}) {
    for (std::size_t i = 1; i <= angles_of_table; ++i) table.columns.push_back(fmt::format("{}theta{}_deg", prefix, i));
  }
  for (const char* name : {"largest_difference_deg", "error_cm", "paper_error_cm"}) table.columns.emplace_back(name);
  const std::size_t error_column = table.columns.size() - 2;
  const std::vector<Row> rows = rows_of(study);
  std::vector<double> errors;
  for (const Row& row : rows) {
    std::vector<Cell> cells(table.columns.size());  // empty if nothing is printed
    cells[0] = std::int64_t{row.point};
    for (std::size_t i = 0; i < angles_of_table; ++i) cells[1 + i] = row.ours[i];
    cells[error_column] = row.error_cm;
    if (row.printed) {
      for (std::size_t i = 0; i < angles_of_table; ++i) cells[1 + angles_of_table + i] = row.printed->angles_deg[i];
      cells[error_column - 1] = row.largest_difference_deg;
      cells[error_column + 1] = row.printed->error_cm;
    }
    table.rows.push_back(std::move(cells));
    errors.push_back(row.error_cm);
  }
  const std::vector<PrintedPosture> printed = printed_table_8(study.facts.published);
  table.notes.push_back(verdict(rows, printed.size()));
  if (!rows.empty()) {
    const double our_mean = mean(errors);
    table.notes.push_back(std::isfinite(our_mean)
                              ? fmt::format("The mean of our errors is {} cm.", rounded_number(our_mean, 3))
                              : "Some of our answers are not finite, so their mean error is not defined.");
    table.notes.push_back(
        fmt::format("Our numbers are from the first run of {}. theta4 rotates the tool without moving its tip. If the "
                    "arm of the study has three joints, we set theta4 to theta1, as in all printed rows.",
                    study.solvers.front()));
  }
  table.notes.emplace_back(
      "The paper does not print the four lengths of the arm, so we fitted them to the angles of this table. Agreement "
      "therefore tests the closed form and the solver, but not the geometry.");
  table.notes.push_back(printed_errors_note(printed));
  for (std::string& note : status_notes(study)) table.notes.push_back(std::move(note));
  return table;
}

std::optional<Figure> printed_joints_figure(const StudyResults& study, const std::string& name) {
  if (!is_table_8(study)) return std::nullopt;
  std::map<int, std::vector<double>> ours, printed;
  std::vector<double> all;
  for (const Row& row : rows_of(study)) {
    ours[row.point] = {row.ours.begin(), row.ours.end()};
    all.insert(all.end(), row.ours.begin(), row.ours.end());
    if (!row.printed) continue;
    const Angles& angles = row.printed->angles_deg;
    printed[row.point] = {angles.begin(), angles.end()};
    all.insert(all.end(), angles.begin(), angles.end());
  }
  const Axis axis = value_axis(all, {"joint angle", "deg"}, Scale::linear);
  Figure figure{
      .name = name,
      .caption = fmt::format("Joint angles along the circle, in the first run of {}. Joint 4 turns the tool, in the "
                             "paper by the angle of joint 1. Grey: as printed.",
                             study.solvers.front()),
      .settings = axis.settings + point_axis(study.points),
      .data = "# point, then the angle of each joint [deg]\n" + lines_by_point(ours) + "\n\n# as printed\n" +
              lines_by_point(printed)};
  std::vector<std::string> clauses, labels{"as printed"}, limits;
  for (std::size_t joint = 1; joint <= angles_of_table; ++joint) {
    clauses.push_back(fmt::format("'{}.dat' index 1 using 1:{} with points {} {}", name, joint + 1, grey_rings,
                                  joint == 1 ? "title 'as printed'" : "notitle"));
  }
  for (std::size_t joint = 1; joint <= angles_of_table; ++joint) {
    labels.push_back(fmt::format("joint {}", joint));
    clauses.push_back(fmt::format("'{}.dat' index 0 using 1:{} with {} title '{}'", name, joint + 1,
                                  joint == 4 ? "points ls 4 pt 8 ps 0.8" : fmt::format("linespoints ls {}", joint),
                                  labels.back()));
  }
  const auto angles = joint_angles_deg(first_run(study, study.solvers.front()));
  const std::size_t joints = angles.empty() ? 0 : angles.begin()->second.size();
  for (const auto& [joint, lower, upper] : limits_deg(study.facts, joints)) {
    for (const double limit : {lower, upper}) {
      if (joint > angles_of_table || !(limit > axis.low && limit < axis.high)) continue;
      limits.push_back(fmt::format("{} deg (joint {})", rounded_number(limit, 4), joint));
      clauses.push_back(
          fmt::format("{} with lines lw 0.7 dt 2 lc rgb word(colours, {}) notitle", text_of(limit), joint));
    }
  }
  if (!limits.empty()) figure.caption += fmt::format(" Dashed: the joint limits {}.", fmt::join(limits, ", "));
  add_legend(figure, labels);
  figure.plot = plot_command(clauses);
  return figure;
}

std::string printed_angles_verdict(const StudyResults& study) {
  return is_table_8(study) ? "Table 8: " + verdict(rows_of(study), printed_table_8(study.facts.published).size()) : "";
}

}  // namespace ikbench::slim2023
