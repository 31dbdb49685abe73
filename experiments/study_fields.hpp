// The fields of a study that judging has no use for; the others are listed in results/study.cpp, those of a path in
// paths/.
#pragma once

#include "experiments/study.hpp"
#include "numerics/fields.hpp"
#include "numerics/units.hpp"

namespace ikbench::experiments {

inline void list_fields(Fields& io, Path& path) { path->list_fields(io); }

// The key has the chain and the limits that result from these.
inline void list_fields(Fields& io, robots::UrdfChoice& urdf) {
  io.text("base", urdf.base, "link from which the arm is read; \"\": the root, behind joints that float",
          InKey::in_text);
  io.text("tip", urdf.tip, "link to which it is read, the tool; \"\": the end with the most moving joints before it",
          InKey::in_text);
  io.choice("limits", urdf.limits, {"hard", "soft"},
            "hard: the joints' <limit>; soft: the tighter of it and <safety_controller>", InKey::in_text);
  io.number(
      "snap_deg", urdf.snap, numerics::degree, {0, 1},
      "angles this near a multiple of 15 deg, and axes this near parallel, are meant to be it: up to 0.001 only if "
      "the printed digits may mean it",
      InKey::in_text);
}

inline void list_fields(Fields& io, Study& study) {
  list_fields(io, static_cast<results::StudyData&>(study));
  io.numbers("initial_deg", study.initial, 1, 0,
             "configuration before the first point of a run: degrees, and metres for a joint that slides",
             InKey::in_text);
  io.choice("trace", study.trace, {"none", "best_error"}, "whether to store the best error after every iteration",
            InKey::in_text);
}

}  // namespace ikbench::experiments
