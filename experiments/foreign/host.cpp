#include "experiments/foreign/host.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "experiments/environment.hpp"
#include "experiments/foreign/shared_object.hpp"
#include "experiments/solve_runner.hpp"
#include "numerics/json.hpp"
#include "numerics/names.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;
using namespace solvers;

namespace {

using Json = nlohmann::ordered_json;

// The pipes to the suite. Once it exists, standard input is empty, and standard output goes to standard error.
class Suite {
 public:
  Suite() : in_(taken(STDIN_FILENO, "r")), out_(taken(STDOUT_FILENO, "w")) {
    const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    if (nothing < 0 || ::dup2(nothing, STDIN_FILENO) < 0 || ::dup2(STDERR_FILENO, STDOUT_FILENO) < 0)
      throw std::runtime_error(std::strerror(errno));
    ::close(nothing);
  }
  ~Suite() { std::free(line_); }
  Suite(const Suite&) = delete;
  Suite& operator=(const Suite&) = delete;

  std::optional<Json> next() {
    std::size_t room = 0;
    std::free(std::exchange(line_, nullptr));
    if (::getline(&line_, &room, in_.get()) < 0) return std::nullopt;
    return numerics::parsed_ordered_json(line_);
  }
  void say_line(const std::string& line) {
    if (std::fputs((line + '\n').c_str(), out_.get()) < 0 || std::fflush(out_.get()) != 0)
      throw std::runtime_error("nobody listens");
  }
  void say(const Json& message) { say_line(numerics::text_of(message)); }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  using File = std::unique_ptr<std::FILE, Close>;

  static File taken(int descriptor, const char* mode) {
    File file(::fdopen(::fcntl(descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1), mode));
    if (!file) throw std::runtime_error(std::strerror(errno));
    return file;
  }

  File in_, out_;
  char* line_ = nullptr;
};

constexpr std::size_t longest_trace = 40'000;  // numbers that fit in a line of a million bytes
constexpr double no_bound = std::numeric_limits<double>::infinity();

// The protocol says null for an infinite limit.
double number_in(const Json& value, double if_null) { return value.is_null() ? if_null : value.get<double>(); }

Eigen::VectorXd vector_in(const Json& list, double if_null = std::numeric_limits<double>::quiet_NaN()) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(list.size()));
  std::ranges::transform(list, values.begin(), [&](const Json& value) { return number_in(value, if_null); });
  return values;
}

Frame frame_in(const Json& list) {
  const Eigen::VectorXd numbers = vector_in(list);
  return {.position = numbers.head<3>(), .rpy = numbers.tail<3>()};
}

// The values of the options in the order of the solver's list; a choice is given by its number.
std::vector<double> option_values(const Json& list, const Json& told) {
  std::vector<double> values;
  for (const Json& option : list) {
    const Json& value = told.at(option.at("name").get<std::string>());
    if (value.is_number()) {
      values.push_back(value.get<double>());
    } else {
      const Json choices = option.value("choices", Json::array({"false", "true"}));
      values.push_back(static_cast<double>(std::ranges::find(choices, value) - choices.begin()));
    }
  }
  return values;
}

HostedArm arm_in(const Json& robot, const Json& options) {
  std::vector<DhLink> links;
  Eigen::VectorXd lower(static_cast<Eigen::Index>(robot.at("joints").size())), upper = lower;
  for (const Json& joint : robot.at("joints")) {
    const auto j = static_cast<Eigen::Index>(links.size());
    lower[j] = number_in(joint.at("lower"), -no_bound);
    upper[j] = number_in(joint.at("upper"), no_bound);
    const std::string type = joint.at("type");
    links.push_back({.a = joint.at("a"),
                     .alpha = joint.at("alpha"),
                     .d = joint.at("d"),
                     .offset = joint.at("theta"),
                     .joint = type == "prismatic" ? Joint::slides
                              : type == "coupled" ? Joint::coupled
                                                  : Joint::turns});
  }
  return {.name = robot.at("name"),
          .urdf = robot.value("urdf", ""),
          .base_link = robot.value("base_link", ""),
          .tip_link = robot.value("tip_link", ""),
          .chain = Chain(std::move(links), frame_in(robot.at("base_frame")), frame_in(robot.at("tool_frame"))),
          .limits = {lower, upper},
          .options = option_values(options, robot.at("options"))};
}

struct RequestToHost {
  Goal goal;
  Problem problem;
  StopRule stop;
  Key stream;
  std::uint32_t seed;
  Trace trace;
  int repeats;
};

RequestToHost solve_in(const Json& told, double rotation_weight) {
  const Json &target = told.at("target"), &budget = told.at("budget"), &tolerance = told.at("tolerance");
  Pose pose = Pose::Identity();
  pose.translation() = vector_in(target.at("position"));
  const bool is_pose = target.contains("rotation");
  if (is_pose) pose.linear() = vector_in(target["rotation"]).reshaped<Eigen::RowMajor>(3, 3);
  const StopRule stop{.iterations = budget.at("iterations"),
                      .tolerance = tolerance.at("position"),
                      .angle_tolerance = tolerance.at("rotation"),
                      .evaluations = budget.at("evaluations"),
                      .seconds = budget.at("seconds")};
  const std::uint32_t seed = told.at("seed");
  return {.goal = is_pose ? Goal(pose, rotation_weight) : Goal(pose.translation()),
          .problem = {.start = vector_in(told.at("start")),
                      .lower = vector_in(told.at("lower"), -no_bound),
                      .upper = vector_in(told.at("upper"), no_bound),
                      .population = told.at("population")},
          .stop = stop,
          .stream = told.contains("stream") ? Key::of(told["stream"]) : Key(seed),
          .seed = seed,
          .trace = told.value("trace", false) ? Trace::best_error : Trace::none,
          .repeats = told.value("repeats", 1)};
}

struct Measured {
  Solution solution;
  double seconds, cpu_seconds;
};

// Solves as often as asked; the results are ordered by time. Throws Breach if the answers differ, or if the processor's
// mode was changed.
std::vector<Measured> solved(SharedSolver& solver, const Chain& chain, const RequestToHost& asked) {
  std::vector<Measured> all;
  for (int i = 0; i < asked.repeats; ++i) {
    solver.set_seed(asked.seed);
    Objective objective(chain, asked.goal);
    Random random(asked.stream);
    const double thread_started = thread_seconds();
    const auto started = std::chrono::steady_clock::now();
    Solution solution = solvers::solve(solver, asked.problem, objective, random, asked.stop, asked.trace);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - started;
    all.push_back({std::move(solution), seconds.count(), thread_seconds() - thread_started});
    if (solver.changed_mode()) throw Breach("it changed the floating-point mode");
    if (!same_answer(all.back().solution, all.front().solution))
      throw Breach("it gives another answer when it solves the same again");
  }
  std::ranges::sort(all, {}, &Measured::seconds);
  return all;
}

Json answer(std::int64_t id, SharedSolver& solver, const Chain& chain, const RequestToHost& asked) {
  Json message{{"message", "solved"}, {"id", id}};
  try {
    const std::vector<Measured> all = solved(solver, chain, asked);
    const Measured& median = all[(all.size() - 1) / 2];
    const Solution& solution = median.solution;
    message["q"] = Json(std::vector<double>(solution.best.q.begin(), solution.best.q.end()));
    message["error"] = solution.position_error;
    message["evaluations"] = solution.evaluations;
    message["iterations"] = solution.iterations;
    message["reason"] = name_of(recorded(solution.stopped));
    message["seconds"] = median.seconds;
    message["cpu_seconds"] = median.cpu_seconds;
    message["smallest_seconds"] = all.front().seconds;
    message["largest_seconds"] = all.back().seconds;
    if (solution.trace.size() <= longest_trace) message["trace"] = solution.trace;
    if (solution.trace.size() + 2 * solution.improved.at.size() <= longest_trace) {
      message["improved_at"] = solution.improved.at;
      message["improved_to"] = solution.improved.to;
    }
  } catch (const Refusal& refusal) {
    return {{"message", "declined"}, {"id", id}, {"why", refusal.what()}};
  } catch (const Breach& breach) {
    message["fault"] = breach.what();
  }
  return message;
}

}  // namespace

std::vector<std::string> host_command(const std::string& object, const std::string& name) {
  const std::string self = "/proc/self/exe";
  std::error_code none;
  const bool is_ikbench = std::filesystem::read_symlink(self, none).filename().string().starts_with("ikbench");
  std::vector<std::string> command{is_ikbench ? self : "ikbench", "host", object};
  if (!name.empty()) command.push_back(name);
  return command;
}

void host(const std::filesystem::path& object, const std::string& name) {
  Suite suite;
  const SharedObject shared(object, name);
  const ikbench_solver& table = shared.solver();
  if (shared.changed_mode()) suite.say_line("it changes the floating-point mode when it is loaded; that was undone");
  suite.say(Json{{"ikbench", protocol_version},
                 {"message", "hello"},
                 {"name", table.name},
                 {"version", table.version == nullptr ? "" : table.version},
                 {"modes", {"solve"}},
                 {"options", shared.options()},
                 {"deterministic", table.is_deterministic != 0}});
  std::optional<HostedArm> arm;
  std::optional<SharedSolver> solver;
  double rotation_weight = 0;
  while (const std::optional<Json> told = suite.next()) {
    const std::string message = told->at("message");
    if (message == "bye") break;
    if (message == "ping") suite.say(Json{{"message", "pong"}, {"id", told->at("id")}});
    if (message == "robot") {
      arm.emplace(arm_in(*told, shared.options()));
      rotation_weight = told->at("rotation_weight");
      try {
        solver.emplace(table, *arm);
        suite.say(Json{{"message", "ready"}});
      } catch (const Refusal& refusal) {
        suite.say(Json{{"message", "declined"}, {"why", refusal.what()}});
      }
    }
    if (message == "solve" && solver)
      suite.say(answer(told->at("id"), *solver, arm->chain, solve_in(*told, rotation_weight)));
  }
}

}  // namespace ikbench::experiments
