// A thin C++17 wrapper of ikbench_plugin.h: a solver is a class, and no exception leaves it.
//
//   struct Mine {
//     explicit Mine(const ikbench_robot& robot);  // may throw ikbench_plugin::Declined
//     void start(const ikbench_problem& problem, Objective& objective, Best& best);
//     void step(Objective& objective, Best& best);  // optional: without it start solves
//   };
//   IKBENCH_SOLVERS(ikbench_plugin::solver<Mine>("mine", "1.0"))
#pragma once

#include <ikbench_plugin.h>

#include <cstdio>
#include <exception>
#include <memory>
#include <stdexcept>
#include <type_traits>

namespace ikbench_plugin {

// Thrown for what a solver does not solve: an arm, by its constructor; one problem, by start.
struct Declined : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The answer so far. Each call of start and step improves it or leaves it alone.
struct Best {
  double* q;      // one value per joint; the problem's start until start writes to it
  double& error;  // [m] error of q, as the objective gives it
  bool is_finished = false;
};

// The evaluations, counts and random numbers of ikbench. Joint j of candidate i is q[j * stride + i].
class Objective {
 public:
  explicit Objective(const ikbench_objective& suite) : suite_(&suite) {}

  double error(const double* q) {
    double error;
    errors(q, 1, 1, &error);
    return error;
  }
  void errors(const double* q, std::int64_t stride, std::int64_t candidates, double* errors) {
    suite_->errors(suite_->suite, q, stride, candidates, errors);
  }
  // Computes the residual, 3 rows or 6 for a pose, and its Jacobian by columns. Returns the number of rows.
  int linearize(const double* q, double* residual, double* jacobian) {
    return suite_->linearize(suite_->suite, q, residual, jacobian);
  }
  // A loop in which each candidate depends on those before it; ikbench still evaluates it in batches, ahead of time.
  // propose(first, count) writes these candidates to q (stride: candidates) from the present state. decide(i) accepts
  // candidate i or not, and says whether that changed the state for later proposals. Those are then proposed anew and
  // do not count.
  template <class Propose, class Decide>
  void one_by_one(double* q, std::int64_t candidates, double* errors, Propose&& propose, Decide&& decide) {
    struct Both {
      std::remove_reference_t<Propose>& propose;
      std::remove_reference_t<Decide>& decide;
      std::exception_ptr trouble = nullptr;
    } both{propose, decide};
    suite_->one_by_one(
        suite_->suite, q, candidates, errors, &both,
        [](void* context, std::int64_t first, std::int64_t count) {
          Both& call = *static_cast<Both*>(context);
          guarded(call.trouble, [&] { call.propose(first, count); });
        },
        [](void* context, std::int64_t first, std::int64_t count) {
          Both& call = *static_cast<Both*>(context);
          std::int64_t done = 0;
          guarded(call.trouble, [&] {
            while (done < count && !call.decide(first + done++)) {
            }
          });
          return call.trouble ? count : done;
        });
    if (both.trouble) std::rethrow_exception(both.trouble);
  }

  double uniform() { return suite_->uniform(suite_->suite); }  // in [0, 1)
  void uniforms(double* out, std::int64_t count) { suite_->uniforms(suite_->suite, out, count); }
  void normals(double* out, std::int64_t count) { suite_->normals(suite_->suite, out, count); }
  void truncated_normals(double* out, std::int64_t count) { suite_->truncated_normals(suite_->suite, out, count); }
  bool is_over() const { return suite_->is_over(suite_->suite) != 0; }  // evaluations or seconds are used up

 private:
  // Does nothing after an exception, until the loop is over.
  template <class Call>
  static void guarded(std::exception_ptr& trouble, Call&& call) noexcept {
    if (trouble) return;
    try {
      call();
    } catch (...) {
      trouble = std::current_exception();
    }
  }

  const ikbench_objective* suite_;
};

template <class S, class = void>
struct HasStep : std::false_type {};
template <class S>
struct HasStep<S, std::void_t<decltype(&S::step)>> : std::true_type {};

// The functions of the C interface for a class.
template <class S>
struct Functions {
  static void* create(const ikbench_robot* robot, char* why, std::size_t room) noexcept {
    try {
      return std::make_unique<S>(*robot).release();
    } catch (const std::exception& trouble) {
      std::snprintf(why, room, "%s", trouble.what());
    } catch (...) {
      std::snprintf(why, room, "it threw something that is no std::exception");
    }
    return nullptr;
  }
  static void destroy(void* solver) noexcept { delete static_cast<S*>(solver); }
  static std::int32_t start(void* solver, const ikbench_problem* problem, const ikbench_objective* suite, double* best,
                            double* error) noexcept {
    return answered(*suite, {best, *error}, [&](Objective& objective, Best& found) {
      static_cast<S*>(solver)->start(*problem, objective, found);
    });
  }
  static std::int32_t step(void* solver, const ikbench_objective* suite, double* best, double* error) noexcept {
    return answered(*suite, {best, *error}, [&](Objective& objective, Best& found) {
      if constexpr (HasStep<S>::value) static_cast<S*>(solver)->step(objective, found);
    });
  }

 private:
  template <class Call>
  static std::int32_t answered(const ikbench_objective& suite, Best best, Call&& call) noexcept {
    Objective objective(suite);
    try {
      call(objective, best);
      return best.is_finished ? ikbench_finished : ikbench_goes_on;
    } catch (const Declined& declined) {
      suite.say(suite.suite, declined.what());
      return ikbench_declined;
    } catch (const std::exception& trouble) {
      suite.say(suite.suite, trouble.what());
    } catch (...) {
      suite.say(suite.suite, "it threw something that is no std::exception");
    }
    return ikbench_failed;
  }
};

enum class Deterministic { no, yes };  // the same for every seed and stream

// `options` is a JSON list, as in a hello.
template <class S>
constexpr ikbench_solver solver(const char* name, const char* version, const char* options = nullptr,
                                Deterministic deterministic = Deterministic::no) {
  using F = Functions<S>;
  return {sizeof(ikbench_solver),
          name,
          version,
          options,
          deterministic == Deterministic::yes ? 1 : 0,
          &F::create,
          &F::destroy,
          &F::start,
          HasStep<S>::value ? &F::step : nullptr};
}

}  // namespace ikbench_plugin

// Lists all solvers of an object; use it once, outside of any namespace.
#define IKBENCH_SOLVERS(...)                                                             \
  extern "C" const ikbench_solver* ikbench_solver_at(std::int32_t abi, std::int32_t i) { \
    static const ikbench_solver all[] = {__VA_ARGS__};                                   \
    const auto count = static_cast<std::int32_t>(sizeof(all) / sizeof(all[0]));          \
    return abi == IKBENCH_ABI && i >= 0 && i < count ? &all[i] : nullptr;                \
  }
