#include "analysis/show/terminal.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "analysis/show/headline.hpp"
#include "analysis/show/phrases.hpp"
#include "analysis/show/result_tables.hpp"
#include "analysis/show/text.hpp"
#include "base/names.hpp"

namespace ikbench::show {

using namespace judge;

std::string terminal_report(const ReportModel& answer, const std::string& page) {
  constexpr std::size_t most_rows = 20;
  const auto short_of = base::short_names(answer.solvers());
  const auto with_short_names = [&](std::string text) {
    for (const auto& [name, its] : short_of)
      for (std::size_t at = 0; name != its && (at = text.find(name, at)) != std::string::npos; at += its.size())
        text.replace(at, name.size(), its);
    return text;
  };
  Table table = results_table(answer, answer.direction.empty());
  table.columns[0].name = "";
  const auto cut = [&](Table& its) {  // to the first, with the reference; how many are left out
    const std::size_t all = its.rows.size();
    if (all <= most_rows) return std::string();
    const auto last = its.rows.begin() + (most_rows - 2);
    const auto own = std::find_if(last, its.rows.end(),
                                  [&](auto& row) { return std::get<std::string>(row[0]) == reference_of(answer); });
    if (own != its.rows.end()) std::rotate(last, own, own + 1);
    its.rows.resize(most_rows - 1);
    return fmt::format("  and {} more solvers\n", all - most_rows + 1);
  };
  const std::string more_solvers = cut(table);
  std::string notes = fmt::format("{}", fmt::join(std::exchange(table.notes, {}), " "));
  if (const std::string decides = ranking_note(answer); !decides.empty())
    notes += fmt::format("{}{}.", notes.empty() ? "" : " ", decides);
  std::string text = wrapped_paragraph(with_short_names(headline(answer)), "") + '\n';
  const auto add = [&](Table its) {
    for (auto& row : its.rows)
      for (Cell& cell : row)
        if (auto* const words = std::get_if<std::string>(&cell)) *words = with_short_names(*words);
    text += to_text(its);
  };
  add(std::move(table));
  text += more_solvers;
  if (!notes.empty()) text += wrapped_paragraph(with_short_names(notes), "");
  if (!answer.rejections_text.empty()) text += wrapped_paragraph("! " + with_short_names(answer.rejections_text), "  ");
  for (auto [heading, more] : answer.extra_tables) {
    if (more.rows.empty()) continue;
    text += fmt::format("\n{}\n", more.caption);
    const std::string left_out = cut(more);
    add(more);
    text += left_out + '\n';
  }
  if (page.empty() && answer.primary().comparisons.size() <= max_pairs)
    if (Table pairs = tested_pairs_table(answer); !pairs.rows.empty()) add(std::move(pairs));
  const std::vector<Warning> warnings = answer.all_warnings();  // in the order of their kinds
  for (const Warning& warning : warnings) {
    const bool is_told = !page.empty() && std::any_of(warnings.data(), &warning,
                                                      [&](const Warning& other) { return other.kind == warning.kind; });
    const auto alike = std::ranges::count(warnings, warning.kind, &Warning::kind);
    if (is_told) continue;  // on the page
    text += wrapped_paragraph("! " + with_short_names(warning_text(warning)) +
                                  (page.empty() || alike == 1 ? "" : fmt::format("; {} more on the page", alike - 1)),
                              "  ");
  }
  return page.empty() ? text : fmt::format("{}Report: {}\n", text, one_line(page));
}

}  // namespace ikbench::show
