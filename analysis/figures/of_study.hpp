// The figures of a judged study and of a user's file. Some figures are also functions by themselves, because the
// figures of papers are variants of them. The figures are documented in docs/reference/report.md.
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

// The most pairs that a figure of differences draws. If there are more, only pairs with the reference are drawn.
constexpr std::size_t most_drawn_pairs = 15;

// A figure that some studies have.
struct KindOfFigure {
  std::string_view name, meaning;  // name of the files, and meaning in help
  std::optional<Figure> (*of)(const judge::JudgedStudy& judged,
                              const Look& look);  // nullopt: the study has no values for the figure
};
// Returns all kinds of figures, in the order of a report.
std::span<const KindOfFigure> kinds_of_figures();
// Returns the figures for which the study has values.
std::vector<Figure> of_study(const judge::JudgedStudy& judged, const Look& look);

// Returns the solvers whose times are not compared: all of them if no times are.
std::vector<std::string> not_compared_in_time(const judge::JudgedStudy& judged);
// Returns the figures of a user's file: boxes of each metric that has values, ranks and differences of the first.
std::vector<Figure> of_file(const std::vector<judge::JudgedMetric>& metrics, const Look& look);

// Returns the figure of error against joint motion. `add_printed` adds the numbers that a paper printed to each dot.
std::optional<Figure> overview_of(const judge::JudgedStudy& judged, const Look& look,
                                  const std::function<void(Dot&)>& add_printed);
// Returns the figure of mean ranks, for at least three solvers that were compared with one another. Nullopt with a
// control, which leaves out pairs of other solvers, and where means decide.
std::optional<Figure> ranks_of(const judge::JudgedMetric& judged, const std::vector<std::string>& shown,
                               const Look& look);
// Returns the figure of differences, with a row per tested pair. Of more than most_drawn_pairs pairs only those of the
// first name in `shown` are drawn. Nullopt if all values are equal.
std::optional<Figure> differences_of(const judge::JudgedMetric& metric, const DrawnUnit& unit,
                                     const std::vector<std::string>& shown, const Look& look);
// Returns the path of the first solver's first run, with the arm at `arms` of the points. The caption ends with `more`.
Figure path_of(const judge::StudyResults& study, const Look& look, std::size_t arms, const std::string& more);

}  // namespace ikbench::figures
