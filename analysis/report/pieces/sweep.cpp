// The swept settings of a study: what each combination reached, and whether settings depend on each other.
#include "analysis/inference/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "analysis/figures/sweep_figure.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/study_pieces.hpp"
#include "analysis/report/words.hpp"

namespace ikbench::report {

using namespace inference;
using namespace statistics;
using namespace figures;
using namespace fmt::literals;

namespace {

// The best mean of a family; not if all are equal.
std::optional<double> best_of(const SweptFamily& family, const SweptQuantity& quantity) {
  std::optional<double> best, worst;
  for (const SweptFamily::Member& member : family.members) {
    const double mean = quantity.of(member.label).value;
    if (!std::isfinite(mean)) continue;
    if (!best || quantity.is_better(mean, *best)) best = mean;
    if (!worst || quantity.is_better(*worst, mean)) worst = mean;
  }
  return best == worst ? std::nullopt : best;
}

Table swept_table(const std::vector<SweptFamily>& families, const std::vector<SweptQuantity>& quantities) {
  Table table{.name = "sweep", .caption = std::string(words::sweep_caption), .columns = {"family"}};
  std::vector<std::string> settings;
  for (const SweptFamily& family : families) {
    for (const SweptFamily::Setting& setting : family.settings) {
      if (std::ranges::find(settings, setting.name) == settings.end()) settings.push_back(setting.name);
    }
  }
  std::ranges::copy(settings, std::back_inserter(table.columns));
  for (const SweptQuantity& quantity : quantities) {
    table.columns.push_back(quantity.observations.quantity);
    table.columns.push_back(quantity.observations.name + " interval");
  }
  table.columns.emplace_back("best in");
  for (const SweptFamily& family : families) {
    std::vector<std::optional<double>> best;
    for (const SweptQuantity& quantity : quantities) best.push_back(best_of(family, quantity));
    for (const SweptFamily::Member& member : family.members) {
      std::vector<Cell>& row = table.rows.emplace_back();
      row.emplace_back(family.name);
      for (const std::string& setting : settings) {
        const auto own = std::ranges::find(family.settings, setting, &SweptFamily::Setting::name);
        row.emplace_back(own == family.settings.end()
                             ? Cell()
                             : Cell(own->values[member.at[static_cast<std::size_t>(own - family.settings.begin())]]));
      }
      std::string best_in;
      for (std::size_t i = 0; i < quantities.size(); ++i) {
        const Estimate mean = quantities[i].of(member.label);
        row.push_back(or_nothing(mean.value));
        row.emplace_back(range_of(mean));
        if (best[i] == mean.value) best_in += (best_in.empty() ? "" : ", ") + quantities[i].observations.name;
      }
      row.push_back(best_in.empty() ? Cell() : Cell(best_in));
    }
  }
  table.notes = {
      fmt::format(words::sweep_note, "level"_a = percent(1 - quantities.front().evidence.plan.significance))};
  for (const SweptQuantity& quantity : quantities) {
    for (const std::string& note : quantity.evidence.notes) {
      if (std::ranges::count(table.notes, note) == 0) table.notes.push_back(note);
    }
  }
  return table;
}

// The corners of the two settings, which the difference of differences compares.
std::string corner_words(const SweptFamily& family, const SettingsInteraction& pair) {
  const SweptFamily::Setting &first = family.settings[pair.first], &second = family.settings[pair.second];
  return fmt::format("{} {} to {}, at {} {} and {}", first.name, first.values.front(), first.values.back(), second.name,
                     second.values.back(), second.values.front());
}

Table interaction_table(const std::vector<SweptFamily>& families, const std::vector<SweptQuantity>& quantities) {
  Table table{.name = "sweep-interactions",
              .caption = std::string(words::interaction_caption),
              .columns = {"family", "settings", "quantity", "depends", "F", "df", "df within", "p", "effect of",
                          "difference or ratio", "interval"},
              .notes = {std::string(words::interaction_note)}};
  for (const SweptFamily& family : families) {
    for (const SweptQuantity& quantity : quantities) {
      if (with_values({family}, quantity).empty()) continue;
      for (const SettingsInteraction& pair : interactions(family, quantity)) {
        const Interaction& found = pair.found;
        const std::string settings =
            fmt::format("{}, {}", family.settings[pair.first].name, family.settings[pair.second].name);
        const std::string finding = !found.undefined.empty() ? "not defined: " + named(found.undefined, "a combination")
                                    : pair.depends           ? "yes"
                                                             : "not shown";
        std::vector<Cell> row{family.name, settings, quantity.observations.quantity, finding};
        if (found.undefined.empty()) {
          row.insert(row.end(), {found.statistic, found.df, found.df_within, PValue{found.p}});
          row.insert(row.end(), {corner_words(family, pair), found.corners.value, range_of(found.corners)});
        }
        row.resize(table.columns.size());
        if (!found.undefined.empty()) row.back() = Range{};
        table.rows.push_back(std::move(row));
      }
    }
  }
  return table;
}

}  // namespace

std::vector<Table> sweep_tables(const StudyResults& study, const std::vector<Metric>& metrics) {
  const std::vector<SweptFamily> families = swept_families(study);
  if (families.empty() || study.solves.empty()) return {};
  const std::vector<SweptQuantity> quantities = swept_quantities(study, metrics);
  if (quantities.empty()) return {};
  std::vector<Table> tables{swept_table(families, quantities)};
  if (Table table = interaction_table(families, quantities); !table.rows.empty()) tables.push_back(std::move(table));
  return tables;
}

std::vector<Figure> sweep_figures(const StudyResults& study, const std::vector<Metric>& metrics) {
  // Families by what they were swept by: these share a figure.
  std::map<std::vector<std::string>, std::vector<SweptFamily>> alike;
  for (SweptFamily& family : swept_families(study)) {
    std::vector<std::string> names;
    for (const SweptFamily::Setting& setting : family.settings) names.push_back(setting.name);
    alike[names].push_back(std::move(family));
  }
  if (alike.empty()) return {};
  std::vector<Figure> figures;
  for (const SweptQuantity& quantity : swept_quantities(study, metrics)) {
    int number = 0;
    for (const auto& [names, all] : alike) {
      const std::string end = ++number == 1 ? "" : fmt::format("-{}", number);
      const std::vector<SweptFamily> families = with_values(all, quantity);
      if (families.empty()) continue;
      figures.push_back(sweep_figure(families, quantity, fmt::format("sweep-{}{}", quantity.observations.name, end)));
    }
  }
  return figures;
}

}  // namespace ikbench::report
