// The figures of a judged study, and those of which a paper's are variants.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/figures/look.hpp"
#include "analysis/figures/plots.hpp"
#include "analysis/figures/rows.hpp"
#include "analysis/judge/judge.hpp"

namespace ikbench::figures {

constexpr std::size_t most_drawn_pairs = 15;  // of more only those of the reference

struct KindOfFigure {
  std::string_view name, meaning;  // of its files, and in help
  std::optional<Figure> (*of)(const judge::JudgedStudy& judged,
                              const Look& look);  // none: the study has no values for it
};
std::span<const KindOfFigure> kinds_of_figures();
std::vector<Figure> of_study(const judge::JudgedStudy& judged, const Look& look);

// Returns the figures of a user's file: boxes of each metric that has values, ranks and differences of the first.
std::vector<Figure> of_file(const std::vector<judge::JudgedMetric>& metrics, const Look& look);

// Error against joint motion; `add_printed` adds what a paper printed.
std::optional<Figure> overview_of(const judge::JudgedStudy& judged, const Look& look,
                                  const std::function<void(Dot&)>& add_printed);
// Returns the figure of mean ranks, for at least three solvers that were compared with one another. Nullopt with a
// control, which leaves out pairs of other solvers, and where means decide.
std::optional<Figure> ranks_of(const judge::JudgedMetric& metric, const std::vector<std::string>& shown,
                               const Look& look);
// Each pair that was tested; of more than 15 those of the first name alone. None where all values are equal.
std::optional<Figure> differences_of(const judge::JudgedMetric& metric, const DrawnUnit& unit,
                                     const std::vector<std::string>& shown, const Look& look);
// Returns the path of the first solver's first run, with the arm at `arms` of the points. The caption ends with `more`.
Figure path_of(const judge::StudyResults& study, const Look& look, std::size_t arms, const std::string& more);

}  // namespace ikbench::figures
