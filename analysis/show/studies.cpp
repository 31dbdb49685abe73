#include "analysis/show/studies.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "analysis/show/headline.hpp"
#include "analysis/show/phrases.hpp"
#include "analysis/show/requirements.hpp"
#include "analysis/show/result_tables.hpp"
#include "analysis/show/text.hpp"
#include "base/json.hpp"
#include "base/names.hpp"

namespace ikbench::show {

using namespace judge;

namespace {

constexpr std::size_t max_interval_columns = 4;  // wider tables leave the intervals out
constexpr std::size_t max_reversed_pairs = 3;    // named in a headline
constexpr std::size_t max_warnings = 5;          // on a screen

using Names = std::vector<std::string>;

// The difference that the first metric of a study decides.
struct Outcome {
  bool is_nothing_solved = false, is_tested = false;
  std::string metric, reference;
  Names losers = {};  // solvers that are worse than the reference, in the order of the table

  // Returns whether another study decides the same, whatever the order of its losers.
  bool is_like(const Outcome& other) const {
    return is_nothing_solved == other.is_nothing_solved && is_tested == other.is_tested && metric == other.metric &&
           reference == other.reference && std::ranges::is_permutation(losers, other.losers);
  }
};

Outcome outcome_of(const ReportModel& model) {
  const JudgedMetric& primary = model.primary();
  Outcome outcome{.metric = primary.samples.quantity, .reference = reference_of(model)};
  const auto is_unsolved = [&](const JudgedMetric& judged) {
    return judged.samples.quantity_kind == QuantityKind::solved &&
           std::ranges::all_of(judged.descriptives, [](const Descriptives& shares) { return shares.mean == 0; });
  };
  outcome.is_nothing_solved = std::ranges::any_of(model.metrics, is_unsolved);
  const PairIndex pairs(primary, model.solvers());
  for (const std::string& solver : model.solvers()) {
    outcome.is_tested |= pairs.tested_pairs(solver) > 0;
    if (solver != outcome.reference && pairs.is_better(outcome.reference, solver)) outcome.losers.push_back(solver);
  }
  return outcome;
}

// The words for the studies of a report.
struct PlaceWords {
  std::string preposition, things;
  std::string key = {};  // before the values
};

PlaceWords place_words(const StudiesReport& report) {
  if (report.keys.size() != 1) return {.preposition = "in", .things = "studies"};
  const std::string& key = report.keys.front();
  if (key == "robot") return {.preposition = "on", .things = "arms"};
  return {.preposition = "at", .things = "values of " + key, .key = key + " = "};
}

// Returns where a sentence holds: "on ur5e and franka_panda", "at near_deg = 1 and 10", "in all 28 studies".
std::string place_text(const StudiesReport& report, const Names& names) {
  const PlaceWords words = place_words(report);
  const bool are_all = names.size() == report.columns.size();
  if (names.size() <= max_named && !(are_all && names.size() > 2))
    return fmt::format("{} {}{}", words.preposition, words.key, listed(names));
  if (are_all) return fmt::format("{} all {} {}", words.preposition, names.size(), words.things);
  return fmt::format("{} {} of the {} {}", words.preposition, names.size(), report.columns.size(), words.things);
}

// Returns a solver with its number: "LM (94 %)".
std::string with_number(const ReportModel& model, const std::string& solver) {
  const JudgedMetric& primary = model.primary();
  const BoundedValue shown = displayed_average(primary, index_of(primary.samples, solver));
  if (std::isnan(shown.value)) return solver;
  const std::string number = number_within(shown.value, percent_boundaries(primary));
  return fmt::format("{} ({}{})", solver, shown.is_bound ? "at most " : "", with_unit(number, primary.samples.unit));
}

// Returns the clause of an outcome. `only` is the study of the outcome, whose numbers are named; null if there are
// several such studies.
std::string clause(const Outcome& outcome, const ReportModel* only, bool names_metric) {
  if (outcome.losers.empty() && outcome.is_nothing_solved) return "no solver reached any target";
  if (outcome.losers.empty()) return outcome.is_tested ? "no difference is shown" : "no pair is tested";
  const bool has_numbers = only != nullptr && outcome.losers.size() < max_named;
  Names losers = outcome.losers;
  if (has_numbers)
    for (std::string& loser : losers) loser = with_number(*only, loser);
  const std::string reference = has_numbers ? with_number(*only, outcome.reference) : outcome.reference;
  return fmt::format("{}{} {} worse than {}{}", outcome.is_nothing_solved ? "no solver reached any target, and " : "",
                     names_of(losers), losers.size() == 1 ? "is" : "are", reference,
                     names_metric ? " in " + outcome.metric : "");
}

// The studies of an outcome.
struct OutcomeGroup {
  Outcome outcome;
  Names names = {};
  const ReportModel* model = nullptr;  // of the first study
};

// Returns the outcomes with their studies: outcomes with a difference first.
std::vector<OutcomeGroup> outcome_groups(const StudiesReport& report) {
  std::vector<OutcomeGroup> groups;
  for (const StudyColumn& column : report.columns) {
    Outcome outcome = outcome_of(column.model);
    if (outcome.losers.empty()) outcome.reference.clear();  // says nothing then
    auto group =
        std::ranges::find_if(groups, [&](const OutcomeGroup& known) { return known.outcome.is_like(outcome); });
    if (group == groups.end())
      group = groups.insert(group, OutcomeGroup{.outcome = std::move(outcome), .model = &column.model});
    group->names.push_back(column.name);
  }
  std::ranges::stable_partition(groups, [](const OutcomeGroup& group) { return !group.outcome.losers.empty(); });
  return groups;
}

// Returns "The order changes: A is better than B at 1, and B is better than A at 10."; empty if no two studies decide
// opposite differences.
std::string reversals_text(const StudiesReport& report) {
  std::map<std::pair<std::string, std::string>, Names> winners;  // studies, by the better solver and the worse one
  for (const StudyColumn& column : report.columns) {
    for (const Comparison& comparison : column.model.primary().comparisons) {
      if (verdict_of(comparison) == Verdict::better)
        winners[{comparison.first, comparison.second}].push_back(column.name);
      if (verdict_of(comparison) == Verdict::worse)
        winners[{comparison.second, comparison.first}].push_back(column.name);
    }
  }
  Names texts;
  std::size_t more = 0;
  for (const auto& [pair, names] : winners) {
    const auto& [first, second] = pair;
    const auto opposite = winners.find({second, first});
    if (opposite == winners.end() || second < first) continue;
    if (texts.size() == max_reversed_pairs) {
      ++more;
      continue;
    }
    texts.push_back(fmt::format("{0} is better than {1} {2}, and {1} is better than {0} {3}", first, second,
                                place_text(report, names), place_text(report, opposite->second)));
  }
  if (texts.empty()) return "";
  const std::string rest = more == 0 ? "" : fmt::format("; so do {}", base::counted(std::int64_t(more), "more pairs"));
  return fmt::format(" The order changes: {}{}.", fmt::join(texts, "; "), rest);
}

// Returns the table with a row per study. All studies must have the same unit.
Table transposed(const Table& studies, const std::string& key) {
  Table turned{.name = studies.name, .caption = studies.caption, .columns = {{key}}, .notes = studies.notes};
  turned.is_of_study = false;
  for (std::size_t c = 1; c < studies.columns.size(); ++c) turned.rows.push_back({studies.columns[c].name});
  for (const auto& row : studies.rows) {
    turned.columns.push_back({.name = std::get<std::string>(row[0]), .unit = studies.columns[1].unit});
    for (std::size_t c = 1; c < row.size(); ++c) turned.rows[c - 1].push_back(row[c]);
  }
  return turned;
}

// Returns " (p < 0.05, corrected)"; empty if the studies have several significances.
std::string tests_text(const StudiesReport& report) {
  const auto significance_of = [](const StudyColumn& column) { return column.model.primary().plan.significance; };
  const double significance = significance_of(report.columns.front());
  if (std::ranges::count(report.columns, significance, significance_of) < std::ssize(report.columns)) return "";
  const bool is_corrected = std::ranges::any_of(report.columns, [](const StudyColumn& column) {
    return column.model.order.size() > 2 || column.model.named_metrics > 1;
  });
  return fmt::format(" (p < {}{})", number_text(significance), is_corrected ? ", corrected" : "");
}

// Returns "Brackets: 95 % intervals" if a share has an interval, "Brackets: quartiles" for other numbers.
std::string intervals_text(const Table& table, const StudiesReport& report) {
  const auto has_interval = [](const Cell& cell) {
    const auto* const value = std::get_if<ValueCell>(&cell);
    return value != nullptr && value->interval.has_value();
  };
  const bool has_any =
      std::ranges::any_of(table.rows, [&](const auto& row) { return std::ranges::any_of(row, has_interval); });
  if (!has_any) return "";
  const auto is_share = [](const StudyColumn& column) { return is_success_rate(column.model.primary()); };
  if (std::ranges::none_of(report.columns, is_share)) return "Brackets: quartiles";
  const std::string shares = std::ranges::all_of(report.columns, is_share) ? "" : " of shares, otherwise quartiles";
  return fmt::format("Brackets: {:.3g} % intervals{}",
                     100 * (1 - report.columns.front().model.primary().plan.significance), shares);
}

// Returns the warnings of all studies, each with the studies that have it.
Names warnings_of(const StudiesReport& report) {
  NamesByPhrase warnings;
  for (const StudyColumn& column : report.columns)
    for (const Warning& warning : column.model.all_warnings()) warnings.add(warning_sentence(warning), column.name);
  Names texts;
  for (const auto& [sentence, names] : warnings.entries)
    texts.push_back(names.size() == report.columns.size()
                        ? sentence
                        : fmt::format("{}: {}", as_sentence(place_text(report, names)), sentence));
  return texts;
}

// Returns the sections of the page: headline, table and figures.
std::vector<Blocks> sections_of(const StudiesReport& report) {
  std::vector<Blocks> sections{{Heading{headline(report)}}};
  for (const std::string& sentence : requirement_sentences(report)) sections[0].emplace_back(sentence);
  Table table = studies_table(report);
  for (std::string& warning : warnings_of(report)) table.notes.push_back(std::move(warning));
  sections[0].emplace_back(std::move(table));
  Blocks pictures{Heading{"Pictures"}};
  pictures.insert(pictures.end(), report.figures.begin(), report.figures.end());
  if (!report.figures.empty()) sections.push_back(std::move(pictures));
  Blocks each{Heading{"Each study"}};
  for (const StudyColumn& column : report.columns)
    each.emplace_back(
        fmt::format("{}: {}", as_sentence(place_text(report, {column.name})), show::headline(column.model)));
  sections.push_back(std::move(each));
  return sections;
}

}  // namespace

std::vector<std::string> requirement_sentences(const StudiesReport& report) {
  Names texts;
  for (const StudyColumn& column : report.columns)
    for (const std::string& sentence : show::requirement_sentences(column.model))
      texts.push_back(fmt::format("{}: {}", as_sentence(place_text(report, {column.name})), sentence));
  return texts;
}

std::string headline(const StudiesReport& report) {
  std::string text, metric;
  for (const OutcomeGroup& group : outcome_groups(report)) {
    const bool names_metric = !group.outcome.losers.empty() && group.outcome.metric != metric;
    if (names_metric) metric = group.outcome.metric;
    text += fmt::format("{}{}, {}", text.empty() ? "" : "; ", place_text(report, group.names),
                        clause(group.outcome, group.names.size() == 1 ? group.model : nullptr, names_metric));
  }
  return as_sentence(text) + '.' + reversals_text(report);
}

Table studies_table(const StudiesReport& report) {
  Table table{
      .name = "studies", .caption = "The deciding metric of each study", .columns = {{"solver"}}, .is_of_study = false};
  NamesByPhrase quantities, references;  // studies by quantity, and by reference
  std::set<std::string> all_marks;
  const bool has_intervals = report.columns.size() <= max_interval_columns;
  for (std::size_t s = 0; s < report.columns.size(); ++s) {
    const auto& [name, study, model] = report.columns[s];
    Table of_study = results_table(model);
    std::set<std::string> marks;
    table.columns.push_back({.name = name, .unit = of_study.columns[1].unit});
    quantities.add(of_study.columns[1].name, name);
    for (std::vector<Cell>& of_solver : of_study.rows) {
      const auto name_of = [](const std::vector<Cell>& cells) { return std::get<std::string>(cells[0]); };
      auto row = std::ranges::find(table.rows, name_of(of_solver), name_of);
      if (row == table.rows.end()) row = table.rows.insert(row, {of_solver[0]});
      row->resize(s + 1, MissingCell{"not in the study"});
      if (auto* const marked = std::get_if<ValueCell>(&of_solver[1])) {
        marks.insert(marked->mark);
        if (!has_intervals) marked->interval.reset();
        marked->sd.reset();
      }
      row->push_back(of_solver[1]);
    }
    if (const std::string reference = reference_of_marks(model); !marks_text(marks, reference).empty())
      references.add(reference, name);
    all_marks.merge(marks);
  }
  for (auto& row : table.rows) row.resize(table.columns.size(), MissingCell{"not in the study"});
  const Names by_reference =
      references.entries.size() == 1 ? references.formatted("{0}") : references.formatted("{} ({})");
  const Names shown = quantities.entries.size() == 1 ? quantities.formatted("{0}") : quantities.formatted("{} ({})");
  const std::string key = place_words(report).key.empty() ? "" : ", by " + report.keys.front();
  Names sentences{"Shown: " + listed(shown) + key,
                  marks_text(all_marks, listed(by_reference, " or ") + tests_text(report)),
                  intervals_text(table, report), "Each study is judged by itself"};
  std::erase(sentences, "");
  table.notes = {fmt::format("{}.", fmt::join(sentences, ". "))};
  const auto unit = &Column::unit;
  const bool has_one_unit =
      std::ranges::count(table.columns, table.columns.back().unit, unit) == std::ssize(report.columns);
  if (report.columns.size() <= max_study_columns || !has_one_unit) return table;
  return transposed(table, report.keys.size() == 1 ? report.keys.front() : "study");
}

std::string terminal_report(const StudiesReport& report, const std::string& page) {
  Table table = studies_table(report);
  const Names notes = std::exchange(table.notes, {});
  std::string text = wrapped_paragraph(headline(report), "");
  for (const std::string& sentence : requirement_sentences(report)) text += wrapped_paragraph(sentence, "  ");
  text += '\n' + to_text(table) + wrapped_paragraph(fmt::format("{}", fmt::join(notes, " ")), "");
  const Names warnings = warnings_of(report);
  for (std::size_t i = 0; i < warnings.size() && i < max_warnings; ++i)
    text += wrapped_paragraph("! " + warnings[i], "  ");
  if (warnings.size() > max_warnings)
    text += fmt::format("! {} on the page\n",
                        base::counted(std::ssize(warnings) - std::int64_t{max_warnings}, "more warnings"));
  return text + fmt::format("Report: {}\n", one_line(page));
}

base::OrderedJson to_json(const StudiesReport& report) {
  base::OrderedJson json{{"headline", headline(report)}, {"keys", report.keys}};
  for (const StudyColumn& column : report.columns) {
    base::OrderedJson of_study{{"name", column.name}, {"study", column.study}};
    of_study.update(show::to_json(column.model));
    json["studies"].push_back(std::move(of_study));
  }
  return json;
}

WrittenReport write_report(const StudiesReport& report, const std::filesystem::path& folder,
                           const figures::RenderOptions& options, const std::string& program) {
  return publish({.title = report.title, .sections = sections_of(report), .json = to_json(report)}, folder, options,
                 program);
}

}  // namespace ikbench::show
