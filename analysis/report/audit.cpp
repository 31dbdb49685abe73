#include "analysis/report/audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace ikbench::report {

std::string_view name_of(AuditVerdict verdict) {
  constexpr std::array<std::string_view, 5> names{"consistent", "rounding", "misprint", "not supported",
                                                  "contradiction"};
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
      "This table uses no solves. Its numbers follow from what the paper prints and, where the paper is silent, from "
      "statements that results/published marks as not printed. "
      "consistent: the numbers agree to the last printed digit. "
      "rounding: they agree within the rounding of the printed digits. misprint: a number is wrong, and other numbers of "
      "the paper show the right one. not supported: the paper's numbers do not show a claim or an assumption, or only "
      "with something that it does not print; it may still be true. contradiction: two printed things cannot both be "
      "true.");
  return table;
}

std::string audit_sentence(const Table& audit) {
  const auto column = std::ranges::find(audit.columns, "verdict", &Column::name) - audit.columns.begin();
  std::string text = fmt::format("{} statements: ", audit.rows.size());
  bool is_first = true;
  for (const AuditVerdict verdict : {AuditVerdict::contradiction, AuditVerdict::misprint, AuditVerdict::unsupported,
                                     AuditVerdict::rounding, AuditVerdict::consistent}) {
    const auto is_it = [&](const std::vector<Cell>& row) {
      const auto* words = std::get_if<std::string>(&row[static_cast<std::size_t>(column)]);
      return words && *words == name_of(verdict);
    };
    const auto count = std::ranges::count_if(audit.rows, is_it);
    if (count == 0) continue;
    text += fmt::format("{}{} {}", is_first ? "" : ", ", name_of(verdict), count);
    is_first = false;
  }
  return text + '.';
}

}  // namespace ikbench::report
