// What is said of those whom the first metric does not tell apart: the next metric of the plan that does.
#pragma once

#include <string>

#include "analysis/show/answer.hpp"

namespace ikbench::show {

// "LM is the fastest; DLS takes 1.2 times, SLSQP 27 times as long.", after what is not compared or tells nobody apart.
// Pairs and p are those of all solvers, so that the first metric chooses none. Empty where one solver is best alone.
std::string then_of(const Answer& answer);

}  // namespace ikbench::show
