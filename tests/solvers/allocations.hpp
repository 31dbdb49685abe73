// The number of this program's requests for heap memory, by malloc or operator new.
#pragma once

namespace ikbench {

long allocations();

}  // namespace ikbench
