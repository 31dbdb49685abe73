// ikbench check-solver: checks a program for its author before a study runs it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <thread>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/options.hpp"
#include "experiments/foreign/foreign_solver.hpp"
#include "experiments/verifier.hpp"

namespace ikbench::cli {

using namespace experiments;
using namespace numerics;
using namespace robots;
using namespace solvers;
using namespace results;

namespace {

struct CheckLine {
  std::string what;
  bool passed;
  std::string seen;
};

// An arm about a metre long; each axis is at a right angle to the one before.
struct SomeArm {
  explicit SomeArm(Joint second = Joint::turns, bool has_ends = true) : chain(links(second)) {
    const double end = has_ends ? std::numbers::pi : std::numeric_limits<double>::infinity();
    limits = {Configuration::Constant(joints, -std::numbers::pi), Configuration::Constant(joints, std::numbers::pi)};
    limits.lower[0] = -end, limits.upper[0] = end;
    if (second == Joint::slides) limits.lower[1] = 0, limits.upper[1] = 1;
  }
  static std::vector<DhLink> links(Joint second) {
    std::vector<DhLink> all;
    for (int j = 0; j < joints; ++j) {
      all.push_back({.a = 0.15, .alpha = j % 2 == 0 ? std::numbers::pi / 2 : -std::numbers::pi / 2});
    }
    all[1].joint = second;
    return all;
  }
  Pose reachable() const { return chain.forward(Configuration::LinSpaced(joints, 0.3, 0.7)); }

  static constexpr int joints = 7;
  Chain chain;
  JointLimits limits;
};

constexpr double allowed_claim = 1e-6;  // [m], rounding to single precision

struct Tried {
  Configuration q;
  double error = 0;  // [m], of its position
  double seconds = 0;
  Account account;
};

class Checker {
 public:
  explicit Checker(const ProgramChoice& choice) : choice_(choice) {}

  std::vector<CheckLine> run() {
    try {
      program_ = meet(choice_, {});
    } catch (const std::exception& error) {
      line("it says hello", false, error.what());
      return lines_;
    }
    line("it says hello", true, fmt::format("{} {}", program_->hello.name, program_->hello.version));
    const SomeArm arm;
    const Eigen::Vector3d position = arm.reachable().translation();
    const Tried first = answers("it answers for a position, inside the limits", arm, position);
    if (first.account.failure) return lines_;  // the other checks would say the same
    const SomeArm endless(Joint::turns, false), sliding(Joint::slides);
    answers("or declines: a whole pose", arm, {arm.reachable(), 0.25});
    answers("or declines: a joint that turns without end", endless, position);
    answers("or declines: a joint that slides", sliding, Eigen::Vector3d(sliding.reachable().translation()));
    seeds(arm, first);
    budget(arm);
    farewell();
    return lines_;
  }

 private:
  void line(std::string what, bool passed, std::string seen) {
    lines_.push_back({std::move(what), passed, std::move(seen)});
  }

  std::unique_ptr<Sessions> sessions_for(const SomeArm& arm, const Goal& goal) const {
    return std::make_unique<Sessions>(program_, robot_message({.name = "check",
                                                               .arm = arm.chain,
                                                               .limits = arm.limits,
                                                               .rotation_weight = goal.rotation_weight,
                                                               .claim_slack = allowed_claim},
                                                              program_->hello, options_of(program_->hello, {})));
  }

  static constexpr StopRule usual{.iterations = 100, .tolerance = 1e-4, .angle_tolerance = 1e-3, .evaluations = 3000};

  static Tried solve(Sessions& sessions, const SomeArm& arm, const Goal& goal, const StopRule& stop = usual) {
    const Problem problem{.start = Configuration::Constant(SomeArm::joints, 0.1),
                          .lower = arm.limits.lower,
                          .upper = arm.limits.upper,
                          .population = 20};
    Objective objective(arm.chain, goal);
    Random random(Key(1));
    ForeignSolver solver(sessions, stop);
    solver.prepare(problem, objective);
    const Clock::time_point began = Clock::now();
    const Solution solution = solvers::solve(solver, problem, objective, random, stop);
    const double seconds = std::chrono::duration<double>(Clock::now() - began).count();
    return {solution.best.q, objective.deviation(solution.best.q).position, seconds, solver.account()};
  }

  Tried answers(std::string what, const SomeArm& arm, const Goal& goal) {
    const auto sessions = sessions_for(arm, goal);
    const Tried tried = solve(*sessions, arm, goal);
    const Account& account = tried.account;
    const double outside = arm.limits.violation(tried.q);
    const bool lies = std::abs(account.claimed_error - tried.error) > allowed_claim;  // not if it claims none
    std::string wrong;
    if (account.failure)
      wrong = sessions->notes().last_failure;
    else if (!tried.q.allFinite())
      wrong = "its answer is not finite";
    else if (outside > 1e-9)
      wrong = fmt::format("its answer is {:.3g} rad or m outside", outside);
    else if (lies)
      wrong = fmt::format("it says that it is {:.9g} m off, and is {:.9g} m off", account.claimed_error, tried.error);
    else if (account.went_on)
      wrong = "it asks for more evaluations after it is told that its budget is used up";
    const bool may_decline = account.failure == Status::declined && what.starts_with("or declines");
    const std::string counted = account.counted_by == CountedBy::suite
                                    ? fmt::format("{} evaluations, counted here", account.evaluations)
                                : account.counted_by == CountedBy::solver ? "own kinematics; its own count"
                                                                          : "own kinematics; it counts nothing";
    line(std::move(what), wrong.empty() || may_decline,
         wrong.empty() ? fmt::format("{:.2g} m off; {}", tried.error, counted) : wrong);
    return tried;
  }

  void seeds(const SomeArm& arm, const Tried& first) {
    const Goal goal = Eigen::Vector3d(arm.reachable().translation());
    const auto sessions = sessions_for(arm, goal);
    const Tried fresh = solve(*sessions, arm, goal), again = solve(*sessions, arm, goal);
    const bool in_fresh = fresh.q == first.q, in_same = again.q == first.q;
    line("the same seed gives the same answer", in_fresh && in_same,
         in_fresh && in_same ? ""
         : in_fresh          ? "not when it solves again"
                             : "not in another process");
  }

  // A machine may be busy, so the best of a few attempts counts.
  void budget(const SomeArm& arm) {
    const Goal goal = Eigen::Vector3d(10, 0, 0);
    const StopRule stop{.iterations = 1'000'000, .tolerance = 1e-4, .seconds = 0.05};
    const auto sessions = sessions_for(arm, goal);
    Tried tried = solve(*sessions, arm, goal, stop);
    const auto is_late = [&] { return tried.account.went_on || is_over({.seconds = tried.seconds}, stop); };
    for (int i = 0; i < 4 && !tried.account.failure && is_late(); ++i) tried = solve(*sessions, arm, goal, stop);
    line("it keeps a budget of 50 ms for a target out of reach", !tried.account.failure && !is_late(),
         tried.account.failure ? sessions->notes().last_failure : fmt::format("{:.0f} ms", 1000 * tried.seconds));
  }

  void farewell() {
    Hello hello;
    const std::unique_ptr<ChildProcess> child = started(choice_, {}, hello);
    const Clock::time_point began = Clock::now();
    child->end(std::chrono::seconds(2));
    const bool ended = Clock::now() - began < std::chrono::seconds(2);
    line("it ends with its standard input", ended, ended ? "" : "it still ran after 2 s");
  }

  const ProgramChoice& choice_;
  std::shared_ptr<const Program> program_;
  std::vector<CheckLine> lines_;
};

}  // namespace

void add_check_solver(Command& app, Invocation& invocation) {
  struct Arguments {
    std::vector<std::string> words;
    double patience = 5;
    bool is_json = false;
  };
  auto arguments = std::make_shared<Arguments>();
  Command* command = app.add_subcommand("check-solver", "Check a solver that is a program");
  command->add_option("COMMAND", arguments->words, "the program and its arguments, after --")->required();
  command->add_option("--patience", arguments->patience, "seconds after which a solve is given up")
      ->check(number_in({0.1, 3600}))
      ->capture_default_str();
  add_json_option(*command, arguments->is_json);
  command->footer(
      "Examples:\n"
      "  ikbench check-solver -- python3 my_solver.py\n"
      "  ikbench check-solver --patience 60 -- octave-cli --quiet my_solver.m\n\n"
      "Exit code 1 where a check fails. docs/reference/protocol.md describes what a program has to say.");
  command->callback([arguments, &invocation] {
    const ProgramChoice choice{.process = arguments->words, .files = {}, .patience = arguments->patience};
    const std::vector<CheckLine> lines = Checker(choice).run();
    const auto failed = std::ranges::count(lines, false, &CheckLine::passed);
    if (failed > 0) invocation.exit_code = 1;
    if (arguments->is_json) {
      numerics::OrderedJson all = numerics::OrderedJson::array();
      for (const CheckLine& line : lines) {
        all.push_back({{"check", line.what}, {"passed", line.passed}, {"seen", line.seen}});
      }
      return show_json(all);
    }
    fmt::print("{}\n\n", failed == 0 ? coloured(fmt::format("All {} checks passed.", lines.size()), Tone::good)
                                     : coloured(fmt::format("{} of {} checks failed{}", failed, lines.size(),
                                                            lines.size() < 8 ? "; the others were not made." : "."),
                                                Tone::bad));
    for (const CheckLine& line : lines) {
      constexpr std::size_t length_of_state = 8;
      const std::string text = wrapped(fmt::format("{}{}{}", line.what, line.seen.empty() ? "" : ": ", line.seen),
                                       text_width() - length_of_state);
      fmt::print("{}{}\n", line.passed ? coloured("ok      ", Tone::good) : coloured("FAILED  ", Tone::bad), text);
    }
  });
}

}  // namespace ikbench::cli
