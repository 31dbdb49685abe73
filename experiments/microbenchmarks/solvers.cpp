// A solve of the paper (population 50, 200 iterations): by our six solvers, and by the same as an engineer would write
// them from the papers (candidate after candidate, products of 4x4 matrices, the standard library's random numbers).
#include <benchmark/benchmark.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "experiments/microbenchmarks/reach.hpp"
#include "solvers/registry.hpp"
#include "solvers/solve.hpp"

namespace ikbench::microbenchmarks {

using namespace solvers;

namespace {

using Vector = robots::Configuration;

constexpr int iterations = 200;

// What the textbook's solvers share: candidates, their errors, and the best of all.
struct Search {
  Search(const Reach& asked, std::mt19937_64& numbers) : reach(asked), generator(numbers) {
    for (int i = 0; i < reach.problem.population; ++i) {
      x.push_back(drawn());
      errors.push_back(error(x.back()));
    }
  }

  double uniform() { return std::uniform_real_distribution<double>(0, 1)(generator); }
  std::size_t below(std::size_t end) { return std::uniform_int_distribution<std::size_t>(0, end - 1)(generator); }
  Vector uniforms() {
    return Vector::NullaryExpr(start.size(), [&] { return uniform(); });
  }
  Vector normals() {
    return Vector::NullaryExpr(start.size(), [&] { return std::normal_distribution<double>(0, 1)(generator); });
  }
  std::size_t picked(const std::vector<double>& shares) {
    return std::discrete_distribution<std::size_t>(shares.begin(), shares.end())(generator);
  }
  Vector drawn() { return lower + (upper - lower).cwiseProduct(uniforms()); }
  Vector clamped(const Vector& q) const { return q.cwiseMax(lower).cwiseMin(upper); }
  double evaluated(const Vector& q) {
    ++evaluations;
    return reach.textbook_error(q);
  }
  void keep(const Vector& q, double error) {
    if (error < best_error) best = q, best_error = error;
  }
  double error(const Vector& q) {
    const double found = evaluated(q);
    keep(q, found);
    return found;
  }

  const Reach& reach;
  std::mt19937_64& generator;
  const Vector &start = reach.problem.start, &lower = reach.problem.lower, &upper = reach.problem.upper;
  std::vector<Vector> x;
  std::vector<double> errors;
  Vector best;
  double best_error = std::numeric_limits<double>::infinity();
  int evaluations = 0;
};

std::vector<Vector> at_rest(const Search& search) { return {search.x.size(), Vector::Zero(search.start.size())}; }

void ik_bat(Search& search) {
  std::vector<Vector> v = at_rest(search);
  double loudness = 1;
  for (int t = 0; t < iterations; ++t) {
    loudness *= 0.97;                         // Eq. 9
    const double r = 1 - std::exp(-0.1 * t);  // Eq. 10
    for (std::size_t i = 0; i < v.size(); ++i) {
      v[i] += (search.x[i] - (search.best + search.start) / 2) * (2 * search.uniform());  // Eqs. 5, 13
      search.x[i] += v[i];                                                                // Eq. 7
      const Vector candidate = r * search.best + (1 - r) * search.start + 0.1 * loudness * search.normals();  // Eq. 14
      const double before = search.best_error;
      if (search.error(candidate) < before) search.x[i] = candidate;
    }
  }
}

void bat(Search& search) {
  std::vector<Vector> v = at_rest(search);
  Vector loudness = Vector::NullaryExpr(std::ssize(v), [&] { return search.uniform(); });
  std::vector<double> pulse_rate(v.size(), 0.001);
  for (int t = 1; t <= iterations; ++t) {
    for (std::size_t i = 0; i < v.size(); ++i) {
      v[i] += (search.x[i] - search.best) * (2 * search.uniform());  // Eqs. 5, 6
      Vector candidate = search.x[i] + v[i];                         // Eq. 7
      if (search.uniform() > pulse_rate[i])
        candidate = search.best + 0.1 * loudness.mean() * search.normals();  // Eq. 8
      candidate = search.clamped(candidate);
      const double error = search.evaluated(candidate);
      double& own = loudness[static_cast<Eigen::Index>(i)];
      if (error > search.errors[i] || search.uniform() >= own) continue;
      search.keep(candidate, error);
      search.x[i] = candidate;
      search.errors[i] = error;
      own *= 0.5;                                        // Eq. 9
      pulse_rate[i] = 0.001 * (1 - std::exp(-0.5 * t));  // Eq. 10
    }
  }
}

void differential_evolution(Search& search) {
  for (int t = 0; t < iterations; ++t) {
    std::vector<Vector> next = search.x;
    for (std::size_t i = 0; i < next.size(); ++i) {
      std::size_t a = i, b = i, c = i;
      while (a == i) a = search.below(next.size());
      while (b == i || b == a) b = search.below(next.size());
      while (c == i || c == a || c == b) c = search.below(next.size());
      const Vector mutant = search.x[a] + 0.6 * (search.x[b] - search.x[c]);
      Vector trial = (search.uniforms().array() < 0.9).select(mutant, search.x[i]);
      const auto forced = static_cast<Eigen::Index>(search.below(7));
      trial[forced] = mutant[forced];
      trial = search.clamped(trial);
      const double error = search.error(trial);
      if (error < search.errors[i]) next[i] = trial, search.errors[i] = error;
    }
    search.x = next;
  }
}

void particle_swarm(Search& search) {
  std::vector<Vector> v = at_rest(search), personal = search.x;
  for (int t = 0; t < iterations; ++t) {
    for (std::size_t i = 0; i < v.size(); ++i) {
      Vector& x = search.x[i];
      v[i] = 0.53514 * v[i] + 1.1312 * search.uniforms().cwiseProduct(personal[i] - x) +
             2.0149 * search.uniforms().cwiseProduct(search.best - x);
      x = search.clamped(x + v[i]);
      const double error = search.error(x);
      if (error < search.errors[i]) personal[i] = x, search.errors[i] = error;
    }
  }
}

void k_artificial_bee_colony(Search& search) {
  const std::size_t sources = search.x.size();
  std::vector<int> failures(sources, 0);
  const auto visit = [&](std::size_t i) {
    const Vector& best =
        search.x[static_cast<std::size_t>(std::ranges::min_element(search.errors) - search.errors.begin())];
    const auto j = static_cast<Eigen::Index>(search.below(7));
    Vector candidate = search.x[i];
    candidate[j] += (2 * search.uniform() - 1) * (&best == &search.x[i] ? candidate[j] : candidate[j] - best[j]);
    candidate = search.clamped(candidate);
    const double error = search.error(candidate);
    ++failures[i];
    if (error < search.errors[i]) search.x[i] = candidate, search.errors[i] = error, failures[i] = 0;
  };
  for (int t = 0; t < iterations; ++t) {
    for (std::size_t i = 0; i < sources; ++i) visit(i);  // employed bees
    std::vector<double> shares;
    for (const double error : search.errors) shares.push_back(1 / (1 + 100 * error));
    for (std::size_t bee = 0; bee < sources; ++bee) visit(search.picked(shares));  // onlookers
    for (std::size_t i = 0; i < sources; ++i) {                                    // scouts
      if (failures[i] <= (50 + 7) / 2) continue;
      search.x[i] = search.drawn();
      search.errors[i] = search.error(search.x[i]);
      failures[i] = 0;
    }
  }
}

struct Member {
  Vector q;
  double error, variation, crowding = 0;
  bool dominates(const Member& other) const {
    return error <= other.error && variation <= other.variation && (error < other.error || variation < other.variation);
  }
};
using Front = std::vector<Member>;

void add(Front& front, const Member& newcomer) {
  if (std::ranges::any_of(front, [&](const Member& member) { return member.dominates(newcomer); })) return;
  std::erase_if(front, [&](const Member& member) { return newcomer.dominates(member); });
  front.push_back(newcomer);
}

// Where `to` and `from` are in a front by growing error: their distance, in parts of the front in both objectives.
double distance(const Front& front, const Member& from, const Member& to) {
  return (to.error - from.error) / (front.back().error - front.front().error) +
         (from.variation - to.variation) / (front.front().variation - front.back().variation);
}

// Keeps the 50 least crowded members, by growing error.
void thin_out(Front& front) {
  std::ranges::sort(front, {}, &Member::error);
  if (front.size() <= 50) return;
  front.front().crowding = front.back().crowding = 3;
  for (std::size_t m = 1; m + 1 < front.size(); ++m) front[m].crowding = distance(front, front[m - 1], front[m + 1]);
  std::ranges::nth_element(front, front.begin() + 50, std::ranges::greater(), &Member::crowding);
  front.resize(50);
  std::ranges::sort(front, {}, &Member::error);
}

// The roulette's pick: the fewer members there are in one's cell of the grid, the likelier.
const Vector& leader(Search& search, const Front& front) {
  std::vector<int> cells;
  for (const Member& member : front)
    cells.push_back(front.size() == 1 ? 0 : static_cast<int>(20 * distance(front, front.front(), member)));
  std::vector<double> shares;
  for (const int own : cells) shares.push_back(std::pow(std::ranges::count(cells, own), -2));
  return front[search.picked(shares)].q;
}

void multi_objective_swarm(Search& search) {
  std::vector<Vector> v = at_rest(search);
  Front personal, front;
  for (std::size_t i = 0; i < v.size(); ++i) {
    personal.push_back({search.x[i], search.errors[i], (search.x[i] - search.start).norm()});
    add(front, personal.back());
  }
  const Vector limit = 0.05 * (search.upper - search.lower);
  for (int t = 1; t <= iterations; ++t) {
    thin_out(front);
    const Vector lead = leader(search, front);
    const double left = std::pow(1 - t / double(iterations), 5 * 7);
    for (std::size_t i = 0; i < v.size(); ++i) {
      Vector& x = search.x[i];
      v[i] = 0.5 * v[i] + 2 * search.uniforms().cwiseProduct(personal[i].q - x) +
             2 * search.uniforms().cwiseProduct(lead - x);
      x += v[i];
      if (i % 3 != 0 && search.uniform() < (i % 3 == 1 ? 0.5 : left)) x = search.drawn();  // a third stays
      v[i] = v[i].cwiseMax(-limit).cwiseMin(limit);
      v[i] = (x.array() < search.lower.array() || x.array() > search.upper.array()).select(-v[i], v[i]);
      x = search.clamped(x);
      const Member found{x, search.error(x), (x - search.start).norm()};
      add(front, found);
      if (found.dominates(personal[i]) || (!personal[i].dominates(found) && search.uniform() < 0.5))
        personal[i] = found;
    }
  }
}

// The means of all solves.
void count(benchmark::State& state, double error, double evaluations) {
  state.counters["error_cm"] = benchmark::Counter(100 * error, benchmark::Counter::kAvgIterations);
  state.counters["evaluations"] = benchmark::Counter(evaluations, benchmark::Counter::kAvgIterations);
}

void textbook(benchmark::State& state, void solve(Search&)) {
  const Reach reach;
  std::mt19937_64 generator(1);
  double error = 0, evaluations = 0;
  for (auto _ : state) {
    Search search(reach, generator);
    solve(search);
    error += search.best_error;
    evaluations += search.evaluations;
  }
  count(state, error, evaluations);
}

void registered(benchmark::State& state, const char* name) {
  const Reach reach;
  const std::unique_ptr<Solver> solver = solvers::solver(name).make({});
  numerics::Random random{numerics::Key(1)};
  double error = 0, evaluations = 0;
  for (auto _ : state) {
    Objective objective(reach.arm.chain, reach.target);
    const Solution solution = solve(*solver, reach.problem, objective, random, {.iterations = iterations});
    error += solution.best.error;
    evaluations += static_cast<double>(solution.evaluations);
  }
  count(state, error, evaluations);
}

// How often an iteration evaluates all candidates, and draws a number for each of them, or for each of their joints.
struct Needs {
  int evaluations = 1, uniforms = 0, uniforms_of_joints = 0, normals_of_joints = 0;
};

// What no implementation can leave out: the solver's random numbers, and its evaluations in full batches.
void floor(benchmark::State& state, Needs needs) {
  const Reach reach;
  const robots::Candidates q = reach.candidates();
  robots::Candidates of_joints = q;
  Eigen::VectorXd errors(q.cols()), of_candidates = errors;
  numerics::Random random{numerics::Key(1)};
  double evaluations = 0;
  for (auto _ : state) {
    Objective objective(reach.arm.chain, reach.target);
    for (int t = 0; t < iterations; ++t) {
      for (int k = 0; k < needs.uniforms; ++k) random.uniforms(of_candidates);
      for (int k = 0; k < needs.uniforms_of_joints; ++k) random.uniforms(of_joints);
      for (int k = 0; k < needs.normals_of_joints; ++k) random.normals(of_joints);
      for (int k = 0; k < needs.evaluations; ++k) objective.errors(q, errors);
    }
    benchmark::DoNotOptimize(errors.data());
    evaluations += static_cast<double>(objective.evaluations());
  }
  count(state, errors.minCoeff(), evaluations);
}

// All six on an arm of many joints, with many candidates. Counts an evaluation as often as there are joints.
void growth(benchmark::State& state) {
  const Eigen::Index joints = state.range(0);
  std::vector<robots::DhLink> links;
  for (Eigen::Index j = 0; j < joints; ++j)
    links.push_back({.alpha = (j % 2 == 0 ? -0.5 : 0.5) * std::numbers::pi, .d = 0.3});
  const robots::Chain snake(links, Eigen::Vector3d(0.1, 0, 0.1));
  const Problem problem{.start = Vector::Zero(joints),
                        .lower = Vector::Constant(joints, -2),
                        .upper = Vector::Constant(joints, 2),
                        .population = static_cast<int>(state.range(1))};
  numerics::Random random{numerics::Key(1)};
  double evaluations = 0;
  for (auto _ : state) {
    for (const char* name : {"ik_bat", "bat", "differential_evolution", "particle_swarm", "k_artificial_bee_colony",
                             "multi_objective_swarm"}) {
      Objective objective(snake, Eigen::Vector3d(0.3, 0.2, 0.5));
      solve(*solvers::solver(name).make({}), problem, objective, random, {.iterations = iterations});
      evaluations += static_cast<double>(objective.evaluations() * joints);
    }
  }
  count(state, 0, evaluations);
}

#define MEASURE(function, name, argument, by) \
  BENCHMARK_CAPTURE(function, name, argument)->Name("solvers/" #name "/" by)->Unit(benchmark::kMicrosecond)
#define SOLVER(name, ...)                              \
  MEASURE(registered, name, #name, "ours");            \
  MEASURE(floor, name, (Needs{__VA_ARGS__}), "floor"); \
  MEASURE(textbook, name, name, "textbook")
SOLVER(ik_bat, .uniforms = 2, .normals_of_joints = 1);
SOLVER(bat, .uniforms = 3, .normals_of_joints = 1);
SOLVER(differential_evolution, .uniforms = 4, .uniforms_of_joints = 1);
SOLVER(particle_swarm, .uniforms_of_joints = 2);
SOLVER(k_artificial_bee_colony, .evaluations = 2, .uniforms = 5);
SOLVER(multi_objective_swarm, .uniforms = 2, .uniforms_of_joints = 2);
BENCHMARK(growth)->Args({4, 50})->Args({32, 50})->Args({7, 50})->Args({7, 5000})->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace ikbench::microbenchmarks
