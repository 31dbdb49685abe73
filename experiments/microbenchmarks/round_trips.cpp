// Measures a round trip to a program that solves: it gets the errors of ten candidates of two joints, and asks for ten
// others. The programs are the examples in docs/examples/, in C and in Python, with their own computations. The least
// that a round trip can take is that of `cat`, which sends back a line of as many bytes through bare pipes.
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/foreign/foreign_solver.hpp"
#include "experiments/microbenchmarks/harness.hpp"

namespace ikbench::microbenchmarks {

using namespace numerics;
using namespace robots;
using namespace solvers;
using namespace experiments;

namespace {

void round_trip(benchmark::State& state, const std::vector<std::string>& words) {
  const Chain arm({{.a = 0.5}, {.a = 0.5}});
  const JointLimits limits{Configuration::Constant(2, -3), Configuration::Constant(2, 3)};
  const StopRule stop{.iterations = 100};  // of the warm-up
  const Problem problem{
      .start = Configuration::Constant(2, 0.1), .lower = limits.lower, .upper = limits.upper, .population = 10};
  std::shared_ptr<const Program> program;
  try {
    program = meet({.process = words, .patience = 3600}, {});
  } catch (const std::exception& missing) {
    state.SkipWithError(missing.what());
    return;
  }
  Sessions sessions(program, robot_message({.name = "two",
                                            .arm = arm,
                                            .limits = limits,
                                            .joint_names = {"a", "b"},
                                            .urdf = {},
                                            .base_link = {},
                                            .tip_link = {}},
                                           program->hello, options_of(program->hello, {})));
  ForeignSolver solver(sessions, stop);
  Objective objective(arm, Eigen::Vector3d(0.3, 0.4, 0));
  Random random{Key(1)};
  solver.prepare(problem, objective);
  solver.start(problem, objective, random);
  for (auto _ : state) solver.step(objective, random);
  if (solver.account().failure) state.SkipWithError(solver.trouble().c_str());
  solver.conclude();
}

// `cat` behind two pipes.
class Echo {
 public:
  Echo() {
    std::array<int, 2> to{}, from{};
    if (::pipe(to.data()) != 0 || ::pipe(from.data()) != 0) throw std::runtime_error("no pipe");
    process_ = ::fork();
    if (process_ == 0) {
      ::dup2(to[0], STDIN_FILENO);
      ::dup2(from[1], STDOUT_FILENO);
      for (const int end : {to[0], to[1], from[0], from[1]}) ::close(end);
      ::execlp("cat", "cat", nullptr);
      ::_exit(127);
    }
    ::close(to[0]);
    ::close(from[1]);
    in_ = to[1];
    out_ = from[0];
  }
  ~Echo() {
    ::close(in_);
    ::close(out_);
    ::waitpid(process_, nullptr, 0);
  }
  Echo(const Echo&) = delete;
  Echo& operator=(const Echo&) = delete;

  bool sends_back(std::string& line) {
    if (::write(in_, line.data(), line.size()) != static_cast<ssize_t>(line.size())) return false;
    for (std::size_t read = 0; read < line.size();) {
      const ssize_t more = ::read(out_, line.data() + read, line.size() - read);
      if (more <= 0) return false;
      read += static_cast<std::size_t>(more);
    }
    return true;
  }

 private:
  pid_t process_ = -1;
  int in_ = -1, out_ = -1;
};

void echo(benchmark::State& state) {
  constexpr std::size_t bytes = 300;  // ten errors take about 200, ten answers of two joints about 400
  std::string line(bytes, 'x');
  std::signal(SIGPIPE, SIG_IGN);
  Echo cat;
  for (auto _ : state) {
    if (cat.sends_back(line)) continue;
    state.SkipWithError("no cat");
    break;
  }
}

void register_programs() {
  benchmark::RegisterBenchmark("round_trips/echo", echo)->UseRealTime();
  benchmark::RegisterBenchmark("round_trips/c", round_trip, std::vector<std::string>{IKBENCH_SEARCH})->UseRealTime();
  benchmark::RegisterBenchmark("round_trips/python", round_trip, std::vector<std::string>{"python3", IKBENCH_PSO})
      ->UseRealTime();
}

}  // namespace

}  // namespace ikbench::microbenchmarks

int main(int argc, char** argv) {
  ikbench::microbenchmarks::register_programs();
  return ikbench::microbenchmarks::run(argc, argv);
}
