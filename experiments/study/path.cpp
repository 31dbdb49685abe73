#include "experiments/study/path.hpp"

namespace ikbench::experiments {

#define PATH(name) std::unique_ptr<TargetSet> name##_path();
#include "experiments/study/paths.inc"
#undef PATH

std::vector<Path> target_sets() {
  std::vector<Path> sets;
#define PATH(name) sets.emplace_back(name##_path());
#include "experiments/study/paths.inc"
#undef PATH
  return sets;
}

Eigen::Matrix3d tool_rotation(ToolOrientation tool) {
  if (tool == ToolOrientation::down) return Eigen::Matrix3d{{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
  return Eigen::Matrix3d{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
}

std::vector<double> row_major(const Eigen::Matrix3d& R) {
  const Eigen::Matrix3d columns = R.transpose();
  return {columns.reshaped().begin(), columns.reshaped().end()};
}

}  // namespace ikbench::experiments
