// The figure of a grid of targets: where in the plane each solver solves the target, a panel per solver.
// docs/map.md says how to read the figure.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/figures/look.hpp"
#include "analysis/judge/judge.hpp"

namespace ikbench::figures {

// A place of the grid as one solver leaves it.
struct MapCell {
  // solved: at least one target of the place is, and no other solver solves more of them.
  // behind: another solver solves more targets of the place.
  // unsolved: no solver solves a target of the place.
  // missing: this solver was not asked for all targets of the place yet, and solves none of the others.
  enum class State { unsolved, behind, solved, missing } state = State::unsolved;
  double across = 0, up = 0;  // [m] the middle of the cell
  // The evaluations, or the number of tool directions that are solved; NaN: not counted, or none is solved.
  double value = 0;
};
// A panel of the figure.
struct MapPanel {
  std::string label;
  std::size_t solved = 0;  // targets
  std::vector<MapCell> cells = {};
};
// Returns the panels of all solvers that figures show; empty if the targets are no grid.
std::vector<MapPanel> map_panels(const judge::JudgedStudy& judged, const Look& look);
// Returns the figure of these panels; nullopt if the targets are no grid.
std::optional<Figure> map_of(const judge::JudgedStudy& judged, const Look& look);

}  // namespace ikbench::figures
