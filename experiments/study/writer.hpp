// Writes a study as text: TOML to edit and run, JSON for the store. And makes the keys of stored solves, which are
// hashes of everything that decides the numbers of one solver of a study.
#pragma once

#include <string>

#include "base/fields.hpp"
#include "base/json.hpp"
#include "base/units.hpp"
#include "experiments/study/study.hpp"
#include "results/store.hpp"

namespace ikbench::experiments {

// Returns the whole study as a file; parse_study gives the same study again.
std::string to_toml(const Study& study);
// Returns a path as the table [path] of a study.
std::string to_toml(Path path);
// Returns a look of figures as the table [figures].
std::string to_toml(results::FigureStyle style);
// Returns the study without its solvers, with its number of points and its arm, as the store keeps it.
std::string to_json(const Study& study);
// Returns an arm as the definition has it at "/arm".
base::Json arm_json(const Robot& arm);
// Returns a plan as the definition has it at "/analysis".
std::string to_json(results::AnalysisPlan plan);

// Returns the hash of everything in the study that decides the numbers of one solver.
std::string configuration_key(const Study& study, const SolverEntry& entry);
// Returns the digest of the source of the entry's solver: its source file, or the executable and files of a program.
std::string source_digest_of(const SolverEntry& entry);
// Returns the library of a peer, with its version; empty for other solvers.
std::string library_name(const SolverEntry& entry);
// Returns the part of the entry's keys that is made of the source, and of a peer's library.
std::string source_key(const SolverEntry& entry);
// Returns configuration_key and source_key with a hash of the study's check. Equal keys mean equal numbers on one
// machine, unless a solve ends by its wall time.
std::string series_key(const Study& study, const SolverEntry& entry);

// Return the series of the study, and all of it, as the store keeps them. A key is a hash of all targets, which takes
// time, so a run makes it once.
std::vector<results::Series> series_of(const Study& study);
results::StoredStudy to_stored(const Study& study);

// Lists the fields of a study that judging does not need. The others are listed in results/study.cpp, those of a path
// in paths/.
inline void list_fields(Fields& io, Path& path) { path->list_fields(io); }

// The key of a series has the chain and the limits that these give, so the fields are in its text.
inline void list_fields(Fields& io, robots::UrdfChoice& urdf) {
  io.text("base", urdf.base, "link from which the arm is read; \"\": the root, behind joints that float",
          InKey::in_text);
  io.text("tip", urdf.tip, "link to which it is read, the tool; \"\": the end behind the most joints", InKey::in_text);
  io.choice("limits", urdf.limits, {"hard", "soft"},
            "hard: the joints' <limit>; soft: the tighter of it and <safety_controller>", InKey::in_text);
}

inline void list_fields(Fields& io, Study& study) {
  list_fields(io, static_cast<results::StudySpec&>(study));
  io.numbers(
      "initial_deg", study.initial, 1, 0,
      "configuration before the first point of a run: degrees, and metres for a joint that slides; []: zeros, or the "
      "nearest inside the limits",
      InKey::in_text);
  io.choice("trace", study.trace, {"none", "best_error"}, "whether to store the best error after every iteration",
            InKey::in_text);
}

}  // namespace ikbench::experiments
