// Compiled once for every instruction set; IKBENCH_KERNELS names it. Read lanes.hpp before including anything.
#include "solvers/kernels.hpp"

#include "numerics/elementary.hpp"

namespace ikbench::solvers {
namespace {

using namespace numerics;

// Bodies capture a struct by value: its pointers stay in registers, because no store can change the copy.
void fly(const Flight& flight) {
  for_lanes(flight.count, [flight](ptrdiff_t i, auto some) IKBENCH_INLINE {
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
  for_lanes(swarm.count, [swarm](ptrdiff_t i, auto some) IKBENCH_INLINE {
    const Reals x = some.load(swarm.x + i), to_personal = some.load(swarm.personal + i) - x, to_best = swarm.best - x;
    const Reals v_next = swarm.inertia * some.load(swarm.v + i) +
                         swarm.cognitive * (some.load(swarm.u1 + i) * to_personal) +
                         swarm.social * (some.load(swarm.u2 + i) * to_best);
    some.store(swarm.v_next + i, v_next);
    some.store(swarm.x_next + i, x + v_next);
  });
}

void search_locally(const LocalSearch& search) {
  for_lanes(search.count, [search](ptrdiff_t i, auto some) IKBENCH_INLINE {
    const Bits local = where_less(some.load(search.pulse_rate + i), some.load(search.chance + i));
    some.store(search.q + i,
               chosen(local, search.best + search.step * some.load(search.draws + i), some.load(search.flown + i)));
  });
}

void choose(const Choice& choice) {
  for_lanes(choice.count, [choice](ptrdiff_t i, auto some) IKBENCH_INLINE {
    const Bits is_less = where_less(some.load(choice.less + i), some.load(choice.than + i));
    some.store(choice.out + i, chosen(is_less, some.load(choice.yes + i), some.load(choice.no + i)));
  });
}

// NaN stays NaN: it is the second operand of both comparisons.
void clamp(double lower, double upper, double* q, ptrdiff_t count) {
  for_lanes(count, [&](ptrdiff_t i, auto some) IKBENCH_INLINE {
    some.store(q + i, smaller(all(upper), larger(all(lower), some.load(q + i))));
  });
}

void turn_back(const Rebound& rebound) {
  for_lanes(rebound.count, [rebound](ptrdiff_t i, auto some) IKBENCH_INLINE {
    const Reals lower = all(rebound.lower), upper = all(rebound.upper), at = some.load(rebound.q + i);
    const Reals slow = smaller(all(rebound.max_velocity), larger(all(-rebound.max_velocity), some.load(rebound.v + i)));
    const Bits outside = where_less(at, lower) | where_less(upper, at);
    some.store(rebound.v + i, chosen(outside, -slow, slow));
    some.store(rebound.q + i, smaller(upper, larger(lower, at)));
  });
}

IKBENCH_LANES Reals whole_part(Reals x) {
  const Reals nearest = x + to_integer - to_integer;
  return chosen(where_less(x, nearest), nearest - 1.0, nearest);
}

// Returns a place among all numbers, given the place among the numbers without `taken`.
IKBENCH_LANES Reals after(Reals place, Reals taken) { return chosen(where_less(place, taken), place, place + 1.0); }

constexpr double first_places[]{0, 1, 2, 3, 4, 5, 6, 7};

void choose_partners(double* rows, ptrdiff_t count) {
  for_lanes(count, [&](ptrdiff_t i, auto some) IKBENCH_INLINE {
    double *const to_a = rows + i, *const to_b = to_a + count, *const to_c = to_b + count;
    const auto pick = [&](const double* from, ptrdiff_t left)
                          IKBENCH_INLINE { return whole_part(some.load(from) * static_cast<double>(left)); };
    const Reals own = load<Reals>(first_places) + static_cast<double>(i);
    const Reals a = after(pick(to_a, count - 1), own);
    const Reals first = smaller(own, a), second = larger(own, a);
    const Reals b = after(after(pick(to_b, count - 2), first), second);
    const Reals lowest = smaller(first, b), highest = larger(second, b), middle = larger(first, smaller(second, b));
    some.store(to_a, a);
    some.store(to_b, b);
    some.store(to_c, after(after(after(pick(to_c, count - 3), lowest), middle), highest));
  });
}

void add_squares(double centre, const double* q, double* sums, ptrdiff_t count) {
  for_lanes(count, [&](ptrdiff_t i, auto some) IKBENCH_INLINE {
    const Reals off = some.load(q + i) - centre;
    some.store(sums + i, some.load(sums + i) + off * off);
  });
}

}  // namespace

namespace IKBENCH_KERNELS {
Kernels kernels() {
  return {&fly, &swarm, &search_locally, &scatter, &choose, &clamp, &turn_back, &choose_partners, &add_squares};
}
}  // namespace IKBENCH_KERNELS

}  // namespace ikbench::solvers
