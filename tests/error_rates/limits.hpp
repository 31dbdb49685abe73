// Error rates of tests within blocks and of verdicts of "the same".
#pragma once

namespace ikbench::error_rates {

void print_limits(int simulations);

}  // namespace ikbench::error_rates
