// The audit of a paper: what its printed numbers say about each other. Nothing is solved.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/report/claims.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::report {

// A printed thing, judged by others that are printed. It holds if what follows is what is printed to its last digit
// (consistent), in part within the rounding of the printed digits. It fails where two printed things cannot both be
// true (contradiction), or others show what was to be printed (misprint). It is undecided where the numbers do not show
// it, or only with something that is not printed (not supported); it may still be true.
struct AuditItem {
  std::string id;  // of the item in the paper's notes, with a letter: "3.1a"
  std::string where;
  std::string printed;
  std::string follows;
  Verdict verdict;
  bool is_misprint = false;  // of one that fails
  std::string why = {};
};

constexpr std::array<std::string_view, 5> audit_verdicts{"consistent", "rounding", "misprint", "not supported",
                                                         "contradiction"};
std::string_view words_of(const AuditItem& item);  // one of these

// Named "audit".
Table audit_table(const std::vector<AuditItem>& items);
// "40 statements: contradiction 2, misprint 8, ...", of that table.
std::string audit_sentence(const Table& audit);

}  // namespace ikbench::report
