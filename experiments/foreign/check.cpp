#include "experiments/foreign/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <thread>
#include <vector>

#include "experiments/foreign/foreign_solver.hpp"
#include "experiments/foreign/session.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;
using namespace solvers;
using namespace results;

namespace {

constexpr double slack = 1e-9;  // m and rad

// An arm about a metre long; each axis is at a right angle to the one before. All joints turn within limits, or some
// turn without end, or the second slides.
struct SomeArm {
  enum class Kind { limited, endless, sliding };

  explicit SomeArm(int joints, Kind kind = Kind::limited)
      : chain(links(joints, kind)), limits{Configuration(joints), Configuration(joints)} {
    limits.lower.setConstant(-std::numbers::pi);
    limits.upper.setConstant(std::numbers::pi);
    for (int j = 0; kind == Kind::endless && j < joints; j += 2) {
      limits.lower[j] = -std::numeric_limits<double>::infinity();
      limits.upper[j] = std::numeric_limits<double>::infinity();
    }
    if (kind == Kind::sliding) limits.lower[1] = 0, limits.upper[1] = 1;
    for (int j = 1; j <= joints; ++j) names.push_back(fmt::format("joint_{}", j));
  }

  static std::vector<DhLink> links(int joints, Kind kind) {
    std::vector<DhLink> all;
    for (int j = 0; j < joints; ++j) {
      const double twist = j + 1 == joints ? 0 : j % 2 == 0 ? std::numbers::pi / 2 : -std::numbers::pi / 2;
      all.push_back({.a = 1.0 / joints, .alpha = twist});
    }
    if (kind == Kind::sliding) all[1].joint = Joint::slides;
    return all;
  }

  // A position within reach.
  Eigen::Vector3d target() const {
    Configuration q(chain.joints());
    for (int j = 0; j < chain.joints(); ++j) q[j] = 0.4 + 0.07 * (j % 5);
    return chain.position(q);
  }

  Chain chain;
  JointLimits limits;
  std::vector<std::string> names;
};

struct Tried {
  Configuration q;
  double error = 0;    // of q [m]
  double seconds = 0;  // wall time
  Account account;
  std::string trouble;  // empty if it answered
};

class Checker {
 public:
  Checker(const ProgramChoice& choice, const std::function<void(const CheckLine&)>& tell)
      : choice_(choice), tell_(tell) {}

  bool run() {
    if (!greet()) return false;
    if (answers()) {  // without answers, the other checks say nothing
      seeds();
      claims();
      budgets();
    }
    farewells();
    line("it writes nothing but messages", noise_ == 0,
         noise_ == 0 ? "" : fmt::format("{} other lines, the first: {}", noise_, first_noise_));
    return all_passed_;
  }

 private:
  void line(std::string what, bool passed, std::string seen = "") {
    all_passed_ &= passed;
    tell_({std::move(what), passed, std::move(seen)});
  }

  bool greet() {
    const Clock::time_point began = Clock::now();
    try {
      program_ = meet(choice_, {});
    } catch (const Breach& breach) {
      line("it says a proper hello", false, breach.what());
      return false;
    } catch (const std::invalid_argument& error) {
      line("it says a proper hello", false, error.what());
      return false;
    }
    line("it says a proper hello", true,
         fmt::format("{} {}, mode {}, {} option{}, after {:.2f} s", program_->hello.name, program_->hello.version,
                     name_of(program_->mode), program_->hello.options.size(),
                     program_->hello.options.size() == 1 ? "" : "s",
                     std::chrono::duration<double>(Clock::now() - began).count()));
    return true;
  }

  // Starts fresh processes for an arm.
  Sessions sessions_for(const SomeArm& arm) const {
    return {program_, robot_message({.name = "check",
                                     .arm = arm.chain,
                                     .limits = arm.limits,
                                     .joint_names = arm.names,
                                     .urdf = {},
                                     .base_link = {},
                                     .tip_link = {}},
                                    program_->hello, options_of(program_->hello, {}))};
  }

  struct TrialSolve {
    std::uint64_t seed = 1;
    StopRule stop = {.iterations = 100, .tolerance = 1e-4};
    bool is_reachable = true;
  };

  Tried solve(ForeignSolver& solver, const SomeArm& arm, const TrialSolve& asked) const {
    const Configuration start = Configuration::Constant(arm.chain.joints(), 0.1);
    const Problem problem{.start = start, .lower = arm.limits.lower, .upper = arm.limits.upper, .population = 20};
    Objective objective(arm.chain, asked.is_reachable ? arm.target() : Eigen::Vector3d(10, 0, 0));
    Random random(Key(0).with(asked.seed));
    solver.prepare(problem, objective);
    const Clock::time_point began = Clock::now();
    const Solution solution = solvers::solve(solver, problem, objective, random, asked.stop);
    const double seconds = std::chrono::duration<double>(Clock::now() - began).count();
    solver.conclude();
    Tried tried{.q = solution.best.q,
                .error = solution.best.error,
                .seconds = seconds,
                .account = solver.account(),
                .trouble = {}};
    if (tried.account.failure) tried.trouble = fmt::format("{}: {}", name_of(*tried.account.failure), solver.trouble());
    return tried;
  }

  // Solves in a new process.
  Tried solve_afresh(const SomeArm& arm, const TrialSolve& asked) {
    Sessions sessions = sessions_for(arm);
    Tried tried;
    {
      ForeignSolver solver(sessions, asked.stop);
      tried = solve(solver, arm, asked);
    }
    const ProgramNotes notes = sessions.notes();
    if (noise_ == 0 && !notes.examples.empty()) first_noise_ = notes.examples.front();
    noise_ += notes.noise;
    if (!tried.trouble.empty()) tried.trouble = notes.last_failure;
    return tried;
  }

  bool answers() {
    for (const int joints : {1, 7, 64}) {
      const Tried tried = solve_afresh(SomeArm(joints), {});
      const bool declined = tried.account.failure == Status::declined;
      line(fmt::format("it solves for an arm of {} joint{}, or declines", joints, joints == 1 ? "" : "s"),
           declined || tried.trouble.empty(),
           tried.trouble.empty() ? fmt::format("to {:.2g} m", tried.error) : tried.trouble);
      if (tried.trouble.empty() && (!arm_ || joints == 7)) arm_.emplace(joints);
    }
    if (!arm_) return false;
    const Tried tried = solve_afresh(*arm_, {});
    const bool is_finite = tried.trouble.empty() && tried.q.allFinite();
    line("its answer is finite", is_finite, tried.trouble);
    if (!is_finite) return true;
    const double outside = arm_->limits.violation(tried.q);
    line("its answer is inside the joint limits", outside <= slack,
         outside <= slack ? "" : fmt::format("{:.3g} rad outside", outside));
    solves_for("whose joints turn without end", SomeArm(7, SomeArm::Kind::endless));
    solves_for("with a joint that slides", SomeArm(7, SomeArm::Kind::sliding));
    return true;
  }

  // Checks that the program solves for an arm with a number of joints that it may not know.
  void solves_for(std::string_view which, const SomeArm& arm) {
    const Tried tried = solve_afresh(arm, {});
    const double outside = tried.q.allFinite() ? arm.limits.violation(tried.q) : 0, claimed = tried.account.word.error;
    std::string wrong = tried.trouble;
    if (tried.account.failure == Status::declined) {
      wrong.clear();
    } else if (wrong.empty() && !tried.q.allFinite()) {
      wrong = "its answer is not finite";
    } else if (wrong.empty() && outside > slack) {
      wrong = fmt::format("{:.3g} rad or m outside the limits", outside);
    } else if (wrong.empty() && std::abs(claimed - tried.error) > slack) {
      wrong = claim(tried);
    }
    line(fmt::format("it solves for an arm {}, or declines", which), wrong.empty(),
         !wrong.empty()                              ? wrong
         : tried.account.failure == Status::declined ? tried.trouble
                                                     : fmt::format("to {:.2g} m", tried.error));
  }

  static std::string claim(const Tried& tried) {
    return fmt::format("it says {:.9g} m, and is {:.9g} m off", tried.account.word.error, tried.error);
  }

  void seeds() {
    Sessions sessions = sessions_for(*arm_);
    const TrialSolve asked{.stop = {.iterations = 3}};
    ForeignSolver solver(sessions, asked.stop);
    const Tried first = solve(solver, *arm_, asked), again = solve(solver, *arm_, asked),
                other = solve(solver, *arm_, {.seed = 2, .stop = asked.stop}), fresh = solve_afresh(*arm_, asked);
    const auto same = [](const Tried& a, const Tried& b) {
      const auto is_equal = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
      return a.trouble.empty() && b.trouble.empty() &&
             std::equal(a.q.begin(), a.q.end(), b.q.begin(), b.q.end(), is_equal);
    };
    line("the same seed gives the same answer in the same process", same(first, again), first.trouble);
    line("the same seed gives the same answer in a fresh process", same(first, fresh), fresh.trouble);
    const bool is_deterministic = program_->hello.is_deterministic, differs = !same(first, other);
    line("a seed changes its answer only if it does not say that it is deterministic",
         other.trouble.empty() && !(differs && is_deterministic),
         !other.trouble.empty()        ? other.trouble
         : differs && is_deterministic ? "another seed changes its answer"
         : differs || is_deterministic ? ""
                                       : "here another seed changed nothing; if none ever does, say deterministic");
  }

  void claims() {
    const Tried tried = solve_afresh(*arm_, {});
    const double claimed = tried.account.word.error;
    const bool is_silent = std::isnan(claimed);
    line("the error that it claims is true",
         tried.trouble.empty() && (is_silent || std::abs(claimed - tried.error) <= slack),
         !tried.trouble.empty() ? tried.trouble
         : is_silent            ? "it claims none"
                                : claim(tried));
    const Tried far = solve_afresh(*arm_, {.is_reachable = false});
    line("a target that nothing reaches ends too", far.trouble.empty(), far.trouble);
  }

  void budgets() {
    for (const int iterations : {0, 1}) {
      const Tried tried = solve_afresh(*arm_, {.stop = {.iterations = iterations}});
      line(fmt::format("it answers with a budget of {} iteration{}", iterations, iterations == 1 ? "" : "s"),
           tried.trouble.empty(), tried.trouble);
    }
    constexpr double budget = 1e-3;
    constexpr int attempts = 5;  // the machine may be busy
    double least = std::numeric_limits<double>::infinity();
    std::string trouble;
    for (int i = 0; i < attempts && trouble.empty() && !(least <= 10 * budget); ++i) {
      const Tried tried =
          solve_afresh(*arm_, {.stop = {.iterations = 1'000'000, .seconds = budget}, .is_reachable = false});
      least = std::min(least, tried.seconds);
      trouble = tried.trouble;
    }
    line("it keeps a budget of 1 ms within ten times", trouble.empty() && least <= 10 * budget,
         trouble.empty() ? fmt::format("{:.2g} ms", 1000 * least) : trouble);
  }

  void farewells() {
    for (const bool says_bye : {true, false}) {
      ChildProcess child(program_->command());
      std::vector<std::string> noise;
      std::string seen;
      try {
        static_cast<void>(hello_of(child, choice_, noise));
        if (says_bye) {
          child.write(bye_message(), Clock::now() + std::chrono::seconds(1));
          const Clock::time_point until = Clock::now() + std::chrono::seconds(2);
          for (std::string text; child.read_line(text, until) == ChildProcess::Outcome::done;) {
          }
          while (child.is_running() && Clock::now() < until) std::this_thread::sleep_for(std::chrono::milliseconds(10));
          seen = child.is_running() ? "it still runs after 2 s" : "";
        }
        child.end(std::chrono::seconds(2));
        if (!says_bye && !child.how_it_ended().starts_with("exit code"))
          seen = fmt::format("it had to be ended: {}", child.how_it_ended());
      } catch (const std::exception& error) {
        seen = error.what();
      }
      line(says_bye ? "it ends when it is told bye" : "it ends with its standard input", seen.empty(), seen);
    }
  }

  const ProgramChoice& choice_;
  const std::function<void(const CheckLine&)>& tell_;
  std::shared_ptr<const Program> program_;
  std::optional<SomeArm> arm_;  // the arm of most checks
  bool all_passed_ = true;
  std::int64_t noise_ = 0;
  std::string first_noise_;
};

}  // namespace

bool check_program(const ProgramChoice& choice, const std::function<void(const CheckLine&)>& tell) {
  return Checker(choice, tell).run();
}

}  // namespace ikbench::experiments
