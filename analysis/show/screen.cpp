#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <sstream>

#include "analysis/show/report.hpp"
#include "analysis/show/text.hpp"
#include "analysis/show/words.hpp"

namespace ikbench::show {

using namespace compare;

namespace {

using Lines = std::vector<std::string>;

constexpr std::size_t most_rows = 20, most_notes = 4, most_warnings = 3, longest_name = 24;

Lines lines_of(const std::string& text) {
  Lines lines;
  std::istringstream all(text);
  for (std::string line; std::getline(all, line);) lines.push_back(line);
  return lines;
}

Lines table_of(const Shown& shown) {
  Table table = results_table(shown);
  table.columns[0].name = "";
  const std::size_t all = table.rows.size();
  if (all > most_rows) table.rows.resize(most_rows - 1);
  std::vector<std::string> notes = std::exchange(table.notes, {});
  Lines lines = lines_of(to_text(table));
  if (all > most_rows) lines.push_back(fmt::format("  and {} more solvers", all - most_rows + 1));
  notes.resize(std::min(notes.size(), most_notes));
  if (!notes.empty())
    std::ranges::move(wrapped(fmt::format("{}", fmt::join(notes, " ")), ""), std::back_inserter(lines));
  return lines;
}

Lines warnings_of(const Shown& shown) {
  std::vector<Doubt> doubts = shown.all_doubts();
  const auto is_told = [](const Doubt& doubt) { return doubt.kind == DoubtKind::seconds_decide; };
  if (shown.verdict.empty() && std::ranges::any_of(shown.decisive().observations.doubts, is_told))
    std::erase_if(doubts, is_told);  // stands first
  const std::size_t shown_doubts = doubts.size() > most_warnings ? most_warnings - 1 : doubts.size();
  Lines lines;
  for (std::size_t i = 0; i < shown_doubts; ++i) {
    for (std::string& line : wrapped("! " + words_of(doubts[i]), "  ")) lines.push_back(std::move(line));
  }
  if (doubts.size() > shown_doubts)
    lines.push_back(fmt::format("! and {} more warnings", doubts.size() - shown_doubts));
  return lines;
}

}  // namespace

std::string screen(const Shown& whole, const std::string& page) {
  const Shown shown = with_short_names(whole, longest_name);
  constexpr std::size_t gap = 3, width = 100;
  const Lines pairs = lines_of(aligned(pair_rows(shown), gap, width));  // a line a pair
  Lines head, note;
  for (const std::string& line : lines_of(headline(shown)))
    std::ranges::move(wrapped(line, ""), std::back_inserter(head));
  if (const std::string text = chosen_before(shown); shown.decisive().described.size() == 2 && !text.empty())
    note = wrapped(text, "");
  std::string text;
  for (const Lines& part : {head, Lines{""}, table_of(shown), pairs, note, warnings_of(shown)}) {
    for (const std::string& line : part) text += line + '\n';
  }
  return page.empty() ? text : fmt::format("{}Report: {}\n", text, one_line(page));
}

}  // namespace ikbench::show
