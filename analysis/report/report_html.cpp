#include "analysis/report/report_html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "analysis/figures/dark.hpp"
#include "analysis/report/encoding.hpp"
#include "analysis/report/html_pieces.hpp"
#include "numerics/embedded_file.hpp"

namespace ikbench::report {

using namespace figures;
using namespace inference;

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

constexpr std::string_view at_a_glance = "overview";  // the figure beside the verdict

Data topics_data(const std::vector<Sentence>& sentences) {
  Data list(Data::type::list);
  for (const Sentence& sentence : sentences) {
    Data data;
    data.set("topic", text_data(sentence.topic.empty() ? "" : sentence.topic + ':'));
    data.set("rest", text_data(sentence.topic.empty() ? sentence.text : ' ' + sentence.text));
    list.push_back(data);
  }
  return list;
}

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

bool is_shown(const Section& section) { return !section.pieces.empty(); }

// The folded part of a shown section gets its own heading.
Data items_data(const Section& section, HtmlPieces& pieces) {
  Data items(Data::type::list);
  for (const std::vector<Piece>* part : {&section.pieces, &section.folded}) {
    for (const Piece& piece : *part) {
      if (name_of(piece) == at_a_glance) continue;  // it stands at the top
      Data item = pieces.data(piece);
      item.set("fold", is_shown(section) && part == &section.folded);
      items.push_back(item);
    }
  }
  return items;
}

Data section_data(const Section& section, const ReportContent& content, HtmlPieces& pieces) {
  Data data;
  data.set("id", Data("section-" + id_of(section.heading)));
  data.set("heading", text_data(section.heading));
  if (!section.sentences.empty()) {
    data.set("has_sentences", true);
    data.set("sentences", topics_data(section.sentences));
  }
  data.set("folded", !is_shown(section));
  data.set("items", items_data(section, pieces));
  if (!is_shown(section)) data.set("size", Data(piece_counts(section.folded)));
  const auto seen = content.seen.find(section.heading);
  const std::string line = seen != content.seen.end() ? seen->second : section.paragraph;
  if (!is_shown(section) && !line.empty()) data.set("line", text_data(line));
  if (!section.paragraph.empty() && (is_shown(section) || line != section.paragraph)) {
    data.set("paragraph", text_data(section.paragraph));
  }
  return data;
}

// The animated view follows the last shown section; the folded ones come after it.
Data sections_data(const ReportContent& content, HtmlPieces& pieces) {
  const auto last = std::find_if(content.results.rbegin(), content.results.rend(), is_shown);
  bool is_before = last != content.results.rend();
  Data sections(Data::type::list);
  for (const std::vector<Section>* part : {&content.results, &content.circumstances}) {
    for (const Section& section : *part) {
      Data data = section_data(section, content, pieces);
      const bool is_last = is_before && &section == &*last;
      data.set("first", is_before);
      data.set("last", is_last);
      is_before = is_before && !is_last;
      sections.push_back(data);
    }
  }
  return sections;
}

Data solvers_data(const std::vector<std::string>& solvers) {
  Data list(Data::type::list);
  for (std::size_t i = 0; i < solvers.size(); ++i) {
    Data data;
    data.set("name", text_data(solvers[i]));
    data.set("colour", Data(fmt::format("s{}", i % series_colours.size())));
    list.push_back(data);
  }
  return list;
}

// The figures' colours of the solvers.
std::string series_css() {
  std::string css, dark;
  for (std::size_t i = 0; i < series_colours.size(); ++i) {
    css += fmt::format(".s{} {{ --series: {}; }}\n", i, series_colours[i]);
    dark += fmt::format(".s{} {{ --series: {}; }}\n", i, dark_series_colours[i]);
  }
  return css + "@media screen and (prefers-color-scheme: dark) {\n" + dark + "}\n";
}

// "5 warnings: Times are not comparable"
std::string warnings_line(const Doubts& warnings) {
  return fmt::format("{}: {}", warnings.size() == 1 ? "Warning" : fmt::format("{} warnings", warnings.size()),
                     title_of(warnings.front().kind));
}

std::string source(std::string_view code) { return fmt::format("'sha256-{}'", sha256_in_base64(code)); }

// The part above the sections.
void set_header(const ReportContent& content, HtmlPieces& pieces, Data& page) {
  page.set("title", text_data(content.title));
  page.set("study", text_data(content.study));
  page.set("kind", text_data(content.kind));
  page.set("has_studied", !content.studied.empty());
  page.set("studied", list_data(content.studied));
  if (content.claims.empty()) {
    page.set("has_own", !content.answer.empty());
    page.set("own", topics_data(content.answer));
  } else {
    page.set("answers", list_data(answers_of(content)));
  }
  std::vector<std::string> summary = content.summary;
  if (!content.claims.empty()) {
    const std::vector<std::string> answer = words_of(content.answer);
    summary.insert(summary.begin(), answer.begin(), answer.end());
  }
  page.set("has_summary", !summary.empty());
  page.set("summary", list_data(summary));
  page.set("verdicts", verdicts_data(content));
  const Piece* glance = piece_named(content, at_a_glance);
  if (const auto* figure = glance ? std::get_if<ReportFigure>(glance) : nullptr; figure && figure->drawn) {
    page.set("glance", pieces.data(*glance));
  }
  if (!content.warnings.empty()) {
    page.set("has_warnings", true);
    page.set("several", text_data(warnings_line(content.warnings)));
    page.set("warnings", list_data(list_of(content.warnings)));
  }
  if (!content.command.empty()) page.set("command", text_data(content.command));
  if (content.solvers.size() > 1) {
    page.set("has_solvers", true);
    page.set("solvers", solvers_data(content.solvers));
  }
}

}  // namespace

std::string to_html(const ReportContent& content, const HtmlExtras& extras) {
  HtmlPieces pieces(content, extras.figures);
  Data page;
  set_header(content, pieces, page);
  if (!extras.downloads.empty()) {
    page.set("has_downloads", true);
    page.set("downloads", list_data(extras.downloads));
  }

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

  page.set("sections", sections_data(content, pieces));
  if (pieces.left_out() > 0) page.set("beside", Data(fmt::to_string(pieces.left_out())));
  page.set("has_shown", std::ranges::any_of(content.results, is_shown));
  page.set("told", Data(json_in_page(pieces.told())));
  const std::string style = series_css() + std::string(report_css);
  page.set("style", Data(style));
  page.set("script", Data(std::string(report_js)));
  page.set("policy",
           Data(fmt::format("default-src 'none'; img-src data:; script-src {}; style-src {}; base-uri 'none'; "
                            "form-action 'none'",
                            scripts, source(style))));
  kainjow::mustache::mustache page_template{std::string(report_html)};
  return page_template.render(page);
}

}  // namespace ikbench::report
