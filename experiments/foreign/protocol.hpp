// The messages between a program and ikbench, one JSON object per line (docs/solvers-in-any-language.md): numbers to
// text and text to numbers. Programs are not trusted: everything they say is bounded and checked here.
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

// solve: the program has its own kinematics and solves at once. ask: ikbench evaluates its candidates.
enum class Mode { solve, ask };
std::string_view name_of(Mode mode);

// A breach of the protocol; its text is the end of a sentence: "its hello has no name".
struct Breach : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct HelloOption {
  enum class Type { number, integer, choice };

  std::string name, meaning;
  Type type = Type::number;
  double low = 0, high = 0, preset = 0;  // of a number or an integer
  std::vector<std::string> choices;      // of a choice, the preset first
};

// A program's introduction of itself.
struct Hello {
  std::string name, version;
  std::vector<Mode> modes;  // at least one; the preferred one first
  std::vector<HelloOption> options;
  bool is_deterministic = false;  // the same for every seed
};

// The options of a program: its defaults with the settings applied. Throws std::invalid_argument as OptionList::set
// does.
solvers::Settings options_of(const Hello& hello, const solvers::Settings& settings);

// A message of the program. message_in gives nothing for a line that is no JSON object with a message.
struct Message {
  std::string name;
  nlohmann::ordered_json json;
  std::optional<std::int64_t> id;
};
std::optional<Message> message_in(const std::string& line);

// All throw Breach if the message makes no sense.
Hello hello_in(const Message& message);
std::string why_in(const nlohmann::ordered_json& declined);
// Candidates as columns. A list of numbers is one candidate; so is a number, if there is one joint.
robots::Candidates candidates_in(const Message& ask, int joints);

// The answer of a program with its own kinematics. Only q is required; the rest is the program's claim.
struct Solved {
  Eigen::VectorXd q;                                        // [rad]; NaN where the message has null
  double error = std::numeric_limits<double>::quiet_NaN();  // [m] position error
  double seconds = std::numeric_limits<double>::quiet_NaN();
  std::int64_t evaluations = -1, iterations = -1;  // negative: not given
  std::optional<results::StopReason> reason;
};
Solved solved_in(const Message& message, int joints);

// The arm that is searched, and what is the same for all solves.
struct ArmToSearch {
  std::string name;
  const robots::Chain& arm;
  const robots::JointLimits& limits;     // of the searched joints, the first of the arm
  std::vector<std::string> joint_names;  // one per searched joint
  bool is_pose = false;
  double rotation_weight = 0;             // [m]
  std::string urdf, base_link, tip_link;  // as in the file; empty: none
};
std::string robot_message(const ArmToSearch& arm, const Hello& hello, const solvers::Settings& options);

struct SolveRequest {
  std::int64_t id;
  const solvers::Problem& problem;
  const solvers::Goal& goal;
  const solvers::StopRule& stop;
  std::uint32_t seed;
};
std::string solve_message(Mode mode, const SolveRequest& asked);
enum class Over { no, yes };
std::string tell_message(std::int64_t id, const Eigen::VectorXd& errors, double best, Over over);
std::string bye_message();

}  // namespace ikbench::experiments
