// The messages between a program and ikbench, one JSON object a line (docs/reference/protocol.md). Programs are
// not trusted: everything they say is bounded and checked here.
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

using base::ChildProcess, base::Clock, base::Trouble;

constexpr int protocol_version = 2;

struct HelloOption {
  std::string name, meaning;
  bool is_whole = false;
  double low = 0, high = 0, preset = 0;  // of a number
  std::vector<std::string> choices;      // of a choice, the preset first; else empty
};

// A program's introduction of itself.
struct Hello {
  std::string name, version;
  std::vector<HelloOption> options;
  std::vector<std::string> goals;  // that it solves for: position, axis, pose
  bool takes_batches = false;

  bool solves(solvers::GoalKind goal) const;
};

// The options of a program: its defaults with the settings applied. Throws std::invalid_argument as OptionList::set
// does.
solvers::Settings options_of(const Hello& hello, const solvers::Settings& settings);

constexpr std::size_t most_bytes_of_name = 180;  // of what a check says, which is stored with a prefix
constexpr std::size_t most_extras = 50;          // names, in one answer and in all of a program

// A message of a program. What makes no sense is a Trouble that shows the line and what was expected.
class Message {
 public:
  explicit Message(std::string line);
  const std::string& name() const { return name_; }
  Hello hello() const;
  std::string why() const;
  robots::Candidates candidates(int joints, const char* key = "candidates") const;
  std::map<std::string, double> extras(const char* key = "extras") const;
  std::string fault() const;  // why a check finds an answer invalid; empty: it is valid
  // Of a batch, by the messages of its problems, in whose order they come, each with the seed of its problem.
  std::map<std::string, std::optional<Message>> answers(const std::vector<std::string>& problems) const;
  bool has(const char* key) const;
  robots::Configuration joints(int joints) const;  // [rad]; NaN where the message has null
  double number(const char* key) const;            // NaN if there is none
  std::int64_t count(const char* key) const;       // -1 if there is none

  [[noreturn]] void fail(const std::string& expected) const;

 private:
  std::string text(const nlohmann::json& object, const char* key) const;
  HelloOption option(const nlohmann::json& object) const;
  robots::Configuration configuration(const nlohmann::json& list, int joints, const std::string& expected) const;

  std::string line_, name_;
  std::shared_ptr<const nlohmann::json> json_;
};

// What is the same for all solves. `searched` has the joints before the wrist, or all; of `goal` the target does not
// matter. A solver gets the arm that is judged as text, a check its file with the bodies in it: `own_urdf`, if not
// empty.
std::string robot_message(const robots::Robot& arm, const robots::Chain& searched, const solvers::Goal& goal,
                          const std::string& own_urdf, const Hello& hello, const solvers::Settings& options);
// Without the end of its line.
std::string solve_message(const solvers::Problem& problem, const solvers::Goal& goal, const solvers::StopRule& stop,
                          std::uint32_t seed);
std::string errors_message(const Eigen::VectorXd& errors, bool is_over);

}  // namespace ikbench::experiments
