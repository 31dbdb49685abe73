// A solver for ikbench in C++: a random local search. It needs no library, because ikbench evaluates the candidates.
// c++ -std=c++17 -O2 -o search search.cpp
#include "ikbench_program.hpp"

using ikbench::Values;

Values solve(const ikbench::Robot&, ikbench::Problem& problem) {
  std::vector<Values> q(10, problem.start);
  Values best = problem.start;
  double least = 1e300, reach = 0.5;
  while (const auto errors = problem.evaluate(q)) {
    const auto nearest = std::min_element(errors->begin(), errors->end());
    reach = reach < 1e-9 ? 0.5 : reach * (*nearest < least ? 1.2 : 0.9);
    if (*nearest < least) least = *nearest, best = q[nearest - errors->begin()];
    for (std::size_t i = 0; i < q.size(); ++i) {
      for (std::size_t j = 0; j < best.size(); ++j) {
        const double step = i ? std::uniform_real_distribution(-reach, reach)(problem.random) : 0;
        q[i][j] = std::clamp(best[j] + step, problem.lower[j], problem.upper[j]);
      }
    }
  }
  return {};  // the best candidate
}

int main() {
  ikbench::run(
      "cpp_search", {}, [](const ikbench::Robot& robot) { return robot; }, solve);
}
