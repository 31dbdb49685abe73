#include "analysis/report/report_html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <kainjow/mustache.hpp>
#include <string_view>
#include <utility>

#include "analysis/inference/text.hpp"
#include "analysis/report/encoding.hpp"
#include "numerics/embedded_file.hpp"
#include "results/files.hpp"

namespace ikbench::report {

using namespace results;
using namespace inference;
using namespace figures;

namespace {

// The files of templates/ (embed.cmake).
constexpr numerics::EmbeddedFile templates[]{
#include "templates.inc"
};

constexpr std::string_view template_named(std::string_view name) {
  return std::ranges::find(templates, name, &numerics::EmbeddedFile::name)->text;
}

constexpr std::string_view report_html = template_named("report.html"), report_css = template_named("report.css"),
                           report_js = template_named("report.js"), moving_arm_js = template_named("moving_arm.js");

using Data = kainjow::mustache::data;

constexpr std::size_t largest_svg = 400'000;    // bytes; a larger one is shown as a link
constexpr std::size_t largest_sum = 3'000'000;  // bytes of all figures together, for a report below 4 MB

Data text(std::string_view plain) { return Data(one_line(plain)); }  // the template escapes

Data list_of(const std::vector<std::string>& sentences) {
  Data list(Data::type::list);
  for (const std::string& sentence : sentences) list.push_back(text(sentence));
  return list;
}

// "Assumptions: equal variances do not hold" as its topic and the rest.
Data topics_of(const std::vector<std::string>& sentences) {
  Data list(Data::type::list);
  for (const std::string& sentence : sentences) {
    constexpr std::size_t longest_topic = 30;
    const std::size_t colon = sentence.find(": ");
    const std::size_t length = colon == std::string::npos || colon > longest_topic ? 0 : colon + 1;
    Data data;
    data.set("topic", text(sentence.substr(0, length)));
    data.set("rest", text(sentence.substr(length)));
    list.push_back(data);
  }
  return list;
}

// A name as an id and part of a link; names are ours, but a table of another's making stays harmless.
std::string id_of(std::string_view name) {
  std::string id;
  for (const char c : name) {
    const bool is_safe = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-';
    id += is_safe ? c : '-';
  }
  return id;
}

// What stands at the front of a cell and has a colour.
std::string_view verdict_of(std::string_view cell) {
  if (cell.starts_with("relative only: ")) cell.remove_prefix(15);
  for (const std::string_view verdict : {"agrees", "close", "differs"}) {
    if (cell.starts_with(verdict)) return verdict;
  }
  return "";
}

Data cell_data(const Cell& cell, const Column& column) {
  Data data;
  const std::string shown = readable(cell);
  data.set("text", text(shown));
  data.set("right", column.align == Align::right);
  constexpr std::size_t short_text = 16;  // such as a solver's label: not broken at its hyphens
  data.set("short", column.align == Align::left && character_count(shown) <= short_text);
  const bool is_text = std::holds_alternative<std::string>(cell) || std::holds_alternative<std::monostate>(cell);
  if (!is_text) data.set("number", Data(computable(cell)));
  if (column.name == "verdict" && !verdict_of(shown).empty()) data.set("verdict", Data(std::string(verdict_of(shown))));
  return data;
}

// Where words may break: a_long_name.
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
    head.set("text", text(spaced(table.columns[c].name)));
    head.set("right", table.columns[c].align == Align::right);
    heads.push_back(head);
  }
  for (const auto& row : table.rows) {
    Data cells(Data::type::list);
    for (const std::size_t c : used) cells.push_back(cell_data(row[c], table.columns[c]));
    Data cells_of_row;
    cells_of_row.set("cells", cells);
    rows.push_back(cells_of_row);
  }
  data.set("id", Data(id_of(table.name)));
  data.set("name", text(table.name));
  data.set("caption", text(table.caption));
  data.set("heads", heads);
  data.set("rows", rows);
  data.set("notes", list_of(table.notes));
  return data;
}

// The tables and figures of a page, and the ids that only one of them may have.
class Pieces {
 public:
  explicit Pieces(const HtmlExtras& extras) : extras_(extras) {}

  Data data(const Piece& piece) {
    Data result;
    if (const auto* table = std::get_if<Table>(&piece)) {
      result.set("table", table_data(*table));
    } else {
      result.set("figure", figure_data(std::get<ReportFigure>(piece)));
    }
    return result;
  }

  // The figure's SVG in base64. As the source of an image it runs no script, and its ids are its own.
  std::optional<std::string> picture(const Figure& figure) {
    const auto file = read_file(extras_.figures / (figure.name + ".svg"));
    if (!file || file->size() > largest_svg) return std::nullopt;
    std::string svg = base64(*file);
    if (sum_ + svg.size() > largest_sum) return std::nullopt;
    sum_ += svg.size();
    return svg;
  }

 private:
  Data figure_data(const ReportFigure& piece) {
    Data data;
    data.set("id", Data(id_of(piece.figure.name)));
    data.set("name", text(piece.figure.name));
    data.set("title", text(title_of(piece.figure.name)));
    data.set("caption", text(piece.figure.caption));
    data.set("wide", piece.figure.width_cm > 12);
    data.set("drawn", piece.drawn);
    const auto svg = piece.drawn ? picture(piece.figure) : std::nullopt;
    if (svg) data.set("svg", Data(*svg));
    data.set("left_out", piece.drawn && !svg);
    return data;
  }

  const HtmlExtras& extras_;
  std::size_t sum_ = 0;  // bytes of all pictures so far
};

// The piece of that name among the results and the circumstances; null where there is none.
const Piece* piece_named(const ReportContent& content, std::string_view name) {
  for (const std::vector<Section>* part : {&content.results, &content.circumstances}) {
    for (const Section& section : *part) {
      const auto found =
          std::ranges::find_if(section.pieces, [&](const Piece& piece) { return name_of(piece) == name; });
      if (found != section.pieces.end()) return &*found;
    }
  }
  return nullptr;
}

// "in part" is the class in-part.
std::string kind_of(Verdict verdict) {
  std::string kind(name_of(verdict));
  std::ranges::replace(kind, ' ', '-');
  return kind;
}

Data claims_data(const ReportContent& content) {
  Data list(Data::type::list);
  for (const Claim& claim : content.claims) {
    Data data;
    data.set("claim", text(claim.statement));
    data.set("verdict", text(verdict_words(claim)));
    data.set("kind", Data(kind_of(claim.verdict)));
    if (claim.printed) {
      data.set("printed", text(name_of(*claim.printed)));
      data.set("printed_kind", Data(kind_of(*claim.printed)));
    }
    data.set("evidence", text(claim.evidence));
    if (piece_named(content, claim.table)) {
      data.set("table", Data(claim.table));
      data.set("link", Data(title_of(claim.table)));
    }
    list.push_back(data);
  }
  return list;
}

std::string source(std::string_view code) { return fmt::format("'sha256-{}'", sha256_in_base64(code)); }

}  // namespace

std::string to_html(const ReportContent& content, const HtmlExtras& extras) {
  Pieces pieces(extras);
  Data page;
  page.set("title", text(content.title));
  page.set("study", text(content.study));
  page.set("kind", text(content.kind));
  if (!content.answer.empty()) page.set("answer", text(content.answer));
  page.set("summary", list_of(content.summary));
  if (!content.claims.empty()) {
    page.set("has_claims", true);
    page.set("claims", claims_data(content));
    page.set("tally", Data(tally(content.claims)));
  }
  if (!content.warnings.empty()) {
    page.set("has_warnings", true);
    page.set("warnings", list_of(content.warnings));
  }
  if (!content.command.empty()) page.set("command", text(content.command));

  std::string scripts = source(report_js);
  const bool moves = extras.motion && extras.drawing_library;
  if (extras.motion) {
    Data motion;
    const Piece* piece = piece_named(content, content.path);
    const auto* figure = piece ? std::get_if<ReportFigure>(piece) : nullptr;
    if (const auto svg = figure && figure->drawn ? pieces.picture(figure->figure) : std::nullopt) {
      motion.set("still", Data(*svg));
    }
    motion.set("moves", moves);
    page.set("motion", motion);
  }
  if (moves) {
    page.set("data", Data(*extras.motion));
    page.set("library", Data(*extras.drawing_library));
    page.set("view", Data(std::string(moving_arm_js)));
    scripts += ' ' + source(*extras.drawing_library) + ' ' + source(moving_arm_js);
  }

  Data sections(Data::type::list);
  for (const std::vector<Section>* part : {&content.results, &content.circumstances}) {
    for (const Section& section : *part) {
      Data data, items(Data::type::list);
      for (const Piece& piece : section.pieces) items.push_back(pieces.data(piece));
      data.set("id", Data("section-" + id_of(section.heading)));
      data.set("heading", text(section.heading));
      if (!section.paragraph.empty()) data.set("paragraph", text(section.paragraph));
      if (!section.sentences.empty()) {
        data.set("has_sentences", true);
        data.set("sentences", topics_of(section.sentences));
      }
      data.set("items", items);
      sections.push_back(data);
    }
  }
  page.set("sections", sections);
  page.set("style", Data(std::string(report_css)));
  page.set("script", Data(std::string(report_js)));
  page.set("policy",
           Data(fmt::format("default-src 'none'; img-src data:; script-src {}; style-src {}; base-uri 'none'; "
                            "form-action 'none'",
                            scripts, source(report_css))));
  kainjow::mustache::mustache page_template{std::string(report_html)};
  return page_template.render(page);
}

}  // namespace ikbench::report
