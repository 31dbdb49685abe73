/* A solver in a shared object for ikbench (docs/solvers-in-any-language.md); C11 or C++. Metres, radians, seconds.
   Every struct begins with its size in bytes; what comes later is added at its end. Matrices are 4 x 4, row by row.
   Pointers to numbers and texts are valid during the call. The functions of an objective are for the calling thread. */
#ifndef IKBENCH_PLUGIN_H
#define IKBENCH_PLUGIN_H
#include <stddef.h>
#include <stdint.h>
#ifdef __cplusplus
extern "C" {
#endif
#define IKBENCH_ABI 1

typedef struct ikbench_robot {
  size_t size;
  const char *name, *urdf, *base_link, *tip_link; /* the last three "" where there is no URDF text */
  int32_t joints; /* the length of the next two lines */
  const double *theta, *d, *a, *alpha, *lower, *upper; /* of one: Rz(theta) Tz(d) Tx(a) Rx(alpha); no limit: infinite */
  const int32_t *types; /* its value is added 0: to theta; 1: to d; 2: coupled */
  double base[16], tool[16];
  const double *options; /* as ikbench_solver lists them; a choice by number */
} ikbench_robot;

typedef struct ikbench_problem {
  size_t size;
  int32_t joints;
  double target[16], rotation_weight; /* weight 0: only the position is asked for */
  double position_tolerance, rotation_tolerance; /* 0: none */
  const double *start, *lower, *upper; /* finite: a joint without limits has a whole turn each way of the start */
  int32_t population, iterations;
  int64_t evaluations; /* 0: no such budget */
  double seconds; /* the same */
  uint32_t seed; /* for a generator of your own */
  int32_t planned_iterations; /* of a whole population each, for schedules that end with the solve */
} ikbench_problem;

typedef struct ikbench_objective { /* `suite` is the first argument of all */
  size_t size;
  void *suite; /* joint j of candidate i is q[j * stride + i] */
  void (*errors)(void *suite, const double *q, int64_t stride, int64_t candidates, double *errors);
  int32_t (*linearize)(void *suite, const double *q, double *residual, double *jacobian); /* rows, 3 or 6; by columns */
  void (*one_by_one)(void *suite, double *q, int64_t candidates, double *errors, void *context, /* stride: candidates */
                     void (*propose)(void *context, int64_t first, int64_t count),
                     int64_t (*decide)(void *context, int64_t first, int64_t count)); /* how many until a change */
  double (*uniform)(void *suite); /* [0, 1), from the stream of this solve */
  void (*uniforms)(void *suite, double *out, int64_t count);
  void (*normals)(void *suite, double *out, int64_t count);
  void (*truncated_normals)(void *suite, double *out, int64_t count); /* within [-1, 1] */
  int32_t (*is_over)(void *suite); /* evaluations or seconds are used up */
  void (*say)(void *suite, const char *why); /* before declined or failed */
} ikbench_objective;

enum { ikbench_goes_on, ikbench_finished, ikbench_declined, ikbench_failed };

typedef struct ikbench_solver {
  size_t size;
  const char *name, *version, *options; /* options: a JSON list, as in a hello; or null */
  int32_t is_deterministic; /* 1: whatever the seed and the stream */
  void *(*create)(const ikbench_robot *robot, char *why, size_t room); /* null: declined, and why */
  void (*destroy)(void *solver);
  int32_t (*start)(void *solver, const ikbench_problem *, const ikbench_objective *, double *best, double *error);
  int32_t (*step)(void *solver, const ikbench_objective *, double *best, double *error); /* null: start solves */
} ikbench_solver;

__attribute__((visibility("default"))) const ikbench_solver *ikbench_solver_at(int32_t abi, int32_t index); /* yours */
#ifdef __cplusplus
}
#endif
#endif
