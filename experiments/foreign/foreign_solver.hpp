// A program as a solver. Its process is started when it is needed, asked, watched and, where it dies, started anew.
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

// What is told of a program besides its solves.
struct ProgramNotes {
  std::int64_t deaths = 0;
  std::int64_t noise = 0;             // lines that are no messages
  std::vector<std::string> examples;  // the first of them
  std::string last_failure;           // "crashed (exit code 3); it wrote: ..."
  bool is_given_up = false;
};

// What becomes of one solve besides its solution.
struct Account {
  std::optional<results::Status> failure;
  double seconds = std::numeric_limits<double>::quiet_NaN();  // of a solve with own kinematics: to the last byte read
  double cpu_seconds = 0;                                     // of the program
  double transport_seconds = std::numeric_limits<double>::quiet_NaN();  // of a message and its answer
  double waited_seconds = std::numeric_limits<double>::quiet_NaN();     // for a processor, of program and suite
  int round_trips = 0;
  Solved word = {};  // of a solve with own kinematics
};

// A process of a program, with what has to be known of it from solve to solve.
class Session;

// The processes of a program that nobody uses now. Any thread may take one and give it back.
class Sessions {
 public:
  // `robot` is the message that a process gets first.
  Sessions(std::shared_ptr<const Program> program, std::string robot);
  ~Sessions();

  std::unique_ptr<Session> take();
  void give_back(std::unique_ptr<Session> session);
  ProgramNotes notes() const;  // of all of them so far, while none is taken
  const Program& program() const { return *program_; }

 private:
  std::shared_ptr<const Program> program_;
  std::string robot_;
  mutable std::mutex mutex_;
  std::vector<std::unique_ptr<Session>> idle_;
};

// solvers::solve drives it like any other. A solve of a program with own kinematics is its start, and finished then.
// Where the program fails, the error is infinite, and the account says why.
class ForeignSolver final : public solvers::Solver {
 public:
  ForeignSolver(Sessions& sessions, const solvers::StopRule& stop);  // which outlive it
  ~ForeignSolver() override;

  // Before the clock: starts the process where there is none, and lets it warm up. `hosted`: of a shared object.
  void prepare(const solvers::Problem& problem, const solvers::Objective& objective, const HostedSolve& hosted = {});
  void start(const solvers::Problem& problem, solvers::Objective& objective, numerics::Random& random) override;
  void step(solvers::Objective& objective, numerics::Random& random) override;
  const solvers::Best& best() const override { return best_; }
  bool finished() const override { return is_finished_; }
  // After the clock: tells the program that the solve is over, and ends it where it failed.
  void conclude();
  const Account& account() const { return account_; }
  const std::string& trouble() const { return trouble_; }  // why it failed, where it did
  double resident_bytes() const;                           // memory of the process

 private:
  template <class Talk>
  void guarded(Talk&& talk);  // what it throws becomes the account's failure
  void solve_at_once(const std::string& text, solvers::Objective& objective);
  void take_in(const Message& message, solvers::Objective& objective);

  Sessions& sessions_;
  const solvers::StopRule& stop_;
  std::unique_ptr<Session> session_;
  solvers::Best best_;
  bool is_finished_ = false;
  bool is_open_ = false;        // the program was told of a solve, and not of its end
  bool is_warming_up_ = false;  // such a solve forgives no death
  bool is_telling_ = false;     // the program waits for the errors of what it asked
  HostedSolve hosted_;
  int joints_ = 0;
  double cpu_before_ = 0, waited_before_ = 0;
  Eigen::VectorXd errors_;
  Account account_;
  std::string trouble_;  // why it failed
};

}  // namespace ikbench::experiments
