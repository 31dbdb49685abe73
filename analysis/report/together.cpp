#include "analysis/report/together.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "analysis/figures/convergence_figures.hpp"
#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/estimand.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/inference/together.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/words.hpp"

namespace ikbench::report {

using namespace results;
using namespace inference;
using namespace fmt::literals;

namespace {

JudgedStudies studies_of(const Reported& reported) {
  JudgedStudies studies{reported.study};
  studies.insert(studies.end(), reported.companions.begin(), reported.companions.end());
  return studies;
}

std::string_view noun_of(bool are_seeds) { return are_seeds ? "seeds" : "studies"; }

std::string average_of_column(Estimand estimand) {
  return estimand == Estimand::reliability ? "solved [%]" : fmt::format("{} error [cm]", name_of(estimand));
}

Cell average_of_group(const Evidence& evidence, const std::string& solver) {
  const GroupEvidence* const group = group_named(evidence.groups, solver);
  if (group == nullptr || !std::isfinite(group->described.mean)) return {};
  return group->described.mean * (evidence.scale == ValueScale::share ? 100 : 1);
}

void add_columns(Table& table, const std::string& study, const Evidence& evidence, Estimand estimand) {
  table.columns.push_back(fmt::format("{}: {}", study, average_of_column(estimand)));
  for (std::vector<Cell>& row : table.rows)
    row.push_back(average_of_group(evidence, std::get<std::string>(row.front())));
}

std::string set_up_of(const JudgedStudy& study) {
  return fmt::format(words::together_study, "study"_a = study.name, "arm"_a = study.facts.robot,
                     "path"_a = study.facts.path, "runs"_a = study.runs, "points"_a = study.points);
}

Evidence judged_over(const JudgedStudies& studies, const Judged& of, bool are_seeds) {
  const Observations observations = together(studies, of.metric, of.estimand, are_seeds);
  return evidence(observations, feasible(studies.front().get().plan, observations));
}

Table together_table(const JudgedStudies& studies, const std::vector<Judged>& errors, bool are_seeds) {
  Table table{
      .name = "together",
      .caption = fmt::format(words::together_caption, "studies"_a = studies.size(), "noun"_a = noun_of(are_seeds)),
      .columns = {"solver"}};
  std::vector<std::string> solvers;
  for (const JudgedStudy& study : studies) {
    for (const std::string& solver : study.solvers) {
      if (std::ranges::count(solvers, solver) == 0) solvers.push_back(solver);
    }
    table.notes.push_back(set_up_of(study));
  }
  for (const std::string& solver : solvers) table.rows.push_back({solver});
  for (const Judged& of : errors) {
    const Evidence found = judged_over(studies, of, are_seeds);
    add_columns(table, "all", found, of.estimand);
    for (const std::string& note : found.notes) {
      if (std::ranges::count(table.notes, note) == 0) table.notes.push_back(note);
    }
  }
  for (const JudgedStudy& study : studies) {
    for (const Judged& of : errors) add_columns(table, study.name, study.evidence(of.metric, of.estimand), of.estimand);
  }
  return table;
}

// Names the study in each heading and caption, and in each name if it is a companion.
StudyPieces told_of(const StudyResults& study, StudyPieces pieces, const std::string& prefix) {
  const auto tell = [&](std::string& name, std::string& caption) {
    name = prefix + name;
    caption = fmt::format(words::of_study, "study"_a = study.name, "what"_a = caption);
  };
  for (Table& table : pieces.tables) tell(table.name, table.caption);
  for (figures::Figure& figure : pieces.figures) tell(figure.name, figure.caption);
  for (SectionPlan& section : pieces.sections) {
    section.heading = fmt::format(words::of_study, "study"_a = study.name, "what"_a = section.heading);
    for (std::vector<std::string>* names : {&section.names, &section.folded}) {
      for (std::string& name : *names) name = prefix + name;
    }
  }
  return pieces;
}

StudyPieces companion_pieces(const StudyResults& companion) {
  StudyPieces pieces = study_pieces(companion);
  std::ranges::move(figures::convergence_figures(companion), std::back_inserter(pieces.figures));
  pieces.sections.push_back({"Convergence and cost", "", {}, {"statistics-*"}});
  return told_of(companion, std::move(pieces), prefix_of(companion));
}

}  // namespace

std::string prefix_of(const StudyResults& companion) { return companion.name + '-'; }

void add_together(StudyPieces& pieces, const Reported& reported) {
  const JudgedStudies studies = studies_of(reported);
  if (studies.size() < 2) return;
  const std::vector<Judged> judged = judged_together(studies);
  std::vector<Judged> errors = judged;
  std::erase_if(errors, [](const Judged& each) { return each.metric != Metric::position_error_cm; });
  if (errors.empty()) return;
  Table table = together_table(studies, errors, reported.are_seeds);
  const Evidence found = judged_over(studies, errors.front(), reported.are_seeds);
  const auto label = [&](std::size_t group) {
    const double mean = found.groups[group].described.mean;
    return fmt::format(
        "{} ({})", found.groups[group].name,
        found.scale == ValueScale::share ? percent(mean) : figures::value_words(Metric::position_error_cm, mean));
  };
  const Sentence sentence{
      fmt::format(words::together, "studies"_a = studies.size(), "noun"_a = noun_of(reported.are_seeds),
                  "quantity"_a = found.quantity),
      fmt::format("{}.{}", fmt::join(short_answer(found, label), ". "), reasons_of_undecided(found))};
  pieces = told_of(reported.study, std::move(pieces), "");
  for (const StudyResults& companion : reported.companions) {
    StudyPieces further = companion_pieces(companion);
    std::ranges::move(further.tables, std::back_inserter(pieces.tables));
    std::ranges::move(further.figures, std::back_inserter(pieces.figures));
    std::ranges::move(further.sections, std::back_inserter(pieces.sections));
  }
  pieces.results = table.name;
  pieces.sections.insert(pieces.sections.begin(), {std::string(words::all_studies), "", {table.name}});
  pieces.tables.push_back(std::move(table));
  pieces.verdict.push_back(sentence);
}

std::vector<Assessment> together_assessments(const Reported& reported) {
  const JudgedStudies studies = studies_of(reported);
  std::vector<Assessment> result;
  if (studies.size() < 2) return result;
  for (const Judged& of : judged_together(studies)) {
    const Observations observations = together(studies, of.metric, of.estimand, reported.are_seeds);
    result.push_back(assess(observations, feasible(studies.front().get().plan, observations)));
    result.back().study = words::all_studies;
  }
  return result;
}

}  // namespace ikbench::report
