#include "analysis/slim2023/audit.hpp"

#include "analysis/slim2023/audit_conditions.hpp"
#include "analysis/slim2023/audit_geometry.hpp"
#include "analysis/slim2023/audit_statistics.hpp"

namespace ikbench::slim2023 {

using namespace report;

std::vector<AuditItem> audit(std::string_view paper) {
  AuditItems items;
  for (const auto& check :
       {anova_items, variance_items, summary_items, circle_items, geometry_items, parameter_items, condition_items}) {
    for (AuditItem& item : check(paper)) items.push_back(std::move(item));
  }
  return items;
}

}  // namespace ikbench::slim2023
