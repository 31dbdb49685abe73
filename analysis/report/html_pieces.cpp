#include "analysis/report/html_pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "analysis/figures/dark.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/encoding.hpp"
#include "results/files.hpp"

namespace ikbench::report {

using namespace results;
using namespace inference;
using namespace figures;

namespace {

constexpr std::size_t largest_svg = 400'000;    // bytes; a larger one is shown as a link
constexpr std::size_t largest_sum = 1'500'000;  // bytes of all figures together, for a page below 3 MB
constexpr std::size_t most_page_rows = 60;      // most rows of a table on the page; its files have all

constexpr std::string_view colour_of(Nearness nearness) {
  constexpr std::array<std::string_view, 4> colours{"", "agrees", "close", "differs"};
  return colours[static_cast<std::size_t>(nearness)];
}

// Explains cells with two numbers; empty if there are none.
std::string legend_of(const Table& table) {
  bool has_any = false, has_colours = false;
  for (const std::vector<Cell>& row : table.rows) {
    for (const Cell& cell : row) {
      const auto* const beside = std::get_if<Beside>(&cell);
      has_any = has_any || beside != nullptr;
      has_colours = has_colours || (beside != nullptr && beside->nearness != Nearness::unknown);
    }
  }
  if (!has_any) return "";
  return std::string("Large: ours. Small: as printed.") +
         (has_colours
              ? " Green: the printed number is where 95 % of our repetitions are. Yellow: outside, but near. Red: far."
              : "");
}

Data cell_data(const Cell& cell, bool is_left) {
  Data data;
  const std::string shown = readable(cell);
  data.set("text", text_data(shown));
  data.set("right", !is_left);
  constexpr std::size_t short_text = 16;  // such as a solver's label: not broken at its hyphens
  data.set("short", is_left && character_count(shown) <= short_text);
  if (const auto* beside = std::get_if<Beside>(&cell)) {
    data.set("text", text_data(short_number(beside->ours)));
    data.set("number", Data(computable(Cell(beside->ours))));
    data.set("printed", text_data(beside->printed));
    data.set("nearness", Data(std::string(colour_of(beside->nearness))));
    data.set("words", text_data(beside->words));
    return data;
  }
  if (const auto* graded = std::get_if<Graded>(&cell)) {
    if (graded->nearness != Nearness::unknown) data.set("verdict", Data(std::string(colour_of(graded->nearness))));
    return data;
  }
  const bool is_text = std::holds_alternative<std::string>(cell) || std::holds_alternative<std::monostate>(cell);
  if (!is_text) data.set("number", Data(computable(cell)));
  return data;
}

// Replaces underscores by spaces, so that a long name may break into lines.
std::string spaced(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

Data table_data(const Table& table) {
  Data data;
  const std::vector<std::size_t> used = columns_in_use(table);
  Data heads(Data::type::list), rows(Data::type::list);
  for (const std::size_t c : used) {
    Data head;
    head.set("text", text_data(spaced(table.columns[c])));
    head.set("right", !is_left(table, c));
    heads.push_back(head);
  }
  const std::size_t shown = std::min(table.rows.size(), most_page_rows);
  for (std::size_t r = 0; r < shown; ++r) {
    Data cells(Data::type::list);
    for (const std::size_t c : used) cells.push_back(cell_data(table.rows[r][c], is_left(table, c)));
    Data cells_of_row;
    cells_of_row.set("cells", cells);
    rows.push_back(cells_of_row);
  }
  data.set("id", Data(id_of(table.name)));
  data.set("name", text_data(table.name));
  data.set("caption", text_data(numbered_caption(table)));
  if (const std::string legend = legend_of(table); !legend.empty()) data.set("legend", Data(legend));
  data.set("heads", heads);
  data.set("rows", rows);
  data.set("size", Data(fmt::format("{} row{}", table.rows.size(), table.rows.size() == 1 ? "" : "s")));
  if (shown < table.rows.size()) {
    data.set("more",
             Data(fmt::format("The first {} of {} rows; all of them are in the CSV.", shown, table.rows.size())));
  }
  if (!table.notes.empty()) {
    data.set("has_notes", true);
    data.set("notes", list_data(table.notes));
  }
  return data;
}

// "in part" is the class in-part.
std::string kind_of(Verdict verdict) {
  std::string kind(name_of(verdict));
  std::ranges::replace(kind, ' ', '-');
  return kind;
}

Data claim_data(const Claim& claim, const ReportContent& content) {
  Data data;
  data.set("claim", text_data(claim.statement));
  data.set("verdict", text_data(verdict_words(claim)));
  data.set("kind", Data(kind_of(claim.verdict)));
  if (claim.printed) {
    data.set("printed", text_data(name_of(*claim.printed)));
    data.set("printed_kind", Data(kind_of(*claim.printed)));
  }
  data.set("number", text_data(claim.number));
  if (!claim.section.empty()) data.set("stated_in", text_data(claim.section));
  data.set("evidence", text_data(evidence_text(claim)));
  if (piece_named(content, claim.table)) {
    data.set("table", Data(id_of(claim.table)));
    data.set("link", text_data(title_of(claim.table)));
  }
  return data;
}

}  // namespace

Data text_data(std::string_view plain) { return Data(one_line(plain)); }

Data list_data(const std::vector<std::string>& sentences) {
  Data list(Data::type::list);
  for (const std::string& sentence : sentences) list.push_back(text_data(sentence));
  return list;
}

std::string id_of(std::string_view name) {
  std::string id;
  for (const char c : name) {
    const bool is_safe = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-';
    id += is_safe ? c : '-';
  }
  return id;
}

Data verdicts_data(const ReportContent& content) {
  Data lists(Data::type::list);
  for (const By by : {By::paper, By::us}) {
    Data claims(Data::type::list);
    for (const Claim& claim : claims_by(by, content.claims)) claims.push_back(claim_data(claim, content));
    if (claims.list_value().empty()) continue;
    Data list;
    list.set("besides", by == By::us);
    list.set("claims", claims);
    lists.push_back(list);
  }
  return lists;
}

// Ids must be unique on the page, but a table and its figure may share a name.
std::string HtmlPieces::id_of_figure(const std::string& name) const {
  const Piece* const first = piece_named(content_, name);
  return id_of(name) + (first != nullptr && std::holds_alternative<Table>(*first) ? "-figure" : "");
}

Data HtmlPieces::data(const Piece& piece) {
  Data result;
  const std::string& name = name_of(piece);
  if (const auto* table = std::get_if<Table>(&piece)) {
    result.set("table", table_data(*table));
  } else {
    result.set("figure", figure_data(std::get<ReportFigure>(piece)));
  }
  result.set("title", text_data(title_of(name)));
  if (const std::string seen = seen_at(piece, content_); !seen.empty()) result.set("seen", text_data(seen));
  return result;
}

std::optional<std::string> HtmlPieces::picture(const Figure& figure) {
  const auto file = read_file(figures_ / (figure.name + ".svg"));
  if (!file || file->size() > largest_svg) return std::nullopt;
  std::string svg = base64(with_dark_colours(*file));
  if (sum_ + svg.size() > largest_sum) return std::nullopt;
  sum_ += svg.size();
  return svg;
}

Data HtmlPieces::figure_data(const ReportFigure& piece) {
  Data data;
  const std::string id = id_of_figure(piece.figure.name);
  data.set("id", Data(id));
  data.set("name", text_data(piece.figure.name));
  data.set("caption", text_data(piece.figure.caption));
  data.set("wide", piece.figure.width_cm > 12);
  data.set("drawn", piece.drawn);
  const auto svg = piece.drawn ? picture(piece.figure) : std::nullopt;
  if (svg) data.set("svg", Data(*svg));
  data.set("left_out", piece.drawn && !svg);
  left_out_ += piece.drawn && !svg ? 1 : 0;
  Json& series = told_[id] = Json::array();
  for (const HoverTexts& texts : piece.figure.hover_texts) {
    series.push_back({{"series", one_line(texts.series)}, {"words", texts.words}});
  }
  if (!svg || series.empty()) told_.erase(id);
  return data;
}

}  // namespace ikbench::report
