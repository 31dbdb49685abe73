// ikbench check-solver: checks a program for its author before a study runs it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "base/names.hpp"
#include "cli/console.hpp"
#include "cli/options.hpp"
#include "experiments/external/external_solver.hpp"
#include "experiments/verifier.hpp"
#include "solvers/registry.hpp"

namespace ikbench::cli {

using namespace numerics;
using namespace robots;
using namespace solvers;

namespace {

struct CheckLine {
  std::string what;
  bool passed;
  std::string seen;
};

constexpr StopRule usual{.iterations = 3000, .tolerance = 1e-4, .angle_tolerance = 1e-3, .evaluations = 3000};

// An arm about a metre long; each axis is at a right angle to the one before.
Robot some_arm(Joint second = Joint::turns) {
  constexpr int joints = 7;
  std::vector<DhLink> links(joints, DhLink{.a = 0.15});
  for (std::size_t j = 0; j < joints; ++j) links[j].alpha = (j % 2 == 0 ? 1 : -1) * half_turn / 2;
  links[1].joint = second;
  JointLimits limits{Configuration::Constant(joints, -half_turn), Configuration::Constant(joints, half_turn)};
  if (second == Joint::slides) limits.lower[1] = 0;
  return {.name = "check", .summary = "", .source = "", .chain = Chain(links), .limits = limits};
}

Configuration inside(const Robot& arm, const Configuration& q) {
  return q.cwiseMax(arm.limits.lower).cwiseMin(arm.limits.upper);
}

// Names the first joint whose value is not finite.
std::string not_finite_in(const Configuration& q) {
  Eigen::Index joint = 0;
  while (joint + 1 < q.size() && std::isfinite(q[joint])) ++joint;
  return fmt::format("its answer is not finite: joint {} is {}", joint + 1, q[joint]);
}

// The first of the poses that are asked, or another.
Goal some_goal(const Robot& arm, GoalKind kind, double beyond, int which = 0) {
  const Configuration q = Configuration::LinSpaced(arm.joints(), 0.3 - 0.07 * which, 0.7 + 0.03 * which);
  Pose pose = arm.chain.forward(inside(arm, q));
  pose.translation().x() += beyond;
  return kind == GoalKind::position ? Goal(pose.translation()) : Goal(pose, 0.25, kind);
}

struct Tried {
  Configuration q;
  double error, angle;  // of its position [m], and of its orientation [rad], if that is asked
  double seconds;
  ProcessReport account;
};

// Processes of a program that solve for one goal of an arm.
struct Solving {
  Solving(const std::shared_ptr<const Program>& program, Robot its_arm, GoalKind kind, double its_beyond = 0)
      : arm(std::move(its_arm)),
        beyond(its_beyond),
        goal(some_goal(arm, kind, its_beyond)),
        all(program, robot_message(arm, arm.chain, goal, "", program->hello, resolved_options(program->hello, {}))) {}

  Tried once(const StopRule& stop = usual, int which = 0) {
    Objective objective(arm.chain, some_goal(arm, goal.kind, beyond, which));
    Random random(Key(1).with(static_cast<std::uint64_t>(which)));
    ExternalSolver solver(all, stop);
    solver.prepare(problem, objective);
    const Clock::time_point began = Clock::now();
    const Solution solution = solvers::solve(solver, problem, objective, random, stop);
    const std::chrono::duration<double> took = Clock::now() - began;
    solver.count_failure();
    const auto [position, angle] = objective.deviation(solution.best.q);
    const double asked = goal.kind == GoalKind::position ? 0 : angle;
    return {solution.best.q, position, asked, took.count(), solver.report()};
  }

  // Of a program with a batch: asks for all poses of `once` since the last time.
  void ask() {
    ExternalSolver solver(all, usual);
    solver.send_batch();
    solver.count_failure();
  }

  bool is_solved_by_lm(int which) const {
    Objective objective(arm.chain, some_goal(arm, goal.kind, beyond, which));
    Random random(Key(1));
    const std::unique_ptr<Solver> lm = solver("levenberg_marquardt").make({});
    return solvers::solve(*lm, problem, objective, random, usual).stopped == StopReason::tolerance;
  }

  const Robot arm;
  const double beyond;  // [m], of the goal
  const Goal goal;
  const Problem problem{.start = inside(arm, Configuration::Constant(arm.joints(), 0.1)),
                        .lower = arm.limits.lower,
                        .upper = arm.limits.upper,
                        .population = 20};
  ProcessPool all;
};

class Checks {
 public:
  Checks(const ProgramSpec& choice, Robot arm) : arm_(std::move(arm)) {
    try {
      check(probe(choice, {}));
    } catch (const std::invalid_argument& error) {
      line("it says hello", error.what());
    }
  }

  std::vector<CheckLine> lines;

 private:
  const Robot arm_;

  void line(std::string what, std::string wrong, std::string seen = {}) {
    lines.push_back({std::move(what), wrong.empty(), wrong.empty() ? std::move(seen) : std::move(wrong)});
  }

  void check(const std::shared_ptr<const Program>& program) {
    line("it says hello", "", fmt::format("{} {}", program->hello.name, program->hello.version));
    std::unique_ptr<Solving> usually;  // for the first kind of goal that it does not decline
    Tried first;
    for (const auto& [kind, name] : {std::pair(GoalKind::position, "a position"),
                                     {GoalKind::axis, "a position and an axis"},
                                     {GoalKind::pose, "a pose"}}) {
      if (!program->hello.solves(kind)) {
        line(fmt::format("it answers for {}", name), "", "its hello names other goals");
        continue;
      }
      auto solving = std::make_unique<Solving>(program, arm_, kind);
      const Tried tried = answers(name, *solving);
      if (usually || tried.account.failure == Status::declined) continue;
      if (tried.account.failure || !tried.q.allFinite()) return;  // the other checks would say the same
      usually = std::move(solving);
      first = tried;
    }
    if (!usually) return line("it solves one of these", "it declines them all");
    const GoalKind kind = usually->goal.kind;
    Robot endless = some_arm();
    endless.limits.upper[0] = std::numeric_limits<double>::infinity();
    endless.limits.lower[0] = -endless.limits.upper[0];
    Solving afresh(program, arm_, kind), turning(program, endless, kind),
        shifting(program, some_arm(Joint::slides), kind), hopeless(program, arm_, kind, 10);
    answers("a joint that turns without end", turning);
    answers("a joint that slides", shifting);
    same(*usually, afresh, first);
    if (program->hello.takes_batches) {
      auto batched = std::make_shared<Program>(*program);
      batched->choice.batch = 20;
      Solving together(batched, arm_, kind);
      for (int which = 0; which < batched->choice.batch; ++which)
        together.once(usual, which);  // which puts it into one
      together.ask();
      const Tried tried = together.once();
      const bool is_off = tried.account.failure || !(tried.error <= 2 * std::max(usual.tolerance, first.error));
      line("it answers the first of 20 poses in a batch as alone",
           !is_off ? "" : fmt::format("{:.2g} m off; {}", tried.error, together.all.last_failure()));
    }
    budgets(hopeless);
    farewell(usually->all.acquire());
  }

  Tried answers(const std::string& what, Solving& solving) {
    const Tried tried = solving.once();
    const ProcessReport& account = tried.account;
    const double outside = solving.arm.limits.violation(tried.q);
    const bool is_untrue = std::abs(account.reported_error - tried.error) > program_report_tolerance;  // NaN: no claim
    const std::string wrong =
        account.failure        ? solving.all.last_failure()
        : !tried.q.allFinite() ? not_finite_in(tried.q)
        : outside > 1e-9       ? fmt::format("its answer is {:.3g} rad or m outside", outside)
        : is_untrue
            ? fmt::format("it says that it is {:.9g} m off, and is {:.9g} m off", account.reported_error, tried.error)
        : account.ignored_budget ? "it asks for more evaluations after it is told that its budget is used up"
                                 : "";
    const std::string counted = account.counted_by == CountedBy::ikbench
                                    ? base::counted(account.evaluations, "evaluations") + ", counted here"
                                : account.counted_by == CountedBy::solver ? "own kinematics; its own count"
                                                                          : "own kinematics; it counts nothing";
    if (account.failure == Status::declined)
      line("it declines " + what, "", wrong);
    else
      line("it answers inside the limits for " + what, wrong, fmt::format("{:.2g} m off; {}", tried.error, counted));
    return tried;
  }

  // Of threads and clocks a few poses tell nothing. What misses the tolerance by a little may not know it.
  void same(Solving& usually, Solving& afresh, const Tried& first) {
    constexpr int poses = 20;
    int others = 0, solvable = 0, reached = 0, near = 0;
    for (int which = 0; which < poses; ++which) {
      const Tried here = usually.once(usual, which), there = afresh.once(usual, which);
      const double times = std::max(here.error / usual.tolerance, here.angle / usual.angle_tolerance);
      others += here.q != there.q;
      if (!usually.is_solved_by_lm(which)) continue;
      ++solvable;
      reached += times <= 1;
      near += times > 1 && times <= 2;
    }
    line(fmt::format("the same seed gives the same answer for {} poses", poses),
         others > 0                    ? fmt::format("{} differ in another process", others)
         : usually.once().q != first.q ? "not when it solves again"
                                       : "");
    const std::string seen = fmt::format("{} within {:g} m and {:g} rad, {} more within twice that", reached,
                                         usual.tolerance, usual.angle_tolerance, near);
    line(fmt::format("it reaches some of the {} poses that LM solves", solvable),
         reached == 0 && solvable > 0 ? seen : "", seen);
  }

  // A machine may be busy, so the best of a few attempts counts.
  void budgets(Solving& solving) {
    const auto overrun = [&](const StopRule& stop, int tries = 1) -> std::string {
      ResourceUse spent;
      for (; tries > 0; --tries) {
        const Tried tried = solving.once(stop);
        const ProcessReport& its = tried.account;
        if (its.failure) return solving.all.last_failure();
        spent = {credible_seconds(its, tried.seconds), its.evaluations, its.iterations};
        if (!its.ignored_budget && !exceeds_budget(spent, stop)) return "";
      }
      return fmt::format("{:.0f} ms, {} in {}", 1000 * spent.seconds, counted(spent.evaluations, "evaluations"),
                         counted(spent.iterations, "iterations"));
    };
    constexpr StopRule in_time{.iterations = 1'000'000, .tolerance = 1e-4, .seconds = 0.05};
    line(fmt::format("it keeps a budget of 50 ms, {:g} at most, for a target out of reach",
                     1000 * max_budget_ratio * in_time.seconds),
         overrun(in_time, 5));
    if (!solving.all.last_failure().empty()) return;
    std::string wrong = overrun({.iterations = 100, .tolerance = 1e-4, .evaluations = 40});
    if (wrong.empty()) wrong = overrun({.iterations = 10, .tolerance = 1e-4});
    line("it keeps a budget of 40 evaluations, and one of 10 iterations, half more at most", wrong);
  }

  void farewell(WorkerProcess last) {
    if (last.child) last.child->end_input();
    const ProcessFailure heard = last.child ? unsolicited_message(*last.child, 2)
                                            : ProcessFailure{ProcessFailure::Kind::declined, "it had ended before"};
    line("it answers once, and ends when its input does", heard.kind == ProcessFailure::Kind::crashed ? ""
                                                          : heard.kind == ProcessFailure::Kind::timed_out
                                                              ? "it still ran after 2 s"
                                                              : heard.why);
  }
};

}  // namespace

void add_check_solver(const Command& command, Invocation& invocation) {
  auto choice = std::make_shared<ProgramSpec>(ProgramSpec{.process = {}, .files = {}, .timeout = 5});
  command.add("COMMAND", &choice->process, "the program and its arguments, after --").required();
  command.add("--patience", &choice->timeout, "seconds after which a solve is given up").number_in({0.1, 3600});
  auto robot_name = std::make_shared<std::string>();
  command.add("--robot", robot_name.get(),
              "an arm of ikbench list robots, for a solver that knows some kinds of arms alone");
  command.footer(
      "  ikbench check-solver -- python3 my_solver.py\n"
      "  ikbench check-solver --robot ur5e -- python3 my_closed_form.py\n"
      "  ikbench check-solver --patience 60 -- octave-cli --quiet my_solver.m\n\n"
      "Exit code 1 where a check fails. docs/reference/protocol.md describes what a program has to say.");
  command.callback([choice, robot_name, &invocation] {
    std::vector<CheckLine> lines = Checks(*choice, robot_name->empty() ? some_arm() : robot(*robot_name)).lines;
    const auto failed = std::ranges::count(lines, false, &CheckLine::passed);
    if (failed > 0) invocation.exit_code = 1;
    std::stable_partition(lines.begin(), lines.end(), [](const CheckLine& line) { return !line.passed; });
    fmt::print("{}\n\n", failed == 0
                             ? fmt::format("All {} checks passed.", lines.size())
                             : fmt::format("{} of {} checks failed{}", failed, lines.size(),
                                           lines.size() < 11 ? "; mend it, then those after it are made." : "."));
    for (const CheckLine& line : lines) {
      constexpr std::size_t length_of_state = 8;
      const std::string text = wrapped(fmt::format("{}{}{}", line.what, line.seen.empty() ? "" : ": ", line.seen),
                                       terminal_width() - length_of_state);
      fmt::print("{}{}\n", line.passed ? "ok      " : "FAILED  ", text);
    }
  });
}

}  // namespace ikbench::cli
