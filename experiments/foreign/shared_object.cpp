#include "experiments/foreign/shared_object.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cfenv>
#include <chrono>

#include "numerics/json.hpp"
#include "solvers/bounds.hpp"

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;
using namespace solvers;

namespace {

constexpr int most_solvers = 1000;

using RowMajor4d = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;

void write_pose(const Pose& pose, double* out) { Eigen::Map<RowMajor4d>{out} = pose.matrix(); }

#if defined(__SSE2__)
unsigned int mode_now() { return _mm_getcsr() & ~0x3fu; }  // without the exception flags
void set_mode(unsigned int mode) { _mm_setcsr(mode); }
#else
unsigned int mode_now() { return static_cast<unsigned int>(std::fegetround()); }
void set_mode(unsigned int) {}
#endif

std::string text_or_nothing(const char* text) { return text == nullptr ? "" : text; }

}  // namespace

FloatingPointMode::FloatingPointMode() : rounding_(std::fegetround()), mode_(mode_now()) {}

bool FloatingPointMode::restore() const {
  if (mode_now() == mode_) return false;
  std::fesetround(rounding_);
  set_mode(mode_);
  return true;
}

SharedObject::SharedObject(const std::filesystem::path& file, std::string_view name) {
  const FloatingPointMode mode;
  void* const object = ::dlopen(std::filesystem::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL);
  changed_mode_ = mode.restore();
  if (object == nullptr) throw std::invalid_argument(fmt::format("cannot load it: {}", ::dlerror()));
  using SolverAt = const ikbench_solver* (*)(std::int32_t, std::int32_t);
  const auto solver_at = reinterpret_cast<SolverAt>(::dlsym(object, "ikbench_solver_at"));
  if (solver_at == nullptr)
    throw std::invalid_argument(fmt::format("{} has no function ikbench_solver_at", file.string()));
  std::vector<std::string> names;
  for (int i = 0; solver_ == nullptr && i < most_solvers; ++i) {
    const ikbench_solver* const found = solver_at(IKBENCH_ABI, i);
    if (found == nullptr) break;
    names.push_back(text_or_nothing(found->name));
    if (name.empty() || name == names.back()) solver_ = found;
  }
  if (solver_ == nullptr && names.empty())
    throw std::invalid_argument(fmt::format("it has no solver for version {} of ikbench_plugin.h", IKBENCH_ABI));
  if (solver_ == nullptr)
    throw std::invalid_argument(
        fmt::format("it has no solver \"{}\"; expected one of {}", name, fmt::join(names, ", ")));
  if (solver_->size < sizeof(ikbench_solver) || solver_->name == nullptr || solver_->create == nullptr ||
      solver_->destroy == nullptr || solver_->start == nullptr)
    throw std::invalid_argument(
        fmt::format("its solver \"{}\" lacks its size, name, create, destroy or start", names.back()));
  const std::string options = text_or_nothing(solver_->options);
  options_ = numerics::parsed_ordered_json(options.empty() ? "[]" : options);
  if (!options_.is_array()) throw std::invalid_argument("its options are no JSON list");
}

// The functions of ikbench_objective; `suite` is the SharedSolver.
struct Callbacks {
  static SharedSolver& self(void* suite) { return *static_cast<SharedSolver*>(suite); }

  static void errors(void* suite, const double* q, std::int64_t stride, std::int64_t candidates, double* errors) {
    SharedSolver& solver = self(suite);
    if (candidates <= 0) return;
    using Columns = Eigen::Map<const Candidates, 0, Eigen::OuterStride<>>;
    solver.objective_->errors(Columns(q, solver.joints_, candidates, Eigen::OuterStride<>(stride)),
                              Eigen::Map<Eigen::VectorXd>(errors, candidates));
  }

  static std::int32_t linearize(void* suite, const double* q, double* residual, double* jacobian) {
    SharedSolver& solver = self(suite);
    const int rows = solver.objective_->rows();
    const Residual left = solver.objective_->linearize(Eigen::Map<const Eigen::VectorXd>(q, solver.joints_),
                                                       Eigen::Map<Eigen::MatrixXd>(jacobian, rows, solver.joints_));
    Eigen::Map<Eigen::VectorXd>(residual, rows) = left;
    return rows;
  }

  static void one_by_one(void* suite, double* q, std::int64_t candidates, double* errors, void* context,
                         void (*propose)(void*, std::int64_t, std::int64_t),
                         std::int64_t (*decide)(void*, std::int64_t, std::int64_t)) {
    SharedSolver& solver = self(suite);
    if (candidates <= 0) return;
    Eigen::Map<Candidates> all(q, solver.joints_, candidates);
    Eigen::Map<Eigen::VectorXd> found(errors, candidates);
    solver.objective_->batch_by_batch(
        all, found, [&](Eigen::Index first, Eigen::Index count) { propose(context, first, count); },
        [&](Eigen::Index first, Eigen::Index count) -> Objective::Decided {
          const Eigen::Index decided = std::clamp<Eigen::Index>(decide(context, first, count), 1, count);
          return {decided, decided < count};
        });
  }

  static double uniform(void* suite) { return self(suite).random_->uniform(); }
  static void uniforms(void* suite, double* out, std::int64_t count) {
    if (count > 0) self(suite).random_->uniforms(out, count);
  }
  static void normals(void* suite, double* out, std::int64_t count) {
    if (count > 0) self(suite).random_->normals(out, count);
  }
  static void truncated_normals(void* suite, double* out, std::int64_t count) {
    if (count > 0) self(suite).random_->truncated_normals(out, count);
  }

  static std::int32_t is_over(void* suite) {
    const SharedSolver& solver = self(suite);
    const StopRule& stop = solver.stop_;
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - solver.started_;
    const bool is_spent = stop.evaluations > 0 && solver.objective_->evaluations() >= stop.evaluations;
    return is_spent || (stop.seconds > 0 && seconds.count() >= stop.seconds) ? 1 : 0;
  }

  static void say(void* suite, const char* why) { self(suite).said_ = text_or_nothing(why); }
};

SharedSolver::SharedSolver(const ikbench_solver& table, const HostedArm& arm)
    : table_(table), joints_(arm.chain.joints()) {
  std::vector<double> theta, d, a, alpha;
  std::vector<std::int32_t> types;
  for (const DhLink& link : arm.chain.links()) {
    theta.push_back(link.offset);
    d.push_back(link.d);
    a.push_back(link.a);
    alpha.push_back(link.alpha);
    types.push_back(link.joint == Joint::turns ? 0 : link.joint == Joint::slides ? 1 : 2);
  }
  ikbench_robot robot{.size = sizeof(ikbench_robot),
                      .name = arm.name.c_str(),
                      .urdf = arm.urdf.c_str(),
                      .base_link = arm.base_link.c_str(),
                      .tip_link = arm.tip_link.c_str(),
                      .joints = joints_,
                      .theta = theta.data(),
                      .d = d.data(),
                      .a = a.data(),
                      .alpha = alpha.data(),
                      .lower = arm.limits.lower.data(),
                      .upper = arm.limits.upper.data(),
                      .types = types.data(),
                      .base = {},
                      .tool = {},
                      .options = arm.options.data()};
  write_pose(arm.chain.base().pose(), robot.base);
  write_pose(arm.chain.tool().pose(), robot.tool);
  callbacks_ = {.size = sizeof(ikbench_objective),
                .suite = this,
                .errors = &Callbacks::errors,
                .linearize = &Callbacks::linearize,
                .one_by_one = &Callbacks::one_by_one,
                .uniform = &Callbacks::uniform,
                .uniforms = &Callbacks::uniforms,
                .normals = &Callbacks::normals,
                .truncated_normals = &Callbacks::truncated_normals,
                .is_over = &Callbacks::is_over,
                .say = &Callbacks::say};
  std::array<char, 200> why{};
  solver_ = table.create(&robot, why.data(), why.size());
  restore_mode();
  why.back() = '\0';
  if (solver_ == nullptr) throw Refusal(why[0] == '\0' ? "it does not say why" : why.data());
}

SharedSolver::~SharedSolver() { table_.destroy(solver_); }

template <class Call>
void SharedSolver::answer(Objective& objective, Random& random, Call&& call) {
  objective_ = &objective;
  random_ = &random;
  said_.clear();
  const std::int32_t what = call();
  restore_mode();
  if (what == ikbench_declined) throw Refusal(said_.empty() ? "it does not say why" : said_);
  if (what != ikbench_goes_on && what != ikbench_finished)
    throw std::runtime_error(said_.empty() ? "it says that it failed, and not why" : said_);
  is_finished_ = what == ikbench_finished || table_.step == nullptr || changed_mode_;
}

void SharedSolver::start(const Problem& problem, Objective& objective, Random& random) {
  stop_ = problem.stop;
  started_ = std::chrono::steady_clock::now();
  changed_mode_ = false;
  const JointLimits limits = finite_limits(problem);
  best_.q = problem.start;
  best_.error = std::numeric_limits<double>::infinity();
  ikbench_problem told{.size = sizeof(ikbench_problem),
                       .joints = joints_,
                       .target = {},
                       .rotation_weight = objective.goal().rotation_weight,
                       .position_tolerance = stop_.tolerance,
                       .rotation_tolerance = stop_.angle_tolerance,
                       .start = problem.start.data(),
                       .lower = limits.lower.data(),
                       .upper = limits.upper.data(),
                       .population = problem.population,
                       .iterations = stop_.iterations,
                       .evaluations = stop_.evaluations,
                       .seconds = stop_.seconds,
                       .seed = seed_,
                       .planned_iterations = problem.iterations};
  write_pose(objective.goal().target, told.target);
  answer(objective, random, [&] { return table_.start(solver_, &told, &callbacks_, best_.q.data(), &best_.error); });
}

void SharedSolver::step(Objective& objective, Random& random) {
  answer(objective, random, [&] { return table_.step(solver_, &callbacks_, best_.q.data(), &best_.error); });
}

}  // namespace ikbench::experiments
