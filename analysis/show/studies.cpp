#include "analysis/show/studies.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
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
constexpr std::size_t max_counted = 6;           // solvers in a headline about many studies

using Names = std::vector<std::string>;

// The differences that the first metric of a study decides.
struct Outcome {
  bool is_nothing_solved = false, is_tested = false, has_control = false;
  std::string metric, reference;
  std::string why_not_tested = {};  // if all pairs have the same reason
  Names losers = {}, winners = {};  // solvers that are worse or better than the reference, in the order of the table

  bool has_difference() const { return !losers.empty() || !winners.empty(); }
  // Returns whether another study decides the same, whatever the order of its solvers.
  bool is_like(const Outcome& other) const {
    return is_nothing_solved == other.is_nothing_solved && is_tested == other.is_tested && metric == other.metric &&
           reference == other.reference && why_not_tested == other.why_not_tested &&
           std::ranges::is_permutation(losers, other.losers) && std::ranges::is_permutation(winners, other.winners);
  }
};

Outcome outcome_of(const ReportModel& model) {
  const JudgedMetric& primary = model.primary();
  Outcome outcome{.has_control = !primary.plan.control.empty(),
                  .metric = primary.samples.quantity,
                  .reference = reference_of(model)};
  const auto is_unsolved = [&](const JudgedMetric& judged) {
    return judged.samples.quantity_kind == QuantityKind::solved &&
           std::ranges::all_of(judged.descriptives, [](const Descriptives& shares) { return shares.mean == 0; });
  };
  outcome.is_nothing_solved = std::ranges::any_of(model.metrics, is_unsolved);
  const PairIndex pairs(primary, model.solvers());
  for (const std::string& solver : model.solvers()) {
    outcome.is_tested |= pairs.tested_pairs(solver) > 0;
    if (solver == outcome.reference) continue;
    if (pairs.is_better(outcome.reference, solver)) outcome.losers.push_back(solver);
    if (pairs.is_better(solver, outcome.reference)) outcome.winners.push_back(solver);
  }
  std::set<std::string> reasons;
  for (const Comparison& comparison : primary.comparisons)
    if (const auto* const not_tested = std::get_if<NotTested>(&comparison.result))
      reasons.insert(reason_in_metric(*not_tested, primary, observation_noun(model, primary)));
  if (!outcome.is_tested && reasons.size() == 1) outcome.why_not_tested = *reasons.begin();
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

// Returns "mine (71 %) is worse", with numbers of `only` if that is not null.
std::string verdict_clause(Names solvers, const ReportModel* only, std::string_view verdict) {
  if (only != nullptr)
    for (std::string& solver : solvers) solver = with_number(*only, solver);
  return fmt::format("{} {} {}", names_of(solvers), solvers.size() == 1 ? "is" : "are", verdict);
}

// Returns the clause of an outcome. `only` is the study of the outcome, whose numbers are named; null if there are
// several such studies.
std::string clause(const Outcome& outcome, const ReportModel* only, bool names_metric) {
  const std::string metric = names_metric ? " in " + outcome.metric : "";
  if (!outcome.has_difference()) {
    if (outcome.is_nothing_solved) return "no solver reached any target";
    if (outcome.is_tested) return fmt::format("no difference{} is shown", metric);
    if (only != nullptr && only->order.size() == 1)
      return with_number(*only, outcome.reference) + " is the only solver";
    return fmt::format("no pair is tested{}",
                       outcome.why_not_tested.empty() ? "" : fmt::format(" ({})", outcome.why_not_tested));
  }
  const ReportModel* const with_numbers = outcome.losers.size() + outcome.winners.size() < max_named ? only : nullptr;
  const std::string reference = (outcome.has_control ? "the control " : "") +
                                (with_numbers ? with_number(*only, outcome.reference) : outcome.reference);
  Names verdicts;
  if (!outcome.winners.empty()) verdicts.push_back(verdict_clause(outcome.winners, with_numbers, "better"));
  if (!outcome.losers.empty()) verdicts.push_back(verdict_clause(outcome.losers, with_numbers, "worse"));
  return fmt::format("{}{} than {}{}", outcome.is_nothing_solved ? "no solver reached any target, and " : "",
                     fmt::join(verdicts, " and "), reference, metric);
}

// The studies of an outcome.
struct OutcomeGroup {
  Outcome outcome;
  Names names = {};
  const ReportModel* model = nullptr;  // of the first study
};

// Returns the outcomes with their studies: of values of a key in their order, otherwise outcomes with a difference
// first.
std::vector<OutcomeGroup> outcome_groups(const StudiesReport& report) {
  std::vector<OutcomeGroup> groups;
  for (const StudyColumn& column : report.columns) {
    Outcome outcome = outcome_of(column.model);
    if (!outcome.has_difference() && column.model.order.size() > 1) outcome.reference.clear();  // says nothing then
    auto group =
        std::ranges::find_if(groups, [&](const OutcomeGroup& known) { return known.outcome.is_like(outcome); });
    if (group == groups.end())
      group = groups.insert(group, OutcomeGroup{.outcome = std::move(outcome), .model = &column.model});
    group->names.push_back(column.name);
  }
  if (place_words(report).key.empty())
    std::stable_partition(groups.begin(), groups.end(),
                          [](const OutcomeGroup& group) { return group.outcome.has_difference(); });
  return groups;
}

// Returns how often each solver is better or worse, for many studies: "IK-BA is worse than some other solver on 27 of
// the 28 arms, DE on 24".
std::string counts_text(const StudiesReport& report) {
  std::map<std::pair<std::string, std::string>, Names> studies;  // by verdict with its reference, and by solver
  for (const StudyColumn& column : report.columns) {
    const JudgedMetric& primary = column.model.primary();
    const std::string& control = primary.plan.control;
    const std::set<std::string> beaten = beaten_solvers(primary.comparisons);
    const PairIndex pairs(primary, column.model.solvers());
    for (const std::string& solver : column.model.solvers()) {
      const bool is_worse = control.empty() ? beaten.contains(solver) : pairs.is_better(control, solver);
      if (is_worse)
        studies[{control.empty() ? "worse than some other solver" : "worse than the control " + control, solver}]
            .push_back(column.name);
      if (!control.empty() && pairs.is_better(solver, control))
        studies[{"better than the control " + control, solver}].push_back(column.name);
    }
  }
  if (studies.empty()) return "";
  std::map<std::string, std::vector<std::pair<std::string, Names>>> by_verdict;
  for (auto& [key, names] : studies) by_verdict[key.first].emplace_back(key.second, std::move(names));
  Names clauses;
  for (auto& [verdict, solvers] : by_verdict) {
    std::ranges::stable_sort(solvers, std::ranges::greater(), [](const auto& each) { return each.second.size(); });
    Names parts;
    for (const auto& [solver, names] : solvers)
      parts.push_back(parts.empty() ? fmt::format("{} is {} {}", solver, verdict, place_text(report, names))
                                    : fmt::format("{} {}", solver, place_text(report, names)));
    if (parts.size() > max_counted) {
      const std::int64_t more = std::ssize(parts) - std::int64_t{max_counted};
      parts.resize(max_counted);
      parts.push_back(base::counted(more, "more solvers") + " on fewer");
    }
    clauses.push_back(listed(parts));
  }
  return fmt::format("In {}, {}", report.columns.front().model.primary().samples.quantity, fmt::join(clauses, "; "));
}

// Returns the sentences of maps, which are not tested; of many only how often each solver solves most targets.
std::string maps_text(const StudiesReport& report) {
  Names texts;
  if (report.columns.size() <= max_named) {
    for (const StudyColumn& column : report.columns)
      texts.push_back(fmt::format("{}: {}", as_sentence(place_text(report, {column.name})), column.model.verdict));
    return fmt::format("{}", fmt::join(texts, " "));
  }
  std::map<std::string, Names> best;  // studies in which no other solver solves more
  for (const StudyColumn& column : report.columns) {
    const JudgedMetric& primary = column.model.primary();
    const double most = std::ranges::max(primary.descriptives, {}, &Descriptives::mean).mean;
    for (std::size_t i = 0; i < primary.descriptives.size(); ++i)
      if (most > 0 && primary.descriptives[i].mean == most) best[primary.samples.groups[i].name].push_back(column.name);
  }
  std::vector<std::pair<std::string, Names>> solvers(best.begin(), best.end());
  std::ranges::stable_sort(solvers, std::ranges::greater(), [](const auto& each) { return each.second.size(); });
  for (const auto& [solver, names] : solvers)
    texts.push_back(
        fmt::format("{}{} {}", solver, texts.empty() ? " solves the most targets" : "", place_text(report, names)));
  if (texts.empty()) return fmt::format("No solver solves any target of the {} maps.", report.columns.size());
  return fmt::format("{}. Several solvers can be equal.", listed(texts));
}

// Returns "The order changes: A is better than B at 1, and B is better than A at 10."; empty if no two studies decide
// opposite differences.
std::string reversals_text(const StudiesReport& report) {
  using Decided = std::tuple<std::string, std::string, std::string>;  // metric, better solver, worse one
  std::map<Decided, Names> winners;                                   // studies
  for (const StudyColumn& column : report.columns) {
    const std::string& metric = column.model.primary().samples.quantity;
    for (const Comparison& comparison : column.model.primary().comparisons) {
      if (verdict_of(comparison) == Verdict::better)
        winners[{metric, comparison.first, comparison.second}].push_back(column.name);
      if (verdict_of(comparison) == Verdict::worse)
        winners[{metric, comparison.second, comparison.first}].push_back(column.name);
    }
  }
  Names texts;
  std::size_t more = 0;
  for (const auto& [decided, names] : winners) {
    const auto& [metric, first, second] = decided;
    const auto opposite = winners.find({metric, second, first});
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
  NamesByPhrase sentences;
  for (const StudyColumn& column : report.columns)
    for (const std::string& sentence : show::requirement_sentences(column.model)) sentences.add(sentence, column.name);
  Names texts;
  for (const auto& [sentence, names] : sentences.entries)
    texts.push_back(names.size() > 1 && names.size() == report.columns.size()
                        ? sentence
                        : fmt::format("{}: {}", as_sentence(place_text(report, names)), sentence));
  return texts;
}

std::string headline(const StudiesReport& report) {
  const auto has_verdict = [](const StudyColumn& column) { return !column.model.verdict.empty(); };
  if (std::ranges::all_of(report.columns, has_verdict)) return maps_text(report);
  const std::vector<OutcomeGroup> groups = outcome_groups(report);
  const std::string counts = groups.size() > max_named ? counts_text(report) : "";
  if (!counts.empty()) return counts + '.' + reversals_text(report);
  std::string text, metric;
  for (const OutcomeGroup& group : groups) {
    const bool is_about_metric =
        group.outcome.has_difference() || (group.outcome.is_tested && !group.outcome.is_nothing_solved);
    const bool names_metric = is_about_metric && group.outcome.metric != metric;
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
  const auto is_of_unit = [&](const Column& column) { return column.unit == table.columns.back().unit; };
  const bool has_one_unit = std::all_of(table.columns.begin() + 1, table.columns.end(), is_of_unit);
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
