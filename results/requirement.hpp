// A requirement on a share, as [require] of a study and --require state it: "at least 95 % of targets are solved".
// Use it for a gate that needs no other solver; `ikbench compare` is the gate against an earlier version.
#pragma once

#include <string>
#include <string_view>

namespace ikbench::results {

struct Requirement {
  std::string solver = {};  // label; empty: the user's own solvers, or all solvers if none is the user's
  std::string metric = {};  // slug of a share: "solved", "in-time"
  double share = 0;         // smallest share that is enough, above 0 and below 1

  bool operator==(const Requirement&) const = default;
  std::string text() const;  // "solved=95%" or "mine.solved=95%", as parse_requirement reads it
};

// Reads "solved=95%" or "LABEL.solved=95%"; the label may have dots and blanks. Throws std::invalid_argument if the
// text has another form, names another metric than a share, or a share that no number of targets can show.
Requirement parse_requirement(std::string_view text);

}  // namespace ikbench::results
