// Checks 3.6 to 3.9: the parameters of Table 1, and who was given what.
#pragma once

#include <string_view>

#include "analysis/slim2023/audit_items.hpp"

namespace ikbench::slim2023 {

AuditItems parameter_items(std::string_view paper);  // 3.6: Table 1
AuditItems condition_items(std::string_view paper);  // 3.7-3.9: who was given what

}  // namespace ikbench::slim2023
