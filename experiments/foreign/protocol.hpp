// What a program and this one say to each other, one JSON object a line (docs/solvers-in-any-language.md): texts from
// numbers and numbers from texts. A program may be anybody's: whatever it says is bounded and checked here.
#pragma once

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "results/record.hpp"
#include "robots/robot.hpp"
#include "solvers/options.hpp"
#include "solvers/solve.hpp"

namespace ikbench::experiments {

constexpr int protocol_version = 1;

// solve: the program has its own kinematics, and solves at once. ask: this one evaluates its candidates.
enum class Mode { solve, ask };
std::string_view name_of(Mode mode);

// A breach of the protocol; what it says is a sentence's end: "its hello has no name".
struct Breach : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct HelloOption {
  enum class Type { number, integer, choice };

  std::string name, meaning;
  Type type = Type::number;
  double low = 0, high = 0, preset = 0;  // of numbers
  std::vector<std::string> choices;      // of a choice, the preset first
};

// Who a program is.
struct Hello {
  std::string name, version;
  std::vector<Mode> modes;  // at least one; the first is the one it prefers
  std::vector<HelloOption> options;
  bool is_deterministic = false;  // whatever the seed
};

// The options of a program with settings applied, or its defaults; std::invalid_argument as OptionList::set says.
solvers::Settings options_of(const Hello& hello, const solvers::Settings& settings);

// A message of the program: its object, its name. Nothing for what is no JSON object with a message.
struct Message {
  std::string name;
  nlohmann::ordered_json json;
  std::optional<std::int64_t> id;
};
std::optional<Message> message_in(const std::string& line);

// All Breach for what makes no sense.
Hello hello_in(const Message& message);
std::string why_in(const Message& declined);
// Candidates as columns; a list of numbers is one candidate, or of a single joint one a number.
robots::Candidates candidates_in(const Message& ask, int joints);

// The answer of a program with its own kinematics. Only q has to be there; the rest is its own word. What comes after
// `reason` is said of shared objects alone, by `ikbench host`.
struct Solved {
  Eigen::VectorXd q;                                        // [rad]; NaN where it says null
  double error = std::numeric_limits<double>::quiet_NaN();  // [m] of the position
  double seconds = std::numeric_limits<double>::quiet_NaN();
  std::int64_t evaluations = -1, iterations = -1;  // negative: it says nothing
  std::optional<results::StopReason> reason;
  double cpu_seconds = std::numeric_limits<double>::quiet_NaN();
  double smallest_seconds = std::numeric_limits<double>::quiet_NaN();  // of the repeats
  double largest_seconds = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> trace;  // best error [m] after each iteration
  solvers::Improvements improved;
};
Solved solved_in(const Message& message, int joints);

// The arm as it is searched, and what is asked of it for all solves.
struct ArmToSearch {
  std::string name;
  const robots::Chain& arm;
  const robots::JointLimits& limits;     // of these joints, the first of the arm
  std::vector<std::string> joint_names;  // of as many
  bool is_pose = false;
  double rotation_weight = 0;             // [m]
  std::string urdf, base_link, tip_link;  // as the file has it; empty: none
};
std::string robot_message(const ArmToSearch& arm, const Hello& hello, const solvers::Settings& options);

// What `ikbench host` needs besides to solve as this program does. Without repeats it is not told.
struct HostedSolve {
  std::uint64_t stream = 0;  // value of the key
  int repeats = 0;
  solvers::Trace trace = solvers::Trace::none;
};

struct AskedSolve {
  std::int64_t id;
  const solvers::Problem& problem;
  const solvers::Goal& goal;
  const solvers::StopRule& stop;
  std::uint32_t seed;
  HostedSolve hosted = {};
};
std::string solve_message(Mode mode, const AskedSolve& asked);
enum class Over { no, yes };
std::string tell_message(std::int64_t id, const Eigen::VectorXd& errors, double best, Over over);
// As long as a message of so many bytes.
std::string ping_message(std::int64_t id, std::size_t bytes);
std::string bye_message();

}  // namespace ikbench::experiments
