// Writes a study as text: TOML to edit and run, JSON for the store, and the keys of stored solves, a hash of everything
// that decides the numbers of one solver of a study.
#pragma once

#include <string>

#include "base/fields.hpp"
#include "base/json.hpp"
#include "base/units.hpp"
#include "experiments/study.hpp"
#include "results/store.hpp"

namespace ikbench::experiments {

// The whole study; parse_study gives the same study back.
std::string to_toml(const Study& study);
// A path, as in the study's table [path].
std::string to_toml(Path path);
// A look, as in [figures].
std::string to_toml(results::FigureStyle style);
// The study without its solvers, with its number of points and its arm, as the store keeps it.
std::string to_json(const Study& study);
// An arm, as in the definition at "/arm".
base::Json arm_json(const Robot& arm);
// A plan, as in the definition at "/analysis".
std::string to_json(results::Plan plan);

// Hash of everything in the study that decides the numbers of one solver.
std::string configuration_key(const Study& study, const SolverEntry& entry);
// Digest of the source of the entry's solver: its source file, or a program's executable and files.
std::string source_digest_of(const SolverEntry& entry);
// The library of a peer, with its version; empty for other solvers.
std::string library_of(const SolverEntry& entry);
// The part of its keys that is made of the source, and of a peer's library.
std::string source_key(const SolverEntry& entry);
// configuration_key and source_key, and a hash of the study's check. Equal keys mean equal numbers on one machine,
// unless a solve ends by its wall time.
std::string series_key(const Study& study, const SolverEntry& entry);

// The solvers' parts of the study, and all of it, as the store keeps them. A key is a hash of all targets, so a run
// makes it once.
std::vector<results::Series> series_of(const Study& study);
results::StoredStudy stored_study(const Study& study);

// The fields of a study that judging has no use for; the others are listed in results/study.cpp, those of a path in
// paths/.
inline void list_fields(Fields& io, Path& path) { path->list_fields(io); }

// The key has the chain and the limits that result from these.
inline void list_fields(Fields& io, robots::UrdfChoice& urdf) {
  io.text("base", urdf.base, "link from which the arm is read; \"\": the root, behind joints that float",
          InKey::in_text);
  io.text("tip", urdf.tip, "link to which it is read, the tool; \"\": the end behind the most joints", InKey::in_text);
  io.choice("limits", urdf.limits, {"hard", "soft"},
            "hard: the joints' <limit>; soft: the tighter of it and <safety_controller>", InKey::in_text);
}

inline void list_fields(Fields& io, Study& study) {
  list_fields(io, static_cast<results::StudyData&>(study));
  io.numbers(
      "initial_deg", study.initial, 1, 0,
      "configuration before the first point of a run: degrees, and metres for a joint that slides; []: zeros, or the "
      "nearest inside the limits",
      InKey::in_text);
  io.choice("trace", study.trace, {"none", "best_error"}, "whether to store the best error after every iteration",
            InKey::in_text);
}

}  // namespace ikbench::experiments
