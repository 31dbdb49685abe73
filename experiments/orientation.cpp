#include "experiments/orientation.hpp"

namespace ikbench::experiments {

void list_tool(Fields& io, Tool& tool) {
  io.choice("tool", tool, Choices<Tool>{{"down", Tool::down}, {"eq27", Tool::eq27}},
            "how the tool is held: straight down, or as Eq. 27 prints it (horizontal)");
}

Eigen::Matrix3d rotation(Tool tool) {
  Eigen::Matrix3d R;
  if (tool == Tool::down) {
    R << -1, 0, 0, 0, 1, 0, 0, 0, -1;
  } else {
    R << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  }
  return R;
}

void list_spacing(Fields& io, Spacing& spacing) {
  io.choice("spacing", spacing,
            Choices<Spacing>{{"k_over_n", Spacing::k_over_n}, {"k_over_n_minus_1", Spacing::k_over_n_minus_1}},
            "point k = 0 ... n - 1 lies at this fraction of the path");
}

std::vector<double> by_rows(const Eigen::Matrix3d& R) {
  std::vector<double> elements;
  for (int row = 0; row < 3; ++row) elements.insert(elements.end(), {R(row, 0), R(row, 1), R(row, 2)});
  return elements;
}

}  // namespace ikbench::experiments
