// Rules for what is claimed of the poses that are solved, on the arm of each study that is reported together.
#pragma once

#include <vector>

#include "analysis/claims/case.hpp"

namespace ikbench::claims {

// The printed share is inside the interval of ours: a claim for each solver on each arm, in whose sentence {solver},
// {arm} and {share} stand for these. It depends where fewer iterations give it, and as many the other printed shares on
// this arm.
std::vector<report::Claim> rate_as_printed(const Case& of);
// The solver solves more than the one that it is held against, or than all others, on every arm.
std::vector<report::Claim> solves_more(const Case& of);

}  // namespace ikbench::claims
