#include "analysis/slim2023/audit_geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "analysis/inference/text.hpp"
#include "analysis/slim2023/audit_items.hpp"
#include "analysis/slim2023/published_numbers.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "results/published.hpp"

namespace ikbench::slim2023 {

using namespace results;
using namespace statistics;
using namespace report;
using namespace inference;

namespace {

constexpr double degree = std::numbers::pi / 180;

// The three angles that put the Dobot Magician's tool there, elbow up (docs/paper-notes.md 3, item 4).
std::array<double, 3> dobot_angles_deg(const Statements& statements, double x, double y, double z) {
  const double upper = statements.number("dobot_upper_arm_cm"), fore = statements.number("dobot_forearm_cm");
  const double level = std::hypot(x, y) - statements.number("dobot_wrist_to_tool_cm");
  const double rise = z - statements.number("dobot_height_cm");
  const double squared = level * level + rise * rise;
  const double theta2 =
      std::atan2(level, rise) - std::acos((upper * upper + squared - fore * fore) / (2 * upper * std::sqrt(squared)));
  const double theta3 = std::atan2(upper * std::cos(theta2) - rise, level - upper * std::sin(theta2));
  return {std::atan2(y, x) / degree, theta2 / degree, theta3 / degree};
}

// How the helix of Eq. 27 is begun: at an angle, which way round, and in how many intervals to its end.
struct Helix27 {
  int start_deg;
  int sense;
  double intervals;
};

// The farthest wrist centre from the shoulder, with the tool's axis of Eq. 27.
double farthest_wrist(const Statements& statements, const Helix27& helix) {
  const auto number = [&](std::string_view name) { return statements.number(name); };
  const double tool = number("wrist_to_tool_cm");
  double farthest = 0;
  for (int k = 0; k < number("helix_points"); ++k) {
    const double t =
        helix.start_deg * degree + helix.sense * 2 * std::numbers::pi * number("helix_turns") * k / helix.intervals;
    const double x = number("helix_centre_x_cm") + number("helix_radius_cm") * std::cos(t);
    const double y = number("helix_centre_y_cm") + number("helix_radius_cm") * std::sin(t);
    const double z = number("helix_centre_z_cm") + number("helix_length_cm") * k / helix.intervals;
    farthest = std::max(farthest, std::hypot(x - tool * number("tool_axis_x"), y - tool * number("tool_axis_y"),
                                             z - tool * number("tool_axis_z") - number("shoulder_height_cm")));
  }
  return farthest;
}

// The smallest of it over starts in whole steps, both senses and both spacings, and where it is.
std::pair<double, Helix27> nearest_helix(const Statements& statements, int step_deg) {
  std::pair<double, Helix27> nearest{std::numeric_limits<double>::infinity(), {}};
  const double points = statements.number("helix_points");
  for (const double intervals : {points, points - 1}) {
    for (const int sense : {1, -1}) {
      for (int start = 0; start < 360; start += step_deg) {
        const Helix27 helix{start, sense, intervals};
        if (const double distance = farthest_wrist(statements, helix); distance < nearest.first) {
          nearest = {distance, helix};
        }
      }
    }
  }
  return nearest;
}

}  // namespace

AuditItems circle_items(std::string_view paper) {
  const Statements statements(paper);
  const CsvTable table = published::table(paper, "table-8");
  const std::string& said = statements.text("circle_mean_error_cm");
  std::vector<double> errors;
  double slack = 0;
  std::array<double, 3> worst{};
  const std::array<std::string, 3> names{"theta1_deg", "theta2_deg", "theta3_deg"};
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    errors.push_back(table.number(row, "error_cm"));
    slack += half_unit(table.rows[row][table.column("error_cm")]) / static_cast<double>(table.rows.size());
    const double t = 2 * std::numbers::pi * static_cast<double>(row) / static_cast<double>(table.rows.size());
    const double radius = statements.number("circle_radius_cm");
    const std::array<double, 3> angles = dobot_angles_deg(
        statements, statements.number("circle_centre_x_cm") + radius * std::cos(t),
        statements.number("circle_centre_y_cm") + radius * std::sin(t), statements.number("circle_centre_z_cm"));
    for (std::size_t i = 0; i < names.size(); ++i) {
      worst[i] = std::max(worst[i], std::abs(angles[i] - table.number(row, names[i])));
    }
  }
  const double farthest = std::ranges::max(worst);

  AuditItems items;
  items.push_back({"3.4a", "Table 8 and its text: mean error [cm]", said, rounded_number(mean(errors), 4),
                   judged(said, mean(errors), slack, AuditVerdict::misprint),
                   "The mean of the 20 printed errors is not the one in the text."});
  const auto point = static_cast<std::size_t>(std::ranges::max_element(errors) - errors.begin()) + 1;
  std::vector<double> mended = errors;
  mended[point - 1] /= 10;
  items.push_back(
      {"3.4b", fmt::format("Table 8 with {} at point {}", rounded_number(mended[point - 1], 3), point), said,
       rounded_number(mean(mended), 4), judged(said, mean(mended), slack, AuditVerdict::misprint),
       "With a tenth of the largest error, the mean equals that in the text, so its exponent is misprinted."});
  items.push_back({"3.4c", "Table 8: angles of the circle",
                   fmt::format("{} angles to 0.1 deg", names.size() * table.rows.size()),
                   fmt::format("largest difference {} deg", rounded_number(farthest, 2)),
                   unless(farthest <= 0.05 * (1 + 1e-9), AuditVerdict::contradiction),
                   "All follow in closed form from links of 13.5, 14.7 and 6.1 cm and a shoulder 5.8 cm above the "
                   "tool, which we fitted to these angles."});
  return items;
}

AuditItems geometry_items(std::string_view paper) {
  const Statements statements(paper);
  AuditItems items;
  const double down = -statements.number("tool_axis_z");
  items.push_back(
      {"3.5a", "Eq. 27 and its text", statements.text("tool_words"),
       fmt::format("third column ({}, {}, {}): {:.0f} deg from it", statements.text("tool_axis_x"),
                   statements.text("tool_axis_y"), statements.text("tool_axis_z"), std::acos(down) / degree),
       unless(std::abs(std::abs(down) - 1) < 1e-9, AuditVerdict::contradiction),
       "The third column is the axis of the tool; in Eq. 27 it is horizontal."});

  const double reach = statements.number("upper_arm_cm") + statements.number("forearm_cm");
  struct Starts {
    std::string words;
    int step_deg;
    AuditVerdict otherwise;
  };
  const auto reached = [&](const std::string& id, const Starts& starts, const std::string& sentence) {
    const std::pair<double, Helix27> nearest = nearest_helix(statements, starts.step_deg);
    items.push_back({id, fmt::format("Eq. 27: the helix from {}", starts.words),
                     "PSO's minimum is 0.0000: all points are reached",
                     fmt::format("wrist {:.2f} cm from the shoulder (start {} deg); reach {:.2f} cm", nearest.first,
                                 nearest.second.start_deg, reach),
                     unless(nearest.first <= reach, starts.otherwise), sentence});
  };
  reached("3.5b", {"a quarter turn", 90, AuditVerdict::unsupported},
          "With the lengths of the real arm, a helix that starts at 0, 90, 180 or 270 deg, either way round and with "
          "either spacing, has points out of reach.");
  reached("3.5c", {"any whole degree", 1, AuditVerdict::contradiction},
          "A start angle that the paper does not give would just suffice, so reach alone does not refute Eq. 27.");
  items.push_back(
      {"3.5d", fmt::format("{} against {}", statements.source("offset_of_3T4"), statements.source("offset_of_joint_4")),
       statements.text("offset_of_3T4"), statements.text("offset_of_joint_4"),
       unless(statements.text("offset_of_3T4") == statements.text("offset_of_joint_4"), AuditVerdict::misprint),
       "The fourth joint has no offset in Table 2."});
  items.push_back({"3.5e", statements.source("arm_model"), statements.text("arm_model"),
                   statements.text("arm_model_of_kuka"),
                   unless(statements.text("arm_model") == statements.text("arm_model_of_kuka"), AuditVerdict::misprint),
                   fmt::format("The LBR iiwa with a reach of {:.0f} mm is the 14 R820.", reach * 10)});
  items.push_back({"3.5f", statements.source("twist_axis"), "alpha turns about " + statements.text("twist_axis"),
                   "about x", unless(statements.text("twist_axis") == "x", AuditVerdict::misprint),
                   "If alpha also rotated about z, all axes of the arm would be parallel."});
  // Columns 1 and 3 of a Denavit-Hartenberg rotation are (cos theta, sin theta, 0) and (sin theta sin alpha, e, cos
  // alpha): they are perpendicular for this e alone.
  const std::string element = "-cos(theta) sin(alpha)";
  items.push_back({"3.5g", statements.source("element_2_3_of_eq_18") + ", element (2,3)",
                   statements.text("element_2_3_of_eq_18"), element,
                   unless(statements.text("element_2_3_of_eq_18") == element, AuditVerdict::misprint),
                   "With any other element, the first and the third axis of a frame are not perpendicular."});
  items.push_back(
      {"3.5h", fmt::format("{} against {}", statements.source("limits_in_text"), statements.source("limits_of_eq_4")),
       statements.text("limits_in_text"), statements.text("limits_of_eq_4"),
       unless(statements.text("limits_in_text") == statements.text("limits_of_eq_4"), AuditVerdict::misprint),
       "The text calls the lower limit of a joint the upper one, and the upper the lower."});
  return items;
}

}  // namespace ikbench::slim2023
