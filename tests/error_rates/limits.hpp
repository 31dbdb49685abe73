// What tests within blocks, verdicts of "the same", and looks at growing data are wrong about, and what a test can see.
#pragma once

namespace ikbench::error_rates {

void print_limits(int simulations);

}  // namespace ikbench::error_rates
