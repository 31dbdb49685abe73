#include "analysis/figures/box_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "analysis/figures/axis.hpp"
#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/quantile.hpp"
#include "numerics/number.hpp"

namespace ikbench::figures {

using namespace numerics;
using namespace results;
using namespace statistics;
using namespace inference;

namespace {

// Quartiles of so few values say nothing: draws each value.
bool are_few(const Box& box) { return box.n < 5; }

bool is_below_resolution(const Mark& mark) { return mark.min <= 0 && mark.resolution > 0; }

double least_of(const Mark& mark) { return is_below_resolution(mark) ? mark.resolution : mark.min; }

// The marks' lines: position, smallest, median, largest, and how far an arrow points below the smallest.
std::string marks_data(const StudyResults& study, const std::vector<Mark>& marks) {
  std::string data;
  for (std::size_t i = 0; i < study.solvers.size(); ++i) {
    const auto mark = std::ranges::find(marks, study.solvers[i], &Mark::solver);
    if (mark == marks.end()) continue;
    data += fmt::format("{} {} {} {} {}\n", i + 1, data_number(least_of(*mark)), data_number(mark->median),
                        data_number(mark->max), is_below_resolution(*mark) ? "0.3" : "NaN");
  }
  return data;
}

std::string data_of(const StudyResults& study, const std::vector<Box>& boxes, const std::string& marks) {
  std::string data =
      "# solver's position, lower whisker, q1, median, q3, upper whisker, observations, of those not finite\n";
  std::string outliers;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Box& b = boxes[i];
    data += fmt::format("# {}\n{} {} {} {} {} {} {} {}\n", one_line(study.solvers[i]), i + 1,
                        data_number(b.whisker_low), data_number(b.q1), data_number(b.median), data_number(b.q3),
                        data_number(b.whisker_high), b.n, b.not_finite);
    for (const double value : b.outliers) outliers += fmt::format("{} {}\n", i + 1, data_number(value));
  }
  if (outliers.empty()) outliers = "1 NaN\n";
  data += fmt::format("\n\n# outliers: solver's position, value\n{}", outliers);
  return marks.empty()
             ? data
             : data +
                   "\n\n# as printed: solver's position, smallest, median, largest; arrow to this part of the "
                   "smallest, which is an upper limit\n" +
                   marks;
}

// Labels above boxes: how many observations a box does not show.
std::string counts_above(const std::vector<Box>& boxes) {
  std::string counts;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Box& b = boxes[i];
    if (b.not_finite == 0 && b.n > 0) continue;
    const std::string words = b.n == 0 ? "nothing" : fmt::format("{} not", b.not_finite);
    counts += fmt::format("set label \"{}\\n{}\" at {}, graph 1 center offset 0, 1.1 font ',6'\n", words,
                          b.n == 0 ? "solved" : "finite", i + 1);
  }
  return counts.empty() ? counts : counts + "set tmargin 2.5\n";
}

// The solvers' labels below their boxes. Labels lie flat if they have room (about 6 characters per centimetre), else
// they stand, and the figure becomes higher.
std::string label_settings(const StudyResults& study, Figure& figure) {
  const std::size_t n = study.solvers.size();
  std::size_t longest = 0;
  std::string ticks, margin;
  for (std::size_t i = 0; i < n; ++i) {
    const std::string label = shortened(study.solvers[i], longest_label);
    longest = std::max(longest, character_count(label));
    ticks += fmt::format("{}{} {}", i == 0 ? "" : ", ", tick_label(label), i + 1);
  }
  const double room = (figure.width_cm - 1.8) / static_cast<double>(n) * 6;
  const bool standing = static_cast<double>(longest) > room;
  if (standing) {
    const double label_cm = 0.13 * static_cast<double>(longest) + 0.4;
    figure.height_cm += label_cm;
    margin = fmt::format("set bmargin at screen {}\n", text_of(label_cm / figure.height_cm));
  }
  return margin + fmt::format(
                      "unset key\nset grid noxtics ytics\nset xrange [0.4:{}.6]\nset xtics font ',7' {}({})\n"
                      "set boxwidth 0.5\nset style fill solid 0.25 border\n",
                      n, standing ? "rotate by 90 right " : "", ticks);
}

std::string plot_of(const std::vector<Box>& boxes, const std::string& name, bool has_marks) {
  std::vector<std::string> clauses;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (are_few(boxes[i])) {
      clauses.push_back(
          fmt::format("'{}.dat' index 1 using ($1 == {} ? $1 : NaN):(shown($2)) with points ls {} pt 7 ps 0.8", name,
                      i + 1, i + 1));
      continue;
    }
    if (!boxes[i].drawable()) continue;
    clauses.push_back(
        fmt::format("'{}.dat' index 0 every ::{}::{} using 1:(shown($3)):(shown($2)):(shown($6)):(shown($5)) with "
                    "candlesticks ls {} "
                    "dt 1 whiskerbars 0.5",
                    name, i, i, i + 1));
  }
  clauses.push_back(
      fmt::format("'{}.dat' index 0 using ($1-0.25):(shown($4)):(0.5):(0) with vectors nohead ls 101", name));
  clauses.push_back(
      fmt::format("'{}.dat' index 1 using 1:(shown($2)) with points pt 6 ps 0.4 lw 0.8 lc rgb '#000000'", name));
  if (has_marks) {
    clauses.push_back(fmt::format(
        "'{0}.dat' index 2 using ($1+0.36):(shown($2)):(0):(shown($4)-shown($2)) with vectors nohead lw 1.6 lc rgb "
        "'#808080', '' index 2 using ($1+0.29):(shown($3)):(0.14):(0) with vectors nohead lw 1.6 lc rgb '#404040'",
        name));
    clauses.push_back(fmt::format(
        "'{}.dat' index 2 using ($1+0.36):(shown($2)):(0):(shown($2*$5)-shown($2)) with vectors head filled size "
        "graph 0.015, 25 lw 1.2 lc rgb '#808080'",
        name));
    clauses.emplace_back("keyentry with lines lw 1.6 lc rgb '#808080' title 'as printed: minimum to maximum'");
    clauses.emplace_back("keyentry with lines lw 1.6 lc rgb '#404040' title 'median'");
  }
  return plot_command(clauses);
}

// Explains the grey marks.
std::string printed_note(const BoxRequest& request) {
  std::string note = fmt::format(" Grey: {}.", request.printed_words);
  for (const Mark& mark : request.printed) {
    if (!is_below_resolution(mark)) continue;
    note += fmt::format(" The printed minimum of {} is 0, so below {} (arrow).", mark.solver, text_of(mark.resolution));
  }
  return note;
}

}  // namespace

Figure box_figure(const StudyResults& study, const BoxRequest& request) {
  Figure figure{.name = request.name};
  std::vector<Box> boxes;
  std::vector<double> all;
  for (const Sample& sample : samples(study, request.metric)) {
    Box& drawn = boxes.emplace_back(box(sample.values, quantile_type(study.plan.quartiles)));
    if (are_few(drawn)) {
      drawn.outliers = sample.values;
      std::erase_if(drawn.outliers, [](double value) { return !std::isfinite(value); });
    }
    all.insert(all.end(), sample.values.begin(), sample.values.end());
  }
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Box& b = boxes[i];
    if (!b.drawable()) continue;
    const auto words = [&](double value) { return value_words(request.metric, value); };
    figure.told.push_back(
        {.series = shortened(study.solvers[i], longest_label),
         .words = {fmt::format("median {}, quartiles {} and {}, whiskers {} and {}", words(b.median), words(b.q1),
                               words(b.q3), words(b.whisker_low), words(b.whisker_high))}});
  }
  const std::string marks = marks_data(study, request.printed);
  if (!marks.empty()) {
    for (const Mark& mark : request.printed) {
      if (std::ranges::find(study.solvers, mark.solver) == study.solvers.end()) continue;
      all.insert(all.end(), {least_of(mark), mark.median, mark.max});
    }
  }
  const Axis axis = value_axis(all, with_unit(request.metric), Scale::by_spread);
  figure.caption = with_notes(
      fmt::format("{}: box plots over the {}. Quartiles: Hyndman-Fan type {}. Whiskers: last value within 1.5 box "
                  "heights.{}",
                  capitalised(axis.quantity),
                  study.plan.unit == Unit::point ? "points"
                  : is_of_run(request.metric)    ? "runs"
                                                 : fmt::format("run {}s", average_name(request.metric)),
                  study.plan.quartiles,
                  (std::ranges::any_of(boxes, are_few) ? " Of fewer than five values each is a point." : "") +
                      (marks.empty() ? std::string() : printed_note(request))),
      study, request.metric, axis);
  if (boxes.size() > 8) figure.width_cm = two_columns_cm;
  figure.data = data_of(study, boxes, marks);
  figure.settings = axis.settings + counts_above(boxes) + label_settings(study, figure);
  if (!marks.empty()) {
    figure.settings += "set key noautotitle\n";
    add_legend(figure, {"as printed: minimum to maximum", "median"});
  }
  figure.plot = plot_of(boxes, figure.name, !marks.empty());
  return figure;
}

}  // namespace ikbench::figures
