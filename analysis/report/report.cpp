#include "analysis/report/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include "analysis/figures/convergence_figures.hpp"
#include "analysis/figures/figure_parts.hpp"
#include "analysis/figures/solver_styles.hpp"
#include "analysis/inference/analysis_plan.hpp"
#include "analysis/inference/comparable.hpp"
#include "analysis/inference/design.hpp"
#include "analysis/inference/estimand.hpp"
#include "analysis/inference/judge.hpp"
#include "analysis/inference/make_study.hpp"
#include "analysis/inference/metrics.hpp"
#include "analysis/inference/study_facts.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/inference/times.hpp"
#include "analysis/report/assessment.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/moving_arm.hpp"
#include "analysis/report/report_content.hpp"
#include "analysis/report/study_tables.hpp"
#include "analysis/report/summary.hpp"
#include "analysis/report/words.hpp"
#include "numerics/names.hpp"
#include "results/export.hpp"
#include "results/files.hpp"

namespace ikbench::report {

using namespace numerics;
using namespace results;
using namespace statistics;
using namespace inference;
using namespace figures;

namespace {

// Judges another study by the reported one's plan. Ignores a control that the other study lacks.
JudgedStudy judged_by(const AnalysisPlan& plan, StudyResults other) {
  other.plan = plan;
  if (std::ranges::find(other.solvers, plan.control) == other.solvers.end()) other.plan.control.clear();
  return JudgedStudy(std::move(other));
}

// Returns whether the name is that of a companion: the reported study's name plus the ending of a study of the paper.
bool is_companion(const std::string& name, const StudyResults& study, const Paper& paper) {
  return std::ranges::any_of(paper.studies, [&](const PaperStudy& other) {
    const std::string part = other.name.substr(paper.studies.front().name.size());
    return !part.empty() && name == study.name + part;
  });
}

std::vector<std::string> labels_of(const StudyEntry& entry) {
  std::vector<std::string> labels;
  for (const Series& series : entry.series) labels.push_back(series.label);
  return labels;
}

// Refuses labels that are no solvers of the study.
void check_drawn(const StudyEntry& entry, const FigureStyle& style) {
  const std::vector<std::string> labels = labels_of(entry);
  for (const std::string& solver : style.solvers) {
    if (std::ranges::count(labels, solver) == 0)
      throw std::invalid_argument(unknown_name("solver of the study", solver, labels));
  }
}

// Gives every solver of the store one look in all figures, the study's first, and adds its colours to the style.
std::map<std::string, int> looks_of(const StudyEntry& entry, const std::vector<StudyEntry>& others,
                                    FigureStyle& style) {
  std::vector<NamedSolver> solvers;
  for (const std::string& label : style.solvers) {
    const auto series = std::ranges::find(entry.series, label, &Series::label);
    if (series != entry.series.end()) solvers.push_back({label, series->algorithm});
  }
  for (const Series& series : entry.series) solvers.push_back({series.label, series.algorithm});
  for (const StudyEntry& other : others) {
    for (const Series& series : other.series) solvers.push_back({series.label, series.algorithm});
  }
  return line_styles(solvers, style);
}

// Reads the studies of a store.
class CheckedStore {
 public:
  CheckedStore(const Store& store, const ReportRequest& request, std::map<std::string, int> looks,
               std::vector<std::string> drawn)
      : store_(store), request_(request), looks_(std::move(looks)), drawn_(std::move(drawn)) {}

  StudyResults study(const StudyEntry& entry) {
    return read(entry, [](const SolveRecord&) {});
  }
  // Reads the reported study and writes its solves as CSV.
  StudyResults reported(const StudyEntry& entry) {
    std::optional<StudyResults> study;
    remove_litter(request_.folder);  // an incomplete CSV may fill the disk
    write_csv(request_.folder / "solves.csv", [&](const std::function<void(const SolveRecord&)>& take) {
      if (study)
        store_.each_of_study(entry, take);
      else
        study = read(entry, take);
    });
    return std::move(*study);
  }
  const std::vector<Session>& sessions() const { return sessions_; }

 private:
  StudyResults read(const StudyEntry& entry, const std::function<void(const SolveRecord&)>& take) {
    const std::int64_t all = store_.solves_of(entry.series);
    std::int64_t done = 0;
    StudyMaker maker(entry, static_cast<std::size_t>(all));
    store_.each_of_study(entry, [&](const SolveRecord& solve) {
      maker.add(solve);
      take(solve);
      if (request_.progress) request_.progress(ReportStep::reading, ++done, all);
    });
    sessions_ = store_.sessions();  // a session may have begun meanwhile
    StudyResults study = maker.finish(sessions_);
    study.line_styles = looks_;
    study.drawn_solvers = drawn_;
    return study;
  }

  const Store& store_;
  const ReportRequest& request_;
  std::map<std::string, int> looks_;
  std::vector<std::string> drawn_;
  std::vector<Session> sessions_ = {};
};

bool has_another_solver(const StudyResults& other, const StudyResults& study) {
  return std::ranges::any_of(other.solvers, [&](const std::string& solver) {
    return std::ranges::find(study.solvers, solver) == study.solvers.end();
  });
}

// Other studies of the store that the report uses. Lists of those with the same targets begin with the reported one.
// Studies that treat limits differently cannot be compared directly: they get their own table.
struct Others {
  std::vector<JudgedStudy> judged = {};
  JudgedStudies companions = {}, same_targets_given = {}, same_limits_too = {};  // of these
};

Others others_of(CheckedStore& store, const std::vector<StudyEntry>& entries, const JudgedStudy& study,
                 const Paper& paper) {
  Others result{.same_targets_given = {study}, .same_limits_too = {study}};
  result.judged.reserve(entries.size());  // the lists refer to its elements
  for (const StudyEntry& entry : entries) {
    if (entry.name == study.name || entry.series.empty()) continue;
    StudyResults other = store.study(entry);
    const bool is_collected = is_companion(other.name, study, paper), is_beside = same_targets(study, other);
    if (!is_collected && !is_beside) continue;
    const JudgedStudy& judged = result.judged.emplace_back(judged_by(study.plan, std::move(other)));
    if (is_collected) result.companions.push_back(judged);
    if (!is_beside) continue;
    result.same_targets_given.push_back(judged);
    // A companion with the same solvers under other conditions serves a claim.
    const bool is_for_a_claim = is_collected && !has_another_solver(judged, study);
    if (judged.facts.enforces_limits == study.facts.enforces_limits && !is_for_a_claim)
      result.same_limits_too.push_back(judged);
  }
  return result;
}

// The studies of the store that are neither the reported one nor its companions.
std::vector<std::string> further_studies(const std::vector<StudyEntry>& entries, const Reported& reported) {
  std::vector<std::string> names;
  for (const StudyEntry& entry : entries) {
    const bool is_companion = std::ranges::any_of(
        reported.companions, [&](const StudyResults& companion) { return companion.name == entry.name; });
    if (entry.name != reported.study.name && !is_companion) names.push_back(entry.name);
  }
  return names;
}

// The paper that the study names; an empty one if there is none.
const Paper& paper_of(const StudyResults& study, std::span<const Paper> papers) {
  static const Paper none;
  const auto found = std::ranges::find(papers, study.facts.published, &Paper::name);
  return found == papers.end() ? none : *found;
}

// Assesses a paper's printed summaries by the same methods.
std::vector<Assessment> printed_assessments(const StudyResults& study, const Paper& paper) {
  std::vector<Assessment> result;
  if (!paper.printed) return result;
  for (const Observations& printed : paper.printed(study))
    result.push_back(assess(printed, feasible(study.plan, printed), study.drawn_solvers));
  return result;
}

std::vector<Assessment> assessments_of(const JudgedStudy& study, const Paper& paper, const ReportRequest& request) {
  if (study.solves.empty()) return {};
  std::vector<Assessment> result;
  const std::vector<Metric> judged = shown_metrics(study);
  for (std::size_t m = 0; m < judged.size(); ++m) {
    if (request.progress) request.progress(ReportStep::judging, static_cast<std::int64_t>(m), std::ssize(judged));
    for (const Estimand estimand : estimands_of(study, judged[m])) {
      result.push_back(assess(study, judged[m], estimand));
    }
  }
  std::ranges::move(printed_assessments(study, paper), std::back_inserter(result));
  return result;
}

// Doubts of targets out of reach, as found before the study was solved.
Doubts out_of_reach_doubts(const StudyResults& study) {
  const StudyFacts::OutOfReach& of = study.facts.out_of_reach;
  const double points = of.points, all = of.farthest_point + of.farthest_cm + of.reach_cm;
  const bool is_count = points >= 1 && points <= study.points && points == std::floor(points);
  if (!is_count || !std::isfinite(all)) return {};  // missing, or written by somebody else
  return {{.kind = DoubtKind::out_of_reach,
           .count = points,
           .of = static_cast<double>(study.points),
           .other = of.farthest_point,
           .value = of.farthest_cm,
           .limit = of.reach_cm,
           .what = study.facts.wrist ? "the wrist's centre would be" : "it is"}};
}

Doubts paper_doubts(const StudyResults& study, std::span<const Paper> papers) {
  if (study.facts.published.empty() || !paper_of(study, papers).name.empty()) return {};
  Doubt doubt{.kind = DoubtKind::unknown_paper, .what = study.facts.published};
  for (const Paper& paper : papers) {
    doubt.who.push_back(paper.name);
  }
  return {doubt};
}

Doubts missing_doubts(const StudyResults& study) {
  Doubts doubts;
  for (const SolverCounts& count : counts(study)) {
    if (count.solves >= count.expected) continue;
    doubts.push_back({.kind = DoubtKind::solves_missing,
                      .who = {count.solver},
                      .count = static_cast<double>(count.solves),
                      .of = static_cast<double>(count.expected)});
  }
  return doubts;
}

// Adds the companions' doubts. One that the study has too, of the same solvers, only gains the companion's name.
Doubts with_companions(Doubts doubts, const JudgedStudies& companions) {
  for (const StudyResults& companion : companions) {
    for (Doubt& doubt : out_of_reach_doubts(companion) + times_doubts(companion) + load_doubts(companion)) {
      const auto same = std::ranges::find_if(doubts, [&](const Doubt& each) {
        return each.study.empty() && title_of(each.kind) == title_of(doubt.kind) && each.who == doubt.who;
      });
      if (same == doubts.end()) {
        doubt.study = companion.name;
        doubts.push_back(std::move(doubt));
      } else if (std::ranges::find(same->studies, companion.name) == same->studies.end()) {
        same->studies.push_back(companion.name);
      }
    }
  }
  return doubts;
}

// Adds the sentences of `seen` for the pieces of any study.
void add_seen_in_boxes(const JudgedStudy& study, ReportContent& content) {
  for (const Metric metric : shown_metrics(study)) {
    if (study.solves.empty() || !is_comparable(study, metric)) continue;
    content.seen.emplace(fmt::format("{}-boxes", info_of(metric).slug),
                         words_of(leader_sentence(study, metric, average_estimand(metric))));
  }
}

}  // namespace

StudyPieces pieces_of(const Reported& reported, const Paper& paper) {
  StudyPieces pieces = paper.pieces ? paper.pieces(reported) : study_pieces(reported.study);
  add_rates(pieces, reported, paper.rates);
  return pieces;
}

Report write_report(const Store& store, const ReportRequest& request) {
  const StudyEntry entry = store.study(request.study);
  const std::vector<StudyEntry> entries = store.studies();
  RenderOptions figure_options = request.figures;
  FigureStyle& style = figure_options.style = request.style.value_or(figure_style_of(entry));
  check_drawn(entry, style);
  CheckedStore checked(store, request, looks_of(entry, entries, style), style.solvers);
  const std::vector<Session>& sessions = checked.sessions();
  StudyResults stored = checked.reported(entry);
  if (request.plan) stored.plan = *request.plan;
  const JudgedStudy study(std::move(stored));
  const Paper& paper = paper_of(study, request.papers);
  const Others others = others_of(checked, entries, study, paper);
  const Reported reported{study, others.companions};

  std::vector<Table> tables{definition_table(entry), options_table(entry),
                            plan_table(entry, study.plan, plan_notes(entry, sessions, solves_of_sessions(study))),
                            environment_table(study, sessions), status_table(study)};
  StudyPieces pieces = pieces_of(reported, paper);
  ReportPlan plan = paper.sections;
  if (plan.results.empty()) plan.results = std::move(pieces.sections);
  std::vector<Figure> figures = std::move(pieces.figures);
  std::ranges::move(pieces.tables, std::back_inserter(tables));
  if (others.same_limits_too.size() > 1) tables.push_back(baselines_table(others.same_limits_too));
  if (std::optional<Table> table = limits_table(others.same_targets_given)) tables.push_back(std::move(*table));
  std::ranges::copy(request.extra_tables, std::back_inserter(tables));
  std::ranges::copy(request.extra_figures, std::back_inserter(figures));

  ReportContent content{.study = study.name,
                        .title = study.facts.title.empty() ? study.name : study.facts.title,
                        .studied = studied(study, paper),
                        .claims = paper.claims ? paper.claims(reported) : std::vector<Claim>(),
                        .summary = summary(study),
                        .command = command_of(study, sessions),
                        .plan = std::move(plan),
                        .path = pieces.path,
                        .seen = pieces.seen};
  join(content.claims, request.shares);
  const Doubts of_points = study.plan.unit == Unit::point ? Doubts{{DoubtKind::points_as_observations}} : Doubts{};
  content.warnings =
      of_points + wrong_claims(study) + paper_doubts(study, request.papers) + missing_doubts(study) +
      with_companions(out_of_reach_doubts(study) + times_doubts(study) + load_doubts(study), reported.companions) +
      plan_changes(entry, sessions, solves_of_sessions(study)) + fairness_doubts(study, reported.companions);
  std::ranges::move(convergence_figures(study), std::back_inserter(figures));
  std::vector<Sentence> own =
      study.solves.empty() ? std::vector<Sentence>() : own_verdict(study, !content.claims.empty());
  if (!content.claims.empty()) {  // they are the verdict
    const std::vector<std::string> sentences = words_of(own);
    content.summary.insert(content.summary.begin(), sentences.begin(), sentences.end());
  } else {
    content.answer = std::move(own);
  }
  add_seen_in_boxes(study, content);
  if (!request.shares.empty()) content.seen.emplace("multiverse", request.shares.front().sentence);
  const Table results = *std::ranges::find(tables, pieces.results, &Table::name);
  content.assessments = assessments_of(study, paper, request);
  content.motion = moving_arm(entry, study);
  if (request.progress) {
    figure_options.progress = [&](std::int64_t done, std::int64_t all) {
      request.progress(ReportStep::drawing, done, all);
    };
  }
  Report report = publish(std::move(content), std::move(tables), std::move(figures), request.folder, figure_options);
  report.results = results;
  report.answers = no_answer_sentences(study);
  std::erase(report.answers, "");
  if (!study.solves.empty()) {
    report.findings = findings_of(study.evidence(Metric::position_error_cm, primary_estimand(study)));
  }
  report.further = further_studies(entries, reported);
  return report;
}

}  // namespace ikbench::report
