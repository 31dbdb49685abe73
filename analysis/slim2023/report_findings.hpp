// The verdict: the paper's findings one by one, whether each holds here, and by which numbers.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/inference/study.hpp"

namespace ikbench::slim2023 {

enum class Verdict { holds, in_part, undecided, does_not_hold };
std::string_view name_of(Verdict verdict);

struct Finding {
  std::string claim;
  Verdict verdict;
  std::string evidence;                 // in words and numbers, all of them of the store but those said to be printed
  std::string table;                    // the name of the table that has the numbers
  std::optional<Verdict> printed = {};  // on the printed numbers alone; none where they cannot say
};

// How many hold here, in a sentence.
std::string tally(const std::vector<Finding>& findings);

// Those of the study and of its companions, studies of the paper's other experiments. None where nothing is published
// of them, or nothing is solved.
std::vector<Finding> findings(const inference::StudyResults& study,
                              const std::vector<inference::StudyResults>& companions, results::Unit unit);

}  // namespace ikbench::slim2023
