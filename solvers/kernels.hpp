// Equations that many solvers share, computed in lanes on one joint's row of candidates. kernels.cpp is compiled once
// per instruction set; all give the same bits.
#pragma once

#include <stddef.h>

#include "numerics/kernels.hpp"

namespace ikbench::solvers {

// One joint of `count` candidates that a velocity moves. x_next and v_next may be x and v.
struct Flight {
  double pole;  // the velocity grows away from it
  const double* frequency;
  const double *x, *v;
  double *x_next, *v_next;
  ptrdiff_t count;
};

// One joint of `count` particles: v_next = inertia v + cognitive u1 (personal - x) + social u2 (best - x), x_next = x +
// v_next.
struct Swarm {
  double inertia, cognitive, social, best;
  const double *x, *v, *personal, *u1, *u2;
  double *x_next, *v_next;
  ptrdiff_t count;
};

// One joint of `count` bats, some of which search around the best: q = best + step draws where chance > pulse_rate,
// else flown. q may be flown.
struct LocalSearch {
  double best, step;
  const double *draws, *chance, *pulse_rate, *flown;
  double* q;
  ptrdiff_t count;
};

// out = yes where less < than, else no. out may be one of the others.
struct Choice {
  const double *less, *than, *yes, *no;
  double* out;
  ptrdiff_t count;
};

struct Kernels {
  void (*fly)(const Flight& flight);  // v_next = v + (x - pole) frequency, x_next = x + v_next
  void (*swarm)(const Swarm& swarm);
  void (*search_locally)(const LocalSearch& search);
  void (*scatter)(double centre, double step, const double* draws, double* q, ptrdiff_t count);  // centre + step draws
  void (*choose)(const Choice& choice);
  void (*clamp)(double lower, double upper, double* q, ptrdiff_t count);
  // Limits v to `most`, turns it back where q is outside, and clamps q.
  void (*turn_back)(double lower, double upper, double most, double* q, double* v, ptrdiff_t count);
  // Three rows of numbers in [0, 1) become three different others of `count` candidates for each: DE's partners.
  void (*choose_partners)(double* rows, ptrdiff_t count);
  void (*add_squares)(double centre, const double* q, double* sums, ptrdiff_t count);  // sums += (q - centre)^2
};

IKBENCH_DECLARE_KERNELS

}  // namespace ikbench::solvers
