#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "analysis/inference/text.hpp"
#include "analysis/report/report_content.hpp"

namespace ikbench::report {

using namespace results;
using namespace inference;
using namespace figures;

namespace {

std::string bullets(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) text += fmt::format("- {}\n", markdown_text(sentence));
  return text + '\n';
}

// The file of a picture, of the wanted type if there is one.
std::string shown_picture(const ReportFigure& piece, std::string_view wanted) {
  const bool has_wanted = std::ranges::count(piece.types, wanted) > 0;
  return fmt::format("{}.{}", piece.figure.name, has_wanted ? wanted : piece.types.front());
}

std::string markdown(const ReportFigure& piece) {
  const Figure& figure = piece.figure;
  const std::string caption = markdown_text(figure.caption);
  const auto link = [&](std::string_view type) { return fmt::format("[{0}](figures/{1}.{0})", type, figure.name); };
  const std::string title = fmt::format("**{}**\n\n", markdown_text(title_of(figure.name)));
  if (piece.types.empty()) {
    return title +
           fmt::format("{} Not drawn. Gnuplot can draw it from {} and {}.\n\n", caption, link("gp"), link("dat"));
  }
  const std::string picture = shown_picture(piece, "png");
  std::vector<std::string> others;
  for (const std::string_view type : piece.types) {
    if (!picture.ends_with(type)) others.push_back(link(type));
  }
  return title + fmt::format("![{0}](figures/{1})\n\n{0} ({2}{3}{4}, {5})\n\n", caption, picture,
                             fmt::join(others, ", "), others.empty() ? "" : "; ", link("gp"), link("dat"));
}

std::string markdown(const Table& table) { return to_markdown(table) + '\n'; }

std::string index_row(const Piece& piece) {
  constexpr std::size_t longest_title = 120;
  const auto* table = std::get_if<Table>(&piece);
  const auto* figure = std::get_if<ReportFigure>(&piece);
  const std::string& name = name_of(piece);
  std::vector<std::string_view> types{"md", "csv", "tex"};
  if (figure) {
    types.assign(figure->types.begin(), figure->types.end());
    types.insert(types.end(), {"gp", "dat"});
  }
  std::string files;
  for (const std::string_view type : types)
    files += fmt::format("{0}[{1}]({2}/{3}.{1})", files.empty() ? "" : " ", type, table ? "tables" : "figures", name);
  const std::string title = table ? numbered_caption(*table) : figure->figure.caption;
  return fmt::format("| {} | {} | {} |\n", markdown_text(name), markdown_text(shortened(title, longest_title)), files);
}

std::string verdict(const ReportContent& content, EvidenceShown evidence) {
  std::string text;
  const std::vector<Claim> papers = claims_by(Claimant::paper, content.claims),
                           ours = claims_by(Claimant::us, content.claims);
  if (!papers.empty()) {
    text += "## Verdict\n\n" +
            markdown(claims_table(papers, "claims", fmt::format("{}", fmt::join(answers_of(content), " ")), evidence));
  }
  if (!ours.empty()) {
    text +=
        "## Our own questions\n\n" + markdown(claims_table(ours, "questions", "Not claims of the paper.", evidence));
  }
  return text;
}

std::string markdown(const std::vector<Section>& sections) {
  std::string text;
  for (const Section& section : sections) {
    text += fmt::format("## {}\n\n", markdown_text(section.heading));
    if (!section.paragraph.empty()) text += markdown_text(section.paragraph) + "\n\n";
    if (!section.sentences.empty()) text += bullets(words_of(section.sentences));
    for (const std::vector<Piece>* part : {&section.pieces, &section.folded}) {
      for (const Piece& piece : *part) text += std::visit([](const auto& shown) { return markdown(shown); }, piece);
    }
  }
  return text;
}

}  // namespace

std::string to_markdown(const ReportContent& content) {
  std::string text = fmt::format("# {}\n\n", markdown_text(content.title));
  text += fmt::format("{} {}.\n\n", content.kind, markdown_text(content.study));
  for (const std::string& sentence : content.studied) text += markdown_text(sentence) + "\n\n";
  if (!content.answer.empty()) text += markdown_text(paragraph_of(content.answer)) + "\n\n";
  if (!content.warnings.empty()) text += "## Warnings\n\n" + bullets(list_of(content.warnings));
  text += verdict(content, EvidenceShown::whole) + "## Summary\n\n";
  text += bullets(content.summary);
  if (!content.command.empty()) {
    text += fmt::format("To repeat this:\n\n    {}\n\n", one_line(content.command));
  }
  text +=
      "[index.md](index.md) lists all tables and figures. `tables/` has every table as Markdown, CSV (all digits) and LaTeX. `figures/` has the script and the data of every "
      "figure, and where gnuplot drew it SVG, PDF and PNG.\n\n";
  return text + markdown(content.circumstances) + markdown(content.results);
}

std::string index_markdown(const ReportContent& content) {
  std::string text = fmt::format("# Tables and figures: {}\n\n", markdown_text(content.title));
  for (const std::vector<Section>* part : {&content.results, &content.circumstances}) {
    for (const Section& section : *part) {
      if (section.pieces.empty() && section.folded.empty()) continue;
      text += fmt::format("## {}\n\n| name | what it shows | files |\n| :--- | :--- | :--- |\n",
                          markdown_text(section.heading));
      for (const std::vector<Piece>* pieces : {&section.pieces, &section.folded}) {
        for (const Piece& piece : *pieces) text += index_row(piece);
      }
      text += '\n';
    }
  }
  return text;
}

std::string verdict_markdown(const ReportContent& content) {
  std::string text = fmt::format("# {}\n\n", markdown_text(content.title));
  for (const std::string& sentence : content.studied) text += markdown_text(sentence) + "\n\n";
  text += verdict(content, EvidenceShown::first_sentence);
  for (const Section& section : content.results) {
    if (section.pieces.empty()) continue;
    text += fmt::format("## {}\n\n", markdown_text(section.heading));
    if (!section.paragraph.empty()) text += markdown_text(section.paragraph) + "\n\n";
    for (const Piece& piece : section.pieces) {
      if (const std::string seen = seen_at(piece, content); !seen.empty()) text += markdown_text(seen) + "\n\n";
      if (auto table = std::get_if<Table>(&piece)) {
        Table without_notes = *table;
        without_notes.notes.clear();
        text += markdown(without_notes);
        continue;
      }
      const auto& drawn = std::get<ReportFigure>(piece);
      if (drawn.types.empty()) continue;
      const std::string title = markdown_text(title_of(drawn.figure.name));
      text += fmt::format("![{0}](figures/{1})\n\n**{0}.** {2}\n\n", title, shown_picture(drawn, "svg"),
                          markdown_text(drawn.figure.caption));
    }
  }
  return text;
}

}  // namespace ikbench::report
