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

Blocks first(const Reported& of) {
  if (!of.first.empty()) return of.first;
  Blocks blocks{Heading{headline(of.shown)}};
  if (!of.study.entry.series.empty()) blocks.emplace_back(what_is_studied(of.study) + '.');
  blocks.emplace_back(results_table(of.shown));
  Table pairs{.caption = "Pairs", .columns = {{"pair"}, {"verdict"}, {"difference"}, {"p"}}};
  for (const std::vector<std::string>& row : pair_rows(of.shown)) pairs.rows.emplace_back(row.begin(), row.end());
  if (!pairs.rows.empty()) blocks.emplace_back(std::move(pairs));
  return blocks;
}

Blocks claims(const Reported& of) { return of.claims; }

Blocks pictures(const Reported& of) { return with_heading("Pictures", {of.figures.begin(), of.figures.end()}); }

Blocks table_if_any(std::string heading, Table table) {
  return table.rows.empty() ? Blocks() : Blocks{Heading{std::move(heading)}, std::move(table)};
}

Blocks pairs(const Reported& of) { return table_if_any("Who is better?", pairs_table(of.shown)); }
Blocks descriptives(const Reported& of) {
  return of.has_own_numbers ? Blocks() : table_if_any("All numbers", descriptives_table(of.shown));
}
Blocks anova(const Reported& of) {
  return of.has_own_numbers ? Blocks() : table_if_any("All solvers at once", anova_table(of.shown));
}

Blocks warnings(const Reported& of) {
  Blocks blocks;
  for (const Doubt& doubt : of.shown.all_doubts()) blocks.emplace_back(words_of(doubt) + '.');
  for (const std::string& warning : of.warnings) blocks.emplace_back(warning);
  return with_heading("Warnings", std::move(blocks));
}

Blocks setup(const Reported& of) {
  if (of.study.entry.series.empty()) return {};  // of a user's file
  return with_heading("Set-up", {methods_of(of.shown, of.study, of.keys), study_table(of.study),
                                 options_table(of.study), plan_table(of.study), machine_table(of.study)});
}

}  // namespace

Reported reported(JudgedStudy judged, std::vector<figures::Figure> figures) {
  Reported of{.shown = shown(judged), .figures = std::move(figures)};
  of.study = std::move(judged.study);
  return of;
}

std::vector<Blocks> sections_of(const Reported& of) {
  std::vector<Blocks> sections;
  const auto add = [&](std::string_view name, Blocks blocks) {
    if (!blocks.empty()) sections.push_back(std::move(blocks));
    if (name == "pictures") std::ranges::copy(of.additions, std::back_inserter(sections));
  };
#define SECTION(name) add(#name, name(of));
#include "analysis/show/sections.inc"
#undef SECTION
  return sections;
}

}  // namespace ikbench::show
