// A program as a solver. Its process is started when needed, asked and watched, and started anew if it dies.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "experiments/foreign/program.hpp"
#include "results/record.hpp"
#include "solvers/solver.hpp"

namespace ikbench::experiments {

// Facts about a program besides its solves.
struct ProgramNotes {
  std::int64_t deaths = 0;
  std::int64_t noise = 0;             // lines that are no messages
  std::vector<std::string> examples;  // the first of these lines
  std::string last_failure;           // "crashed (exit code 3); it wrote: ..."
  bool is_given_up = false;
};

// Facts about one solve besides its solution.
struct Account {
  std::optional<results::Status> failure;
  double seconds = std::numeric_limits<double>::quiet_NaN();  // of a solve with own kinematics, to the last byte read
  double cpu_seconds = 0;                                     // of the program
  Solved word = {};                                           // the answer of a program with own kinematics
};

// A process of a program, with the state kept from solve to solve.
class Session;

// The idle processes of a program. Any thread may take one and give it back.
class Sessions {
 public:
  // `robot` is the first message to each process.
  Sessions(std::shared_ptr<const Program> program, std::string robot);
  ~Sessions();

  std::unique_ptr<Session> take();
  void give_back(std::unique_ptr<Session> session);
  ProgramNotes notes() const;  // of all processes so far; none may be taken
  const Program& program() const { return *program_; }

 private:
  std::shared_ptr<const Program> program_;
  std::string robot_;
  mutable std::mutex mutex_;
  std::vector<std::unique_ptr<Session>> idle_;
};

// solvers::solve drives it like any other solver. A program with own kinematics solves completely in `start`. If the
// program fails, the error is infinite, and the account says why.
class ForeignSolver final : public solvers::Solver {
 public:
  ForeignSolver(Sessions& sessions, const solvers::StopRule& stop);  // both outlive it
  ~ForeignSolver() override;

  // Call before the clock starts: starts the process if there is none, and warms it up.
  void prepare(const solvers::Problem& problem, const solvers::Objective& objective);
  void start(const solvers::Problem& problem, solvers::Objective& objective, numerics::Random& random) override;
  void step(solvers::Objective& objective, numerics::Random& random) override;
  const solvers::Best& best() const override { return best_; }
  bool finished() const override { return is_finished_; }
  // Call after the clock stopped: tells the program that the solve is over, and ends the program if it failed.
  void conclude();
  const Account& account() const { return account_; }
  const std::string& trouble() const { return trouble_; }  // why it failed; empty if it did not

 private:
  template <class Talk>
  void guarded(Talk&& talk);  // an exception becomes the account's failure
  void solve_at_once(const std::string& text, solvers::Objective& objective);
  void take_in(const Message& message, solvers::Objective& objective);

  Sessions& sessions_;
  const solvers::StopRule& stop_;
  std::unique_ptr<Session> session_;
  solvers::Best best_;
  bool is_finished_ = false;
  bool is_open_ = false;        // the program knows of this solve, but not of its end
  bool is_warming_up_ = false;  // a warm-up that succeeds does not forget earlier deaths
  bool is_telling_ = false;     // the program waits for the errors of its candidates
  int joints_ = 0;
  double cpu_before_ = 0;
  Eigen::VectorXd errors_;
  Account account_;
  std::string trouble_;
};

}  // namespace ikbench::experiments
