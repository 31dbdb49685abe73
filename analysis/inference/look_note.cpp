#include "analysis/inference/look_note.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "analysis/inference/text.hpp"

namespace ikbench::inference {

using namespace results;

int runs_looked_at(const StudyResults& study) {
  int runs = 0;
  for (const SolverCounts& count : counts(study)) runs = std::max(runs, count.complete_runs);
  return runs;
}

std::string look_note(const std::vector<Look>& looks, int runs, double significance) {
  std::vector<std::string> earlier;
  for (const Look& look : looks) {
    if (look.runs < runs) earlier.push_back(fmt::format("{} ({})", look.runs, look.when.substr(0, 10)));
  }
  if (earlier.empty()) return "";
  const std::size_t number = earlier.size() + 1;
  return fmt::format(
      "This is look {} at these solves: earlier ones were after {} runs, and now there are {}. Whoever adds runs until p "
      "is small finds differences that are none. So take for a difference only p below {} here ({} divided by {} looks), "
      "or plan the looks: ikbench compare --sequential.",
      number, fmt::join(earlier, ", "), runs, rounded_number(significance / static_cast<double>(number), 3),
      rounded_number(significance, 3), number);
}

}  // namespace ikbench::inference
