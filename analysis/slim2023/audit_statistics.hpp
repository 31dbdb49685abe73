// Checks 3.1 to 3.3: the statistics of Tables 3 to 7.
#pragma once

#include <string_view>

#include "analysis/slim2023/audit_items.hpp"

namespace ikbench::slim2023 {

AuditItems anova_items(std::string_view paper);     // 3.1: Tables 4-6 from Table 3
AuditItems variance_items(std::string_view paper);  // 3.2: what equal variances would ask
AuditItems summary_items(std::string_view paper);   // 3.3: Tables 3 and 7 row by row

}  // namespace ikbench::slim2023
