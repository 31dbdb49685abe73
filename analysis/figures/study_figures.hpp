// The figures of any study with solves: its path, a metric point by point, and the joint angles of each solver's first
// run.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/study.hpp"

namespace ikbench::figures {

// The targets of the first run, joined in their order unless they are drawn at random, and what its first solver
// reached; with the arm at the first target, or at up to three of them.
enum class View { with_arm, with_three_arms, from_above };
Figure path_figure(const inference::StudyResults& study, const std::string& name, View view = View::with_arm);
// Medians over the runs with the middle half of them, or means with the median thin beside. `printed` is drawn in grey,
// by point.
enum class Curves { medians, means };
Figure curves_figure(const inference::StudyResults& study, inference::Metric metric, const std::string& name,
                     const std::map<int, std::vector<double>>& printed = {}, Curves shown = Curves::medians);
struct JointLimits {
  std::size_t joint;  // from 1
  double lower, upper;
};
// The limits of the joints that turn [deg]; only where the definition has an arm of so many joints.
std::vector<JointLimits> limits_deg(const inference::StudyFacts& facts, std::size_t joints);
// One sheet with a panel per solver with answers; none if there is no such solver. `repeated`: a joint, from 1, as
// which a further one turns that the solver does not search.
std::optional<Figure> joints_figure(const inference::StudyResults& study, const std::string& name,
                                    std::optional<std::size_t> repeated = {});

}  // namespace ikbench::figures
