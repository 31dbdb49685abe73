// Studies that are small enough to run many times.
#pragma once

#include "base/units.hpp"
#include "experiments/environment.hpp"
#include "experiments/external/protocol.hpp"
#include "experiments/multiverse.hpp"
#include "experiments/runner.hpp"
#include "experiments/solve_runner.hpp"
#include "experiments/study/path.hpp"
#include "experiments/study/reader.hpp"
#include "experiments/study/series_key.hpp"
#include "experiments/study/study.hpp"
#include "experiments/study/study_fields.hpp"
#include "experiments/study/writer.hpp"
#include "experiments/verifier.hpp"
#include "experiments/workers.hpp"
#include "robots/spherical_wrist.hpp"
#include "solvers/bounds.hpp"
#include "tests/numerics/reference.hpp"
#include "tests/results/samples.hpp"
#include "tests/solvers_for.hpp"

using namespace ikbench::robots;
using namespace ikbench::solvers;
using namespace ikbench::experiments;

namespace ikbench {

// Returns overrides that add to a text what a study needs: an arm and a kind of path.
inline experiments::Overrides completed(const std::string& toml, const experiments::Overrides& overrides = {}) {
  experiments::Overrides all;
  if (!contains(toml, "robot")) all.emplace_back("robot=kuka_iiwa14");
  if (!contains(toml, "path")) all.emplace_back("path.kind=helix");
  all.insert(all.end(), overrides.begin(), overrides.end());
  return all;
}

inline experiments::Study read(const std::string& toml, const experiments::Overrides& overrides = {}) {
  return experiments::parse_study(toml, "my.toml", completed(toml, overrides));
}
// Returns the complaint about a text; empty if the text is a study.
inline std::string statements_of(const std::string& toml, const experiments::Overrides& overrides = {}) {
  return complaint<std::invalid_argument>([&] { read(toml, overrides); });
}

// Returns the default path with settings, as path_of({"kind=circle", "points=4"}).
inline experiments::Path path_of(const std::vector<std::string>& settings) {
  experiments::Overrides overrides;
  for (const std::string& setting : settings) overrides.push_back("path." + setting);
  return read("[[solvers]]\nsolver = \"ik_bat\"\n", overrides).path;
}

// A path of given poses, of any numbers.
class PathThrough final : public experiments::TargetSet {
 public:
  explicit PathThrough(std::vector<robots::Pose> poses) : poses_(std::move(poses)) {}
  std::string_view name() const override { return "poses"; }
  std::string_view summary() const override { return ""; }
  void list_fields(base::Fields& io) override { io.poses("poses", poses_); }
  int points() const override { return static_cast<int>(poses_.size()); }
  std::vector<robots::Pose> poses(const robots::Robot&, numerics::Random&) const override { return poses_; }

 private:
  std::vector<robots::Pose> poses_;
};
inline experiments::Path path_through(std::vector<robots::Pose> poses) {
  return std::make_shared<PathThrough>(std::move(poses));
}

// Returns the poses of a path in the first run with seed 1, with the paper's arm.
inline std::vector<robots::Pose> poses_of(const experiments::Path& path) {
  experiments::Study study;
  study.path = path;
  return experiments::targets_of_run(study, 1);
}

// Returns a study with two runs of three solvers over four points of the paper's helix: 24 solves.
inline experiments::Study small_study() {
  experiments::Study study;
  study.name = "small";
  study.path = path_of({"points=4"});
  study.initial = Eigen::VectorXd::Zero(7);
  study.population = 6;
  study.stop.iterations = 5;
  study.runs = 2;
  study.solvers = {{"IK-BA", "ik_bat", {}}, {"BA", "bat", {}}, {"DE", "differential_evolution", {}}};
  return study;
}

// Returns a solve without the values that differ between sessions.
inline results::SolveRecord without_times(results::SolveRecord record) {
  record.seconds = record.wall_seconds = record.cpu_seconds = 0;
  record.batch_size = 1;
  record.timing = results::Timing::clean;
  record.session = 0;
  return record;
}

inline bool same_numbers(const std::vector<results::SolveRecord>& a, const std::vector<results::SolveRecord>& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](const auto& x, const auto& y) {
           return same(without_times(x), without_times(y));
         });
}

// Returns the solves of a study that is run into a store of its own.
inline std::vector<results::SolveRecord> solve_all(const experiments::Study& study, int jobs = 1) {
  ScratchStore store;
  experiments::run(study, store, {.jobs = jobs});
  return solves_of(store, study.name);
}

inline std::vector<results::SolveRecord> only(const std::string& solver,
                                              const std::vector<results::SolveRecord>& records) {
  std::vector<results::SolveRecord> chosen;
  for (const results::SolveRecord& record : records) {
    if (record.label == solver) chosen.push_back(record);
  }
  return chosen;
}

}  // namespace ikbench
