// A line of JSON for each answer: the example of docs/adding-anything.md.
#include "numerics/json.hpp"
#include "results/export.hpp"

namespace ikbench::results {

std::string answers_text(const Exported& exported) {
  std::string text;
  for (const SolveRecord& solve : exported.solves) {
    const numerics::OrderedJson line{
        {"solver", solve.solver}, {"run", solve.run}, {"point", solve.point}, {"answer_rad", solve.answer_rad}};
    text += numerics::text_of(line) + '\n';
  }
  return text;
}

}  // namespace ikbench::results
