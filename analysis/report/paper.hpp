// What is reported together: a collection of built-in studies, and what a paper adds to their report. What it leaves
// empty is as in the report of any study.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/inference/judged_study.hpp"
#include "analysis/inference/multiverse.hpp"
#include "analysis/inference/observations.hpp"
#include "analysis/report/audit.hpp"
#include "analysis/report/claims.hpp"
#include "analysis/report/multiverse.hpp"
#include "analysis/report/rates.hpp"
#include "analysis/report/repetitions.hpp"
#include "analysis/report/report_content.hpp"
#include "analysis/report/study_pieces.hpp"

namespace ikbench::report {

// A study with its companions, the collection's other studies where the store has them. All are judged by the study's
// plan.
struct Reported {
  const inference::JudgedStudy& study;
  inference::JudgedStudies companions = {};
  std::span<const RepeatedSolver> repetitions = {};  // the study's run means with other seeds; none where not solved
};

struct Paper {
  std::string citation = {};        // a sentence with the DOI
  std::string not_reproduced = {};  // a sentence
  int repetitions = 0;              // with so many seeds its first study is solved, for what a repetition would give
  std::function<std::vector<Claim>(const Reported&)> claims = {};
  std::function<StudyPieces(const Reported&)> pieces = {};  // instead of study_pieces, which it may take and add to
  ReportPlan sections = {};                                 // where these stand
  std::function<std::vector<std::string>(const Reported&)> summary = {};  // of a study with solves
  // What is printed and can be assessed by the same methods.
  std::function<std::vector<inference::Summaries>(const inference::StudyResults&)> printed = {};
  std::function<std::vector<AuditItem>()> audit = {};
  std::function<MultiverseReport(const inference::Multiverse&, const results::AnalysisPlan&)> multiverse = {};
  // Of the universes with at most one choice that is not the default.
  std::function<Table(const inference::Multiverse&, const results::AnalysisPlan&)> one_at_a_time = {};
};

// A built-in study that `ikbench reproduce` runs.
struct CollectedStudy {
  std::string name;
  bool takes_runs = false;  // of the command
};

struct Collection {
  std::string name;           // of a paper's: as a study's `published` and results/published have it
  std::string in_short = {};  // what is solved, in a few words for --help
  // The first is the collection's own; "first-part" is a companion of it, and "mine-part" of a study "mine".
  std::vector<CollectedStudy> studies = {};
  RatesPlan rates = {};
  std::optional<Paper> paper = {};
};

// The tables and figures of the study itself and of the collection.
StudyPieces pieces_of(const Reported& reported, const Collection& collection);

}  // namespace ikbench::report
