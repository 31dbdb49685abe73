#include "analysis/figures/overview_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>

#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/comparable.hpp"
#include "analysis/inference/estimand.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "numerics/number.hpp"

namespace ikbench::figures {

using namespace numerics;
using namespace results;
using namespace statistics;
using namespace inference;

namespace {

std::vector<OverviewMark> means_of(const StudyResults& study) {
  const auto errors = samples(study, Metric::position_error_cm), variations = samples(study, Metric::variation_deg),
             times = samples(study, Metric::seconds);
  std::vector<OverviewMark> marks;
  for (std::size_t i = 0; i < study.solvers.size(); ++i) {
    marks.push_back({.solver = study.solvers[i],
                     .error_cm = describe(errors[i].values).mean,
                     .variation_deg = describe(variations[i].values).mean,
                     .seconds = describe(times[i].values).median});
  }
  return marks;
}

// The printed means of the same solvers, in their order.
std::vector<OverviewMark> beside(const std::vector<OverviewMark>& ours, const std::vector<OverviewMark>& printed) {
  std::vector<OverviewMark> marks;
  for (const OverviewMark& mark : ours) {
    const auto found = std::ranges::find(printed, mark.solver, &OverviewMark::solver);
    marks.push_back(found != printed.end() ? *found : OverviewMark{mark.solver, not_defined, not_defined, not_defined});
  }
  return marks;
}

constexpr std::size_t most_named = 12;
constexpr double largest_size = 1.6, smallest_size = 0.4;
// Margins around the axes.
constexpr double left_cm = 1.5, right_cm = 0.3, bottom_cm = 1.05, top_cm = 0.3;

struct Disc {
  double variation_deg, error_cm, size;
};

// The area of a disc is in proportion to the time, but never too small to see.
std::vector<Disc> discs_of(const std::vector<OverviewMark>& marks, bool has_times) {
  double slowest = 0;
  for (const OverviewMark& mark : marks) slowest = std::max(slowest, mark.seconds);
  std::vector<Disc> discs;
  for (const OverviewMark& mark : marks) {
    const double size = has_times && slowest > 0 && mark.seconds >= 0
                            ? std::max(smallest_size, largest_size * std::sqrt(mark.seconds / slowest))
                            : largest_size / 2;
    discs.push_back({mark.variation_deg, mark.error_cm, size});
  }
  return discs;
}

std::string lines_of(const std::vector<Disc>& discs) {
  std::string lines;
  for (const Disc& disc : discs) lines += data_line({disc.variation_deg, disc.error_cm, disc.size});
  return lines;
}

std::string words_of_sizes(const std::vector<OverviewMark>& marks, bool has_times) {
  if (!has_times) return "Without times.";
  const double longest = std::ranges::max(marks, {}, &OverviewMark::seconds).seconds;
  const double least = longest * smallest_size * smallest_size / (largest_size * largest_size);
  const bool is_cut = std::ranges::any_of(marks, [&](const OverviewMark& mark) { return mark.seconds < least; });
  return is_cut ? "Size of a dot: median time; all times below a sixteenth of the longest look the same."
                : "Size of a dot: median time.";
}

// Places in the picture [cm], from the lower left corner of the axes.
struct LabelBox {
  double left, bottom, right, top;
};

bool overlap(const LabelBox& a, const LabelBox& b) {
  return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

struct Spot {
  double x, y, radius;
};

struct PlacedLabel {
  double x, y;            // its left end and its middle
  double line_x, line_y;  // where a line from the disc ends, if it has one
  bool has_line;
};

// A place for the label of each of the first discs: beside it, or farther away with a line. No label and no line is on
// another, on a disc or outside. Empty if there is no room.
std::vector<PlacedLabel> placed(const std::vector<std::string>& labels, const std::vector<Spot>& spots, double width,
                                double height) {
  constexpr double half_height = 0.15, gap = 0.08;
  constexpr int directions = 16;
  std::vector<LabelBox> taken;
  for (const Spot& spot : spots) {
    taken.push_back({spot.x - spot.radius, spot.y - spot.radius, spot.x + spot.radius, spot.y + spot.radius});
  }
  std::vector<PlacedLabel> places;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const Spot& spot = spots[i];
    const double length = label_cm(labels[i]);
    const auto is_free = [&](const LabelBox& box, std::size_t own) {
      for (std::size_t k = 0; k < taken.size(); ++k) {
        if (k != own && overlap(box, taken[k])) return false;
      }
      return true;
    };
    const auto try_at = [&](double angle, double distance) {
      const double from = spot.radius + gap + distance, across = std::cos(angle), up = std::sin(angle);
      const double x = spot.x + from * across - (across < -0.3 ? length : across < 0.3 ? length / 2 : 0);
      const double y = spot.y + (from + (std::abs(up) > 0.9 ? half_height : 0)) * up;
      const LabelBox box{x, y - half_height, x + length, y + half_height};
      const bool is_inside = box.left >= 0 && box.bottom >= 0 && box.right <= width && box.top <= height;
      if (!is_inside || !is_free(box, taken.size())) return false;
      const PlacedLabel place{x, y, std::clamp(spot.x, box.left, box.right), std::clamp(spot.y, box.bottom, box.top),
                              distance > 0.1};
      std::vector<LabelBox> line;  // small parts of it
      for (double part = 0; place.has_line && part <= 1; part += 0.02) {
        const double at_x = std::lerp(spot.x, place.line_x, part), at_y = std::lerp(spot.y, place.line_y, part);
        line.push_back({at_x - 0.03, at_y - 0.03, at_x + 0.03, at_y + 0.03});
      }
      if (!std::ranges::all_of(line, [&](const LabelBox& part) { return is_free(part, i); })) return false;
      taken.push_back(box);
      taken.insert(taken.end(), line.begin(), line.end());
      places.push_back(place);
      return true;
    };
    for (double distance = 0; distance < 3 && places.size() == i; distance += 0.2) {
      for (const int direction : {0, 8, 4, 12, 1, 15, 7, 9, 2, 14, 6, 10, 3, 13, 5, 11}) {
        if (try_at(2 * std::numbers::pi * direction / directions, distance)) break;
      }
    }
    if (places.size() == i) return {};
  }
  return places;
}

// The best solvers by the quantity that decides the study, and its control.
std::vector<std::string> named_of_many(const StudyResults& study, const Quantity& decides, std::size_t count) {
  std::vector<Sample> values = samples(study, decides.value);
  const auto score = [&](const Sample& sample) {
    const double mean = describe(sample.values).mean;
    return !std::isfinite(mean) ? HUGE_VAL : decides.described.better == Better::smaller ? mean : -mean;
  };
  std::ranges::stable_sort(values, {}, score);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(count, values.size()); ++i) names.push_back(values[i].solver);
  const std::string& control = study.plan.control;
  if (std::ranges::count(study.solvers, control) > 0 && std::ranges::count(names, control) == 0)
    names.push_back(control);
  return names;
}

}  // namespace

Figure overview_figure(const StudyResults& all, const std::vector<OverviewMark>& printed) {
  const StudyResults study = drawn_part(all);
  const std::vector<OverviewMark> ours = means_of(study), rings = beside(ours, printed);
  const bool has_times = times_are_comparable(study), has_rings = !printed.empty();
  Figure figure{.name = "overview", .caption = words_of_sizes(ours, has_times), .height_cm = 6.6};
  std::vector<double> errors;
  double widest = 1e-9;
  for (const auto* marks : {&ours, &rings}) {
    for (const OverviewMark& mark : *marks) {
      errors.insert(errors.end(), {mark.error_cm / 1.3, mark.error_cm * 1.3});  // a disc has a size
      if (std::isfinite(mark.variation_deg)) widest = std::max(widest, mark.variation_deg);
    }
  }
  const Axis axis =
      value_axis(errors, {fmt::format("mean {}", info_of(Metric::position_error_cm).name), "cm"}, Scale::logarithmic);
  if (std::isfinite(tolerance_cm(study))) figure.caption += " Errors are as measured, also below the tolerance.";
  if (axis.shows_at_edge) figure.caption += " Values of zero are drawn at the lower edge.";
  const double far = 1.12 * widest;
  figure.settings =
      axis.settings + fmt::format("set xlabel {}\nset xrange [0:{}]\n",
                                  gnuplot_string("mean " + quantity(Metric::variation_deg)), text_of(far));
  const std::vector<Disc> discs = discs_of(ours, has_times), printed_discs = discs_of(rings, has_times);
  figure.data = "# a line a solver: angles variation, position error, size\n" + lines_of(discs);
  std::vector<std::string> clauses{"NaN"}, labels;
  if (has_rings) {
    figure.caption += " Rings: the paper's numbers.";
    figure.data += "\n\n# as printed\n" + lines_of(printed_discs) + "\n\n# from ours to the printed\n";
    for (std::size_t i = 0; i < ours.size(); ++i) {
      figure.data += data_line({ours[i].variation_deg, ours[i].error_cm, rings[i].variation_deg, rings[i].error_cm});
    }
    clauses.emplace_back(
        "data index 2 using 1:(shown($2)):($3-$1):(shown($4)-shown($2)) with vectors nohead lw 0.7 lc rgb '#808080'");
  }

  // Labels beside the discs, or a legend where there is no room for them.
  const bool is_wide = ours.size() > 8;
  const double axes_width_cm = (is_wide ? two_columns_cm : 8.5) - left_cm - right_cm,
               axes_height_cm = is_wide ? 7 : 5.2;
  const double logarithm = std::log10(axis.high / axis.low);
  const auto spot_of = [&](const Disc& disc) {
    const double up = axis.logarithmic ? std::log10(std::max(disc.error_cm, axis.low) / axis.low) / logarithm
                                       : (disc.error_cm - axis.low) / (axis.high - axis.low);
    return Spot{axes_width_cm * disc.variation_deg / far, axes_height_cm * up, 0.06 + 0.12 * disc.size};
  };
  for (const OverviewMark& mark : ours) labels.push_back(shortened(mark.solver, longest_label));
  const auto is_drawn = [](const Disc& disc) {
    return std::isfinite(disc.error_cm) && std::isfinite(disc.variation_deg);
  };
  std::vector<std::optional<PlacedLabel>> places(ours.size());
  // Returns whether there is room for the labels of these solvers.
  const auto has_room_for = [&](const std::vector<std::string>& named) {
    std::vector<std::string> texts;
    std::vector<std::size_t> whose;
    std::vector<Spot> spots, others;
    for (std::size_t i = 0; i < ours.size(); ++i) {
      const bool is_named = std::ranges::count(named, ours[i].solver) > 0;
      if (is_named && !is_drawn(discs[i])) return false;
      if (is_named) {
        texts.push_back(labels[i]);
        whose.push_back(i);
      }
      if (is_drawn(discs[i])) (is_named ? spots : others).push_back(spot_of(discs[i]));
    }
    std::ranges::move(others, std::back_inserter(spots));
    for (const Disc& ring : printed_discs) {
      if (is_drawn(ring)) spots.push_back(spot_of(ring));
    }
    const std::vector<PlacedLabel> found = placed(texts, spots, axes_width_cm, axes_height_cm);
    for (std::size_t k = 0; k < found.size(); ++k) places[whose[k]] = found[k];
    return found.size() == ours.size() || (!found.empty() && ours.size() > most_named);
  };
  bool has_labels = false;
  if (ours.size() <= most_named) {
    has_labels = has_room_for(study.solvers);
  } else {
    const Quantity decides = quantity_of(study, Metric::position_error_cm, primary_estimand(study));
    for (std::size_t count = most_named; count > 0 && !has_labels; --count) {
      const std::vector<std::string> named = named_of_many(study, decides, count);
      if (!(has_labels = has_room_for(named))) continue;
      const bool has_control = named.size() > count || std::ranges::count(named, study.plan.control) > 0;
      figure.caption += fmt::format(" Named: the best {} of {} by {}{}.", count, ours.size(),
                                    decides.described.quantity, has_control ? ", and the control" : "");
    }
  }

  for (std::size_t i = 0; i < ours.size(); ++i) {
    const int style = style_of(study, ours[i].solver);
    // Filled, another each time that the colours begin anew; the open one of a shape is one less.
    const std::string shape = fmt::format("int(word('7 5 9 11 13', {} / hues % 5 + 1))", style - 1);
    const auto points = [&](int index, const std::string& type) {
      return fmt::format("data index {0} every ::{1}::{1} using 1:(shown($2)):3 with points ls {2} pt {3} ps variable",
                         index, i, style, type);
    };
    const std::string title = gnuplot_string(labels[i]);
    if (has_rings) clauses.push_back(points(1, "(" + shape + " - 1)") + " lw 1.2");
    clauses.push_back(fmt::format("{} title {}", points(0, shape), title));
    if (places[i]) {
      const PlacedLabel& place = *places[i];
      const auto x = [&](double cm) { return text_of(cm / axes_width_cm * far); };
      const auto y = [&](double cm) {
        const double up = cm / axes_height_cm;
        return text_of(axis.logarithmic ? axis.low * std::pow(10, up * logarithm)
                                        : axis.low + up * (axis.high - axis.low));
      };
      clauses.push_back(
          fmt::format("'+' every ::::0 using ({}):({}):({}) with labels left noenhanced font names title {}",
                      x(place.x), y(place.y), title, title));
      if (place.has_line) {
        figure.settings +=
            fmt::format("set arrow from {}, {} to {}, {} nohead back lw 0.5 lc rgb '#808080'\n", x(spot_of(discs[i]).x),
                        y(spot_of(discs[i]).y), x(place.line_x), y(place.line_y));
      }
    }
  }
  if (has_labels) {
    figure.width_cm = axes_width_cm + left_cm + right_cm;
    figure.height_cm = axes_height_cm + bottom_cm + top_cm;
    figure.settings += fmt::format(
        "set key off\nset lmargin at screen margin({})\nset rmargin at screen 1 - margin({})\n"
        "set bmargin at screen up({})\nset tmargin at screen 1 - up({})\n",
        text_of(left_cm), text_of(right_cm), text_of(bottom_cm), text_of(top_cm));
  } else {
    add_legend(figure, labels);
  }
  figure.plot = plot_command(clauses);
  return figure;
}

}  // namespace ikbench::figures
