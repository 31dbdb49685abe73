// ikbench check-solver: checks an external solver for the solver's author before a study runs the solver.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "base/names.hpp"
#include "cli/console.hpp"
#include "cli/options.hpp"
#include "experiments/diagnosis.hpp"
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
  std::string seen;  // what was measured, or what is wrong; empty: nothing to add
};

constexpr StopRule usual_budget{.iterations = 3000, .tolerance = 1e-4, .angle_tolerance = 1e-3, .evaluations = 3000};

// Makes an arm about a metre long, in which each axis is at a right angle to the one before.
Robot example_arm(Joint second = Joint::turns) {
  constexpr int joints = 7;
  std::vector<DhLink> links(joints, DhLink{.a = 0.15});
  for (std::size_t j = 0; j < joints; ++j) links[j].alpha = (j % 2 == 0 ? 1 : -1) * half_turn / 2;
  links[1].joint = second;
  JointLimits limits{Configuration::Constant(joints, -half_turn), Configuration::Constant(joints, half_turn)};
  if (second == Joint::slides) limits.lower[1] = 0;
  return {.name = "check", .summary = "", .source = "", .chain = Chain(links), .limits = limits};
}

// Returns the configuration within the limits that is nearest to `q`.
Configuration inside(const Robot& arm, const Configuration& q) {
  return q.cwiseMax(arm.limits.lower).cwiseMin(arm.limits.upper);
}

// Returns a sentence that names the first joint whose value is not finite.
std::string not_finite_text(const Configuration& q) {
  Eigen::Index joint = 0;
  while (joint + 1 < q.size() && std::isfinite(q[joint])) ++joint;
  return fmt::format("its answer is not finite: joint {} is {}", joint + 1, q[joint]);
}

// Makes the goal with the given number. The arm reaches each goal, unless `offset` [m] moves the goal along x.
Goal example_goal(const Robot& arm, GoalKind kind, double offset, int number = 0) {
  const Configuration q = Configuration::LinSpaced(arm.joints(), 0.3 - 0.07 * number, 0.7 + 0.03 * number);
  Pose pose = arm.chain.forward(inside(arm, q));
  pose.translation().x() += offset;
  return kind == GoalKind::position ? Goal(pose.translation()) : Goal(pose, 0.25, kind);
}

// One measured solve.
struct Attempt {
  Configuration q;
  double error;    // of the position [m]
  double angle;    // of the orientation [rad]; 0 if the goal has none
  double seconds;  // wall time
  ProcessReport report;
};

// A program at work on goals of one kind for one arm, with the processes that solve these goals.
struct CheckedProgram {
  CheckedProgram(const std::shared_ptr<const Program>& program, Robot checked_arm, GoalKind kind,
                 double goal_offset = 0, results::CacheState state = results::CacheState::first)
      : arm(std::move(checked_arm)),
        offset(goal_offset),
        goal(example_goal(arm, kind, goal_offset)),
        processes(program,
                  robot_message({.arm = arm,
                                 .searched = arm.chain,
                                 .goal = goal,
                                 .hello = program->hello,
                                 .options = resolved_options(program->hello, {})}),
                  state) {}

  Attempt solve_once(const StopRule& stop = usual_budget, int number = 0) {
    Objective objective(arm.chain, example_goal(arm, goal.kind, offset, number));
    Random random(Key(1).with(static_cast<std::uint64_t>(number)));
    ExternalSolver solver(processes, stop, WrapPolicy::no);  // an answer must be right as it is
    solver.prepare(problem, objective);
    const Clock::time_point began = Clock::now();
    const Solution solution = solvers::solve(solver, problem, objective, random, stop);
    const std::chrono::duration<double> took = Clock::now() - began;
    solver.count_failure();
    const auto [position, angle] = objective.deviation(solution.best.q);
    const double asked = goal.kind == GoalKind::position ? 0 : angle;
    return {solution.best.q, position, asked, took.count(), solver.report()};
  }

  // Sends a batch with the goals of all calls of `solve_once` since the last batch.
  void send_batch() {
    ExternalSolver solver(processes, usual_budget, WrapPolicy::no);
    solver.send_batch();
    solver.count_failure();
  }

  bool is_solved_by_lm(int number) const {
    Objective objective(arm.chain, example_goal(arm, goal.kind, offset, number));
    Random random(Key(1));
    const std::unique_ptr<Solver> lm = solver("levenberg_marquardt").make({});
    return solvers::solve(*lm, problem, objective, random, usual_budget).stopped == StopReason::tolerance;
  }

  const Robot arm;
  const double offset;  // [m] by which the goals are moved along x
  const Goal goal;
  const Problem problem{.start = inside(arm, Configuration::Constant(arm.joints(), 0.1)),
                        .lower = arm.limits.lower,
                        .upper = arm.limits.upper,
                        .population = 20};
  ProcessPool processes;
};

// Returns what is wrong with an answer; empty if the answer is right.
std::string fault_text(const Attempt& attempt, const CheckedProgram& checked) {
  const ProcessReport& report = attempt.report;
  if (report.failure) return checked.processes.last_failure();
  if (!attempt.q.allFinite()) return not_finite_text(attempt.q);
  const double outside = checked.arm.limits.violation(attempt.q);
  if (outside > 1e-9) return fmt::format("its answer is {:.3g} rad or m outside the joint limits", outside);
  if (std::abs(report.reported_error - attempt.error) > program_report_tolerance)  // false for NaN: none was reported
    return fmt::format("it reports an error of {:.9g} m, but the error is {:.9g} m", report.reported_error,
                       attempt.error);
  return report.ignored_budget ? "it asks for more evaluations after the message that its budget is used up" : "";
}

std::string evaluations_text(const ProcessReport& report) {
  if (report.counted_by == CountedBy::ikbench) return counted(report.evaluations, "evaluations") + ", counted here";
  return report.counted_by == CountedBy::solver ? "own kinematics, self-reported count" : "own kinematics, no count";
}

// All checks of one program, which the constructor makes.
class Checks {
 public:
  Checks(const ProgramSpec& choice, Robot arm) : arm_(std::move(arm)) {
    try {
      check(probe(choice, {}));
    } catch (const std::invalid_argument& error) {
      line("hello message", error.what());
    }
  }

  std::vector<CheckLine> lines;

 private:
  const Robot arm_;

  void line(std::string what, std::string wrong, std::string seen = {}) {
    lines.push_back({std::move(what), wrong.empty(), wrong.empty() ? std::move(seen) : std::move(wrong)});
  }

  void check(const std::shared_ptr<const Program>& program) {
    line("hello message", "", fmt::format("{} {}", program->hello.name, program->hello.version));
    std::unique_ptr<CheckedProgram> chosen;  // with goals of the first kind that the program does not decline
    Attempt first;
    for (const auto& [kind, name] : {std::pair(GoalKind::position, "a position"),
                                     {GoalKind::axis, "a position and an axis"},
                                     {GoalKind::pose, "a pose"}}) {
      if (!program->hello.solves(kind)) {
        line(fmt::format("it solves for {}", name), "", "its hello message does not name this goal");
        continue;
      }
      auto checked = std::make_unique<CheckedProgram>(program, arm_, kind);
      const Attempt attempt = check_answer(name, *checked);
      if (chosen || attempt.report.failure == Status::declined) continue;
      if (attempt.report.failure || !attempt.q.allFinite()) return;  // the other checks would say the same
      chosen = std::move(checked);
      first = attempt;
    }
    if (!chosen) return line("it solves for one of these goals", "it declines them all");
    const GoalKind kind = chosen->goal.kind;
    Robot endless = example_arm();
    endless.limits.upper[0] = std::numeric_limits<double>::infinity();
    endless.limits.lower[0] = -endless.limits.upper[0];
    CheckedProgram second(program, arm_, kind);
    CheckedProgram warm(program, arm_, kind, 0, results::CacheState::warm);
    CheckedProgram continuous(program, endless, kind);
    CheckedProgram prismatic(program, example_arm(Joint::slides), kind);
    CheckedProgram unreachable(program, arm_, kind, 10);
    check_answer("a continuous joint", continuous);
    check_answer("a prismatic joint", prismatic);
    if (check_repeated(*chosen, second, first)) check_warm(warm, first);
    check_cause(program);
    if (program->hello.takes_batches) check_batch(*program, kind, first);
    check_budgets(unreachable);
    check_end(chosen->processes.acquire());
  }

  Attempt check_answer(const std::string& what, CheckedProgram& checked) {
    const Attempt attempt = checked.solve_once();
    const std::string wrong = fault_text(attempt, checked);
    if (attempt.report.failure == Status::declined)
      line("it declines " + what, "", wrong);
    else
      line("it answers inside the limits for " + what, wrong,
           fmt::format("{:.2g} m off; {}", attempt.error, evaluations_text(attempt.report)));
    return attempt;
  }

  void check_batch(const Program& program, GoalKind kind, const Attempt& alone) {
    auto batched = std::make_shared<Program>(program);
    batched->choice.batch = 20;
    CheckedProgram checked(batched, arm_, kind);
    for (int number = 0; number < batched->choice.batch; ++number)
      checked.solve_once(usual_budget, number);  // puts the goal into the batch
    checked.send_batch();
    const Attempt attempt = checked.solve_once();
    const bool is_off = attempt.report.failure || !(attempt.error <= 2 * std::max(usual_budget.tolerance, alone.error));
    line("in a batch of 20 poses it answers the first as well as without a batch",
         !is_off ? "" : fmt::format("{:.2g} m off; {}", attempt.error, checked.processes.last_failure()));
  }

  // Solves a few poses in two processes. Twenty are too few to find threads or clocks that change answers rarely.
  // Errors up to twice the tolerance are counted separately, because a program may compute the error with less
  // precision. Returns true if the answers are the same.
  bool check_repeated(CheckedProgram& chosen, CheckedProgram& second, const Attempt& first) {
    constexpr int poses = 20;
    int different = 0, solvable = 0, reached = 0, near = 0;
    for (int number = 0; number < poses; ++number) {
      const Attempt here = chosen.solve_once(usual_budget, number), there = second.solve_once(usual_budget, number);
      const double times = std::max(here.error / usual_budget.tolerance, here.angle / usual_budget.angle_tolerance);
      different += here.q != there.q;
      if (!chosen.is_solved_by_lm(number)) continue;
      ++solvable;
      reached += times <= 1;
      near += times > 1 && times <= 2;
    }
    std::string wrong;
    if (different > 0)
      wrong = fmt::format("{} answers differ in another process", different);
    else if (chosen.solve_once().q != first.q)
      wrong = "the answer differs when it solves again";
    line(fmt::format("the same seed gives the same answer for {} poses", poses), wrong);
    const std::string seen = fmt::format("{} within {:g} m and {:g} rad, {} more within twice that", reached,
                                         usual_budget.tolerance, usual_budget.angle_tolerance, near);
    line(fmt::format("it reaches some of the {} poses that LM solves", solvable),
         reached == 0 && solvable > 0 ? seen : "", seen);
    return wrong.empty();
  }

  // Asks as a warm study does. The answer must be that of a single solve.
  void check_warm(CheckedProgram& warm, const Attempt& first) {
    const Attempt attempt = warm.solve_once();
    std::string wrong;
    if (attempt.report.failure)
      wrong = warm.processes.last_failure();
    else if (attempt.q != first.q || attempt.report.differs_from_first)
      wrong = "it gives another answer when it solves twice in a row";
    line("it gives the same answer in a warm study", wrong,
         attempt.report.is_of_second_solve ? "it solves twice, and times the second solve"
                                           : "it solves once, so its time counts as one through a pipe");
  }

  // Looks for one cause of wrong answers, among the goals that tell most of an answer.
  void check_cause(const std::shared_ptr<const Program>& program) {
    constexpr std::array<GoalKind, 3> kinds{GoalKind::pose, GoalKind::axis, GoalKind::position};
    const auto kind = std::ranges::find_if(kinds, [&](GoalKind each) { return program->hello.solves(each); });
    if (kind == kinds.end()) return;
    CheckedProgram checked(program, arm_, *kind);
    constexpr int poses = 20;
    std::vector<experiments::AnsweredTarget> answers;
    for (int number = 0; number < poses; ++number) {
      const Attempt attempt = checked.solve_once(usual_budget, number);
      if (attempt.report.failure || attempt.report.counted_by == CountedBy::ikbench || !attempt.q.allFinite()) continue;
      answers.push_back({example_goal(arm_, *kind, 0, number).target, attempt.q});
    }
    const auto diagnosis = experiments::diagnose(
        arm_, answers, {.kind = *kind, .position = usual_budget.tolerance, .angle = usual_budget.angle_tolerance});
    if (diagnosis) line("its answers have no common fault", experiments::diagnosis_text(*diagnosis));
  }

  // A machine may be busy, so the best of a few attempts counts.
  void check_budgets(CheckedProgram& checked) {
    bool is_counted = false;
    const auto overrun = [&](const StopRule& stop, int tries = 1) -> std::string {
      ResourceUse used;
      for (; tries > 0; --tries) {
        const Attempt attempt = checked.solve_once(stop);
        const ProcessReport& report = attempt.report;
        if (report.failure) return checked.processes.last_failure();
        used = {credible_seconds(report, attempt.seconds), report.evaluations, report.iterations};
        is_counted = is_counted || used.evaluations > 0 || used.iterations > 0;
        if (!report.ignored_budget && !exceeds_budget(used, stop)) return "";
      }
      return fmt::format("{:.0f} ms, {} in {}", 1000 * used.seconds, counted(used.evaluations, "evaluations"),
                         counted(used.iterations, "iterations"));
    };
    constexpr StopRule in_time{.iterations = 1'000'000, .tolerance = 1e-4, .seconds = 0.05};
    line(fmt::format("it keeps a budget of 50 ms ({:g} ms at most) for an unreachable target",
                     1000 * max_budget_ratio * in_time.seconds),
         overrun(in_time, 5));
    if (!checked.processes.last_failure().empty()) return;
    std::string wrong = overrun({.iterations = 100, .tolerance = 1e-4, .evaluations = 40});
    if (wrong.empty()) wrong = overrun({.iterations = 10, .tolerance = 1e-4});
    if (wrong.empty() && !is_counted)
      line("its budgets of evaluations and iterations", "", "not checked, because nobody counts them");
    else
      line("it keeps a budget of 40 evaluations, and one of 10 iterations (at most half more)", wrong);
  }

  // Ends the input of the last process, which then has to exit.
  void check_end(WorkerProcess last) {
    if (last.child) last.child->end_input();
    const ProcessFailure heard =
        last.child ? unsolicited_message(*last.child, 2)
                   : ProcessFailure{ProcessFailure::Kind::declined, "it had ended before its input did"};
    std::string wrong = heard.why;
    if (heard.kind == ProcessFailure::Kind::crashed) wrong = "";
    if (heard.kind == ProcessFailure::Kind::timed_out) wrong = "it still ran after 2 s";
    line("it answers each message once, and ends when its input ends", wrong);
  }
};

std::string summary_of(std::size_t checks, std::size_t failed) {
  constexpr std::size_t full_number = 11;  // fewer if a failure makes the others useless
  if (failed == 0) return fmt::format("All {} checks passed.", checks);
  return fmt::format("{} of {} checks failed{}", failed, checks,
                     checks < full_number ? "; fix it, and the rest will run." : ".");
}

}  // namespace

void add_check_solver(const Command& command, Invocation& invocation) {
  auto choice = std::make_shared<ProgramSpec>(ProgramSpec{.process = {}, .files = {}, .timeout = 5});
  command.add("COMMAND", &choice->process, "the solver and its arguments, after --").required();
  command.add("--timeout", &choice->timeout, "seconds after which a solve is aborted").number_in({0.1, 3600});
  auto robot_name = std::make_shared<std::string>();
  command.add("--robot", robot_name.get(),
              "arm to use (ikbench list robots), for a solver that supports only some kinds of arms");
  command.footer(
      "  ikbench check-solver -- python3 my_solver.py\n"
      "  ikbench check-solver --robot ur5e -- python3 my_closed_form.py\n"
      "  ikbench check-solver --timeout 60 -- octave-cli --quiet my_solver.m\n\n"
      "The exit code is 1 if a check fails. docs/reference/protocol.md describes the messages.");
  command.callback([choice, robot_name, &invocation] {
    std::vector<CheckLine> lines = Checks(*choice, robot_name->empty() ? example_arm() : robot(*robot_name)).lines;
    const auto failed = static_cast<std::size_t>(std::ranges::count(lines, false, &CheckLine::passed));
    if (failed > 0) invocation.exit_code = 1;
    std::stable_partition(lines.begin(), lines.end(), [](const CheckLine& line) { return !line.passed; });
    fmt::print("{}\n\n", summary_of(lines.size(), failed));
    for (const CheckLine& line : lines) {
      constexpr std::size_t length_of_state = 8;
      const std::string text = wrapped(fmt::format("{}{}{}", line.what, line.seen.empty() ? "" : ": ", line.seen),
                                       terminal_width() - length_of_state);
      fmt::print("{}{}\n", line.passed ? "ok      " : "FAILED  ", text);
    }
  });
}

}  // namespace ikbench::cli
