// Checks 3.4 and 3.5: the circle of Table 8, the helix of Eq. 27 and the arms that have to reach them. Centimetres.
#pragma once

#include <string_view>

#include "analysis/slim2023/audit_items.hpp"

namespace ikbench::slim2023 {

AuditItems circle_items(std::string_view paper);    // 3.4: Table 8
AuditItems geometry_items(std::string_view paper);  // 3.5: Eq. 27 and the arm

}  // namespace ikbench::slim2023
