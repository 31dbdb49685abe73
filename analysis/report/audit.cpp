#include "analysis/report/audit.hpp"

#include <array>

namespace ikbench::report {

std::string_view name_of(AuditVerdict verdict) {
  constexpr std::array<std::string_view, 4> names{"consistent", "rounding", "misprint", "contradiction"};
  return names[static_cast<std::size_t>(verdict)];
}

Table audit_table(const std::vector<AuditItem>& items) {
  Table table{.name = "audit",
              .caption = "Audit: whether the printed numbers agree with each other",
              .columns = {{"id", Align::left},
                          {"where", Align::left},
                          {"printed", Align::left},
                          {"follows", Align::left},
                          {"verdict", Align::left},
                          {"why", Align::left}}};
  for (const AuditItem& item : items) {
    table.rows.push_back(
        {item.id, item.where, item.printed, item.follows, std::string(name_of(item.verdict)), item.sentence});
  }
  table.notes.emplace_back(
      "No solve enters this table. Numbers follow from what the paper prints and, where it is silent, from statements "
      "that results/published marks as not printed. "
      "consistent: to the last printed digit; "
      "rounding: within what the rounding of the printed numbers allows; misprint: others of the paper's numbers show "
      "what is meant; contradiction: two things that cannot both hold, or a claim that the numbers do not carry.");
  return table;
}

}  // namespace ikbench::report
