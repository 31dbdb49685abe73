// A line of JSON for each answer: the example of docs/adding-anything.md.
#include "numerics/json.hpp"
#include "results/export.hpp"

namespace ikbench::results {

void answers_text(const Exported& exported, const Write& write) {
  exported.each_solve([&](const SolveRecord& solve) {
    const numerics::OrderedJson line{
        {"solver", solve.solver}, {"run", solve.run}, {"point", solve.point}, {"answer_rad", solve.answer_rad}};
    write(numerics::text_of(line) + '\n');
  });
}

}  // namespace ikbench::results
