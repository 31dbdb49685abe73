#include "analysis/slim2023/audit.hpp"

#include <array>

#include "analysis/slim2023/audit_conditions.hpp"
#include "analysis/slim2023/audit_geometry.hpp"
#include "analysis/slim2023/audit_statistics.hpp"

namespace ikbench::slim2023 {

using namespace report;

std::string_view name_of(AuditVerdict verdict) {
  constexpr std::array<std::string_view, 4> names{"consistent", "rounding", "misprint", "contradiction"};
  return names[static_cast<std::size_t>(verdict)];
}

std::vector<AuditItem> audit(std::string_view paper) {
  AuditItems items;
  for (const auto& check :
       {anova_items, variance_items, summary_items, circle_items, geometry_items, parameter_items, condition_items}) {
    for (AuditItem& item : check(paper)) items.push_back(std::move(item));
  }
  return items;
}

Table audit_table(std::string_view paper) {
  Table table{.name = "audit",
              .caption = "Audit: what the printed numbers say about each other",
              .columns = {{"id", Align::left},
                          {"where", Align::left},
                          {"printed", Align::left},
                          {"follows", Align::left},
                          {"verdict", Align::left},
                          {"why", Align::left}}};
  for (const AuditItem& item : audit(paper)) {
    table.rows.push_back(
        {item.id, item.where, item.printed, item.follows, std::string(name_of(item.verdict)), item.sentence});
  }
  table.notes.emplace_back(
      "No solve enters this table. Numbers follow from what the paper prints and, where it is silent, from statements "
      "that "
      "results/published marks as not printed (lengths of the links, the name of the KUKA arm, what K-ABC's source "
      "says). "
      "consistent: to the last printed digit; "
      "rounding: within what the rounding of the printed numbers allows; misprint: others of the paper's numbers show "
      "what is meant; contradiction: two things that cannot both hold, or a claim that the numbers do not carry.");
  return table;
}

}  // namespace ikbench::slim2023
