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
#include "analysis/show/text.hpp"
#include "analysis/show/words.hpp"
#include "base/files.hpp"
#include "base/json.hpp"
#include "base/names.hpp"

namespace ikbench::show {

using namespace judge;

namespace {

// "DLS against PSO: better, 35 points (5.45 to 61.1), p = 0.0469"
std::string told(const Finding& finding, const JudgedMetric& judged) {
  std::vector<std::string> parts{verdict_words(finding, judged), amount_words(finding, judged)};
  if (const auto [name, value] = effect_size(finding, judged); !name.empty() && !is_share(judged))
    parts.push_back(fmt::format("{} = {}", name, number_text(value)));
  if (p_of(finding)) parts.push_back(p_sentence(*p_of(finding), {judged.plan.significance}));
  std::erase(parts, "");
  return fmt::format("{} against {}: {}", finding.first, finding.second, fmt::join(parts, ", "));
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

std::string at_once(const JudgedMetric& judged) {
  const auto [tests, without, equal] = tests_of_all(judged.observations);
  std::vector<std::string> all;
  for (const TestOfAll& test : tests) {
    const bool is_f = !std::isnan(test.df_within);
    all.push_back(fmt::format(
        "{}: {} = {}, df = {:g}{}, {}{}", test.name, is_f ? "F" : "chi-squared", number_text(test.statistic), test.df,
        is_f ? fmt::format(" and {:g}", test.df_within) : "", p_sentence(test.p, {judged.plan.significance}),
        std::isnan(test.ss_between)
            ? ""
            : fmt::format(", partial eta squared = {}", number_text(test.partial_eta_squared()))));
  }
  if (all.empty()) return "";
  return fmt::format("All at once{}: {}.", without.empty() ? "" : ", without " + names_of(without),
                     fmt::join(all, "; "));
}

// The pairs of a metric: all, or of many how many are decided, and those of the reference, of many with their ends.
std::string pairs_of(const Answer& answer, const JudgedMetric& judged) {
  constexpr std::array<std::string_view, 5> words{"is better than", "is worse than", "is the same as",
                                                  "is not decided against", "is not tested against"};
  std::vector<Finding> findings = judged.findings;
  const std::string tests = tests_of(noun_of(answer, judged), findings), reference = reference_of(answer);
  std::vector<std::string> parts, counts, names;
  if (findings.size() > most_pairs) {
    std::map<std::string_view, int> by_verdict;
    for (const Finding& its : findings)
      ++by_verdict[is_difference(verdict_of(its)) ? "decided" : judge::name_of(verdict_of(its))];
    for (const auto& [verdict, count] : by_verdict) counts.push_back(fmt::format("{} {}", count, verdict));
    parts.push_back(fmt::format("{} pairs ({})", findings.size(), listed(counts, ", ")));
    std::erase_if(findings, [&](const Finding& its) { return its.first != reference && its.second != reference; });
  }
  if (findings.size() > most_pairs) {
    std::map<Verdict, std::vector<std::string>> others;
    for (const Finding& its : findings) {
      const bool is_first = its.first == reference;
      others[is_first ? verdict_of(its) : turned(verdict_of(its))].push_back(is_first ? its.second : its.first);
    }
    for (const auto& [verdict, who] : others)
      parts.push_back(fmt::format("{} {} {}", reference, words[static_cast<std::size_t>(verdict)], listed(who)));
    std::erase_if(findings, [](const Finding& its) { return !is_difference(verdict_of(its)) || !amount_of(its); });
    const auto [least, most] = std::ranges::minmax_element(findings, {}, [](const Finding& its) {
      const double value = amount_of(its)->value;
      return std::abs(its.scale == Scale::ratio ? std::log(value) : value);
    });
    if (!findings.empty()) parts.push_back("the least estimate, " + told(*least, judged));
    if (findings.size() > 1) parts.push_back("the largest, " + told(*most, judged));
    findings.clear();
  }
  for (const Finding& finding : findings) parts.push_back(told(finding, judged));
  std::string text = fmt::format("{}{}: {}.", judged.observations.quantity, tests.empty() ? "" : ", by " + tests,
                                 fmt::join(parts, "; "));
  return answer.direction.empty() ? as_sentence(text) : text;  // else its name is the user's
}

}  // namespace

Table for_article(const Table& whole, const Report& report) {
  Table table = whole.in_article.empty() ? whole : whole.in_article.front();
  for (std::size_t c = 0; c < table.columns.size(); ++c) {  // writers leave out what is empty
    if (table.columns[c].role != Role::remark) continue;
    for (auto& row : table.rows) row[c] = {};
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
  for (const JudgedMetric& judged : answer.metrics) {
    if (!judged.findings.empty() && (are_two || &judged == &answer.decisive()))
      sentences.push_back(pairs_of(answer, judged));
  }
  sentences.push_back(are_two ? what_decides(answer) : at_once(answer.decisive()));
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
