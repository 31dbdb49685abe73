// How often this program has asked for heap memory, by malloc or operator new.
#pragma once

namespace ikbench {

long allocations();

}  // namespace ikbench
