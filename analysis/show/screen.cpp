#include "analysis/show/screen.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "analysis/show/answer_tables.hpp"
#include "analysis/show/tell.hpp"
#include "analysis/show/text.hpp"
#include "analysis/show/words.hpp"

namespace ikbench::show {

using namespace judge;

std::string screen(const Answer& whole, const std::string& page) {
  const Answer answer = with_short_names(whole, longest_name);
  const bool is_of_file = !answer.direction.empty();
  constexpr std::size_t most_rows = 20;
  Table table = results_table(answer, !is_of_file);
  table.columns[0].name = "";
  const std::size_t all = table.rows.size();
  if (all > most_rows) table.rows.resize(most_rows - 1);
  std::string notes = fmt::format("{}", fmt::join(std::exchange(table.notes, {}), " "));
  if (const std::string decides = what_decides(answer); !decides.empty())
    notes += fmt::format("{}{}.", notes.empty() ? "" : " ", decides);
  std::string text = paragraph(headline(answer), "") + '\n' + to_text(table);
  if (all > most_rows) text += fmt::format("  and {} more solvers\n", all - most_rows + 1);
  if (!notes.empty()) text += paragraph(notes, "");
  for (const Table& more : {answer.loop, answer.beside})
    if (!more.rows.empty()) text += fmt::format("\n{}\n{}\n", more.caption, to_text(more));
  const auto pairs = page.empty() ? pair_rows(answer) : std::vector<std::vector<std::string>>();
  text += in_columns(pairs);
  if (const std::string of = of_pairs(answer); !pairs.empty() && !of.empty()) text += paragraph(of, "");
  const std::vector<Doubt> doubts = answer.all_doubts();  // in the order of their kinds
  for (const Doubt& doubt : doubts) {
    const bool is_told = !page.empty() && std::any_of(doubts.data(), &doubt, [&](const Doubt& other) {
      return other.kind == doubt.kind || (other.what == doubt.what && doubt.kind == DoubtKind::times_not_comparable);
    });
    const auto alike = std::ranges::count(doubts, doubt.kind, &Doubt::kind);
    if (doubt.kind == DoubtKind::sessions_left_out || is_told) continue;  // on the page
    text += paragraph(
        "! " + words_of(doubt) + (page.empty() || alike == 1 ? "" : fmt::format("; {} more on the page", alike - 1)),
        "  ");
  }
  return page.empty() ? text : fmt::format("{}Report: {}\n", text, one_line(page));
}

}  // namespace ikbench::show
