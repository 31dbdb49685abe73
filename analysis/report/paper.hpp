// A collection of built-in studies that are reported together, and a paper's additions to their report. An empty field
// means the report of any study.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/inference/judged_study.hpp"
#include "analysis/inference/multiverse.hpp"
#include "analysis/inference/observations.hpp"
#include "analysis/report/claims.hpp"
#include "analysis/report/last_bits.hpp"
#include "analysis/report/lock.hpp"
#include "analysis/report/rates.hpp"
#include "analysis/report/report_content.hpp"
#include "analysis/report/study_pieces.hpp"

namespace ikbench::report {

// Results of one solver: by seed, one value per run.
struct RepeatedSolver {
  std::string label;
  std::vector<std::vector<double>> error_cm;
  std::vector<std::vector<double>> variation_deg;
};

struct MultiverseReport {
  std::vector<ClaimShares> claims;
  std::vector<std::string> sentences = {};    // compare the printed numbers with the universes
  std::vector<Table> tables = {};             // "multiverse", "multiverse-alternatives", "multiverse-printed", ...
  std::vector<figures::Figure> figures = {};  // "multiverse"
};

// A study with its companions: the collection's other studies that the store has. The study's plan judges all.
struct Reported {
  const inference::JudgedStudy& study;
  inference::JudgedStudies companions = {};
  std::span<const RepeatedSolver> repetitions = {};  // run means of the study with other seeds; empty if not solved
  PerturbedCopies perturbed = {};                    // copies of the study and its companions
  bool are_seeds = false;                            // the companions are the study with other seeds
};

// The copies of one study among those reported.
PerturbedCopies copies_of(const inference::StudyResults& study, const Reported& reported);

struct Paper {
  std::string citation = {};        // a sentence with the DOI
  std::string kind = {};            // a sentence: what kind of reproduction this is
  std::string not_reproduced = {};  // a sentence
  int repetitions = 0;              // number of seeds with which its first study is solved again
  std::function<std::vector<Claim>(const Reported&)> claims = {};
  std::function<StudyPieces(const Reported&)> pieces = {};  // replaces study_pieces(), whose result it may extend
  ReportPlan sections = {};  // places the pieces; without results, the pieces place themselves
  std::function<std::vector<std::string>(const Reported&)> summary = {};  // adds sentences to the summary; may be empty
  std::function<StudyPieces(const Reported&)> rows = {};  // tables rows-*, and a sentence on how many agree
  std::optional<Lock> lock = {};
  // Returns the printed summaries that the same methods can assess.
  std::function<std::vector<inference::Observations>(const inference::StudyResults&)> printed = {};
  std::function<MultiverseReport(const inference::Multiverse&, const results::AnalysisPlan&)> multiverse = {};
  // Makes the table of the universes with at most one choice that is not the default.
  std::function<Table(const inference::Multiverse&, const results::AnalysisPlan&)> one_at_a_time = {};
};

// A built-in study that `ikbench reproduce` runs.
struct CollectedStudy {
  std::string name;
  bool takes_runs = false;  // takes the command's --runs
};

struct Collection {
  std::string name;           // a paper's collection has the name in a study's `published` and in results/published
  std::string in_short = {};  // short description for --help
  // The first is the collection's own study; "first-part" is its companion, as "mine-part" is of a study "mine".
  std::vector<CollectedStudy> studies = {};
  RatesPlan rates = {};
  std::optional<Paper> paper = {};
  // Set for a user's collection, which has any studies: they get one table and one test (together.hpp).
  bool is_together = false;
  bool are_seeds = false;  // they are one study with several seeds, each a block
  std::string title = {};  // replaces that of the first study; may be empty
};

// The tables and figures of the study itself and of the collection.
StudyPieces pieces_of(const Reported& reported, const Collection& collection);

}  // namespace ikbench::report
