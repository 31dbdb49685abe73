#include "analysis/slim2023/readings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/slim2023/published_numbers.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/tails.hpp"
#include "numerics/number.hpp"
#include "results/published.hpp"

namespace ikbench::slim2023 {

using namespace numerics;
using namespace results;
using namespace statistics;
using namespace inference;
using namespace figures;
using namespace report;

namespace {

constexpr std::array<Metric, 2> scored_metrics{Metric::position_error_cm, Metric::variation_deg};

// One metric of one solver under one reading, against the printed.
struct Score {
  double mean = not_defined;       // over the runs of all seeds
  double log_ratio = not_defined;  // log10 of the mean by the printed one
  double lowest = not_defined;     // the same of single seeds
  double highest = not_defined;
  double off = not_defined;            // of the mean from the printed one, in the metric's unit
  double error = not_defined;          // standard error of our mean
  double printed_error = not_defined;  // of the printed one, by its standard deviation and number of runs
  std::string fits;                    // which of the printed median, std, max and min lie among those of our seeds
};

const std::vector<std::vector<double>>& values_of(const ReadSolver& solver, Metric metric) {
  return metric == Metric::position_error_cm ? solver.error_cm : solver.variation_deg;
}

Score score(const CsvTable& printed, const ReadSolver& solver, Metric metric) {
  Score result;
  std::vector<Description> seeds;
  std::vector<double> means, all;
  for (const std::vector<double>& runs : values_of(solver, metric)) {
    seeds.push_back(describe(runs));
    means.push_back(seeds.back().mean);
    all.insert(all.end(), runs.begin(), runs.end());
  }
  result.error = standard_error(all);
  result.mean = mean(means);
  for (std::size_t row = 0; row < printed.rows.size(); ++row) {
    if (printed.rows[row][printed.column("algorithm")] != solver.label) continue;
    if (printed.rows[row][printed.column("metric")] != name_of(metric)) continue;
    const double printed_mean = printed.number(row, "mean");
    result.off = std::abs(result.mean - printed_mean);
    result.printed_error = printed.number(row, "std") / std::sqrt(printed.number(row, "n"));
    result.log_ratio = std::log10(result.mean / printed_mean);
    result.lowest = std::log10(std::ranges::min(means) / printed_mean);
    result.highest = std::log10(std::ranges::max(means) / printed_mean);
    for (const auto& [column, field] : {std::pair("median", &Description::median), std::pair("std", &Description::std),
                                        std::pair("max", &Description::max), std::pair("min", &Description::min)}) {
      const double rounding = half_unit(printed.rows[row][printed.column(column)]);
      const double value = printed.number(row, column);
      const auto [least, most] = std::ranges::minmax(seeds, {}, field);
      if (least.*field - rounding <= value && value <= most.*field + rounding) {
        result.fits += fmt::format("{}{}", result.fits.empty() ? "" : " ", column);
      }
    }
    if (result.fits.empty()) result.fits = "none";
  }
  return result;
}

// All solvers of a reading at once: root mean square of the log ratios.
double distance(const std::vector<Score>& scores) {
  double sum = 0;
  for (const Score& each : scores) sum += each.log_ratio * each.log_ratio;
  return std::sqrt(sum / static_cast<double>(scores.size()));
}

using Scores = std::vector<std::array<std::vector<Score>, 2>>;  // by reading, metric, solver

Scores scores_of(std::string_view paper, std::span<const ReadingResults> readings) {
  const CsvTable printed = published::table(paper, "table-3");
  Scores all;
  for (const ReadingResults& reading : readings) {
    auto& of_reading = all.emplace_back();
    for (std::size_t m = 0; m < scored_metrics.size(); ++m) {
      for (const ReadSolver& solver : reading.solvers) {
        of_reading[m].push_back(score(printed, solver, scored_metrics[m]));
      }
    }
  }
  return all;
}

// The printed mean is one of 20 runs: whether two means lie at different distances from it counts beyond the errors of
// all three, in 95 % of such cases.
bool is_nearer(const Score& other, const Score& usual) {
  const double error = std::hypot(usual.printed_error, usual.error, other.error);
  return usual.off - other.off > normal_critical(0.95) * error;
}

// Which reading brings a solver's mean nearest to the printed one.
std::string nearest_words(std::span<const ReadingResults> readings, const Scores& scores, std::size_t metric,
                          std::size_t solver) {
  const auto score_of = [&](std::size_t reading) -> const Score& { return scores[reading][metric][solver]; };
  const Score& usual = score_of(0);
  if (usual.off <= normal_critical(0.95) * std::hypot(usual.printed_error, usual.error)) {
    return "as near as the printed number's own error allows";
  }
  std::size_t best = 0;
  for (std::size_t r = 1; r < readings.size(); ++r) {
    if (std::abs(score_of(r).log_ratio) < std::abs(score_of(best).log_ratio)) best = r;
  }
  if (!is_nearer(score_of(best), usual)) {
    return "no interpretation is nearer by more than the printed number's own error";
  }
  return fmt::format("closest: {} ({:+.3f})", readings[best].name, score_of(best).log_ratio);
}

std::vector<std::string> nearest(std::span<const ReadingResults> readings, const Scores& scores) {
  std::vector<std::string> sentences;
  const std::array<std::string_view, 2> words{"error", "variation"};
  for (std::size_t m = 0; m < scored_metrics.size(); ++m) {
    for (std::size_t s = 0; s < readings.front().solvers.size(); ++s) {
      const Score& usual = scores[0][m][s];
      sentences.push_back(fmt::format("Printed {} of {}: default {:+.3f} (seeds from {:+.3f} to {:+.3f}); {}.",
                                      words[m], readings.front().solvers[s].label, usual.log_ratio, usual.lowest,
                                      usual.highest, nearest_words(readings, scores, m, s)));
    }
  }
  return sentences;
}

Table table_of(std::span<const ReadingResults> readings, const Scores& scores) {
  Table table{
      .name = "readings",
      .caption = "Interpretations of what the paper leaves open: what each changes, compared with the printed Table 3",
      .columns = {{"reading", Align::left},
                  {"notes", Align::left},
                  {"out_of_reach"},
                  {"algorithm", Align::left},
                  {"error_cm"},
                  {"error_log_ratio"},
                  {"error_moved"},
                  {"error_fits", Align::left},
                  {"variation_deg"},
                  {"variation_log_ratio"},
                  {"variation_moved"},
                  {"variation_fits", Align::left}}};
  const std::size_t seeds = readings.front().solvers.front().error_cm.size();
  const auto rounded = [](double value) -> Cell {
    return std::isfinite(value) ? std::round(value * 1000) / 1000 + 0.0 : value;
  };
  for (std::size_t r = 0; r < readings.size(); ++r) {
    const ReadingResults& reading = readings[r];
    std::vector<Cell> all{reading.name, reading.section, std::int64_t{reading.out_of_reach}, std::string("all")};
    for (std::size_t m = 0; m < scored_metrics.size(); ++m) {
      const double off = distance(scores[r][m]);
      const std::vector<Cell> cells{{}, rounded(off), r == 0 ? Cell() : rounded(off - distance(scores[0][m])), {}};
      all.insert(all.end(), cells.begin(), cells.end());
    }
    table.rows.push_back(std::move(all));
    for (std::size_t s = 0; s < reading.solvers.size(); ++s) {
      if (r > 0 && !reading.solvers[s].is_moved) continue;
      std::vector<Cell> row{reading.name, reading.section, std::int64_t{reading.out_of_reach},
                            reading.solvers[s].label};
      for (std::size_t m = 0; m < scored_metrics.size(); ++m) {
        const Score& now = scores[r][m][s];
        const std::vector<Cell> cells{now.mean, rounded(now.log_ratio),
                                      r == 0 ? Cell() : rounded(now.log_ratio - scores[0][m][s].log_ratio),
                                      seeds == 1 ? Cell() : Cell(now.fits)};
        row.insert(row.end(), cells.begin(), cells.end());
      }
      table.rows.push_back(std::move(row));
    }
  }

  table.notes.push_back(
      fmt::format("Means over seeds 1 to {}. log_ratio: log10 of our mean divided by the printed mean; 0 means equal, "
                  "0.3 means twice as large. Rows for all algorithms have the root mean square. moved: change of "
                  "log_ratio against the default. Algorithms without a row equal the default bit for bit. "
                  "out_of_reach: number of targets that no configuration reaches.",
                  seeds));
  if (seeds == 1) {
    table.notes.push_back("One seed shows no variation, so fits and the closest interpretation are not defined.");
  } else {
    table.notes.push_back(
        fmt::format("fits: which of the printed median, standard deviation, maximum and minimum lie within our range "
                    "over the seeds. If an interpretation is the paper's, each does so with a probability of {} %.",
                    100 * (seeds - 1) / (seeds + 1)));
    table.notes.emplace_back(
        "The printed mean has an error of its own: its standard deviation divided by the root of its number of runs. An "
        "interpretation counts as closer than the default beyond 1.96 times this error, combined with those of our means.");
    for (std::string& sentence : nearest(readings, scores)) table.notes.push_back(std::move(sentence));
  }
  for (const ReadingResults& reading : readings) {
    if (!reading.sentence.empty()) table.notes.push_back(fmt::format("{}: {}", reading.name, reading.sentence));
  }
  return table;
}

// A panel of the figure: where a log ratio is drawn on the common axis.
struct Panel {
  double from, to;     // log ratios
  double left, width;  // on the axis
  double at(double log_ratio) const { return left + (log_ratio - from) / (to - from) * width; }
};

Panel panel_of(const Scores& scores, std::size_t metric, double left, double width) {
  double from = -0.3, to = 0.3;
  for (const auto& reading : scores) {
    for (const Score& each : reading[metric]) {
      for (const double value : {each.lowest, each.highest}) {
        if (!std::isfinite(value)) continue;
        from = std::min(from, value);
        to = std::max(to, value);
      }
    }
  }
  const double room = 0.05 * (to - from);
  return {from - room, to + room, left, width};
}

std::string ticks_of(const Panel& panel) {
  std::vector<std::string> ticks;
  const double decades = panel.to - panel.from;
  const int step = decades > 6 ? 2 : 1;
  for (int decade = -20; decade <= 20; ++decade) {
    for (const int digit : {1, 2, 5}) {
      if (decade % step != 0 || (digit != 1 && decades > 1.5)) continue;
      const double value = digit * std::pow(10, decade);
      const double x = std::log10(value);
      if (x < panel.from || x > panel.to) continue;
      ticks.push_back(fmt::format("'{}' {}", text_of(value), text_of(panel.at(x))));
    }
  }
  return fmt::format("{}", fmt::join(ticks, ", "));
}

Figure figure_of(std::span<const ReadingResults> readings, const Scores& scores) {
  constexpr double row_cm = 0.42;
  constexpr std::size_t longest_reading = 60;
  Figure figure{.name = "readings",
                .caption =
                    "Interpretations: our mean divided by the printed mean of Table 3, position error (left) and "
                    "angles variation (right). Dots: the algorithms that an interpretation changes, with the range "
                    "over the seeds. Coloured lines: the default. Black: as printed.",
                .width_cm = 17,
                .height_cm = 3.2 + row_cm * static_cast<double>(readings.size())};
  const std::array<Panel, 2> panels{panel_of(scores, 0, 0, 1), panel_of(scores, 1, 1.08, 0.72)};
  const std::array<std::string_view, 2> titles{"position error", "angles variation"};
  const auto rows = static_cast<double>(readings.size());
  const std::vector<ReadSolver>& solvers = readings.front().solvers;

  std::vector<std::string> labels;
  for (std::size_t r = 0; r < readings.size(); ++r) {
    labels.push_back(fmt::format("{} {}", tick_label(shortened(readings[r].name, longest_reading)),
                                 text_of(-static_cast<double>(r))));
  }
  figure.settings = fmt::format(
      "set xrange [0:{}]\nset yrange [{}:0.6]\nset xtics ({}, {})\nset ytics noenhanced font ',7' ({})\nset xlabel "
      "'ours / printed'\nset tmargin 1.6\nset bars 0.4\nset key maxcols 6\n",
      text_of(panels[1].left + panels[1].width), text_of(-rows + 0.4), ticks_of(panels[0]), ticks_of(panels[1]),
      fmt::join(labels, ", "));
  const auto line = [&](double x, std::string_view style) {
    figure.settings += fmt::format("set arrow from {0}, graph 0 to {0}, graph 1 nohead back {1}\n", text_of(x), style);
  };
  for (std::size_t m = 0; m < panels.size(); ++m) {
    figure.settings += fmt::format("set label '{}' at {}, graph 1 center offset 0, 0.7\n", titles[m],
                                   text_of(panels[m].left + panels[m].width / 2));
    line(panels[m].at(0), "lw 1.2 lc rgb '#000000'");
    for (std::size_t s = 0; s < solvers.size(); ++s) {
      const double log_ratio = scores[0][m][s].log_ratio;
      if (std::isfinite(log_ratio)) line(panels[m].at(log_ratio), fmt::format("ls {} lw 0.7 dt 2", s + 1));
    }
  }
  line((panels[0].left + panels[0].width + panels[1].left) / 2, "lw 0.5 lc rgb '#888888'");

  figure.data = "# place of the row; error: log10 of ours by printed, smallest and largest seed; variation: the same\n";
  std::vector<std::string> clauses;
  for (std::size_t s = 0; s < solvers.size(); ++s) {
    figure.data += fmt::format("{}# {}\n", s == 0 ? "" : "\n\n", one_line(solvers[s].label));
    for (std::size_t r = 0; r < readings.size(); ++r) {
      const bool is_drawn = r == 0 || readings[r].solvers[s].is_moved;
      const double spread = 0.56 / static_cast<double>(solvers.size());  // so that dots of a row are told apart
      const double y =
          -static_cast<double>(r) + spread * ((static_cast<double>(solvers.size()) - 1) / 2 - static_cast<double>(s));
      figure.data += text_of(std::round(y * 1000) / 1000);
      for (std::size_t m = 0; m < panels.size(); ++m) {
        const Score& each = scores[r][m][s];
        for (const double value : {each.log_ratio, each.lowest, each.highest}) {
          figure.data += ' ' + data_number(is_drawn ? value : not_defined);
        }
      }
      figure.data += fmt::format(" # {}\n", one_line(readings[r].name));
    }
    for (std::size_t m = 0; m < panels.size(); ++m) {
      const Panel& panel = panels[m];
      const std::size_t column = 2 + 3 * m;
      const auto at = [&](std::size_t c) {
        return fmt::format("({}+(${}-({}))*{})", text_of(panel.left), c, text_of(panel.from),
                           text_of(panel.width / (panel.to - panel.from)));
      };
      clauses.push_back(fmt::format("'readings.dat' index {} using {}:1:{}:{} with xerrorbars ls {} ps 0.55 {}", s,
                                    at(column), at(column + 1), at(column + 2), s + 1,
                                    m == 0 ? "title " + gnuplot_string(shortened(solvers[s].label, 28)) : "notitle"));
    }
  }
  figure.plot = fmt::format("plot {}", fmt::join(clauses, ", \\\n  "));
  return figure;
}

}  // namespace

ReadingsReport readings_report(std::string_view paper, std::span<const ReadingResults> readings) {
  if (readings.empty() || readings.front().solvers.empty() || readings.front().solvers.front().error_cm.empty()) {
    throw std::invalid_argument("no interpretation to report; expected the default first");
  }
  const Scores scores = scores_of(paper, readings);
  return {.table = table_of(readings, scores), .figure = figure_of(readings, scores)};
}

}  // namespace ikbench::slim2023
