// Error rates of tests within blocks, of verdicts of "the same" and of looks at growing data, and the power of tests.
#pragma once

namespace ikbench::error_rates {

void print_limits(int simulations);

}  // namespace ikbench::error_rates
