#include "analysis/figures/sweep_figure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "analysis/figures/axis.hpp"
#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/text.hpp"
#include "numerics/number.hpp"

namespace ikbench::figures {

using namespace numerics;
using namespace statistics;
using namespace inference;

namespace {

// The values along the axis: numbers at their places, or words at 1, 2, ...
struct SweptAxis {
  std::size_t setting = 0;
  bool are_numbers = false;
  bool is_logarithmic = false;
  std::map<std::string, double> places = {};
  std::string settings = {};  // label, range, ticks, and at(x, curve), where a curve draws x
};

bool are_numbers(const SweptFamily::Setting& setting) {
  return std::ranges::all_of(setting.values, [](const std::string& value) {
    const std::optional<double> number = number_from(value);
    return number && is_drawable(*number);
  });
}

// The setting with most numbers; without numbers the first one.
std::size_t setting_along(const SweptFamily& family) {
  const auto numbers = [](const SweptFamily::Setting& setting) {
    return are_numbers(setting) ? setting.values.size() : 0;
  };
  const auto most = std::ranges::max_element(family.settings, {}, numbers);
  return static_cast<std::size_t>(most - family.settings.begin());
}

SweptAxis axis_along(const std::vector<SweptFamily>& families, std::size_t curves) {
  SweptAxis axis{.setting = setting_along(families.front())};
  axis.are_numbers = std::ranges::all_of(
      families, [&](const SweptFamily& family) { return are_numbers(family.settings[axis.setting]); });
  double low = 0, high = 0;
  for (const SweptFamily& family : families) {
    for (const std::string& value : family.settings[axis.setting].values) {
      if (axis.places.contains(value)) continue;  // of an earlier family
      const double next = static_cast<double>(axis.places.size()) + 1;
      const double place = axis.are_numbers ? *number_from(value) : next;
      low = axis.places.empty() ? place : std::min(low, place);
      high = axis.places.empty() ? place : std::max(high, place);
      axis.places.emplace(value, place);
    }
  }
  constexpr double spread_of_values = 20;
  axis.is_logarithmic = axis.are_numbers && low > 0 && high > spread_of_values * low;
  constexpr std::size_t most_ticks = 9;
  std::vector<std::string> ticks;
  for (const auto& [value, place] : axis.places)
    ticks.push_back(fmt::format("{} {}", tick_label(shortened(value, longest_label)), text_of(place)));
  if (axis.places.size() <= most_ticks || !axis.are_numbers)
    axis.settings = fmt::format("set xtics ({})\n", fmt::join(ticks, ", "));
  axis.settings += fmt::format("set xlabel {}\n", gnuplot_string(families.front().settings[axis.setting].name));
  // Curves stand side by side, so that their intervals do not cover each other.
  const double middle = (static_cast<double>(curves) - 1) / 2,
               step = std::min(0.014, 0.1 / static_cast<double>(curves));
  if (axis.is_logarithmic) {
    const double span = std::log10(high / low);
    axis.settings += fmt::format("set logscale x\nset xrange [{}:{}]\nat(x, curve) = x * 10 ** ({} * (curve - {}))\n",
                                 text_of(low * std::pow(10, -0.08 * span)), text_of(high * std::pow(10, 0.08 * span)),
                                 text_of(step * span), text_of(middle));
  } else {
    const double span = high > low ? high - low : std::max(1.0, std::abs(low));
    axis.settings +=
        fmt::format("set xrange [{}:{}]\nat(x, curve) = x + {} * (curve - {})\n", text_of(low - 0.08 * span),
                    text_of(high + 0.08 * span), text_of(step * span), text_of(middle));
  }
  return axis;
}

// A family at one combination of its other settings.
struct SweptCurve {
  std::string label;
  std::size_t family = 0;       // its number in the figure, from 0
  std::size_t combination = 0;  // of all families', from 0
  std::vector<const SweptFamily::Member*> members = {};
};

std::vector<SweptCurve> curves_of(const std::vector<SweptFamily>& families, std::size_t along) {
  std::vector<SweptCurve> curves;
  std::vector<std::string> combinations;
  for (std::size_t number = 0; number < families.size(); ++number) {
    const SweptFamily& family = families[number];
    for (const SweptFamily::Member& member : family.members) {
      std::string others;
      for (std::size_t setting = 0; setting < member.at.size(); ++setting) {
        if (setting == along) continue;
        others += fmt::format("{}{} {}", others.empty() ? "" : ", ", family.settings[setting].name,
                              family.settings[setting].values[member.at[setting]]);
      }
      const auto known = std::ranges::find(combinations, others);
      const auto combination = static_cast<std::size_t>(known - combinations.begin());
      if (known == combinations.end()) combinations.push_back(others);
      auto curve = std::ranges::find_if(
          curves, [&](const SweptCurve& one) { return one.family == number && one.combination == combination; });
      if (curve == curves.end()) {
        const bool needs_family = families.size() > 1 || others.empty();
        const std::string between = needs_family && !others.empty() ? ", " : "";
        curve = curves.insert(curve, {.label = (needs_family ? family.name : "") + between + others,
                                      .family = number,
                                      .combination = combination});
      }
      curve->members.push_back(&member);
    }
  }
  return curves;
}

// A curve looks as its first entry with values does in the other figures: the colour of its solver, with a shade,
// markers and dashes of its own.
int style_of(const SweptCurve& curve, const Observations& observations) {
  for (const SweptFamily::Member* member : curve.members) {
    const Group* const group = group_named(observations.groups, member->label);
    if (group != nullptr && group->style) return *group->style;
  }
  return static_cast<int>(curve.combination) + 1;
}

}  // namespace

Figure sweep_figure(const std::vector<SweptFamily>& families, const SweptQuantity& quantity, const std::string& name) {
  const std::size_t along = setting_along(families.front());
  const std::vector<SweptCurve> curves = curves_of(families, along);
  const SweptAxis x = axis_along(families, curves.size());
  const Observations& observations = quantity.observations;
  Figure figure{.name = name};
  std::vector<double> all;
  bool is_cut = false;
  std::vector<std::string> clauses{"NaN"}, labels;
  for (std::size_t number = 0; number < curves.size(); ++number) {
    const SweptCurve& curve = curves[number];
    std::vector<std::pair<double, std::string>> rows;
    for (const SweptFamily::Member* member : curve.members) {
      const std::string& value = families[curve.family].settings[along].values[member->at[along]];
      const Estimate mean = quantity.of(member->label);
      const bool has_interval = std::isfinite(mean.low) && std::isfinite(mean.high);
      const double place = x.places.at(value), low = has_interval ? mean.low : mean.value,
                   high = has_interval ? mean.high : mean.value;
      rows.emplace_back(place, data_line({place, mean.value, low, high}));
      const bool reaches_zero =
          low <= 0 && mean.value > 0;  // an axis of positive means may be logarithmic all the same
      is_cut = is_cut || reaches_zero;
      all.insert(all.end(), {mean.value, reaches_zero ? mean.value : low, high});
    }
    std::ranges::sort(rows);
    figure.data += fmt::format("{}# {}: {}, mean, low, high\n", number == 0 ? "" : "\n\n", one_line(curve.label),
                               one_line(families.front().settings[along].name));
    for (const auto& [place, row] : rows) figure.data += row;
    const std::string look = fmt::format("ls {}", style_of(curve, observations));
    labels.push_back(shortened(curve.label, longest_label));
    const std::string place = fmt::format("data index {0} using (at($1, {0}))", number);
    clauses.push_back(fmt::format("{}:(shown($2)) with lines {}", place, look));
    clauses.push_back(fmt::format("{}:(shown($3)):(0):(shown($4)-shown($3)) with vectors nohead {} dt 1", place, look));
    clauses.push_back(fmt::format("{}:(shown($2)) with points {} dt 1", place, look));
    clauses.push_back(fmt::format("keyentry with linespoints {} title {}", look, gnuplot_string(labels.back())));
  }
  const NameWithUnit described = split_unit(observations.quantity);
  const bool is_share = quantity.evidence.scale == ValueScale::share;
  const Axis axis = value_axis(all, is_share ? NameWithUnit{described.name, ""} : described, Scale::by_spread);
  figure.settings = axis.settings + x.settings;
  figure.caption = fmt::format(
      "{} over {}: means over the observations of each entry, with {} intervals{}. Curves are moved a little "
      "sideways, so that no interval hides another.{}",
      capitalised(axis.quantity), one_line(families.front().settings[along].name),
      percent(1 - quantity.evidence.plan.significance),
      observations.scale == ValueScale::log10 ? " (geometric means)" : "",
      axis.shows_at_edge ? " Values of zero are drawn at the lower edge." : "");
  if (is_cut) figure.caption += " Intervals that reach below 0 end at the lower edge.";
  for (const std::string& note : observations.counting) figure.caption += ' ' + note;
  if (!observations.flaws.empty()) figure.caption += fmt::format(" Flawed: {}", words_of(observations.flaws));
  add_legend(figure, labels);
  figure.plot = plot_command(clauses);
  return figure;
}

}  // namespace ikbench::figures
