#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "analysis/show/report.hpp"
#include "analysis/show/words.hpp"
#include "numerics/names.hpp"

namespace ikbench::show {

using namespace compare;
using numerics::counted;

namespace {

Blocks with_heading(std::string heading, Blocks blocks) {
  if (!blocks.empty()) blocks.insert(blocks.begin(), Heading{std::move(heading)});
  return blocks;
}

Blocks first(const Report& report) {
  if (!report.first.empty()) return report.first;
  Blocks blocks{Heading{headline(report.shown)}};
  if (!report.study.entry.series.empty()) blocks.emplace_back(what_is_studied(report.study) + '.');
  blocks.emplace_back(results_table(report.shown));
  Table pairs{.caption = "Pairs", .columns = {{"pair"}, {"verdict"}, {"difference"}, {"p"}}};
  for (const std::vector<std::string>& row : pair_rows(report.shown)) pairs.rows.emplace_back(row.begin(), row.end());
  if (!pairs.rows.empty()) blocks.emplace_back(std::move(pairs));
  return blocks;
}

Blocks claims(const Report& report) { return report.claims; }

Blocks pictures(const Report& report) {
  return with_heading("Pictures", {report.figures.begin(), report.figures.end()});
}

Blocks table_if_any(std::string heading, Table table) {
  return table.rows.empty() ? Blocks() : Blocks{Heading{std::move(heading)}, std::move(table)};
}

Blocks pairs(const Report& report) { return table_if_any("Who is better?", pairs_table(report.shown)); }
Blocks descriptives(const Report& report) {
  return report.has_own_numbers ? Blocks() : table_if_any("All numbers", descriptives_table(report.shown));
}
Blocks anova(const Report& report) {
  return report.has_own_numbers ? Blocks() : table_if_any("All solvers at once", anova_table(report.shown));
}

Blocks warnings(const Report& report) {
  Blocks blocks;
  for (const Doubt& doubt : report.shown.all_doubts()) blocks.emplace_back(warning_of(doubt));
  for (const std::string& warning : report.warnings) blocks.emplace_back(warning);
  return with_heading("Warnings", std::move(blocks));
}

Blocks setup(const Report& report) {
  if (report.study.entry.series.empty()) return {};  // of a user's file
  return with_heading("Set-up",
                      {methods_of(report.shown, report.study) + ". For LaTeX, with what to cite: tables/methods.tex.",
                       study_table(report.study), options_table(report.study), machine_table(report.study)});
}

}  // namespace

Report report_of(JudgedStudy judged, std::vector<figures::Figure> figures) {
  Report report{.shown = shown(judged), .figures = std::move(figures)};
  report.study = std::move(judged.study);
  return report;
}

std::vector<Blocks> sections_of(const Report& report) {
  std::vector<Blocks> sections;
  const auto add = [&](std::string_view name, Blocks blocks) {
    if (!blocks.empty()) sections.push_back(std::move(blocks));
    if (name == "pictures") std::ranges::copy(report.additions, std::back_inserter(sections));
  };
#define SECTION(name) add(#name, name(report));
#include "analysis/show/sections.inc"
#undef SECTION
  return sections;
}

}  // namespace ikbench::show
