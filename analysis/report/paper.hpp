// What a paper adds to the report of a study that is held against it. A paper is a folder beside this one, which fills
// one Paper, and a line in analysis/papers.inc. What it leaves empty is as in the report of a study without a paper.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "analysis/inference/judged_study.hpp"
#include "analysis/inference/multiverse.hpp"
#include "analysis/inference/observations.hpp"
#include "analysis/report/audit.hpp"
#include "analysis/report/claims.hpp"
#include "analysis/report/multiverse.hpp"
#include "analysis/report/repetitions.hpp"
#include "analysis/report/report_content.hpp"
#include "analysis/report/study_pieces.hpp"

namespace ikbench::report {

// A study with its companions, the paper's other studies where the store has them. All are judged by the study's plan.
struct Reported {
  const inference::JudgedStudy& study;
  inference::JudgedStudies companions = {};
  std::span<const RepeatedSolver> repetitions = {};  // the study's run means with other seeds; none where not solved
};

// A built-in study that `ikbench reproduce` runs.
struct PaperStudy {
  std::string name;
  std::vector<std::string> takes;  // of the command's options: "seed", "runs"
};

struct Paper {
  std::string name;                 // as a study's `published` and results/published have it
  std::string in_short = {};        // what is repeated, in a few words for --help
  std::string citation = {};        // a sentence with the DOI
  std::string not_reproduced = {};  // a sentence
  // The first is the paper's own; "first-part" is a companion of it, and "mine-part" of a study "mine".
  std::vector<PaperStudy> studies = {};
  int repetitions = 0;  // with so many seeds the first is solved, for what a repetition would give
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

}  // namespace ikbench::report
