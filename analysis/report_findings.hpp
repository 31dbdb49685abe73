// The verdict: the paper's findings one by one, whether each holds here, and by which numbers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/study.hpp"

namespace ikbench {

enum class Verdict { holds, in_part, undecided, does_not_hold };
std::string_view name_of(Verdict verdict);

struct Finding {
  std::string claim;
  Verdict verdict;
  std::string evidence;  // in words and numbers, all of them of the store but those said to be printed
  std::string table;     // the name of the table that has the numbers
};

// None where nothing is published of the study, or nothing is solved. `timed` is the study of the paper's Table 7 (time
// to come within 0.1 cm); null where the store has none.
std::vector<Finding> findings(const StudyResults& study, Unit unit, const StudyResults* timed = nullptr);

}  // namespace ikbench
