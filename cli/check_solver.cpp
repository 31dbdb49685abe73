// ikbench check-solver: checks a program for its author before a study runs it.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/options.hpp"
#include "experiments/foreign/foreign_solver.hpp"
#include "experiments/verifier.hpp"
#include "numerics/json.hpp"

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

constexpr StopRule usual{.iterations = 100, .tolerance = 1e-4, .angle_tolerance = 1e-3, .evaluations = 3000};

// An arm about a metre long; each axis is at a right angle to the one before.
Robot some_arm(Joint second = Joint::turns, double end_of_first = std::numbers::pi) {
  std::vector<DhLink> links;
  for (const double side : {1, -1, 1, -1, 1, -1, 1}) links.push_back({.a = 0.15, .alpha = side * std::numbers::pi / 2});
  links[1].joint = second;
  Configuration ends = Configuration::Constant(7, std::numbers::pi);
  ends[0] = end_of_first;
  Robot arm{.name = "check", .summary = {}, .source = {}, .chain = Chain(links), .limits = {-ends, ends}};
  if (second == Joint::slides) arm.limits.lower[1] = 0, arm.limits.upper[1] = 1;
  return arm;
}

Pose reachable(const Robot& arm) { return arm.chain.forward(Configuration::LinSpaced(arm.joints(), 0.3, 0.7)); }

struct Tried {
  Configuration q;
  double error;  // [m], of its position
  double seconds;
  Account account;
};

// Processes of a program that solve for one goal of an arm.
struct Solving {
  Solving(const std::shared_ptr<const Program>& program, const Robot& its_arm, Goal its_goal)
      : arm(its_arm),
        goal(std::move(its_goal)),
        all(program,
            robot_message(arm, arm.chain, goal, {}, program->hello, options_of(program->hello, {}))) {}

  Tried once(const StopRule& stop = usual) {
    const Problem problem{.start = Configuration::Constant(arm.joints(), 0.1),
                          .lower = arm.limits.lower,
                          .upper = arm.limits.upper,
                          .population = 20};
    Objective objective(arm.chain, goal);
    Random random(Key(1));
    ForeignSolver solver(all, stop);
    solver.prepare(problem, objective);
    const Clock::time_point began = Clock::now();
    const Solution solution = solvers::solve(solver, problem, objective, random, stop);
    const std::chrono::duration<double> took = Clock::now() - began;
    return {solution.best.q, objective.deviation(solution.best.q).position, took.count(), solver.account()};
  }

  const Robot arm;
  const Goal goal;
  Conversations all;
};

class Checks {
 public:
  explicit Checks(const ProgramChoice& choice) {
    try {
      check(meet(choice, {}));
    } catch (const std::invalid_argument& error) {
      line("it says hello", error.what());
    }
  }

  std::vector<CheckLine> lines;

 private:
  void line(std::string what, std::string wrong, std::string seen = {}) {
    lines.push_back({std::move(what), wrong.empty(), wrong.empty() ? std::move(seen) : std::move(wrong)});
  }

  void check(const std::shared_ptr<const Program>& program) {
    line("it says hello", "", fmt::format("{} {}", program->hello.name, program->hello.version));
    const Robot arm = some_arm(), endless = some_arm(Joint::turns, std::numeric_limits<double>::infinity()),
                sliding = some_arm(Joint::slides);
    const Eigen::Vector3d position = reachable(arm).translation(), slid = reachable(sliding).translation();
    Solving usually(program, arm, position), afresh(program, arm, position), pose(program, arm, {reachable(arm), 0.25}),
        turning(program, endless, position), shifting(program, sliding, slid),
        hopeless(program, arm, Eigen::Vector3d(10, 0, 0));
    const Tried first = answers("it answers for a position, inside the limits", usually);
    if (first.account.failure || !first.q.allFinite()) return;  // the other checks would say the same
    answers("or declines: a whole pose", pose);
    answers("or declines: a joint that turns without end", turning);
    answers("or declines: a joint that slides", shifting);
    line("the same seed gives the same answer", afresh.once().q != first.q    ? "not in another process"
                                                : usually.once().q != first.q ? "not when it solves again"
                                                                              : "");
    budget(hopeless);
    farewell(usually.all.take());
  }

  Tried answers(std::string what, Solving& solving) {
    const Tried tried = solving.once();
    const Account& account = tried.account;
    const double outside = solving.arm.limits.violation(tried.q);
    std::string wrong;
    if (account.failure)
      wrong = solving.all.last_failure();
    else if (!tried.q.allFinite())
      wrong = "its answer is not finite";
    else if (outside > 1e-9)
      wrong = fmt::format("its answer is {:.3g} rad or m outside", outside);
    else if (std::abs(account.claimed_error - tried.error) > claim_slack(solving.arm))  // not if it claims none
      wrong = fmt::format("it says that it is {:.9g} m off, and is {:.9g} m off", account.claimed_error, tried.error);
    else if (account.went_on)
      wrong = "it asks for more evaluations after it is told that its budget is used up";
    const std::string counted = account.counted_by == CountedBy::suite
                                    ? numerics::counted(account.evaluations, "evaluations") + ", counted here"
                                : account.counted_by == CountedBy::solver ? "own kinematics; its own count"
                                                                          : "own kinematics; it counts nothing";
    const bool may_decline = account.failure == Status::declined && what.starts_with("or declines");
    line(std::move(what), may_decline ? "" : wrong,
         may_decline ? wrong : fmt::format("{:.2g} m off; {}", tried.error, counted));
    return tried;
  }

  // A machine may be busy, so the best of a few attempts counts.
  void budget(Solving& solving) {
    const StopRule stop{.iterations = 1'000'000, .tolerance = 1e-4, .seconds = 0.05};
    Tried tried;
    bool is_late = true;
    for (int i = 0; i < 5 && is_late && !tried.account.failure; ++i) {
      tried = solving.once(stop);
      is_late = tried.account.went_on || is_over({.seconds = tried.seconds}, stop);
    }
    const std::string took = fmt::format("{:.0f} ms", 1000 * tried.seconds);
    line("it keeps a budget of 50 ms for a target out of reach",
         tried.account.failure ? solving.all.last_failure()
         : is_late             ? took
                               : "",
         took);
  }

  void farewell(Conversation last) {
    if (last.child) last.child->end_input();
    const Trouble heard =
        last.child ? unasked(*last.child, std::chrono::seconds(2)) : Trouble{Status::declined, "it had ended before"};
    line("it answers once, and ends with its standard input", heard.status == Status::crashed ? ""
                                                              : heard.status == Status::timed_out
                                                                  ? "it still ran after 2 s"
                                                                  : heard.why);
  }
};

}  // namespace

void add_check_solver(CLI::App& app, Invocation& invocation) {
  struct Arguments {
    ProgramChoice choice{.process = {}, .files = {}, .patience = 5};
    bool is_json = false;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("check-solver", "Check a solver that is a program");
  command->add_option("COMMAND", arguments->choice.process, "the program and its arguments, after --")->required();
  command->add_option("--patience", arguments->choice.patience, "seconds after which a solve is given up")
      ->check(number_in({0.1, 3600}))
      ->capture_default_str();
  add_json_option(*command, arguments->is_json);
  command->footer(
      "Examples:\n"
      "  ikbench check-solver -- python3 my_solver.py\n"
      "  ikbench check-solver --patience 60 -- octave-cli --quiet my_solver.m\n\n"
      "Exit code 1 where a check fails. docs/reference/protocol.md describes what a program has to say.");
  command->callback([arguments, &invocation] {
    const std::vector<CheckLine> lines = Checks(arguments->choice).lines;
    const auto failed = std::ranges::count(lines, false, &CheckLine::passed);
    if (failed > 0) invocation.exit_code = 1;
    if (arguments->is_json) {
      OrderedJson all = OrderedJson::array();
      for (const CheckLine& line : lines)
        all.push_back({{"check", line.what}, {"passed", line.passed}, {"seen", line.seen}});
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
