#include "experiments/diagnosis.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <set>

#include "base/names.hpp"
#include "base/units.hpp"
#include "numerics/functions.hpp"
#include "robots/rotation.hpp"

namespace ikbench::experiments {

using namespace robots;
using namespace solvers;

namespace {

constexpr double enough_right = 0.3, explains = 0.5;  // shares of answers
constexpr int most_joints_to_permute = 8;             // 40 320 orders
constexpr double small_error = 2e-3;                  // [m, rad]
constexpr std::size_t fewest_answers = 3;             // any frame fits one answer

using AnswerSpan = std::span<const AnsweredTarget>;
using Change = std::function<Configuration(const Configuration&)>;

// Returns the angle [rad] that counts between two orientations.
double angle_between(const Pose& reached, const Pose& target, GoalKind kind) {
  switch (kind) {
    case GoalKind::position:
      return 0;
    case GoalKind::axis: {
      const Eigen::Vector3d reached_axis = reached.linear().col(2), axis = target.linear().col(2);
      return numerics::arc_tangent(reached_axis.cross(axis).norm(), numerics::dot(reached_axis, axis));
    }
    case GoalKind::pose:
      break;
  }
  return rotation_vector(reached.linear().transpose() * target.linear()).norm();
}

bool is_right(const Pose& reached, const Pose& target, const RightWithin& right) {
  const double distance = (reached.translation() - target.translation()).norm();
  return distance <= right.position && angle_between(reached, target, right.kind) <= right.angle;
}

bool is_share(std::ptrdiff_t count, std::size_t total, double share) {
  return static_cast<double>(count) >= share * static_cast<double>(total);
}

// Returns the upper median of values, whose order changes. There must be one.
double median(std::vector<double>& values) {
  const auto half = values.begin() + std::ssize(values) / 2;
  std::ranges::nth_element(values, half);
  return *half;
}

// The answers with the poses that they reach.
struct Reached {
  const Robot& arm;
  AnswerSpan answers;
  const RightWithin& right;
  std::vector<Pose> poses;

  std::size_t size() const { return answers.size(); }
  // Returns whether so many answers reach their targets once their joints are changed, that the change explains them.
  bool is_explained_by(const Change& change) const {
    const auto count = std::ranges::count_if(answers, [&](const AnsweredTarget& answer) {
      return is_right(arm.chain.forward(change(answer.q)), answer.target, right);
    });
    return is_share(count, size(), explains);
  }
};

std::optional<Diagnosis> in_degrees(const Reached& reached) {
  const auto to_radians = [&](Configuration q) {
    for (Eigen::Index j = 0; j < q.size(); ++j)
      if (!reached.arm.chain.slides(j)) q[j] *= base::degree;
    return q;
  };
  return reached.is_explained_by(to_radians) ? std::optional(Diagnosis{.cause = Cause::degrees}) : std::nullopt;
}

std::optional<Diagnosis> in_another_order(const Reached& reached) {
  const int joints = reached.arm.joints();
  if (joints > most_joints_to_permute) return std::nullopt;
  std::vector<int> order(static_cast<std::size_t>(joints));
  std::iota(order.begin(), order.end(), 0);
  const Change permuted = [&](const Configuration& q) {
    Configuration moved(q.size());
    for (std::size_t j = 0; j < order.size(); ++j) moved[static_cast<Eigen::Index>(j)] = q[order[j]];
    return moved;
  };
  constexpr std::size_t tried = 5;  // answers, of which one has to be right before all are looked at
  const AnswerSpan first = reached.answers.first(std::min(tried, reached.size()));
  while (std::ranges::next_permutation(order).found) {
    const bool may_be = std::ranges::any_of(first, [&](const AnsweredTarget& answer) {
      return is_right(reached.arm.chain.forward(permuted(answer.q)), answer.target, reached.right);
    });
    if (may_be && reached.is_explained_by(permuted)) return Diagnosis{.cause = Cause::joint_order, .order = order};
  }
  return std::nullopt;
}

std::optional<Diagnosis> by_shifted_rows(const Reached& reached) {
  constexpr int furthest = 3;
  for (const int rows : {1, -1, 2, -2, furthest, -furthest}) {
    std::ptrdiff_t count = 0;
    for (int i = 0; i < std::ssize(reached.answers); ++i) {
      const int target = i + rows;
      if (target < 0 || target >= std::ssize(reached.answers)) continue;
      count += is_right(reached.poses[static_cast<std::size_t>(i)],
                        reached.answers[static_cast<std::size_t>(target)].target, reached.right);
    }
    if (!is_share(count, reached.size(), explains)) continue;
    return Diagnosis{.cause = Cause::shifted,
                     .rows = rows,
                     .answers = reached.size(),
                     .shifted_answers = static_cast<std::size_t>(count)};
  }
  return std::nullopt;
}

// Returns the frame that at least half of the frames are; nothing if there is none. The median of each number leads to
// it.
std::optional<Pose> common_frame(const std::vector<Pose>& frames, const Reached& reached) {
  const RightWithin& right = reached.right;
  Eigen::Matrix<double, 3, 4> middle;
  std::vector<double> values(frames.size());
  for (Eigen::Index i = 0; i < middle.size(); ++i) {
    for (std::size_t k = 0; k < frames.size(); ++k) values[k] = frames[k].matrix()(i % 3, i / 3);
    middle(i % 3, i / 3) = median(values);
  }
  const auto are_near = [&](const Pose& frame, const Eigen::Matrix<double, 3, 4>& other) {
    const Eigen::Matrix<double, 3, 4> difference = (frame.matrix().topRows<3>() - other).cwiseAbs();
    return difference.leftCols<3>().maxCoeff() <= right.angle && difference.col(3).maxCoeff() <= right.position;
  };
  const auto is_near = [&](const Pose& frame) { return are_near(frame, middle); };
  const auto found = std::ranges::find_if(frames, is_near);
  if (found == frames.end() || !is_share(std::ranges::count_if(frames, is_near), frames.size(), explains))
    return std::nullopt;
  // One wrong answer to a target that is asked again and again misses by one frame, too.
  std::vector<Pose> targets;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Pose& target = reached.answers[i].target;
    const auto is_known = [&](const Pose& known) { return known.isApprox(target); };
    if (is_near(frames[i]) && std::ranges::none_of(targets, is_known)) targets.push_back(target);
    if (targets.size() == fewest_answers) break;
  }
  if (targets.size() < fewest_answers) return std::nullopt;
  const bool is_none = are_near(*found, Pose::Identity().matrix().topRows<3>());
  return is_none ? std::nullopt : std::optional(*found);
}

std::optional<Diagnosis> by_one_frame(const Reached& reached) {
  if (reached.right.kind != GoalKind::pose) return std::nullopt;
  std::vector<Pose> at_tool, at_base;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    at_tool.push_back(reached.poses[i].inverse() * reached.answers[i].target);
    at_base.push_back(reached.answers[i].target * reached.poses[i].inverse());
  }
  const auto of_base = common_frame(at_base, reached);
  if (const auto of_tool = common_frame(at_tool, reached))
    return Diagnosis{.cause = Cause::tool_frame, .frame = *of_tool, .base_frame = of_base};
  if (of_base) return Diagnosis{.cause = Cause::base_frame, .frame = *of_base};
  return std::nullopt;
}

std::optional<Diagnosis> by_orientation(const Reached& reached) {
  if (reached.right.kind != GoalKind::pose) return std::nullopt;
  std::ptrdiff_t first = 0, last = 0, inverse = 0;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const Pose& target = reached.answers[i].target;
    if ((reached.poses[i].translation() - target.translation()).norm() > reached.right.position) continue;
    const Eigen::Vector4d wanted = Eigen::Quaterniond(target.linear()).coeffs();  // x, y, z, w
    const Eigen::Vector4d found = Eigen::Quaterniond(reached.poses[i].linear()).coeffs();
    const auto is_found = [&](const Eigen::Vector4d& other) {
      return std::abs(numerics::dot(found, other)) >= 1 - 1e-6;
    };
    first += is_found({wanted[1], wanted[2], wanted[3], wanted[0]});
    last += is_found({wanted[3], wanted[0], wanted[1], wanted[2]});
    inverse += is_found({-wanted[0], -wanted[1], -wanted[2], wanted[3]});
  }
  if (is_share(std::max(first, last), reached.size(), explains)) return Diagnosis{.cause = Cause::quaternion_order};
  if (is_share(inverse, reached.size(), explains)) return Diagnosis{.cause = Cause::inverse};
  return std::nullopt;
}

std::optional<Diagnosis> by_few_digits(const Reached& reached) {
  std::vector<double> distances, errors;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const Pose& target = reached.answers[i].target;
    distances.push_back((reached.poses[i].translation() - target.translation()).norm());
    errors.push_back(std::max(distances.back(), angle_between(reached.poses[i], target, reached.right.kind)));
  }
  if (!(median(errors) <= small_error)) return std::nullopt;
  return Diagnosis{.cause = Cause::few_digits, .error = median(distances)};
}

// Returns a number without a sign of zero, rounded to so many parts of 1.
double rounded(double value, double parts) { return std::round(value * parts) / parts + 0.0; }

// Returns an axis by its name, such as "z" or "-x", or as its numbers. A half turn has no direction.
std::string axis_text(const Eigen::Vector3d& axis, bool is_half_turn) {
  constexpr std::array<std::string_view, 3> names{"x", "y", "z"};
  Eigen::Index longest = 0;
  if (axis.cwiseAbs().maxCoeff(&longest) <= 1 - 1e-6)
    return fmt::format("({:g}, {:g}, {:g})", rounded(axis.x(), 1000), rounded(axis.y(), 1000), rounded(axis.z(), 1000));
  const bool is_negative = axis[longest] < 0 && !is_half_turn;
  return fmt::format("{}{}", is_negative ? "-" : "", names[static_cast<std::size_t>(longest)]);
}

// Returns a frame such as "(0, 0, 100) mm, 180 deg about z".
std::string frame_text(const Pose& frame) {
  const Eigen::Vector3d mm = frame.translation() * 1000;
  const std::string moved =
      fmt::format("({:g}, {:g}, {:g}) mm", rounded(mm.x(), 100), rounded(mm.y(), 100), rounded(mm.z(), 100));
  const Eigen::Vector3d turn = rotation_vector(frame.linear());
  const double angle = rounded(turn.norm() / base::degree, 100);
  if (angle == 0) return moved;
  return fmt::format("{}, {:g} deg about {}", moved, angle, axis_text(turn.normalized(), angle == 180));
}

// The first answer to each target, in the order of the targets, and counts of rows.
struct Examined {
  std::vector<AnsweredTarget> first = {};
  std::size_t right_targets = 0, wrong_beside_right = 0, doubled = 0;
};

// Returns how many rows of one target repeat another one, to 1e-9 rad or m.
std::size_t doubled_rows(const Candidates& q) {
  constexpr double parts = 1e9;  // of a rad or m
  std::set<std::vector<std::int64_t>> different;
  std::size_t finite = 0;
  for (const Configuration answer : q.colwise()) {
    if (!answer.allFinite()) continue;
    ++finite;
    std::vector<std::int64_t> rounded_joints;
    for (const double joint : answer) rounded_joints.push_back(std::llround(joint * parts));
    different.insert(std::move(rounded_joints));
  }
  return finite - different.size();
}

void examine_target(const Candidates& q, const Pose& target, const Reached& how, Examined& found) {
  std::size_t right = 0, finite = 0;
  for (const Configuration answer : q.colwise()) {
    if (!answer.allFinite()) continue;
    if (finite++ == 0) found.first.push_back({target, answer});
    right += is_right(how.arm.chain.forward(answer), target, how.right);
  }
  found.doubled += doubled_rows(q);
  if (right == 0) return;
  ++found.right_targets;
  found.wrong_beside_right += finite - right;
}

Examined examine(const GivenAnswers& answers, const Study& study, const Reached& how) {
  Examined found;
  for (std::size_t at = 0; at < answers.rows.size();) {
    const int run = answers.rows[at].run;
    const std::vector<Pose> targets = targets_of_run(study, how.arm, run);
    while (at < answers.rows.size() && answers.rows[at].run == run) {
      const int point = answers.rows[at].point;
      const auto [first, count] = answers.of(run, point);
      examine_target(answers.q.middleCols(static_cast<Eigen::Index>(first), static_cast<Eigen::Index>(count)),
                     targets[static_cast<std::size_t>(point - 1)], how, found);
      at = first + count;
    }
  }
  return found;
}

// Returns the sentences on a file that are shown whatever the share of right answers is.
std::string facts_text(const GivenAnswers& answers, const Examined& found) {
  std::vector<std::string> facts;
  if (!answers.no_number.empty())
    facts.push_back(fmt::format("{} is not a number ({}); leave out the row of a target without an answer",
                                answers.no_number, base::counted(std::int64_t(answers.lacking_rows), "such rows")));
  if (found.wrong_beside_right > 0)
    facts.push_back(base::counted(std::int64_t(found.wrong_beside_right), "wrong answers") + " beside right ones");
  if (found.doubled > 0) facts.push_back(base::counted(std::int64_t(found.doubled), "doubled rows"));
  if (!answers.names_targets && answers.poses.cols() == 0)
    facts.emplace_back("only the numbers of its rows (run, point) were compared with the study's targets");
  return fmt::format("{}", fmt::join(facts, "; "));
}

}  // namespace

RightWithin right_within(const Study& study) {
  RightWithin right{.kind = goal_kind(study.search)};
  right.position = std::max(right.position, study.stop.tolerance);
  right.angle = std::max(right.angle, study.stop.angle_tolerance);
  return right;
}

std::optional<Diagnosis> diagnose(const Robot& arm, AnswerSpan answers, const RightWithin& right) {
  if (answers.size() < fewest_answers) return std::nullopt;
  Reached reached{.arm = arm, .answers = answers, .right = right, .poses = {}};
  std::ptrdiff_t count = 0;
  for (const AnsweredTarget& answer : answers) {
    reached.poses.push_back(arm.chain.forward(answer.q));
    count += is_right(reached.poses.back(), answer.target, right);
  }
  if (is_share(count, answers.size(), enough_right)) return std::nullopt;
  for (const auto& test : {in_degrees, in_another_order, by_shifted_rows, by_one_frame, by_orientation, by_few_digits})
    if (auto found = test(reached)) return found;
  return std::nullopt;
}

std::string diagnosis_text(const Diagnosis& diagnosis) {
  switch (diagnosis.cause) {
    case Cause::degrees:
      return "angles are in degrees; expected radians";
    case Cause::joint_order: {
      std::vector<std::string> columns;
      for (const int column : diagnosis.order) columns.push_back(fmt::format("q{}", column + 1));
      return fmt::format("the joints are in another order: joints 1 to {} stand as {}", columns.size(),
                         fmt::join(columns, ", "));
    }
    case Cause::shifted: {
      const auto rows = static_cast<std::size_t>(std::abs(diagnosis.rows));  // so many have no such target
      const std::string belong =
          diagnosis.shifted_answers + rows == diagnosis.answers
              ? "each answer belongs"
              : fmt::format("{} of {} answers belong", diagnosis.shifted_answers, diagnosis.answers);
      return fmt::format("rows are shifted: {} to the target {} further {}", belong,
                         base::counted(std::abs(diagnosis.rows), "rows"), diagnosis.rows > 0 ? "down" : "up");
    }
    case Cause::tool_frame: {
      const std::string tool = fmt::format("all miss by the same frame of the tool: {}", frame_text(diagnosis.frame));
      if (!diagnosis.base_frame) return tool;
      return fmt::format("{}; or of the base: {} (targets of one orientation do not tell which)", tool,
                         frame_text(*diagnosis.base_frame));
    }
    case Cause::base_frame:
      return fmt::format("all miss by the same frame of the base: {}", frame_text(diagnosis.frame));
    case Cause::quaternion_order:
      return "positions are right, orientations are not: the quaternion is in another order; expected qx, qy, qz, qw";
    case Cause::inverse:
      return "positions are right, orientations are inverse (transposed)";
    case Cause::few_digits:
      return fmt::format("errors are small, {:.2g} mm in the median: too few digits, or the solver's own tolerance",
                         diagnosis.error * 1000);
  }
  return "";
}

AnswersReport report_on(const GivenAnswers& answers, const Study& study, const Robot& arm) {
  const RightWithin right = right_within(study);
  const Examined found = examine(answers, study, {.arm = arm, .answers = {}, .right = right, .poses = {}});
  AnswersReport report{.cause = {}, .facts = facts_text(answers, found)};
  if (is_share(static_cast<std::ptrdiff_t>(found.right_targets), found.first.size(), enough_right)) return report;
  if (const auto diagnosis = diagnose(arm, found.first, right)) report.cause = diagnosis_text(*diagnosis);
  return report;
}

}  // namespace ikbench::experiments
