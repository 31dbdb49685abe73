// Compiled once for every instruction set, with IKBENCH_KERNELS naming it; read lanes.hpp before including anything.
#include "solvers/row_kernels.hpp"

#include "robots/lanes.hpp"

namespace ikbench {
namespace {

void fly(const Flight& flight) {
  for_lanes(flight.count, [&](ptrdiff_t i, auto some) IKBENCH_INLINE {
    const Reals x = some.load(flight.x + i), v = some.load(flight.v + i), f = some.load(flight.frequency + i);
    const Reals v_next = v + (x - flight.pole) * f;
    some.store(flight.v_next + i, v_next);
    some.store(flight.x_next + i, x + v_next);
  });
}

void scatter(double centre, double step, const double* draws, double* q, ptrdiff_t count) {
  for_lanes(count,
            [&](ptrdiff_t i, auto some) IKBENCH_INLINE { some.store(q + i, centre + step * some.load(draws + i)); });
}

}  // namespace

namespace IKBENCH_KERNELS {
RowKernels row_kernels() { return {&fly, &scatter}; }
}  // namespace IKBENCH_KERNELS

}  // namespace ikbench
