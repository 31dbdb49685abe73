// What an article takes: paragraphs for Methods and Results, tables with captions that say of what, and an example that
// inputs all.
#include "analysis/show/article.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "analysis/show/headline.hpp"
#include "analysis/show/page.hpp"
#include "analysis/show/phrases.hpp"
#include "analysis/show/publish.hpp"
#include "analysis/show/text.hpp"
#include "base/files.hpp"
#include "base/names.hpp"

namespace ikbench::show {

using namespace judge;

namespace {

// "DLS against PSO: better, A12 = 0.75, p = 0.0469"
std::string told(const Comparison& its, const JudgedMetric& judged) {
  std::string text = fmt::format("{} against {}: {}", its.first, its.second, comparison_text(its, judged));
  const auto* const tested = std::get_if<TestResult>(&its.result);
  if (tested && tested->hedges_g)
    text += fmt::format(", {} = {}", judged.samples.is_paired ? "g_av" : "g", number_text(*tested->hedges_g));
  else if (tested && tested->dominance && !is_success_rate(judged))
    text += fmt::format(", A12 = {}", number_text(tested->dominance->a12()));
  const std::string p = tested ? p_text(tested->adjusted_p, {judged.plan.significance}) : "";
  return text + (p.empty() ? "" : p[0] == '<' ? ", p " + p : ", p = " + p);
}

// The pairs of a metric, if few, else how many have each verdict, and by which tests.
std::string pairs_of(const ReportModel& answer, const JudgedMetric& judged) {
  std::map<std::string_view, int> counts;
  std::set<std::string> tests;
  std::set<int> sizes;
  std::vector<std::string> parts;
  for (const Comparison& its : judged.comparisons) {
    const Verdict verdict = verdict_of(its);
    ++counts[is_difference(verdict) ? "decided" : judge::name_of(verdict)];
    if (judged.comparisons.size() <= max_pairs) parts.push_back(told(its, judged));
    if (const auto* const tested = std::get_if<TestResult>(&its.result))
      tests.insert(std::string(tested->test)), sizes.insert(tested->n);
  }
  if (parts.empty()) {
    for (const auto& [verdict, count] : counts) parts.push_back(fmt::format("{} {}", count, verdict));
    parts = {fmt::format("{} pairs ({})", judged.comparisons.size(), listed(parts))};
  }
  const std::string by = sizes.empty() ? ""
                                       : fmt::format(", by {} (n = {}{})", listed({tests.begin(), tests.end()}),
                                                     sizes.size() == 1 ? "" : fmt::format("{} to ", *sizes.begin()),
                                                     base::counted(*sizes.rbegin(), observation_noun(answer, judged)));
  const std::string text = fmt::format("{}{}: {}.", judged.samples.quantity, by, fmt::join(parts, "; "));
  return answer.direction.empty() ? as_sentence(text) : text;  // else its name is the user's
}

}  // namespace

Table article_table(const Table& whole, const Report& report) {
  Table table = whole;
  if (table.visible_rows > 0 && table.visible_rows < table.rows.size()) table.rows.resize(table.visible_rows);
  const std::string& name = report.study.name;
  if (!name.empty()) table.name = fmt::format("{}-{}", anchor_id(name), table.name);
  if (table.is_of_study && !name.empty())
    table.caption += fmt::format("{} {}", table.caption.ends_with('?') ? "" : ".",
                                 report.answer.study_text.empty() ? std::filesystem::path(name).stem().string() + '.'
                                                                  : report.answer.study_text);
  return table;
}

std::string methods_paragraph(const Report& report, const std::string& program) {
  const ReportModel& answer = report.answer;
  const bool is_of_file = report.study.series.empty();
  std::vector<std::string> facts, sentences;
  for (const Table& table : setup_tables(report))
    for (const auto& row : table.rows)
      facts.push_back(fmt::format("{}: {}", std::get<std::string>(row[0]), std::get<std::string>(row[1])));
  if (is_of_file) {
    sentences.push_back(fmt::format("{} of {} were compared; {}",
                                    base::counted(std::ssize(answer.primary().descriptives), "groups"),
                                    report.study.name, answer.direction));
    sentences.insert(sentences.end(), answer.notes.begin(), answer.notes.end());
  } else {
    sentences.push_back(listed(report.study.labels) + " were compared");
  }
  sentences.push_back(as_sentence(fmt::format("{}", fmt::join(facts, "; "))));
  sentences.push_back("Made with " + program);
  std::erase(sentences, "");
  for (std::string& sentence : sentences)
    if (sentence.ends_with('.')) sentence.pop_back();  // as notes do
  return fmt::format("{}", fmt::join(sentences, ". "));
}

std::vector<std::string> results_sentences(const ReportModel& answer) {
  std::vector<std::string> sentences{headline(answer)};
  const bool are_two = answer.primary().descriptives.size() == 2;
  for (const JudgedMetric& judged : answer.metrics) {
    if (!judged.comparisons.empty() && (are_two || answer.is_in_headline(judged)))
      sentences.push_back(pairs_of(answer, judged));
  }
  if (const std::string decides = ranking_note(answer); !decides.empty()) sentences.push_back(decides + '.');
  for (const Warning& warning : answer.all_warnings()) sentences.push_back(warning_sentence(warning));
  std::erase(sentences, "");
  return sentences;
}

void write_article(const Report& report, const std::vector<std::string>& tables,
                   const std::vector<figures::Figure>& figures, const std::filesystem::path& folder,
                   const std::string& program) {
  const auto write = [&](const char* name, const std::string& text) {
    base::write_file(folder / "article" / name, text);
  };
  const std::string methods = methods_paragraph(report, program);
  std::vector<std::string> sentences, of_report = results_sentences(report.answer);
  for (const Block& block : report.lead) {  // of a paper what repeats, before its table
    if (std::holds_alternative<Table>(block)) break;
    if (const auto* const heading = std::get_if<Heading>(&block)) sentences.push_back(heading->text);
    if (const auto* const text = std::get_if<std::string>(&block)) sentences.push_back(*text);
  }
  std::ranges::move(of_report, std::back_inserter(sentences));
  const std::string results = fmt::format("{}", fmt::join(sentences, " "));
  const auto& keys = report.citation_keys;
  write("methods.tex", fmt::format("{}.{}{}{}\n", latex_text(methods), keys.empty() ? "" : " Solvers and arm: \\cite{",
                                   fmt::join(keys, ","), keys.empty() ? "" : "}."));
  write("results.tex", latex_text(results) + '\n');
  if (!keys.empty()) write("references.bib", std::string(report.references));
  std::string floats;
  for (const std::string& table : tables) floats += fmt::format("\\input{{\\report/tables/{}}}\n", table);
  for (const figures::Figure& figure : figures) {
    const std::vector<std::string> types = picture_formats_of(figure, folder);
    if (types.empty() || types.back() == "svg") continue;  // which LaTeX cannot draw
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
