// What an article takes: paragraphs for Methods and Results, tables with captions that say of what, and an example that
// inputs all.
#include "analysis/show/article.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "analysis/show/answer_tables.hpp"
#include "analysis/show/page.hpp"
#include "analysis/show/publish.hpp"
#include "analysis/show/tell.hpp"
#include "analysis/show/text.hpp"
#include "analysis/show/words.hpp"
#include "base/files.hpp"
#include "base/json.hpp"
#include "base/names.hpp"

namespace ikbench::show {

using namespace judge;

namespace {

// "better, 35 points (5.45 to 61.1), p = 0.0469"
std::string told(const Finding& finding, const JudgedMetric& judged) {
  std::vector<std::string> parts{verdict_words(finding, judged), amount_words(finding, judged)};
  if (const auto [name, value] = effect_size(finding, judged); !name.empty() && !is_share(judged))
    parts.push_back(fmt::format("{} = {}", name, number_text(value)));
  if (p_of(finding)) parts.push_back(p_sentence(*p_of(finding), {judged.plan.significance}));
  std::erase(parts, "");
  return fmt::format("{}", fmt::join(parts, ", "));
}

// "McNemar's exact (n = 20 targets)", of each test.
std::string tests_of(const std::string& noun, const std::vector<Finding>& findings) {
  std::map<std::string, std::pair<int, int>> sizes;
  for (const Finding& finding : findings) {
    const auto* const tested = std::get_if<Tested>(&finding.what);
    if (tested == nullptr) continue;
    auto& [least, most] = sizes.try_emplace(std::string(tested->test), tested->n, tested->n).first->second;
    least = std::min(least, tested->n), most = std::max(most, tested->n);
  }
  std::vector<std::string> all;
  for (const auto& [test, n] : sizes)
    all.push_back(fmt::format("{} (n = {}{})", test, n.first == n.second ? "" : fmt::format("{} to ", n.first),
                              base::counted(n.second, noun)));
  return listed(all);
}

// The pairs of a metric: those of which all is alike together; of many how many are decided, and those of the
// reference.
std::string pairs_of(const Answer& answer, const JudgedMetric& judged) {
  const std::string tests = tests_of(noun_of(answer, judged), judged.findings), reference = reference_of(answer);
  ByWord pairs, beside;
  std::map<std::string_view, int> counts;
  for (const Finding& its : judged.findings) {
    const Verdict verdict = verdict_of(its);
    const bool is_first = its.first == reference;
    pairs.add(told(its, judged), fmt::format("{} against {}", its.first, its.second));
    ++counts[is_difference(verdict) ? "decided" : judge::name_of(verdict)];
    if (is_first || its.second == reference)
      beside.add(std::string(words_of(is_first ? verdict : turned(verdict)).of_pair),
                 is_first ? its.second : its.first);
  }
  std::vector<std::string> parts;
  for (const auto& [words, names] : pairs.all) parts.push_back(fmt::format("{}: {}", listed(names), words));
  if (judged.findings.size() > most_pairs) {
    for (parts.clear(); const auto& [verdict, count] : counts) parts.push_back(fmt::format("{} {}", count, verdict));
    parts = {fmt::format("{} pairs ({})", judged.findings.size(), listed(parts))};
    for (const std::string& of_reference : beside.told("{0} {1}")) parts.push_back(reference + ' ' + of_reference);
  }
  const std::string text = fmt::format("{}{}: {}.", judged.observations.quantity, tests.empty() ? "" : ", by " + tests,
                                       fmt::join(parts, "; "));
  return answer.direction.empty() ? as_sentence(text) : text;  // else its name is the user's
}

}  // namespace

Table for_article(const Table& whole, const Report& report) {
  Table table = whole;
  if (table.told > 0 && table.told < table.rows.size()) table.rows.resize(table.told);
  const std::vector<std::string> names = report.answer.solvers();
  const auto short_of = base::short_names({names.begin(), names.end()}, longest_name);
  for (auto& row : table.rows) {
    for (Cell& cell : row) {
      auto* const text = std::get_if<std::string>(&cell);
      if (const auto found = text ? short_of.find(*text) : short_of.end(); found != short_of.end())
        *text = found->second;
    }
  }
  const std::string& name = report.study.name;
  const bool is_of_study = !report.study.series.empty();
  if (!name.empty()) table.name = fmt::format("{}-{}", id_of(name), table.name);
  if (table.is_of_study && !name.empty())
    table.caption += fmt::format("{} {}.", table.caption.ends_with('?') ? "" : ".",
                                 is_of_study ? fmt::format("{}: {}. A solve ends at {}", title_of(report.study),
                                                           what_is_solved(report.study), stops_of(report.study))
                                             : std::filesystem::path(name).stem().string());
  return table;
}

std::string methods_of(const Answer& answer, const StudyResults& study, const std::string& program) {
  const results::Definition& definition = study.definition;
  const JudgedMetric& decisive = answer.decisive();
  const bool is_of_study = !study.series.empty();
  std::set<std::string> tests;
  for (const JudgedMetric& judged : answer.metrics) {
    for (const Finding& finding : judged.findings) {
      if (const auto* const tested = std::get_if<Tested>(&finding.what)) tests.insert(std::string(tested->test));
    }
  }
  const auto given = [](const std::set<std::string>& all) { return listed({all.begin(), all.end()}); };
  const std::int64_t runs = definition.runs;
  const std::string targets = definition.draws_targets ? base::counted(runs * definition.points, "targets")
                                                       : base::counted(definition.points, "targets") + " in each of " +
                                                             base::counted(runs, "runs");
  const auto fact = [&](const char* name) {
    const std::set<std::string> values = facts_of(study, name);
    return values.empty() ? "unknown" : given(values);
  };
  std::string text;
  std::set<std::string> populations;
  for (const results::Series& series : study.series) {
    const base::Json options = base::parsed_json(series.options);
    if (options.contains("population")) populations.insert(base::text_of(options["population"]));
  }
  if (is_of_study)
    text = fmt::format(
        "{} had {}{} ({}; search: {}) with the arm {}{}; each solve started {} and ended at {}; the machine was {}.",
        listed(study.labels), study.labels.size() > 1 ? "the same " : "", targets, with_blanks(definition.path),
        with_blanks(name_of(definition.search)), std::filesystem::path(definition.robot).stem().string(),
        populations.empty() ? "" : " and populations of " + given(populations),
        definition.is_chained() ? "at the last answer"
                                : "from its " + with_blanks(name_of(definition.start)) + " position",
        stops_of(study), fact("cpu"));
  else
    text = fmt::format("{} of {} were compared; {}. {}", base::counted(std::ssize(decisive.described), "groups"),
                       study.name, answer.direction, fmt::join(answer.notes, " "));
  if (!tests.empty())
    text += fmt::format(
        " Pairs were tested by {}, p times the number of pairs of a metric that can be tested (Bonferroni), at a "
        "significance of {}; a difference within {} does not matter.",
        given(tests), number_text(decisive.plan.significance), margin_words(decisive));
  return text + (is_of_study ? fmt::format(" Made with ikbench {} (commit {})", fact("version"), fact("commit"))
                             : " Made with " + program);
}

std::vector<std::string> results_of(const Answer& whole) {
  const Answer answer = with_short_names(whole, 2 * longest_name);
  std::vector<std::string> sentences{headline(answer)};
  const bool are_two = answer.decisive().described.size() == 2;
  const std::vector<Question> questions = questions_of(answer);
  for (const JudgedMetric& judged : answer.metrics) {
    if (!judged.findings.empty() && (are_two || std::ranges::count(questions, &judged, &Question::of) > 0))
      sentences.push_back(pairs_of(answer, judged));
  }
  if (const std::string decides = what_decides(answer); !decides.empty()) sentences.push_back(decides + '.');
  for (const Doubt& doubt : answer.all_doubts()) sentences.push_back(warning_of(doubt));
  std::erase(sentences, "");
  return sentences;
}

void write_article(const Report& report, const std::vector<std::string>& tables,
                   const std::vector<figures::Figure>& figures, const std::filesystem::path& folder,
                   const std::string& program) {
  const auto write = [&](const char* name, const std::string& text) {
    base::write_file(folder / "article" / name, text);
  };
  const std::string methods = methods_of(report.answer, report.study, program);
  std::vector<std::string> sentences, of_report = results_of(report.answer);
  for (const Block& block : report.first) {  // of a paper what repeats, before its table
    if (std::holds_alternative<Table>(block)) break;
    if (const auto* const heading = std::get_if<Heading>(&block)) sentences.push_back(heading->text);
    if (const auto* const text = std::get_if<std::string>(&block)) sentences.push_back(*text);
  }
  std::ranges::move(of_report, std::back_inserter(sentences));
  const std::string results = fmt::format("{}", fmt::join(sentences, " "));
  const auto& keys = report.keys;
  write("methods.tex", fmt::format("{}.{}{}{}\n", latex_text(methods), keys.empty() ? "" : " Solvers and arm: \\cite{",
                                   fmt::join(keys, ","), keys.empty() ? "" : "}."));
  write("results.tex", latex_text(results) + '\n');
  if (!keys.empty()) write("references.bib", std::string(report.references));
  std::string floats;
  for (const std::string& table : tables) floats += fmt::format("\\input{{\\report/tables/{}}}\n", table);
  for (const figures::Figure& figure : figures) {
    const std::vector<std::string> types = types_of(figure, folder);
    if (types.empty() || types.back() == "svg") continue;  // which LaTeX cannot draw
    floats += fmt::format(
        "\\begin{{figure{0}}}\n\\centering\n\\includegraphics[width=\\linewidth]{{{1}}}\n\\caption{{{2}}}\\label{{fig:{1}}}\n"
        "\\end{{figure{0}}}\n",
        figure.width_cm > 12 ? "*" : "", figure.name, latex_text(figure.caption));
  }
  write("main.tex",
        filled_template(
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
