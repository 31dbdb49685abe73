// A requirement on a share, as [require] of a study and --require state it: "at least 95 % of targets are solved".
// Use it for a gate that needs no other solver; `ikbench compare` is the gate against an earlier version.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ikbench::results {

// The reason why a study of a grid is neither compared nor has requirements.
inline constexpr std::string_view grid_is_no_sample =
    "the targets are a grid, which is no random sample, so that nothing is shown of a share";

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

// Returns the requirements, with one for each label that a sweep made of a label: those of "LM damping=0.1" and
// "LM damping=1" in place of that of "LM". A requirement whose label is among `labels`, or of which no sweep made one,
// stays.
std::vector<Requirement> for_swept_labels(const std::vector<Requirement>& requirements,
                                          const std::vector<std::string>& labels);

}  // namespace ikbench::results
