// The messages between a program and ikbench, one JSON object per line: reading what a program sends, and writing what
// it is sent. Programs are not trusted: everything that they send is bounded and checked here. Only the files of this
// folder and `ikbench check-solver` need it. Protocol: docs/reference/protocol.md.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/child_process.hpp"
#include "results/study.hpp"
#include "robots/robot.hpp"
#include "solvers/options.hpp"
#include "solvers/solve.hpp"

namespace ikbench::experiments {

using base::ChildProcess, base::Clock, base::ProcessFailure;

constexpr int protocol_version = 2;

// An option that a program offers: a number, or one of several texts.
struct OptionSpec {
  std::string name, meaning;
  bool is_whole = false;
  double low = 0, high = 0, preset = 0;  // of a number
  std::vector<std::string> choices;      // the preset first; empty for a number
};

// A program's introduction of itself.
struct Hello {
  std::string name, version;
  std::vector<OptionSpec> options;
  std::vector<std::string> goals;  // some of position, axis, pose
  bool takes_batches = false;

  bool solves(solvers::GoalKind goal) const;
};

// Returns the options of a program: its defaults with the settings applied. Throws std::invalid_argument as
// OptionList::set does.
solvers::Settings resolved_options(const Hello& hello, const solvers::Settings& settings);

// The message that asks for one solve.
struct SolveQuestion {
  std::string text;  // solve_message
  std::uint32_t seed = 0;
};

constexpr std::size_t max_name_bytes = 180;  // of a name from a check, which is stored with a prefix
constexpr std::size_t max_extras = 50;       // names, in one answer and in all of a program

// A message of a program. Each function that reads the message throws ProcessFailure if the message breaks the
// protocol. The failure shows the line and what was expected.
class Message {
 public:
  explicit Message(std::string line);
  const std::string& name() const { return name_; }
  Hello hello() const;
  std::string decline_reason() const;
  robots::Candidates candidates(int joints, const char* key = "candidates") const;  // [rad, m], one per column
  std::map<std::string, double> extras(const char* key = "extras") const;           // by name; NaN for null
  std::string rejection_reason() const;  // why a check finds an answer invalid; empty: valid
  // Returns the answers of a batch by the texts of its questions. The answers come in the order of the questions, each
  // with the seed of its question.
  std::map<std::string, std::optional<Message>> answers(const std::vector<SolveQuestion>& questions) const;
  // Returns true if the program solved twice in a row, and everything that it reports is of the second solve.
  bool is_of_second_solve() const;
  bool differs_from_first() const;  // the second solve gave another answer
  bool has(const char* key) const;
  robots::Configuration joints(int joints) const;  // [rad, m]; NaN where the message has null
  double number(const char* key) const;            // NaN if there is none
  std::int64_t count(const char* key) const;       // -1 if there is none

  // Throws ProcessFailure.
  [[noreturn]] void fail(const std::string& expected) const;

 private:
  explicit Message(const nlohmann::json& object);  // an answer of a batch, which had no line of its own

  void read_name();
  std::string text(const nlohmann::json& object, const char* key) const;
  OptionSpec option(const nlohmann::json& object) const;
  robots::Configuration configuration(const nlohmann::json& list, int joints, const std::string& expected) const;

  std::string line_;  // empty for an answer of a batch
  std::string name_;
  std::shared_ptr<const nlohmann::json> json_;
};

// Everything that is the same for all solves of a program.
struct SolveSetup {
  const robots::Robot& arm;
  const robots::Chain& searched;  // the joints before the wrist, or all
  solvers::Goal goal;             // without its target
  std::string urdf = {};          // text of the arm's own file, for a check; empty: the arm that is judged as URDF
  Hello hello = {};
  solvers::Settings options = {};  // each option of `hello`
};

// Returns the first message to a process, with the end of its line.
std::string robot_message(const SolveSetup& setup);
// Returns the message on one solve, without the end of its line. A `warm` one asks for two solves in a row.
std::string solve_message(const solvers::Problem& problem, const solvers::Goal& goal, const solvers::StopRule& stop,
                          std::uint32_t seed, results::CacheState state = results::CacheState::first);
// Returns the reply to a request to evaluate, with the end of its line. Errors [m] that are not finite become null.
// With `is_over` the program is told that its budget is used up.
std::string errors_message(const Eigen::VectorXd& errors, bool is_over);

}  // namespace ikbench::experiments
