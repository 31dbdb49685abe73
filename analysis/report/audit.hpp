// The audit of a paper: checks its printed numbers against each other, without solving anything.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/report/claims.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::report {

// A printed statement, judged by other printed ones. It holds if they give the same to the last digit (consistent), and
// in part within the rounding of the printed digits. It fails if two printed statements cannot both be true
// (contradiction), or others show what should have been printed (misprint). It is undecided if the numbers do not show
// it, or only with something unprinted (not supported); it may still be true.
struct AuditItem {
  std::string id;  // of the item in the paper's notes, with a letter: "3.1a"
  std::string where;
  std::string printed;
  std::string follows;
  Verdict verdict;
  bool is_misprint = false;  // one that fails is a misprint, not a contradiction
  std::string why = {};
};

constexpr std::array<std::string_view, 5> audit_verdicts{"consistent", "rounding", "misprint", "not supported",
                                                         "contradiction"};
std::string_view words_of(const AuditItem& item);  // one of these

// Named "audit".
Table audit_table(const std::vector<AuditItem>& items);
// Counts the verdicts of audit_table(): "40 statements: contradiction 2, misprint 8, ...".
std::string audit_sentence(const Table& audit);

}  // namespace ikbench::report
