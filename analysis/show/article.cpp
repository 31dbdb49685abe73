// Writes what an article takes from a report: paragraphs for Methods and Results, tables whose captions name the study,
// and an example that inputs all of them.
#include "analysis/show/article.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "analysis/show/hard_targets.hpp"
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

// Returns "DLS against PSO: better, A12 = 0.75, p = 0.0469".
std::string pair_text(const Comparison& comparison, const JudgedMetric& judged) {
  std::string text =
      fmt::format("{} against {}: {}", comparison.first, comparison.second, comparison_text(comparison, judged));
  const auto* const tested = std::get_if<TestResult>(&comparison.result);
  if (!tested) return text;
  if (tested->hedges_g)
    text += fmt::format(", {} = {}", judged.samples.is_paired ? "g_av" : "g", number_text(*tested->hedges_g));
  else if (tested->dominance && !is_success_rate(judged))
    text += fmt::format(", A12 = {}", number_text(tested->dominance->a12()));
  const std::string p = p_text(tested->adjusted_p, {judged.plan.significance});
  return text + (p[0] == '<' ? ", p " : ", p = ") + p;
}

// Returns " by signed ranks (n = 5 to 20 targets)".
std::string tests_text(const std::set<std::string>& tests, const std::set<int>& sizes, const std::string& noun) {
  if (sizes.empty()) return "";
  const std::string smallest = sizes.size() == 1 ? "" : fmt::format("{} to ", *sizes.begin());
  return fmt::format(", by {} (n = {}{})", listed({tests.begin(), tests.end()}), smallest,
                     base::counted(*sizes.rbegin(), noun));
}

// Returns a sentence about the pairs of a metric: each pair, or how often each verdict is if the pairs are many.
std::string pairs_sentence(const ReportModel& model, const JudgedMetric& judged) {
  std::map<std::string_view, int> counts;
  std::set<std::string> tests;
  std::set<int> sizes;
  std::vector<std::string> parts;
  for (const Comparison& comparison : judged.comparisons) {
    const Verdict verdict = verdict_of(comparison);
    ++counts[is_difference(verdict) ? "decided" : judge::name_of(verdict)];
    if (judged.comparisons.size() <= max_pairs) parts.push_back(pair_text(comparison, judged));
    if (const auto* const tested = std::get_if<TestResult>(&comparison.result)) {
      tests.insert(std::string(tested->test));
      sizes.insert(tested->n);
    }
  }
  if (parts.empty()) {
    for (const auto& [verdict, count] : counts) parts.push_back(fmt::format("{} {}", count, verdict));
    parts = {fmt::format("{} pairs ({})", judged.comparisons.size(), listed(parts))};
  }
  const std::string text =
      fmt::format("{}{}: {}.", judged.samples.quantity, tests_text(tests, sizes, observation_noun(model, judged)),
                  fmt::join(parts, "; "));
  return model.direction.empty() ? as_sentence(text) : text;  // a user's name of a metric keeps its first letter
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

std::string methods_paragraph(const Report& report, const std::string& program) {
  const ReportModel& model = report.model;
  const bool is_of_file = report.study.series.empty();
  std::vector<std::string> facts, sentences;
  for (const Table& table : setup_tables(report))
    for (const auto& row : table.rows)
      facts.push_back(fmt::format("{}: {}", std::get<std::string>(row[0]), std::get<std::string>(row[1])));
  if (is_of_file) {
    sentences.push_back(fmt::format("{} of {} were compared; {}",
                                    base::counted(std::ssize(model.primary().descriptives), "groups"),
                                    report.study.name, model.direction));
    sentences.insert(sentences.end(), model.notes.begin(), model.notes.end());
  } else {
    sentences.push_back(listed(report.study.labels) + " were compared");
  }
  sentences.push_back(as_sentence(fmt::format("{}", fmt::join(facts, "; "))));
  sentences.push_back("Made with " + program);
  std::erase(sentences, "");
  for (std::string& sentence : sentences)
    if (sentence.ends_with('.')) sentence.pop_back();  // the join adds full stops
  return fmt::format("{}", fmt::join(sentences, ". "));
}

std::vector<std::string> results_sentences(const ReportModel& model) {
  std::vector<std::string> sentences{headline(model)};
  if (model.hard_targets) sentences.push_back(hard_targets_sentence(*model.hard_targets));
  const bool are_two = model.primary().descriptives.size() == 2;
  for (const JudgedMetric& judged : model.metrics) {
    if (!judged.comparisons.empty() && (are_two || model.is_in_headline(judged)))
      sentences.push_back(pairs_sentence(model, judged));
  }
  if (const std::string ranking = ranking_note(model); !ranking.empty()) sentences.push_back(ranking + '.');
  for (const Warning& warning : model.all_warnings()) sentences.push_back(warning_sentence(warning));
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
  std::vector<std::string> sentences, of_report = results_sentences(report.model);
  for (const Block& block : report.lead) {  // what a repeated paper says before the table
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
