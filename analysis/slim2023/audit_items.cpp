#include "analysis/slim2023/audit_items.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "analysis/slim2023/published_numbers.hpp"
#include "numerics/number.hpp"
#include "results/published.hpp"

namespace ikbench::slim2023 {

using namespace numerics;
using namespace results;
using namespace report;

Statements::Statements(std::string_view paper) : table_(published::table(paper, "statements")) {}

double Statements::number(std::string_view name) const { return number_from(text(name)).value(); }

const std::string& Statements::cell(std::string_view name, std::string_view column) const {
  const std::size_t names = table_.column("name");
  for (const auto& row : table_.rows) {
    if (row[names] == name) return row[table_.column(column)];
  }
  throw std::logic_error(fmt::format("no statement '{}'", name));
}

AuditVerdict unless(bool holds, AuditVerdict otherwise) { return holds ? AuditVerdict::consistent : otherwise; }

AuditVerdict judged(const std::string& printed, double follows, double slack, AuditVerdict otherwise) {
  const double half = half_unit(printed);
  const double distance = std::abs(number_from(printed).value() - follows);
  constexpr double room = 1 + 1e-9;  // 2.5 printed as 2 is half a unit off, and doubles are not exact
  if (distance <= half * room) return AuditVerdict::consistent;
  return distance <= (half + slack) * room ? AuditVerdict::rounding : otherwise;
}

}  // namespace ikbench::slim2023
