// The rule by which a solve ends: tolerances and budget. Study files set it, solvers obey it, and the store keeps it.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "base/fields.hpp"
#include "base/number.hpp"
#include "base/units.hpp"

namespace ikbench::numerics {

// Why a solve ended.
// iterations, evaluations, time: the budget was used up.
// tolerance: the tolerances were met.
// not_finite: the answer or its error is not finite.
// finished: the solver ended by itself.
// gave_up: the solver ended by itself, and says that it found no solution.
enum class StopReason : std::uint8_t { iterations, tolerance, evaluations, time, not_finite, finished, gave_up };
constexpr std::array<std::string_view, 7> names_of(StopReason) {
  return {"iterations", "tolerance", "evaluations", "time", "not_finite", "finished", "gave_up"};
}

// The limits of a solve, which ends at the first limit that it reaches. 0 means no limit, except for iterations.
struct StopRule {
  int iterations = 200;
  double tolerance = 0;        // [m] position error; for a pose, both tolerances must hold
  double angle_tolerance = 0;  // [rad] orientation error of a pose
  // How a pose meets both tolerances: each error its own, or (true) the squares of the two errors, each divided by its
  // tolerance, add up to 1 at most.
  bool adds_squares = false;
  std::int64_t evaluations = 0;  // checked after each iteration
  double seconds = 0;            // wall time, checked after each iteration

  // Returns true if both errors [m, rad] are within the tolerances. `rounding` is added to each tolerance.
  bool is_met(double position, double angle, double rounding = 0) const {
    if (tolerance > 0 && position > tolerance + rounding) return false;
    if (angle_tolerance > 0 && angle > angle_tolerance + rounding) return false;
    const double by = position / (tolerance + rounding), turned = angle / (angle_tolerance + rounding);
    return !adds_squares || by * by + turned * turned <= 1;
  }

  // Returns true if only tolerance and time can end a solve: a million iterations are more than any limit in use.
  bool only_time_limits() const { return seconds > 0 && evaluations == 0 && iterations >= 1'000'000; }

  // These two return the tolerances in the units of study files, with the digits of the file.
  double tolerance_cm() const { return base::in_unit(tolerance, base::centimetre); }
  double tolerance_deg() const { return base::in_unit(angle_tolerance, base::degree); }
};

inline void list_fields(base::Fields& io, StopRule& stop) {
  io.whole("iterations", stop.iterations, {0, 1'000'000'000},
           {"maximum number of iterations; unless given as many as evaluations, or 200 where these have no maximum",
            base::InKey::in_text});
  io.number("tolerance_cm", stop.tolerance, base::centimetre, {0, 1e6},
            {"a solve stops at this position error; 0: no tolerance", base::InKey::in_text});
  io.number(
      "tolerance_deg", stop.angle_tolerance, base::degree, {0, 180},
      "with search = \"pose\" or \"axis\": a solve stops where the tool, or its z axis, is also turned no further than "
      "this from its target; 0: no tolerance");
  io.choice("tolerances", stop.adds_squares, {"each", "squares"},
            "each: both must hold; squares: the squares of the two errors, each by its tolerance, add up to 1 at most");
  io.whole("evaluations", stop.evaluations, {0, base::no_limit},
           {"maximum number of evaluations; 0: no maximum", base::InKey::in_text});
  io.number("seconds", stop.seconds, 1, {0, 1e6},
            {"maximum wall time of a solve; results then depend on the machine; 0: no maximum", base::InKey::in_text});
}

}  // namespace ikbench::numerics
