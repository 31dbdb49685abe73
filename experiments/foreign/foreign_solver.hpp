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
  std::string last_failure;  // "crashed: it ended (exit code 3; its last words: ...)"
};

// Facts about one solve besides its answer.
struct Account {
  std::optional<results::Status> failure;
  double cpu_seconds = 0;  // of the program
  results::StopReason stopped = results::StopReason::finished;
  bool went_on = false;  // it wanted more evaluations after it was told that its budget is used up
  // It is not `suite` if its answer is none of the candidates evaluated here, or if these are too few to have found it:
  // then it has kinematics of its own, and `evaluations` is its own count.
  results::CountedBy counted_by = results::CountedBy::nobody;
  std::int64_t evaluations = 0, iterations = 0;
  std::vector<double> trace = {};  // of the evaluations made here, as in Solution
  solvers::Improvements improved = {};
  double claimed_error = std::numeric_limits<double>::quiet_NaN();  // [m], its word
  double claimed_seconds = std::numeric_limits<double>::quiet_NaN();
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

 private:
  std::shared_ptr<const Program> program_;
  std::string robot_;
  mutable std::mutex mutex_;
  std::vector<std::unique_ptr<Session>> idle_;
};

// solvers::solve drives it like any other solver; `start` is the whole conversation. If the program fails, the error is
// infinite.
class ForeignSolver final : public solvers::Solver {
 public:
  ForeignSolver(Sessions& sessions, const solvers::StopRule& stop);  // both outlive it
  ~ForeignSolver() override;

  // Call before the clock starts: starts the process if there is none, and warms it up.
  void prepare(const solvers::Problem& problem, const solvers::Objective& objective);
  void start(const solvers::Problem& problem, solvers::Objective& objective, numerics::Random& random) override;
  void step(solvers::Objective&, numerics::Random&) override {}
  const solvers::Best& best() const override { return best_; }
  bool finished() const override { return true; }
  const Account& account() const { return account_; }

 private:
  template <class Talk>
  void guarded(Talk&& talk);  // Trouble becomes the account's failure
  void converse(const solvers::Problem& problem, solvers::Objective& objective, std::uint32_t seed);
  std::optional<results::StopReason> end_of_budget(const solvers::Objective& objective, Clock::time_point began) const;

  Sessions& sessions_;
  const solvers::StopRule& stop_;
  std::unique_ptr<Session> session_;
  solvers::Best best_;
  Account account_;
};

}  // namespace ikbench::experiments
