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

std::string verdict(const ReportContent& content) {
  std::string text;
  const std::vector<Claim> papers = claims_by(Claimant::paper, content.claims),
                           ours = claims_by(Claimant::us, content.claims);
  if (!papers.empty()) {
    text += "## Verdict\n\n" +
            markdown(claims_table(papers, "claims", fmt::format("{}", fmt::join(answers_of(content), " "))));
  }
  if (!ours.empty()) {
    text += "## Our own questions\n\n" + markdown(claims_table(ours, "questions", "Not claims of the paper."));
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
  text += verdict(content) + "## Summary\n\n";
  text += bullets(content.summary);
  if (!content.command.empty()) {
    text += fmt::format("To repeat this:\n\n    {}\n\n", one_line(content.command));
  }
  text +=
      "`tables/` has every table as Markdown, CSV (all digits) and LaTeX. `figures/` has the script and the data of every "
      "figure, and where gnuplot drew it SVG, PDF and PNG.\n\n";
  return text + markdown(content.circumstances) + markdown(content.results);
}

}  // namespace ikbench::report
