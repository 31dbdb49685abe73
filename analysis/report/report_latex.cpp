#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "analysis/inference/text.hpp"
#include "analysis/report/report_content.hpp"

namespace ikbench::report {

using namespace inference;

namespace {

constexpr std::string_view article_preamble =
    R"(% Compile it here, where tables/ and figures/ are: ikbench article ., or pdflatex article.tex, twice. Letters that pdflatex
% lacks need lualatex, and a font that has them.
\documentclass[a4paper]{article}
\usepackage{iftex}
\ifLuaTeX
\usepackage{fontspec}
\usepackage[english,bidi=basic]{babel}
\def\letterfonts{}
\newcommand*\letterfont[1]{\IfFontExistsTF{#1}{\edef\letterfonts{\letterfonts"#1:mode=node;script=arab;",}}{}}
\letterfont{DejaVu Sans}\letterfont{Noto Sans CJK JP}\letterfont{Noto Sans}
\directlua{luaotfload.add_fallback("letters", {\letterfonts})}
\setmainfont{Latin Modern Roman}[RawFeature={fallback=letters}]
\setmonofont{Latin Modern Mono}[RawFeature={fallback=letters}]
\else
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\fi
\usepackage[margin=2.5cm]{geometry}
\usepackage{booktabs,array,adjustbox,rotating,longtable,graphicx,placeins}
\makeatletter\def\fps@table{!htbp}\def\fps@figure{!htbp}\makeatother  % tables and figures where they are named
)";

// Names may be longer than a line; other words have hyphens where LaTeX puts them.
std::string prose(std::string_view text) {
  constexpr std::size_t longest_word = 24;
  return breakable_latex(text, longest_word);
}

std::string latex_paragraph(const std::vector<std::string>& sentences) {
  return prose(fmt::format("{}", fmt::join(sentences, " "))) + "\n\n";
}

std::string items(const std::vector<std::string>& sentences) {
  std::string text = "\\begin{itemize}\n";
  for (const std::string& sentence : sentences) text += fmt::format("\\item {}\n", prose(sentence));
  return sentences.empty() ? "" : text + "\\end{itemize}\n\n";
}

std::string latex(const Table& table) { return fmt::format("\\input{{tables/{}.tex}}\n", table.name); }

std::string latex(const ReportFigure& piece) {
  if (std::ranges::count(piece.types, "pdf") == 0)
    return fmt::format("% figures/{}.pdf is not drawn\n", piece.figure.name);
  return fmt::format(
      "\\begin{{figure}}\n\\centering\n\\includegraphics[width=\\linewidth,height=0.4\\textheight,keepaspectratio]"
      "{{figures/{}.pdf}}\n\\caption{{{}}}\n\\end{{figure}}\n",
      piece.figure.name, prose(piece.figure.caption));
}

std::string latex(const Piece& piece) {
  return std::visit([](const auto& shown) { return latex(shown); }, piece);
}

std::string latex(const std::vector<Section>& sections, const ReportContent& content) {
  std::string text;
  for (const Section& section : sections) {
    if (section.pieces.empty()) continue;
    text += fmt::format("\\subsection{{{}}}\n", latex_text(section.heading));
    if (!section.paragraph.empty()) text += prose(section.paragraph) + "\n\n";
    for (const Piece& piece : section.pieces) {
      if (const std::string seen = seen_at(piece, content); !seen.empty()) text += prose(seen) + "\n\n";
      text += latex(piece);
    }
    text += "\\FloatBarrier\n";
  }
  return text;
}

std::string claims(const ReportContent& content) {
  std::string text;
  for (const auto& [by, name, caption] : {std::tuple(Claimant::paper, "claims", "The claims of the paper"),
                                          std::tuple(Claimant::us, "questions", "Our own questions")}) {
    const std::vector<Claim> these = claims_by(by, content.claims);
    if (!these.empty()) text += to_latex(claims_table(these, name, caption, EvidenceShown::first_sentence));
  }
  return text.empty() ? "" : "\\subsection{Claims}\n" + text + "\\FloatBarrier\n";
}

}  // namespace

std::string to_article(const ReportContent& content) {
  std::string text(article_preamble);
  text +=
      fmt::format("\\title{{{}}}\n\\author{{}}\n\\begin{{document}}\n\\sloppy\\emergencystretch=10em\n\\maketitle\n",
                  latex_text(content.title));
  text += "\\begin{abstract}\n" + latex_paragraph(answers_of(content)) + "\\end{abstract}\n\n";
  text += "\\section{Experimental set-up}\n" + latex_paragraph(content.set_up);
  text += "\\section{Results}\n" + claims(content) + latex(content.results, content);
  if (const Piece* const status = piece_named(content, "status")) {
    text += "\\section{Flow of solves}\n" + latex(*status) + "\\FloatBarrier\n";
  }
  if (!content.warnings.empty()) text += "\\section{Limitations}\n" + items(list_of(content.warnings));
  text += "\\section{Data availability}\n";
  text +=
      "All solves are in \\texttt{store.sqlite}, all tables in \\texttt{tables/}, and the scripts and data of all "
      "figures in \\texttt{figures/}.";
  if (!content.command.empty()) {
    text += fmt::format(
        " The command\n\\begin{{quote}}\\raggedright\\texttt{{{}}}\\end{{quote}}\nrepeats the study, and "
        "\\texttt{{ikbench fingerprint}} says whether the numbers are the same.",
        prose(content.command));
  }
  return text + "\n\n\\end{document}\n";
}

}  // namespace ikbench::report
