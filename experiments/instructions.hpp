// The processor's own count of instructions.
#pragma once

namespace ikbench::experiments {

// Instructions that this thread has executed in user space since its first call. NaN where the system has no such
// counter (many virtual machines), forbids it (kernel.perf_event_paranoid above 2) or shares it with other programs.
double thread_instructions();

}  // namespace ikbench::experiments
