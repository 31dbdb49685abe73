#include "analysis/report/audit.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "analysis/report/words.hpp"

namespace ikbench::report {

std::string_view words_of(const AuditItem& item) {
  const bool fails = item.verdict == Verdict::fails;
  return audit_verdicts[item.verdict == Verdict::holds     ? 0U
                        : item.verdict == Verdict::in_part ? 1U
                        : !fails                           ? 3U
                        : item.is_misprint                 ? 2U
                                                           : 4U];
}

Table audit_table(const std::vector<AuditItem>& items) {
  Table table{.name = "audit",
              .caption = "Audit: whether the printed numbers agree with each other",
              .columns = {"id", "where", "printed", "follows", "verdict", "why"}};
  for (const AuditItem& item : items) {
    table.rows.push_back({item.id, item.where, item.printed, item.follows, std::string(words_of(item)), item.why});
  }
  table.notes.emplace_back(words::audit);
  return table;
}

std::string audit_sentence(const Table& audit) {
  const auto column = std::ranges::find(audit.columns, "verdict") - audit.columns.begin();
  std::vector<std::string> parts;
  for (const std::string_view verdict : {"contradiction", "misprint", "not supported", "rounding", "consistent"}) {
    const auto is_it = [&](const std::vector<Cell>& row) {
      const auto* words = std::get_if<std::string>(&row[static_cast<std::size_t>(column)]);
      return words && *words == verdict;
    };
    const auto count = std::ranges::count_if(audit.rows, is_it);
    if (count > 0) parts.push_back(fmt::format("{} {}", verdict, count));
  }
  return fmt::format("{} statements: {}.", audit.rows.size(), fmt::join(parts, ", "));
}

}  // namespace ikbench::report
