#include "analysis/show/screen.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "analysis/show/answer_tables.hpp"
#include "analysis/show/text.hpp"
#include "analysis/show/words.hpp"

namespace ikbench::show {

using namespace judge;

std::string screen(const Answer& whole, const std::string& page) {
  const Answer answer = with_short_names(whole, longest_name);
  std::string text = paragraph(headline(answer), "");
  if (!answer.studied.empty()) text += paragraph(answer.studied, "");
  constexpr std::size_t most_rows = 20;
  Table table = results_table(answer);
  table.columns[0].name = "";
  const std::size_t all = table.rows.size();
  if (all > most_rows) table.rows.resize(most_rows - 1);
  const std::vector<std::string> notes = std::exchange(table.notes, {});
  text += '\n' + to_text(table);
  if (all > most_rows) text += fmt::format("  and {} more solvers\n", all - most_rows + 1);
  if (!notes.empty()) text += paragraph(fmt::format("{}", fmt::join(notes, " ")), "");
  if (!answer.loop.rows.empty()) text += fmt::format("\n{}\n{}\n", answer.loop.caption, to_text(answer.loop));
  const auto pairs = pair_rows(answer);
  text += in_columns(pairs);
  for (const std::string& note : {pairs.empty() ? "" : of_pairs(answer), what_decides(answer)})
    text += note.empty() ? "" : paragraph(note, "");
  for (const Doubt& doubt : answer.all_doubts())
    if (doubt.kind != DoubtKind::sessions_left_out) text += paragraph("! " + words_of(doubt), "  ");  // on the page
  return page.empty() ? text : fmt::format("{}Report: {}\n", text, one_line(page));
}

}  // namespace ikbench::show
