// Measures a run of the helix study, slim2023, against its floor: for each of the six solvers the evaluations of its
// solves, in the same batches, and as many random numbers, but nothing else; and for the study the six floors together.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <stdexcept>

#include "experiments/microbenchmarks/harness.hpp"
#include "experiments/runner.hpp"
#include "experiments/study_reader.hpp"
#include "experiments/task.hpp"
#include "solvers/bounds.hpp"
#include "solvers/registry.hpp"

namespace ikbench::microbenchmarks {

using namespace numerics;
using namespace robots;
using namespace solvers;
using namespace results;
using namespace experiments;

namespace {

// A fill of so many numbers for each candidate.
struct Fill {
  int each;
  bool is_normal = false;
};

// The fills of a solver's start and of its step. Some also draw single numbers, which are counted.
struct Draws {
  std::vector<Fill> start, step;
};

Draws draws(const std::string& solver, int joints) {
  const Fill one{1}, all{joints}, normal{joints, true};
  const std::map<std::string, Draws> of{{"ik_bat", {{all}, {one, normal, one}}},
                                        {"bat", {{all, one}, {one, one, normal, one}}},
                                        {"differential_evolution", {{all}, {{3}, all, one}}},
                                        {"particle_swarm", {{all}, {all, all}}},
                                        {"k_artificial_bee_colony", {{all}, {one, one, one, one, one}}},
                                        {"multi_objective_swarm", {{all}, {all, all, one, one}}}};
  return of.at(solver);
}

using Block = std::array<double, random_lanes>;

// The next block of random numbers; the original goes on as if it had not been asked.
Block next_block(Random random) {
  Block block;
  random.uniforms(block.data(), random_lanes);
  return block;
}

// Notes the size of each batch.
class RecordingObjective final : public Objective {
 public:
  using Objective::Objective;
  const std::vector<Eigen::Index>& batches() const { return batches_; }

 private:
  void evaluate(const CandidatesRef& q, Eigen::Ref<Eigen::VectorXd> errors) override {
    batches_.push_back(q.cols());
    Objective::evaluate(q, errors);
  }

  std::vector<Eigen::Index> batches_;
};

// The first run of one solver of a study: its solves, and their floor.
class Run {
 public:
  Run(const Study& study, const Robot& arm, const SolverEntry& entry)
      : study_(study),
        task_(study, arm),
        population_(effective_population(study, entry)),
        solver_(info_of(entry).make(effective_options(study, entry))),
        stream_(Key(study.seed).with(entry.label).with(1)),
        targets_(targets(study, arm, 1)),
        draws_(draws(entry.solver, task_.arm().joints())),
        numbers_(population_ * most_joints) {
    Eigen::Index largest = 0;
    solve<RecordingObjective>([&](const RecordingObjective& objective, const Random& random, const Clocked& solved) {
      const auto steps = static_cast<int>(solved.solution.iterations);
      made_.push_back({objective.batches(), steps, single_draws(stream(made_.size()), steps, random)});
      for (const Eigen::Index batch : objective.batches()) {
        evaluated_ += static_cast<double>(batch);
        largest = std::max(largest, batch);
      }
      counted_ += static_cast<double>(objective.evaluations());
    });
    candidates_ = drawn_candidates(task_.problem(study.initial, population_), static_cast<int>(largest));
    errors_.resize(largest);
  }

  // Solves target after target, each from where the previous answer left the arm, and shows each solve to `take`.
  template <class Objective, class Take>
  void solve(const Take& take) {
    Configuration start = study_.initial;
    for (std::size_t point = 0; point < targets_.size(); ++point) {
      Objective objective(task_.arm(), task_.goal(targets_[point]));
      Random random(stream(point));
      const Clocked solved =
          task_.clocked(*solver_, task_.problem(start, population_), objective, random, targets_[point], start);
      start = solved.answer;
      take(objective, random, solved);
    }
  }

  void floor() {
    for (std::size_t point = 0; point < made_.size(); ++point) {
      Random random(stream(point));
      fill(random, made_[point].steps);
      for (int i = 0; i < made_[point].single_draws; ++i) benchmark::DoNotOptimize(random.uniform());
      Objective objective(task_.arm(), task_.goal(targets_[point]));
      for (const Eigen::Index batch : made_[point].batches) {
        objective.errors(candidates_.leftCols(batch), errors_.head(batch));
      }
    }
  }

  // Evaluations, with those ahead that were dropped, for each that counts.
  double evaluated_per_counted() const { return evaluated_ / counted_; }

 private:
  struct Made {
    std::vector<Eigen::Index> batches;
    int steps;
    int single_draws;
  };

  Key stream(std::size_t point) const { return stream_.with(point + 1); }

  void fill(Random& random, int steps) {
    const auto draw = [&](const std::vector<Fill>& fills) {
      for (const auto& [each, is_normal] : fills) {
        is_normal ? random.normals(numbers_.data(), each * population_)
                  : random.uniforms(numbers_.data(), each * population_);
      }
    };
    draw(draws_.start);
    for (int step = 0; step < steps; ++step) draw(draws_.step);
  }

  // As many single numbers, in whole blocks, as bring a stream from the fills to where the solve left it.
  int single_draws(Key key, int steps, const Random& left) {
    Random random(key);
    fill(random, steps);
    constexpr int most = 1'000'000;
    for (int drawn = 0; drawn < most; drawn += random_lanes) {
      if (next_block(random) == next_block(left)) return drawn;
      random.uniforms(numbers_.data(), random_lanes);
    }
    throw std::logic_error("floors: a solver draws other random numbers than its floor");
  }

  const Study& study_;
  Task task_;
  int population_;
  std::unique_ptr<Solver> solver_;
  Key stream_;
  std::vector<Pose> targets_;
  Draws draws_;
  Candidates candidates_;
  Eigen::VectorXd errors_, numbers_;
  std::vector<Made> made_;
  double evaluated_ = 0, counted_ = 0;
};

void register_runs() {
  static Study study = load_study("slim2023");
  study.runs = 1;
  static const Robot arm = arm_of(study);
  static std::vector<std::unique_ptr<Run>> runs;
  const auto add = [](const std::string& name, const auto& function) {
    benchmark::RegisterBenchmark(("floors/" + name).c_str(), function)
        ->Unit(benchmark::kMicrosecond)
        ->MeasureProcessCPUTime();
  };
  for (const SolverEntry& entry : study.solvers) {
    Run& run = *runs.emplace_back(std::make_unique<Run>(study, arm, entry));
    add(entry.label + "/solves", [&run](benchmark::State& state) {
      for (auto _ : state) {
        run.solve<Objective>([](const Objective&, const Random&, const Clocked& solved) {
          benchmark::DoNotOptimize(solved.solution.best.error);
        });
      }
      state.counters["evaluated_per_counted"] = run.evaluated_per_counted();
    });
    add(entry.label + "/floor", [&run](benchmark::State& state) {
      for (auto _ : state) run.floor();
    });
  }
  add("study/solves", [](benchmark::State& state) {
    std::int64_t solves = 0;
    for (auto _ : state) solve_study(study, 1, [&](const SolveRecord&) { ++solves; });
    if (solves != 120 * state.iterations()) state.SkipWithError("a run of slim2023 has other than 120 solves");
  });
  add("study/floor", [](benchmark::State& state) {
    for (auto _ : state) {
      for (const auto& run : runs) run->floor();
    }
  });
}

}  // namespace

}  // namespace ikbench::microbenchmarks

int main(int argc, char** argv) {
  ikbench::microbenchmarks::register_runs();
  return ikbench::microbenchmarks::run(argc, argv);
}
