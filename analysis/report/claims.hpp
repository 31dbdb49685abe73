// The verdict: a paper's claims one by one, whether each holds here, and by which numbers.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ikbench::report {

enum class Verdict { holds, in_part, undecided, fails };
std::string_view name_of(Verdict verdict);

struct Claim {
  std::string statement;
  Verdict verdict;
  std::string evidence;                 // in words and numbers, all of them of the store but those said to be printed
  std::string table;                    // the name of the table that has the numbers
  std::optional<Verdict> printed = {};  // on the printed numbers alone; none where they cannot say
};

// How many of some claims hold here, in a sentence.
std::string tally(const std::vector<Claim>& claims);

}  // namespace ikbench::report
