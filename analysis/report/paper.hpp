// A paper: its built-in studies, and what it adds to their report. An empty field means the report of any study.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/inference/judged_study.hpp"
#include "analysis/inference/multiverse.hpp"
#include "analysis/inference/observations.hpp"
#include "analysis/report/claims.hpp"
#include "analysis/report/rates.hpp"
#include "analysis/report/report_content.hpp"
#include "analysis/report/study_pieces.hpp"

namespace ikbench::report {

struct MultiverseReport {
  std::vector<ClaimShares> claims;
  std::vector<std::string> sentences = {};    // compare the printed numbers with the universes
  std::vector<Table> tables = {};             // "multiverse", "multiverse-alternatives", "multiverse-printed", ...
  std::vector<figures::Figure> figures = {};  // "multiverse"
};

// A study with its companions: the paper's other studies that the store has. The study's plan judges all.
struct Reported {
  const inference::JudgedStudy& study;
  inference::JudgedStudies companions = {};
  bool has_times = true;  // false: its claims are judged without times
};

// A built-in study that `ikbench reproduce` runs.
struct PaperStudy {
  std::string name;
  bool takes_runs = false;  // takes the command's --runs
};

struct Paper {
  std::string name = {};      // in a study's `published` and in results/published
  std::string in_short = {};  // short description for --help
  // The first is the paper's own study; "first-part" is its companion, as "mine-part" is of a study "mine".
  std::vector<PaperStudy> studies = {};
  std::string citation = {};        // a sentence with the DOI
  std::string kind = {};            // a sentence: what kind of reproduction this is
  std::string not_reproduced = {};  // a sentence
  RatesPlan rates = {};
  std::function<std::vector<Claim>(const Reported&)> claims = {};
  std::function<StudyPieces(const Reported&)> pieces = {};  // replaces study_pieces(), whose result it may extend
  ReportPlan sections = {};  // places the pieces; without results, the pieces place themselves
  // Returns the printed summaries that the same methods can assess.
  std::function<std::vector<inference::Observations>(const inference::StudyResults&)> printed = {};
  std::function<MultiverseReport(const inference::Multiverse&, const results::AnalysisPlan&)> multiverse = {};
};

// The tables and figures of the study itself and of the paper.
StudyPieces pieces_of(const Reported& reported, const Paper& paper);

}  // namespace ikbench::report
