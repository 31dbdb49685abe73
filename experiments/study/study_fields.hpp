// Lists the fields of a study that judging does not need, so that results/ does not know them: of the study itself, of
// its path and of its URDF file. The readers and writers of studies follow these lists, and so does the key of a
// series. The other fields of a study are listed in results/study.cpp, those of each kind of path in paths/.
#pragma once

#include "base/fields.hpp"
#include "experiments/study/study.hpp"

namespace ikbench::experiments {

inline void list_fields(Fields& io, Path& path) { path->list_fields(io); }

// The key of a series has the chain and the limits that follow from these fields, so they are `in_text`.
inline void list_fields(Fields& io, robots::UrdfChoice& urdf) {
  io.text("base", urdf.base,
          {"link where the arm begins; \"\": the root, or the link after floating joints", InKey::in_text});
  io.text("tip", urdf.tip, {"link where the arm ends, the tool; \"\": the end after the most joints", InKey::in_text});
  io.choice("limits", urdf.limits, {"hard", "soft"},
            {"hard: the joints' <limit>; soft: the tighter of it and <safety_controller>", InKey::in_text});
}

inline void list_fields(Fields& io, Study& study) {
  list_fields(io, static_cast<results::StudySpec&>(study));
  io.numbers(
      "initial_deg", study.initial, 1, 0,
      {"configuration before the first point of a run: degrees, and metres for prismatic joints; []: zeros, or the "
       "nearest inside the limits",
       InKey::in_text});
  io.choice("trace", study.trace, {"none", "best_error"},
            {"whether to store the best error after every iteration", InKey::in_text});
}

}  // namespace ikbench::experiments
