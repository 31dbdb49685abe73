// Target sets, which study files call paths: the target poses of the tool [m, rad]. A kind of path is a class in a file
// of paths/ and one line of paths.inc (docs/extending.md). The reader of studies makes a path; the runner asks it for
// the poses of each run.
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "base/fields.hpp"
#include "numerics/random.hpp"
#include "results/study.hpp"
#include "robots/robot.hpp"

namespace ikbench::experiments {

using base::Fields, base::InKey, numerics::Key, numerics::Random, robots::Configuration, robots::Pose, robots::Robot;

// The goal of a study's solves, by which a grid leaves out targets that no solve can reach.
struct Aim {
  results::Search search = results::Search::pose;
  double tolerance = 0;        // [m]
  double angle_tolerance = 0;  // [rad]
};

// A kind of path, with the fields of one path. Its file defines NAME_path(), which makes a path with the defaults.
class TargetSet {
 public:
  virtual ~TargetSet() = default;
  virtual std::string_view name() const = 0;     // NAME, as in study files
  virtual std::string_view summary() const = 0;  // in `ikbench list paths`
  virtual void list_fields(Fields& io) = 0;
  // Reads the files that the fields name, in the folder of the study. Throws std::invalid_argument, which says what is
  // wrong and what is expected.
  virtual void load(const std::filesystem::path&) {}
  // Lays the targets out for an arm. Only a grid does; its points are 0 before. Throws std::invalid_argument if the arm
  // has no such targets.
  virtual void lay_out(const Robot&, const Aim&) {}
  // Returns the plane of a grid; null for other paths.
  virtual const results::TargetGrid* grid() const { return nullptr; }
  // Throws std::invalid_argument if the fields do not fit each other, or if the arm has no such targets.
  virtual void check(const Robot&) const {}
  // Returns true if every run draws its own targets, false if all runs have the same.
  virtual bool is_random() const { return false; }
  // Returns true if a run's targets are made of the numbers that NumPy draws after the numbers of the runs before.
  virtual bool uses_numpy_random() const { return false; }
  virtual int points() const = 0;
  // Returns one pose per point. `random` belongs to the run; only random paths use it.
  virtual std::vector<Pose> poses(const Robot& arm, Random& random) const = 0;
  // Returns the configurations from which poses() makes its targets, by the same draws; empty if it uses none.
  virtual std::vector<Configuration> source_configurations(const Robot&, Random&) const { return {}; }
};

// A path of any kind. Copies of the pointer share the path, so fields may be changed only before the first copy.
using Path = std::shared_ptr<TargetSet>;

// Returns a new path of each kind, with its defaults, in the order of paths.inc.
std::vector<Path> target_sets();

// Reads poses from a table of any origin (base/sheet.hpp). The header names the columns, in any order and case, with
// their units:
// - x, y and z in m, cm or mm, of one thing ("pose.position.x", "x [mm]"); without a unit m;
// - w, x, y and z of one other thing, a quaternion whose length is 1 within 1 % and is made exact; or roll, pitch and
//   yaw in deg or rad (Rz(yaw) Ry(pitch) Rx(roll)); or nothing for a tool that points straight down.
// Stamps and the header of a message are left out, by the names of their columns. Without a header rows may also be the
// 12 or 16 numbers of a matrix, whose names are "1" to "16". `columns` replaces the names of the header; empty: it does
// not. Columns whose new name is no part of a pose are left out.
// Throws std::invalid_argument with file, line and column for anything else: a number that is not finite, lengths and
// angles that seem to be in another unit, no row, or more than 100000 rows.
std::vector<Pose> poses_from_csv(std::string_view text, std::string_view file,
                                 const std::vector<std::string>& columns = {});

constexpr std::pair<std::int64_t, std::int64_t> point_count_range{1, 100'000};

// The tool's orientation along a path.
enum class ToolOrientation {
  down,  // R = diag(-1, 1, -1)
  eq27   // a horizontal tool: the third column is (0, 1, 0), as Eq. 27 prints; the other columns are our choice
};
Eigen::Matrix3d tool_rotation(ToolOrientation tool);

// Returns the nine elements of a rotation, row by row.
std::vector<double> row_major(const Eigen::Matrix3d& R);

}  // namespace ikbench::experiments
