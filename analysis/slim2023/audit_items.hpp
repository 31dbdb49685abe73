// What the audit's checks share: the printed statements, and how a difference is judged.
#pragma once

#include "analysis/slim2023/audit.hpp"
#include "results/csv.hpp"

namespace ikbench::slim2023 {

// results/published/<paper>/statements.csv: what is printed outside the tables, and, where the source says so, what is
// not printed and a check needs.
class Statements {
 public:
  explicit Statements(std::string_view paper);

  double number(std::string_view name) const;
  const std::string& text(std::string_view name) const { return cell(name, "value"); }
  const std::string& source(std::string_view name) const { return cell(name, "source"); }

 private:
  const std::string& cell(std::string_view name, std::string_view column) const;

  results::CsvTable table_;
};

// A printed number against the one that follows; `slack` is what the rounding of what it follows from may change.
report::AuditVerdict judged(const std::string& printed, double follows, double slack,
                            report::AuditVerdict otherwise = report::AuditVerdict::contradiction);

// consistent where it holds.
report::AuditVerdict unless(bool holds, report::AuditVerdict otherwise);

using AuditItems = std::vector<report::AuditItem>;

}  // namespace ikbench::slim2023
