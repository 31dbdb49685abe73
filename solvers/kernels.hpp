// Equations that many solvers share, computed in lanes on one joint's row of candidates. kernels.cpp is compiled once
// per instruction set; all give the same bits.
#pragma once

#include <stddef.h>

#include "numerics/kernels.hpp"

namespace ikbench::solvers {

// One joint of `count` candidates that a velocity moves. x_next and v_next may be x and v.
struct Flight {
  double pole;  // place from which the velocity grows away
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

// One joint of `count` bats, some of which search around the best: q = best + step draws if chance > pulse_rate,
// otherwise q = flown. q may be flown.
struct LocalSearch {
  double best, step;
  const double *draws, *chance, *pulse_rate, *flown;
  double* q;
  ptrdiff_t count;
};

// `count` choices: out = yes if less < than, otherwise out = no. out may be one of the other four.
struct Choice {
  const double *less, *than, *yes, *no;
  double* out;
  ptrdiff_t count;
};

// One joint of `count` particles whose velocity is limited. A particle outside is set to the limit and turned back.
struct Rebound {
  double lower, upper, max_velocity;
  double *q, *v;
  ptrdiff_t count;
};

// The kernels of one instruction set.
struct Kernels {
  void (*fly)(const Flight& flight);  // v_next = v + (x - pole) frequency, x_next = x + v_next
  void (*swarm)(const Swarm& swarm);
  void (*search_locally)(const LocalSearch& search);
  void (*scatter)(double centre, double step, const double* draws, double* q, ptrdiff_t count);  // centre + step draws
  void (*choose)(const Choice& choice);
  void (*clamp)(double lower, double upper, double* q, ptrdiff_t count);
  void (*turn_back)(const Rebound& rebound);  // v = +-v within max_velocity, q within the limits
  // Replaces three rows of numbers in [0, 1) by DE's partners: for each of `count` candidates three different others.
  void (*choose_partners)(double* rows, ptrdiff_t count);
  void (*add_squares)(double centre, const double* q, double* sums, ptrdiff_t count);  // sums += (q - centre)^2
};

IKBENCH_DECLARE_KERNELS

}  // namespace ikbench::solvers
