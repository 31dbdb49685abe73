#include "analysis/inference/look_note.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ikbench::inference {

using namespace results;

int runs_looked_at(const StudyResults& study) {
  int runs = 0;
  for (const SolverCounts& count : counts(study)) runs = std::max(runs, count.complete_runs);
  return runs;
}

Doubts look_doubts(const std::vector<Look>& looks, int runs, double significance) {
  std::vector<std::string> earlier;
  for (const Look& look : looks) {
    if (look.runs != runs) earlier.push_back(fmt::format("{} ({})", look.runs, look.when.substr(0, 10)));
  }
  if (earlier.empty()) return {};
  constexpr std::size_t most_named = 5;
  const std::size_t number_of_earlier = earlier.size();
  if (number_of_earlier > most_named) earlier.erase(earlier.begin(), earlier.end() - most_named);
  const std::size_t number = number_of_earlier + 1;
  const double level = significance / static_cast<double>(number * (number - 1));
  return {{.kind = DoubtKind::looked_before,
           .who = earlier,
           .count = static_cast<double>(number),
           .of = static_cast<double>(runs),
           .value = level,
           .limit = 100 * significance,
           .what = number_of_earlier > most_named ? "the latest before it" : "earlier ones"}};
}

}  // namespace ikbench::inference
