// Compiled once for every instruction set; IKBENCH_KERNELS names it. Read lanes.hpp before including anything.
#include "solvers/kernels.hpp"

#include "numerics/elementary.hpp"

namespace ikbench::solvers {
namespace {

using namespace numerics;

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

void swarm(const Swarm& swarm) {
  for_lanes(swarm.count, [&](ptrdiff_t i, auto some) IKBENCH_INLINE {
    const Reals x = some.load(swarm.x + i), to_personal = some.load(swarm.personal + i) - x, to_best = swarm.best - x;
    const Reals v_next = swarm.inertia * some.load(swarm.v + i) +
                         swarm.cognitive * (some.load(swarm.u1 + i) * to_personal) +
                         swarm.social * (some.load(swarm.u2 + i) * to_best);
    some.store(swarm.v_next + i, v_next);
    some.store(swarm.x_next + i, x + v_next);
  });
}

void search_locally(const LocalSearch& search) {
  for_lanes(search.count, [&](ptrdiff_t i, auto some) IKBENCH_INLINE {
    const Bits local = where_less(some.load(search.pulse_rate + i), some.load(search.chance + i));
    some.store(search.q + i,
               chosen(local, search.best + search.step * some.load(search.draws + i), some.load(search.q + i)));
  });
}

void choose(const double* chance, double limit, const double* other, double* q, ptrdiff_t count) {
  for_lanes(count, [&](ptrdiff_t i, auto some) IKBENCH_INLINE {
    const Bits stays = where_less(some.load(chance + i), all(limit));
    some.store(q + i, chosen(stays, some.load(q + i), some.load(other + i)));
  });
}

// NaN stays NaN: it is the second operand of both comparisons.
void clamp(double lower, double upper, double* q, ptrdiff_t count) {
  for_lanes(count, [&](ptrdiff_t i, auto some) IKBENCH_INLINE {
    some.store(q + i, smaller(all(upper), larger(all(lower), some.load(q + i))));
  });
}

}  // namespace

namespace IKBENCH_KERNELS {
Kernels kernels() { return {&fly, &swarm, &search_locally, &scatter, &choose, &clamp}; }
}  // namespace IKBENCH_KERNELS

}  // namespace ikbench::solvers
