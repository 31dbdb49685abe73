// Rules for claims about the solved poses, on the arm of each study that is reported together.
#pragma once

#include <vector>

#include "analysis/claims/case.hpp"

namespace ikbench::claims {

// The printed share is inside the interval of ours: one claim per solver and arm, whose sentence has {solver}, {arm}
// and {share}. The verdict is "depends" if fewer iterations give the share, and as many give the other printed shares
// on this arm.
std::vector<report::Claim> rate_as_printed(const Case& of);
// The solver solves more than the one that it is compared with, or than all others, on every arm.
std::vector<report::Claim> solves_more(const Case& of);

}  // namespace ikbench::claims
