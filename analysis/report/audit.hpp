// The audit of a paper: what its printed numbers say about each other. Nothing is solved.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/report/table.hpp"

namespace ikbench::report {

// consistent: what follows is what is printed, to its last digit; rounding: it differs by no more than the rounding of
// the printed numbers that it follows from; misprint: a word or number that others of the paper show to be another;
// unsupported: a claim that the numbers do not show, or only with something that is not printed, and that may still be
// true; contradiction: two printed things that cannot both be true.
enum class AuditVerdict { consistent, rounding, misprint, unsupported, contradiction };
std::string_view name_of(AuditVerdict verdict);

struct AuditItem {
  std::string id;  // of the item in the paper's notes, with a letter: "3.1a"
  std::string where;
  std::string printed;
  std::string follows;
  AuditVerdict verdict;
  std::string sentence;
};

// Named "audit".
Table audit_table(const std::vector<AuditItem>& items);
// "40 statements: contradiction 2, misprint 8, ...", of that table.
std::string audit_sentence(const Table& audit);

}  // namespace ikbench::report
