// Writes what an article takes from a report: paragraphs for Methods and Results, tables whose captions name the study,
// and an example that inputs all of them.
#include "analysis/show/article.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <regex>

#include "analysis/show/hard_targets.hpp"
#include "analysis/show/methods_paragraph.hpp"
#include "analysis/show/page.hpp"
#include "analysis/show/phrases.hpp"
#include "analysis/show/publish.hpp"
#include "analysis/show/result_tables.hpp"
#include "analysis/show/results_paragraph.hpp"
#include "analysis/show/text.hpp"
#include "base/files.hpp"

namespace ikbench::show {

namespace {

// Returns sentences as LaTeX, in which the symbols of statistics are set as such.
std::string latex_paragraph(const std::vector<std::string>& sentences) {
  static const std::array<std::pair<std::regex, const char*>, 4> symbols{
      {{std::regex(R"(\bp = ([0-9.]{0,30}[0-9]))"), "$$p = $1$$"},
       {std::regex(R"(\bp \\textless\{\} ([0-9.]{0,30}[0-9]))"), "$$p < $1$$"},
       {std::regex(R"(\bA12 (?==|is the share))"), "$$A_{12}$$ "},
       {std::regex(R"(\bg\\_av(?= =|, Hedges))"), "$$g_{\\mathrm{av}}$$"}}};
  std::string text = latex_text(fmt::format("{}", fmt::join(sentences, " ")));
  for (const auto& [symbol, in_latex] : symbols) text = std::regex_replace(text, symbol, in_latex);
  return text;
}

// Returns what a repeated paper says before its table, as a paragraph of its own; empty for another report.
std::string lead_paragraph(const Report& report) {
  std::vector<std::string> sentences;
  for (const Block& block : report.lead) {
    if (std::holds_alternative<Table>(block)) break;
    if (const auto* const heading = std::get_if<Heading>(&block)) sentences.push_back(heading->text);
    if (const auto* const text = std::get_if<std::string>(&block)) sentences.push_back(*text);
  }
  return sentences.empty() ? "" : latex_paragraph(sentences) + "\n\n";
}

// Returns the results, and what is said of hard targets if there is room.
std::vector<std::string> results_with_hard_targets(const Report& report) {
  std::vector<std::string> sentences = results_sentences(report.model);
  if (report.model.hard_targets && sentences.size() < max_result_sentences)
    sentences.push_back(hard_targets_sentence(*report.model.hard_targets));
  return sentences;
}

// Returns the sentence that names the table of pairs; empty if there is none.
std::string pairs_reference(const Report& report) {
  const std::string predicate = pairs_predicate(report.model);
  if (predicate.empty()) return "";
  return fmt::format(" Table~\\ref{{tab:{}}} {}.", article_table(pairs_table(report.model), report).name,
                     latex_text(predicate));
}

}  // namespace

Table article_table(const Table& whole, const Report& report) {
  Table table = whole;
  if (table.visible_rows > 0 && table.visible_rows < table.rows.size()) table.rows.resize(table.visible_rows);
  const std::string& name = report.study.name;
  if (!name.empty()) table.name = fmt::format("{}-{}", anchor_id(name), table.name);
  if (table.is_of_study && !name.empty())
    table.caption += fmt::format(
        "{} {}", table.caption.ends_with('?') ? "" : ".",
        report.model.study_text.empty() ? std::filesystem::path(name).stem().string() + '.' : report.model.study_text);
  return table;
}

void write_article(const Report& report, const std::vector<std::string>& tables,
                   const std::vector<figures::Figure>& figures, const std::filesystem::path& folder,
                   const std::string& program) {
  const auto write = [&](const char* name, const std::string& text) {
    base::write_file(folder / "article" / name, text);
  };
  const auto& keys = report.citation_keys;
  write("methods.tex", fmt::format("{}{} {}\n", latex_paragraph(methods_sentences(report)),
                                   keys.empty() ? ""
                                                : fmt::format(" Solvers and the arm are described in~\\cite{{{}}}.",
                                                              fmt::join(keys, ",")),
                                   latex_text(methods_bracket(report, program))));
  write("results.tex", fmt::format("{}{}{}\n", lead_paragraph(report),
                                   latex_paragraph(results_with_hard_targets(report)), pairs_reference(report)));
  if (!keys.empty()) write("references.bib", std::string(report.references));
  std::string floats;
  for (const std::string& table : tables) floats += fmt::format("\\input{{\\report/tables/{}}}\n", table);
  for (const figures::Figure& figure : figures) {
    const std::vector<std::string> types = picture_formats_of(figure, folder);
    if (types.empty() || types.back() == "svg") continue;  // LaTeX cannot draw SVG
    floats += fmt::format(
        "\\begin{{figure{0}}}\n\\centering\n\\includegraphics[width=\\linewidth]{{{1}}}\n\\caption{{{2}}}\\label{{fig:{1}}}\n"
        "\\end{{figure{0}}}\n",
        figure.width_cm > 12 ? "*" : "", figure.name, latex_text(figure.caption));
  }
  write("main.tex",
        fill_template(
            "main.tex",
            {{"program", program},
             {"commands", keys.empty() ? "pdflatex main, or xelatex main"
                                       : "pdflatex main, bibtex main, pdflatex main, pdflatex main, or with xelatex"},
             {"title", latex_text(title_of(report.study))},
             {"floats", floats},
             {"bibliography",
              keys.empty() ? "" : "\\bibliographystyle{plain}\n\\bibliography{\\report/article/references}\n"}}));
}

}  // namespace ikbench::show
