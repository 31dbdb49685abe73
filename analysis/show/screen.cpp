#include "analysis/show/screen.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <sstream>

#include "analysis/show/text.hpp"
#include "analysis/show/words.hpp"

namespace ikbench::show {

using namespace compare;

namespace {

using Lines = std::vector<std::string>;

constexpr std::size_t most_rows = 7, most_notes = 3, most_warnings = 3, longest_name = 24;

Lines lines_of(const std::string& text) {
  Lines lines;
  std::istringstream all(text);
  for (std::string line; std::getline(all, line);) lines.push_back(line);
  return lines;
}

// A line a pair: those of the best solvers first, as the table has them.
Lines pairs_of(const Shown& shown) {
  const bool has_two = shown.decisive().described.size() == 2;
  std::vector<std::vector<std::string>> rows;
  for (const Judged& judged : shown.metrics) {
    if (!has_two && &judged != &shown.decisive()) continue;
    std::vector<Finding> findings = judged.findings;
    const std::vector<std::size_t> order = best_first(judged, shown.plan);
    const auto place = [&](const std::string& name) {
      return std::ranges::find(order, name, [&](std::size_t i) { return judged.observations.groups[i].name; });
    };
    std::ranges::stable_sort(findings, {}, [&](const Finding& of) {
      return std::minmax({place(of.first), place(of.second)});
    });
    for (const Finding& of : findings) {
      auto& row = rows.emplace_back();
      if (has_two) row.push_back("  " + shortened(judged.observations.quantity, longest_name));
      row.push_back((has_two ? "" : "  ") + fmt::format("{} vs {}", of.first, of.second));
      row.push_back(verdict_words(of, judged));
      row.push_back(amount_words(of, judged));
      row.push_back(of.p ? p_sentence(*of.p) : "");
    }
  }
  return lines_of(aligned(rows));
}

Lines table_of(const Shown& shown) {
  Table table = results_table(shown);
  table.columns[0].name = "";
  const std::size_t all = table.rows.size();
  if (all > most_rows) table.rows.resize(most_rows - 1);
  std::vector<std::string> notes = std::exchange(table.notes, {});
  std::erase_if(notes, [](const std::string& note) { return note.starts_with('!'); });  // a warning says more
  Lines lines = lines_of(to_text(table));
  if (all > most_rows) lines.push_back(fmt::format("  and {} more solvers", all - most_rows + 1));
  for (std::size_t i = 0; i < std::min(notes.size(), most_notes); ++i) {
    for (std::string& line : wrapped(notes[i], "")) lines.push_back(std::move(line));
  }
  return lines;
}

Lines warnings_of(const Shown& shown) {
  std::vector<Doubt> doubts = shown.all_doubts();
  const auto is_told = [](const Doubt& doubt) { return doubt.kind == DoubtKind::seconds_decide; };
  if (std::ranges::any_of(shown.decisive().observations.doubts, is_told))
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
  const Lines head = wrapped(headline(shown), ""), table = table_of(shown), warnings = warnings_of(shown);
  Lines pairs = pairs_of(shown), note;
  if (const std::string text = chosen_before(shown); shown.decisive().described.size() == 2 && !text.empty())
    note = wrapped(text, "");
  const std::size_t others = head.size() + note.size() + table.size() + warnings.size() + (page.empty() ? 1 : 2);
  const std::size_t room = others + 1 < screen_lines ? screen_lines - others : 1;
  if (const std::size_t all = pairs.size(); all > room) {
    pairs.resize(room - 1);
    pairs.push_back(fmt::format("  and {} more pairs", all - pairs.size()));
  }
  std::string text;
  for (const Lines& part : {head, pairs, note, Lines{""}, table, warnings}) {
    for (const std::string& line : part) text += line + '\n';
  }
  return page.empty() ? text : fmt::format("{}Report: {}\n", text, one_line(page));
}

}  // namespace ikbench::show
