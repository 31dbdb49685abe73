#include "robots/instruction_set.hpp"

namespace ikbench {

std::vector<std::string_view> instruction_sets() { return {"portable"}; }
std::string_view instruction_set() { return "portable"; }

}  // namespace ikbench
