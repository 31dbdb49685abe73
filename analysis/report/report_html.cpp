#include <fmt/format.h>
#include <openssl/evp.h>
#include <openssl/sha.h>

#include <algorithm>
#include <array>
#include <kainjow/mustache.hpp>
#include <string_view>
#include <utility>

#include "analysis/inference/text.hpp"
#include "analysis/report/json.hpp"
#include "analysis/report/moving_arm.hpp"
#include "analysis/report/report_content.hpp"
#include "analysis/report/words.hpp"
#include "numerics/embedded_file.hpp"
#include "results/files.hpp"

namespace ikbench::report {

using namespace results;
using namespace figures;
using namespace inference;
using namespace fmt::literals;

namespace {

const unsigned char* bytes_of(std::string_view text) { return reinterpret_cast<const unsigned char*>(text.data()); }

std::string base64(std::string_view bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');  // plus a terminating zero
  EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()), bytes_of(bytes), static_cast<int>(bytes.size()));
  text.pop_back();
  return text;
}

// The hash by which a Content-Security-Policy allows an inline script or style.
std::string sha256_in_base64(std::string_view bytes) {
  std::array<char, SHA256_DIGEST_LENGTH> digest{};
  SHA256(bytes_of(bytes), bytes.size(), reinterpret_cast<unsigned char*>(digest.data()));
  return base64({digest.data(), digest.size()});
}

constexpr numerics::EmbeddedFile templates[]{
#include "templates.inc"
};

std::string_view template_named(std::string_view name) {
  return std::ranges::find(templates, name, &numerics::EmbeddedFile::name)->text;
}

// Data of the template, which escapes texts. What is null or an empty text is false; "has_NAME" says that the list NAME
// is not empty.
kainjow::mustache::data page_data(const Json& json) {
  using Data = kainjow::mustache::data;
  if (json.is_string() && !json.get_ref<const std::string&>().empty()) return Data(one_line(json.get<std::string>()));
  if (json.is_array()) {
    Data list(Data::type::list);
    for (const Json& item : json) list.push_back(page_data(item));
    return list;
  }
  if (!json.is_object()) return Data(json.is_boolean() && json.get<bool>());
  Data object;
  for (const auto& [key, value] : json.items()) {
    object.set(key, page_data(value));
    if (value.is_array()) object.set("has_" + key, Data(!value.empty()));
  }
  return object;
}

// Makes a name safe as an id, in a link and as a file, even if a foreign table brings it.
std::string id_of(std::string_view name) {
  std::string id;
  for (const char c : name) {
    const bool is_safe = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-';
    id += is_safe ? c : '-';
  }
  return id;
}

const std::string_view report_html = template_named("report.html"), report_css = template_named("report.css"),
                       report_js = template_named("report.js"), moving_arm_js = template_named("moving_arm.js");

constexpr std::string_view at_a_glance = "overview";  // the figure beside the verdict
constexpr std::size_t largest_svg = 400'000;          // bytes; a larger one is shown as a link
constexpr std::size_t largest_sum = 1'500'000;        // bytes of all figures together, for a page below 3 MB
constexpr std::size_t most_page_rows = 60;            // most rows of a table on the page; its files have all

constexpr std::string_view colour_of(Nearness nearness) {
  constexpr std::array<std::string_view, 3> colours{"", "agrees", "differs"};
  return colours[static_cast<std::size_t>(nearness)];
}

// Explains cells with two numbers; empty if there are none.
std::string legend_of(const Table& table) {
  bool has_any = false;
  for (const std::vector<Cell>& row : table.rows) {
    for (const Cell& cell : row) {
      has_any = has_any || std::holds_alternative<OursAndPrinted>(cell);
    }
  }
  return has_any ? std::string(words::legend) + table.legend : "";
}

Json cell_json(const Cell& cell, bool is_left) {
  constexpr std::size_t short_text = 16;  // such as a solver's label: not broken at its hyphens
  if (const auto* beside = std::get_if<OursAndPrinted>(&cell)) {
    return {{"text", short_number(beside->ours)},
            {"number", computable(cell)},
            {"printed", beside->printed},
            {"nearness", colour_of(beside->nearness)}};
  }
  const std::string text = readable(cell);
  const bool is_words = std::holds_alternative<std::string>(cell) || is_empty(cell);
  return {{"text", text},
          {"right", !is_left},
          {"short", is_left && character_count(text) <= short_text},
          {"number", is_words ? Json() : Json(computable(cell))}};
}

Json table_json(const Table& given) {
  const Table table = for_people(given);
  Json heads = Json::array(), rows = Json::array();
  const std::vector<std::size_t> used = columns_in_use(table);
  for (const std::size_t c : used) {
    heads.push_back({{"text", table.columns[c]}, {"right", !is_left(table, c)}});
  }
  const std::size_t all = table.rows.size(), shown = std::min(all, most_page_rows);
  for (std::size_t r = 0; r < shown; ++r) {
    Json cells = Json::array();
    for (const std::size_t c : used) cells.push_back(cell_json(table.rows[r][c], is_left(table, c)));
    rows.push_back({{"cells", cells}});
  }
  return {{"id", id_of(table.name)},
          {"name", table.name},
          {"caption", numbered_caption(table)},
          {"legend", legend_of(table)},
          {"heads", heads},
          {"rows", rows},
          {"size", fmt::format("{} row{}", all, all == 1 ? "" : "s")},
          {"more", shown < all ? Json(fmt::format(words::first_rows, "shown"_a = shown, "all"_a = all)) : Json()},
          {"notes", table.notes}};
}

// "in part" is the class in-part.
std::string kind_of(Verdict verdict) {
  std::string kind(name_of(verdict));
  std::ranges::replace(kind, ' ', '-');
  return kind;
}

Json claim_json(const Claim& claim, const ReportContent& content) {
  const bool has_table = piece_named(content, claim.table) != nullptr;
  return {{"claim", claim.statement},
          {"verdict", verdict_words(claim)},
          {"kind", kind_of(claim.verdict)},
          {"printed", claim.printed ? Json(name_of(*claim.printed)) : Json()},
          {"printed_kind", claim.printed ? Json(kind_of(*claim.printed)) : Json()},
          {"number", claim.number},
          {"stated_in", claim.section},
          {"evidence", evidence_text(claim)},
          {"table", has_table ? Json(id_of(claim.table)) : Json()},
          {"link", has_table ? title_of(claim.table) : ""}};
}

// The paper's claims and our own questions, as a list of the lists that are not empty.
Json verdicts_json(const ReportContent& content) {
  Json lists = Json::array();
  for (const Claimant by : {Claimant::paper, Claimant::us}) {
    Json claims = Json::array();
    for (const Claim& claim : claims_by(by, content.claims)) claims.push_back(claim_json(claim, content));
    if (!claims.empty()) lists.push_back({{"besides", by == Claimant::us}, {"claims", claims}});
  }
  return lists;
}

Json topics_json(const std::vector<Sentence>& sentences) {
  Json list = Json::array();
  for (const Sentence& sentence : sentences) {
    const bool has_topic = !sentence.topic.empty();
    list.push_back(
        {{"topic", has_topic ? sentence.topic + ':' : ""}, {"rest", has_topic ? ' ' + sentence.text : sentence.text}});
  }
  return list;
}

bool has(const ReportFigure& piece, std::string_view type) { return std::ranges::count(piece.types, type) > 0; }

Json pictures_json(const ReportFigure& piece) {
  Json pictures = Json::array();
  for (const std::string_view type : piece.types) {
    std::string title(type);
    std::ranges::transform(title, title.begin(), [](char c) { return static_cast<char>(c - 'a' + 'A'); });
    pictures.push_back({{"type", type}, {"title", title}, {"name", piece.figure.name}});
  }
  return pictures;
}

// The tables and figures of a page. Together the pictures stay below a limit; those beyond it are links.
class Pieces {
 public:
  Pieces(const ReportContent& content, std::filesystem::path figures)
      : content_(content), figures_(std::move(figures)) {}

  Json json(const Piece& piece) {
    const auto* table = std::get_if<Table>(&piece);
    return {{table ? "table" : "figure", table ? table_json(*table) : figure_json(std::get<ReportFigure>(piece))},
            {"title", title_of(name_of(piece))},
            {"seen", seen_at(piece, content_)}};
  }
  // The figure's SVG in base64; null if it is not drawn, or too large. As an image source it runs no script, and its
  // ids cannot clash.
  Json picture(const ReportFigure& piece) {
    const auto file =
        has(piece, "svg") ? read_file(figures_ / (piece.figure.name + ".svg")) : std::optional<std::string>();
    if (!file || file->size() > largest_svg) return {};
    std::string svg = base64(*file);
    if (sum_ + svg.size() > largest_sum) return {};
    sum_ += svg.size();
    return svg;
  }
  int left_out() const { return left_out_; }  // pictures beyond the limit so far

 private:
  Json figure_json(const ReportFigure& piece) {
    const Figure& figure = piece.figure;
    // Ids must be unique on the page, but a table and its figure may share a name.
    const Piece* const first = piece_named(content_, figure.name);
    const std::string id =
        id_of(figure.name) + (first != nullptr && std::holds_alternative<Table>(*first) ? "-figure" : "");
    const Json svg = picture(piece);
    const bool is_left_out = has(piece, "svg") && svg.is_null();
    left_out_ += is_left_out ? 1 : 0;
    return {{"id", id},
            {"name", figure.name},
            {"caption", figure.caption},
            {"wide", figure.width_cm > 12},
            {"drawn", !piece.types.empty()},
            {"pictures", pictures_json(piece)},
            {"svg", svg},
            {"left_out", is_left_out}};
  }

  const ReportContent& content_;
  std::filesystem::path figures_;
  std::size_t sum_ = 0;  // bytes of all pictures so far
  int left_out_ = 0;
};

// "2 tables, 1 figure"
std::string piece_counts(const std::vector<Piece>& pieces) {
  const auto tables = std::ranges::count_if(pieces, [](const Piece& p) { return std::holds_alternative<Table>(p); });
  const auto figures = static_cast<std::ptrdiff_t>(pieces.size()) - tables;
  const auto several = [](std::ptrdiff_t count, std::string_view what) {
    return count == 0 ? "" : fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
  };
  return fmt::format("{}{}{}", several(tables, "table"), tables > 0 && figures > 0 ? ", " : "",
                     several(figures, "figure"));
}

std::string pieces_left_out(int figures) {
  return figures == 1 ? std::string(words::figure_beside) : fmt::format(words::figures_beside, "count"_a = figures);
}

bool is_shown(const Section& section) { return !section.pieces.empty(); }

Json section_json(const Section& section, const ReportContent& content, Pieces& pieces) {
  const bool is_folded = !is_shown(section);
  Json items = Json::array();
  for (const std::vector<Piece>* part : {&section.pieces, &section.folded}) {
    for (const Piece& piece : *part) {
      if (name_of(piece) == at_a_glance) continue;  // it stands at the top
      Json item = pieces.json(piece);
      item["fold"] = !is_folded && part == &section.folded;  // the folded part of a shown section has its own heading
      items.push_back(item);
    }
  }
  const auto seen = content.seen.find(section.heading);
  const std::string line = seen != content.seen.end() ? seen->second : section.paragraph;
  return {{"id", "section-" + id_of(section.heading)},
          {"heading", section.heading},
          {"sentences", topics_json(section.sentences)},
          {"folded", is_folded},
          {"items", items},
          {"size", is_folded ? piece_counts(section.folded) : ""},
          {"line", is_folded ? line : ""},
          {"paragraph", is_folded && line == section.paragraph ? "" : section.paragraph}};
}

// The animated view follows the last shown section; the folded ones come after it.
Json sections_json(const ReportContent& content, Pieces& pieces) {
  const auto last = std::find_if(content.results.rbegin(), content.results.rend(), is_shown);
  bool is_before = last != content.results.rend();
  Json sections = Json::array();
  for (const std::vector<Section>* part : {&content.results, &content.circumstances}) {
    for (const Section& section : *part) {
      Json json = section_json(section, content, pieces);
      const bool is_last = is_before && &section == &*last;
      json["first"] = is_before;
      json["last"] = is_last;
      is_before = is_before && !is_last;
      sections.push_back(json);
    }
  }
  return sections;
}

// "5 warnings: Times are not comparable"
std::string warnings_line(const Doubts& warnings) {
  return fmt::format("{}: {}", warnings.size() == 1 ? "Warning" : fmt::format("{} warnings", warnings.size()),
                     title_of(warnings.front()));
}

std::string source(std::string_view code) { return fmt::format("'sha256-{}'", sha256_in_base64(code)); }

// The part above the sections.
Json header_json(const ReportContent& content, Pieces& pieces) {
  const Piece* glance = piece_named(content, at_a_glance);
  const auto* figure = glance ? std::get_if<ReportFigure>(glance) : nullptr;
  return {{"title", content.title},
          {"study", content.study},
          {"kind", content.kind},
          {"studied", content.studied},
          {"own", topics_json(content.answer)},
          {"answers", answers_of(content)},
          {"summary", content.summary},
          {"verdicts", verdicts_json(content)},
          {"glance", figure && !figure->types.empty() ? pieces.json(*glance) : Json()},
          {"several", content.warnings.empty() ? "" : warnings_line(content.warnings)},
          {"warnings", list_of(content.warnings)},
          {"command", content.command},
          {"program", content.program.empty() ? "ikbench" : content.program}};
}

// Files of the report's folder that the page offers for download.
std::vector<std::string> downloads_in(const std::filesystem::path& folder) {
  std::vector<std::string> files;
  for (const char* name : {"report.md", "store.sqlite", "solves.csv", "statistics.json"}) {
    if (std::filesystem::is_regular_file(folder / name)) files.emplace_back(name);
  }
  return files;
}

}  // namespace

std::string to_html(const ReportContent& content, const std::filesystem::path& folder) {
  Pieces pieces(content, folder / "figures");
  Json json = header_json(content, pieces);
  json["downloads"] = downloads_in(folder);
  const std::optional<std::string> library = content.motion ? drawing_library() : std::nullopt;
  if (content.motion) {
    const Piece* piece = piece_named(content, content.path);
    const auto* figure = piece ? std::get_if<ReportFigure>(piece) : nullptr;
    json["motion"] = {{"still", figure ? pieces.picture(*figure) : Json()}, {"moves", library.has_value()}};
  }
  json["sections"] = sections_json(content, pieces);
  if (pieces.left_out() > 0) json["beside"] = pieces_left_out(pieces.left_out());
  const Json& sections = json["sections"];
  json["has_rest"] = !sections.empty() && sections.front()["first"] && !sections.back()["first"];

  kainjow::mustache::data page = page_data(json);
  std::string scripts = source(report_js);
  if (library) {  // as they are, line by line
    page.set("data", kainjow::mustache::data(*content.motion));
    page.set("library", kainjow::mustache::data(*library));
    page.set("view", kainjow::mustache::data(std::string(moving_arm_js)));
    scripts += ' ' + source(*library) + ' ' + source(moving_arm_js);
  }
  page.set("style", kainjow::mustache::data(std::string(report_css)));
  page.set("script", kainjow::mustache::data(std::string(report_js)));
  page.set("policy", kainjow::mustache::data(
                         fmt::format("default-src 'none'; img-src data:; script-src {}; style-src {}; base-uri 'none'; "
                                     "form-action 'none'",
                                     scripts, source(report_css))));
  kainjow::mustache::mustache page_template{std::string(report_html)};
  return page_template.render(page);
}

}  // namespace ikbench::report
