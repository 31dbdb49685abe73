// A user's own solver beside a built-in one, with the installed libraries: docs/reference/api.md.
#include <cstdio>

#include "analysis/judge/judge.hpp"
#include "analysis/show/headline.hpp"
#include "analysis/show/publish.hpp"
#include "analysis/show/report.hpp"
#include "analysis/show/result_tables.hpp"
#include "experiments/runner.hpp"
#include "experiments/study/reader.hpp"

using namespace ikbench;

// Random steps from the best so far, which shrink.
class Climb final : public solvers::Solver {
 public:
  struct Options {
    double shrink = 0.97;
    void list(solvers::OptionList& list) { list.number("shrink", shrink, {0, 1}, "of the steps, in every iteration"); }
  };
  explicit Climb(Options options) : options_(options) {}

  void start(const solvers::Problem& problem, solvers::Objective& objective, numerics::Random&) override {
    steps_.resize(problem.joints(), problem.population);
    errors_.resize(problem.population);
    size_ = 0.5;
    best_ = {problem.start, objective.error(problem.start)};
  }
  void step(solvers::Objective& objective, numerics::Random& random) override {
    random.normals(steps_);
    const robots::Candidates candidates = (size_ * steps_).colwise() + best_.q;
    objective.errors(candidates, errors_);
    for (Eigen::Index i = 0; i < candidates.cols(); ++i) best_.improve(candidates.col(i), errors_[i]);
    size_ *= options_.shrink;
  }
  const solvers::Best& best() const override { return best_; }

 private:
  Options options_;
  robots::Candidates steps_;
  Eigen::VectorXd errors_;
  double size_ = 0;
  solvers::Best best_;
};

int main() {
  experiments::Study study = experiments::parse_study(R"(name = "mine"
robot = "kuka_iiwa14"
search = "all_joints"
runs = 3
path = { kind = "circle", points = 4 }
stop = { iterations = 50 }
solvers = [{ label = "random", solver = "random_search" }]
)",
                                                      "my study");
  const auto climb = solvers::solver_info<Climb>("climb", "random steps that shrink", "me");
  study.solvers.push_back(
      {.label = "mine", .solver = climb.name, .custom = std::make_shared<solvers::SolverInfo>(climb)});
  results::Store store("made/store.sqlite", results::Store::Mode::write);
  experiments::run(study, store, {});
  const auto reported = show::make_report(judge::judge(judge::read_study(store, store.study("mine"))), {});
  show::write_report(reported, "made", {.only = {"none"}});
  std::puts(show::headline(reported.model).c_str());
  std::puts(show::to_markdown(show::results_table(reported.model)).c_str());
}
