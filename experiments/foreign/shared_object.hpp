// A solver in a shared object (plugin/ikbench_plugin.h), in the process that loaded it. It calls our objective, our
// random stream and our counts.
#pragma once

#include <ikbench_plugin.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/foreign/protocol.hpp"
#include "solvers/solver.hpp"

namespace ikbench::experiments {

// Thrown if the object declines an arm or a problem.
struct Refusal : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The processor's rounding and its treatment of numbers near zero. Code that was linked with -Ofast changes both for
// the whole process.
class FloatingPointMode {
 public:
  FloatingPointMode();
  // Restores the mode; true if it had changed.
  bool restore() const;

 private:
  int rounding_;
  unsigned int mode_;
};

class SharedObject {
 public:
  // Loads the file. `name` selects one of its solvers; empty: the first. std::invalid_argument says what is wrong.
  SharedObject(const std::filesystem::path& file, std::string_view name);

  const ikbench_solver& solver() const { return *solver_; }
  const nlohmann::ordered_json& options() const { return options_; }  // a list, as in a hello
  bool changed_mode() const { return changed_mode_; }                 // while it was loaded

 private:
  const ikbench_solver* solver_ = nullptr;  // points into the object, which stays loaded
  nlohmann::ordered_json options_;
  bool changed_mode_ = false;
};

// The arm for which a solver of an object is created. It owns what the struct of the interface points to.
struct HostedArm {
  std::string name, urdf, base_link, tip_link;
  robots::Chain chain;
  robots::JointLimits limits;
  std::vector<double> options;
};

// solvers::solve drives it like any other solver.
class SharedSolver final : public solvers::Solver {
 public:
  // Throws Refusal if it declines the arm.
  SharedSolver(const ikbench_solver& table, const HostedArm& arm);
  ~SharedSolver() override;
  SharedSolver(const SharedSolver&) = delete;
  SharedSolver& operator=(const SharedSolver&) = delete;

  // Both throw Refusal if it declines, and std::runtime_error if it reports a failure.
  void start(const solvers::Problem& problem, solvers::Objective& objective, numerics::Random& random) override;
  void step(solvers::Objective& objective, numerics::Random& random) override;
  const solvers::Best& best() const override { return best_; }
  bool finished() const override { return is_finished_; }
  // Sets the seed of the next start.
  void set_seed(std::uint32_t seed) { seed_ = seed; }
  // True if it changed the processor's mode since the last start; that was undone.
  bool changed_mode() const { return changed_mode_; }

 private:
  friend struct Callbacks;
  template <class Call>
  void answer(solvers::Objective& objective, numerics::Random& random, Call&& call);
  void restore_mode() { changed_mode_ |= mode_.restore(); }

  const ikbench_solver& table_;
  void* solver_ = nullptr;
  int joints_;
  std::uint32_t seed_ = 0;
  ikbench_objective callbacks_;
  FloatingPointMode mode_;
  solvers::Objective* objective_ = nullptr;  // of the present call
  numerics::Random* random_ = nullptr;
  solvers::StopRule stop_;
  std::chrono::steady_clock::time_point started_;
  std::string said_;
  solvers::Best best_;
  bool is_finished_ = false, changed_mode_ = false;
};

}  // namespace ikbench::experiments
