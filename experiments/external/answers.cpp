#include "experiments/external/answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "base/inputs.hpp"
#include "base/names.hpp"
#include "base/sheet.hpp"
#include "experiments/targets.hpp"
#include "numerics/random.hpp"
#include "robots/urdf.hpp"
#include "solvers/bounds.hpp"

namespace ikbench::experiments {

namespace fs = std::filesystem;

using namespace robots;
using namespace solvers;

namespace {

constexpr double no_time = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<std::string_view, 7> pose_titles{"x", "y", "z", "qx", "qy", "qz", "qw"};

bool has_title(const base::Sheet& sheet, std::string_view title) {
  return std::ranges::count(sheet.titles(), title) > 0;
}

// Returns whether a column of this title has another meaning than a joint.
bool is_reserved(std::string_view title) {
  constexpr std::array<std::string_view, 4> others{"run", "point", "target", "ms"};
  return std::ranges::count(pose_titles, title) > 0 || std::ranges::count(others, title) > 0;
}

// Returns a clause on a column of this name whose title has a unit, such as "q1 [rad]"; empty if there is none.
std::string hint_at_unit(const base::Sheet& sheet, const std::string& name, std::string_view unit) {
  for (const std::string& title : sheet.titles())
    if (const base::Title parts(title); parts.name == name && !parts.unit.empty())
      return fmt::format(", but {}; expected the header {} without a unit, and values in {}", base::in_quotes(title),
                         base::in_quotes(name), unit);
  return "";
}

// Returns the columns of all joints: by their names if the file has one of these, otherwise q1, q2, ... An arm with a
// joint whose name is that of another column has only q1, q2, ...
std::vector<std::size_t> joint_columns(base::Sheet& sheet, const Robot& arm) {
  std::vector<std::string> names = joint_names(arm);
  const bool are_named = std::ranges::none_of(names, is_reserved) &&
                         std::ranges::any_of(names, [&](const std::string& name) { return has_title(sheet, name); });
  for (std::size_t j = 0; j < names.size() && !are_named; ++j) names[j] = fmt::format("q{}", j + 1);
  std::vector<std::size_t> columns;
  for (const std::string& name : names) {
    if (const std::string hint = hint_at_unit(sheet, name, "rad (m, if it slides)");
        !has_title(sheet, name) && !hint.empty())
      sheet.refuse(fmt::format("no column {}{}", base::in_quotes(name), hint));
    if (!has_title(sheet, name))
      sheet.refuse(fmt::format("no column {}; the arm has {}: {} to {}", base::in_quotes(name),
                               base::counted(arm.joints(), "joints"), base::in_quotes(names.front()),
                               base::in_quotes(names.back())));
    columns.push_back(sheet.column(name));
  }
  return columns;
}

// Returns the columns of poses; none if the file has no poses.
std::vector<std::size_t> pose_columns(base::Sheet& sheet) {
  const auto has_it = [&](std::string_view title) { return has_title(sheet, title); };
  std::vector<std::size_t> columns;
  if (!std::ranges::all_of(pose_titles, has_it)) return columns;
  for (const std::string_view title : pose_titles) columns.push_back(sheet.column(title));
  return columns;
}

// The columns of a file of answers.
struct AnswerColumns {
  AnswerColumns(base::Sheet& sheet, const Robot& arm) {
    for (const std::string_view title : {"run", "point"})
      if (!has_title(sheet, title))
        sheet.refuse(fmt::format("no column '{}'; expected run, point and a column per joint", title));
    run = sheet.column("run");
    point = sheet.column("point");
    joints = joint_columns(sheet, arm);
    pose = pose_columns(sheet);
    if (has_title(sheet, "ms"))
      ms = sheet.column("ms");
    else if (const std::string hint = hint_at_unit(sheet, "ms", "ms"); !hint.empty())
      sheet.refuse("no column 'ms'" + hint);
    if (has_title(sheet, "target")) target = sheet.column("target");
  }

  std::size_t run = 0, point = 0;
  std::vector<std::size_t> joints, pose;
  std::optional<std::size_t> ms, target;
};

// Returns the number of a run or a point.
int number_in(base::Sheet& sheet, std::size_t row, std::size_t column) {
  constexpr double largest = 1e9;
  const double value = sheet.number(row, column);
  if (!(value >= 1) || value > largest || value != std::floor(value))
    sheet.refuse(row, column, "is not the number of a run or a point; expected 1, 2, 3 ... as in targets.csv");
  return static_cast<int>(value);
}

// Returns the time [s] of a row; NaN for an empty cell.
double seconds_in(base::Sheet& sheet, std::size_t row, std::size_t column) {
  const double value = sheet.number(row, column) / 1000;
  if (value <= 0 || std::isinf(value))
    sheet.refuse(row, column, "is not a time; expected milliseconds above 0, or an empty cell");
  return value;
}

std::string digest_of_answer_text(std::string_view text) {
  return fmt::format("{:016x}", numerics::Key(0).with(text).value());
}

// Returns the value of a joint [rad, m]; NaN for an empty cell.
double joint_in(base::Sheet& sheet, std::size_t row, std::size_t column) {
  constexpr double largest = 1e6;  // digits of a larger angle are lost
  const double value = sheet.number(row, column);
  if (std::isinf(value))
    sheet.refuse(row, column,
                 "is infinite; expected the value of a joint; leave out the row of a target without an answer");
  if (std::abs(value) > largest)
    sheet.refuse(row, column, fmt::format("is beyond {:g} rad or m; expected the value of a joint", largest));
  return value;
}

// Moves rows and numbers into the order of run and point.
void sort_rows(GivenAnswers& answers) {
  std::vector<std::size_t> order(answers.rows.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto place = [&](std::size_t i) { return std::pair(answers.rows[i].run, answers.rows[i].point); };
  if (std::ranges::is_sorted(order, {}, place)) return;
  std::ranges::stable_sort(order, {}, place);
  const auto sorted = [&](const Candidates& columns) {
    Candidates moved(columns.rows(), columns.cols());
    for (Eigen::Index i = 0; i < columns.cols(); ++i)
      moved.col(i) = columns.col(static_cast<Eigen::Index>(order[static_cast<std::size_t>(i)]));
    return moved;
  };
  answers.q = sorted(answers.q);
  answers.poses = sorted(answers.poses);
  std::vector<GivenRow> rows;
  for (const std::size_t i : order) rows.push_back(std::move(answers.rows[i]));
  answers.rows = std::move(rows);
}

// Throws std::invalid_argument for more rows of one target than a solve may have.
void refuse_long_lists(const GivenAnswers& answers) {
  constexpr std::size_t most = 1000;
  for (std::size_t i = most; i < answers.rows.size(); ++i) {
    const GivenRow& row = answers.rows[i];
    const GivenRow& earlier = answers.rows[i - most];
    if (row.run == earlier.run && row.point == earlier.point)
      throw std::invalid_argument(fmt::format("{}:{}: run {}, point {} has more than {} answers; expected fewer",
                                              answers.file, row.line, row.run, row.point, most));
  }
}

// Returns the full path of a relative name that leads out of the folder; empty for other names.
fs::path place_outside(const std::string& name, const fs::path& folder) {
  if (fs::path(name).is_absolute()) return {};
  const fs::path home = fs::weakly_canonical(folder.empty() ? "." : folder);
  const fs::path meant = fs::weakly_canonical(home / name);
  const bool is_inside = std::mismatch(home.begin(), home.end(), meant.begin(), meant.end()).first == home.end();
  return is_inside ? fs::path() : meant;
}

std::string text_on_row(const GivenAnswers& answers, const GivenRow& row, const std::string& what) {
  return fmt::format("{}:{}: run {}, point {}: {}", answers.file, row.line, row.run, row.point, what);
}

// Returns how far the pose of a row is from a target: the largest difference [m], or of a number of the quaternion.
double distance_to(const Eigen::VectorXd& pose, const Pose& target) {
  const Eigen::Quaterniond wanted(target.linear());
  const double away = (pose.head<3>() - target.translation()).cwiseAbs().maxCoeff();
  const double as_is = (pose.tail<4>() - wanted.coeffs()).cwiseAbs().maxCoeff();
  const double negative = (pose.tail<4>() + wanted.coeffs()).cwiseAbs().maxCoeff();
  return std::max(away, std::min(as_is, negative));
}

}  // namespace

RowRange GivenAnswers::of(int run, int point) const {
  const auto place = [](const GivenRow& row) { return std::pair(row.run, row.point); };
  const auto first = std::ranges::lower_bound(rows, std::pair(run, point), {}, place);
  const auto last = std::ranges::upper_bound(rows, std::pair(run, point), {}, place);
  return {.first = static_cast<std::size_t>(first - rows.begin()), .count = static_cast<std::size_t>(last - first)};
}

GivenAnswers answers_in(std::string_view text, const std::string& name, const Robot& arm) {
  base::Sheet sheet(text, name, 0, base::Sheet::Header::required, max_answer_bytes);
  sheet.advise_on_numbers("leave out the row of a target without an answer");
  const AnswerColumns columns(sheet, arm);
  GivenAnswers answers{.file = name,
                       .digest = digest_of_answer_text(text),
                       .names_targets = columns.target.has_value(),
                       .has_times = columns.ms.has_value()};
  const auto rows = static_cast<Eigen::Index>(sheet.rows().size());
  answers.q.resize(arm.joints(), rows);
  answers.poses.resize(std::ssize(pose_titles), columns.pose.empty() ? 0 : rows);
  Eigen::Index at = 0;
  for (const std::size_t row : sheet.rows()) {
    GivenRow& read = answers.rows.emplace_back(GivenRow{.run = number_in(sheet, row, columns.run),
                                                        .point = number_in(sheet, row, columns.point),
                                                        .line = sheet.line(row)});
    read.seconds = columns.ms ? seconds_in(sheet, row, *columns.ms) : no_time;
    if (columns.target) read.target = base::lower_case(sheet.cell(row, *columns.target));
    for (std::size_t j = 0; j < columns.joints.size(); ++j) {
      const double value = joint_in(sheet, row, columns.joints[j]);
      answers.q(static_cast<Eigen::Index>(j), at) = value;
      if (answers.no_number.empty() && std::isnan(value))
        answers.no_number = fmt::format("line {}: {}", read.line, sheet.titles()[columns.joints[j]]);
    }
    for (std::size_t i = 0; i < columns.pose.size(); ++i)
      answers.poses(static_cast<Eigen::Index>(i), at) = sheet.number(row, columns.pose[i]);
    if (!answers.q.col(at).allFinite()) ++answers.lacking_rows;
    ++at;
  }
  sort_rows(answers);
  refuse_long_lists(answers);
  return answers;
}

std::shared_ptr<const GivenAnswers> read_answers(const std::string& name, const fs::path& folder, const Robot& arm) {
  if (const fs::path meant = place_outside(name, folder); !meant.empty())
    throw std::invalid_argument(
        fmt::format("answers is {}, which is outside the study's folder; write its full path, {}",
                    base::in_quotes(name), meant.string()));
  std::error_code error;
  if (!fs::exists(folder / name, error)) return nullptr;
  const std::string text = base::text_of_file(folder / name, max_answer_bytes);
  GivenAnswers answers = answers_in(text, name, arm);
  answers.path = (folder / name).string();
  return std::make_shared<const GivenAnswers>(std::move(answers));
}

std::optional<std::string> digest_of_answers(const std::string& name) {
  std::error_code error;
  if (fs::path(name).is_absolute() || !place_outside(name, "").empty()) return std::nullopt;
  if (!fs::is_regular_file(name, error) || fs::file_size(name, error) > max_answer_bytes) return std::nullopt;
  return digest_of_answer_text(base::text_of_file(name, max_answer_bytes));
}

std::string difference_in_targets(const GivenAnswers& answers, const Study& study, const Robot& arm) {
  const bool are_compared = answers.names_targets || answers.poses.cols() > 0;
  int run = 0;
  std::vector<Pose> targets;
  std::vector<Configuration> starts;
  for (std::size_t i = 0; i < answers.rows.size(); ++i) {
    const GivenRow& row = answers.rows[i];
    if (row.run > study.runs || row.point > study.path->points())
      return text_on_row(answers, row,
                         fmt::format("the study has no such target, but {} of {}", base::counted(study.runs, "runs"),
                                     base::counted(study.path->points(), "points")));
    if (!are_compared) continue;
    if (run != row.run) {
      run = row.run;
      targets = targets_of_run(study, arm, run);
      starts = all_starts_of_run(study, arm, run);
    }
    const auto place = static_cast<std::size_t>(row.point - 1);
    if (answers.names_targets && row.target != target_digest(targets[place], starts[place]))
      return text_on_row(answers, row,
                         fmt::format("its target is {}, but the study has {}", base::in_quotes(row.target),
                                     target_digest(targets[place], starts[place])));
    constexpr double rounding = 1e-6;
    const bool has_pose = answers.poses.cols() > 0;
    if (has_pose && !(distance_to(answers.poses.col(static_cast<Eigen::Index>(i)), targets[place]) <= rounding))
      return text_on_row(answers, row, "its x to qw are not the study's target (1e-6)");
  }
  return "";
}

void GivenSolver::start(const Problem& problem, Objective& objective, Random&) {
  take(problem);
  if (rows_.count == 0) return;
  turned_ = answers_.q.middleCols(static_cast<Eigen::Index>(rows_.first), static_cast<Eigen::Index>(rows_.count));
  for (Eigen::Index j = 0; j < turned_.rows(); ++j) {
    if (objective.arm().slides(j)) continue;
    for (double& angle : turned_.row(j)) angle = turned_inside(angle, problem.lower[j], problem.upper[j]);
  }
  best_.q =
      turned_.cols() > 1 ? nearest_answer(turned_, problem, objective.arm(), wrap_) : Configuration(turned_.col(0));
  Objective uncounted(objective.arm(), objective.goal());
  best_.error = uncounted.error(best_.q);
}

ProcessReport GivenSolver::report() const {
  ProcessReport report;
  if (rows_.count > 0) return report;
  report.failure = results::Status::declined;
  report.stopped = StopReason::gave_up;
  return report;
}

double GivenSolver::seconds() const { return rows_.count == 0 ? no_time : answers_.rows[rows_.first].seconds; }

std::vector<double> GivenSolver::all_answers() const {
  std::vector<double> all;
  if (rows_.count < 2) return all;
  for (const Configuration q : turned_.colwise()) all.insert(all.end(), q.begin(), q.end());
  return all;
}

}  // namespace ikbench::experiments
