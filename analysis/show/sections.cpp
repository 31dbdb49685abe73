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

Blocks first(const Reported& reported) {
  if (!reported.first.empty()) return reported.first;
  Blocks blocks{Heading{headline(reported.shown)}};
  if (!reported.study.entry.series.empty()) blocks.emplace_back(what_is_studied(reported.study) + '.');
  blocks.emplace_back(results_table(reported.shown));
  Table pairs{.caption = "Pairs", .columns = {{"pair"}, {"verdict"}, {"difference"}, {"p"}}};
  for (const std::vector<std::string>& row : pair_rows(reported.shown)) pairs.rows.emplace_back(row.begin(), row.end());
  if (!pairs.rows.empty()) blocks.emplace_back(std::move(pairs));
  return blocks;
}

Blocks claims(const Reported& reported) { return reported.claims; }

Blocks pictures(const Reported& reported) {
  return with_heading("Pictures", {reported.figures.begin(), reported.figures.end()});
}

Blocks table_if_any(std::string heading, Table table) {
  return table.rows.empty() ? Blocks() : Blocks{Heading{std::move(heading)}, std::move(table)};
}

Blocks pairs(const Reported& reported) { return table_if_any("Who is better?", pairs_table(reported.shown)); }
Blocks descriptives(const Reported& reported) {
  return reported.has_own_numbers ? Blocks() : table_if_any("All numbers", descriptives_table(reported.shown));
}
Blocks anova(const Reported& reported) {
  return reported.has_own_numbers ? Blocks() : table_if_any("All solvers at once", anova_table(reported.shown));
}

Blocks warnings(const Reported& reported) {
  Blocks blocks;
  for (const Doubt& doubt : reported.shown.all_doubts()) blocks.emplace_back(warning_of(doubt));
  for (const std::string& warning : reported.warnings) blocks.emplace_back(warning);
  return with_heading("Warnings", std::move(blocks));
}

Blocks setup(const Reported& reported) {
  if (reported.study.entry.series.empty()) return {};  // of a user's file
  return with_heading(
      "Set-up", {methods_of(reported.shown, reported.study) + ". For LaTeX, with what to cite: tables/methods.tex.",
                 study_table(reported.study), options_table(reported.study), machine_table(reported.study)});
}

}  // namespace

Reported reported(JudgedStudy judged, std::vector<figures::Figure> figures) {
  Reported reported{.shown = shown(judged), .figures = std::move(figures)};
  reported.study = std::move(judged.study);
  return reported;
}

std::vector<Blocks> sections_of(const Reported& reported) {
  std::vector<Blocks> sections;
  const auto add = [&](std::string_view name, Blocks blocks) {
    if (!blocks.empty()) sections.push_back(std::move(blocks));
    if (name == "pictures") std::ranges::copy(reported.additions, std::back_inserter(sections));
  };
#define SECTION(name) add(#name, name(reported));
#include "analysis/show/sections.inc"
#undef SECTION
  return sections;
}

}  // namespace ikbench::show
