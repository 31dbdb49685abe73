// The messages between a program and ikbench, one JSON object per line (docs/reference/protocol.md). Programs are not
// trusted: everything they send is bounded and checked here.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/child_process.hpp"
#include "robots/robot.hpp"
#include "solvers/options.hpp"
#include "solvers/solve.hpp"

namespace ikbench::experiments {

using base::ChildProcess, base::Clock, base::ProcessFailure;

constexpr int protocol_version = 2;

// An option that a program offers.
struct OptionSpec {
  std::string name, meaning;
  bool is_whole = false;
  double low = 0, high = 0, preset = 0;  // if it is a number
  std::vector<std::string> choices;      // if it is a choice, the preset first; otherwise empty
};

// A program's introduction of itself.
struct Hello {
  std::string name, version;
  std::vector<OptionSpec> options;
  std::vector<std::string> goals;  // of position, axis, pose
  bool takes_batches = false;

  bool solves(solvers::GoalKind goal) const;
};

// Returns the options of a program: its defaults with the settings applied. Throws std::invalid_argument as
// OptionList::set does.
solvers::Settings resolved_options(const Hello& hello, const solvers::Settings& settings);

constexpr std::size_t max_name_bytes = 180;  // of a name from a check, which is stored with a prefix
constexpr std::size_t max_extras = 50;       // names, in one answer and in all of a program

// A message of a program. A message that breaks the protocol throws Trouble, which shows the line and what was
// expected.
class Message {
 public:
  explicit Message(std::string line);
  const std::string& name() const { return name_; }
  Hello hello() const;
  std::string decline_reason() const;
  robots::Candidates candidates(int joints, const char* key = "candidates") const;
  std::map<std::string, double> extras(const char* key = "extras") const;
  std::string rejection_reason() const;  // why a check finds an answer invalid; empty: valid
  // Returns the answers of a batch by the messages of its problems. They come in the order of the problems, each with
  // the seed of its problem.
  std::map<std::string, std::optional<Message>> answers(const std::vector<std::string>& problems) const;
  bool has(const char* key) const;
  robots::Configuration joints(int joints) const;  // [rad]; NaN where the message has null
  double number(const char* key) const;            // NaN if there is none
  std::int64_t count(const char* key) const;       // -1 if there is none

  [[noreturn]] void fail(const std::string& expected) const;

 private:
  std::string text(const nlohmann::json& object, const char* key) const;
  OptionSpec option(const nlohmann::json& object) const;
  robots::Configuration configuration(const nlohmann::json& list, int joints, const std::string& expected) const;

  std::string line_, name_;
  std::shared_ptr<const nlohmann::json> json_;
};

// Returns the message on what is the same for all solves. `searched` has the joints before the wrist, or all. The
// target of `goal` does not matter. A solver gets the arm that is judged as text; a check gets its file with the bodies
// in it, `urdf_text_for`, if that is not empty.
std::string robot_message(const robots::Robot& arm, const robots::Chain& searched, const solvers::Goal& goal,
                          const std::string& urdf_text_for, const Hello& hello, const solvers::Settings& options);
// Returns the message on one solve, without the end of its line.
std::string solve_message(const solvers::Problem& problem, const solvers::Goal& goal, const solvers::StopRule& stop,
                          std::uint32_t seed);
std::string errors_message(const Eigen::VectorXd& errors, bool is_over);

}  // namespace ikbench::experiments
