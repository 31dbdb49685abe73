// A paper as data: the claims, the printed numbers and the studies that repeat the paper. Each paper is a TOML file
// with the paper's name in this folder. `reproduce` and the reports of published studies look papers up with
// paper_named.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/judge/data/sampling.hpp"

namespace ikbench::papers {

// The statistic of a metric that a claim compares: the means, or the standard deviations of the runs.
enum class Of { means, spread };
// The groups of a claim whose numbers come from the companion study that the claim names: both groups, the claim's
// solvers, or the solvers against which the claim is. All other numbers come from the paper's own study.
enum class From { both, solvers, others };

struct Rule;  // rules.hpp

// A claim of a paper, or a question of ours.
struct Claim {
  std::string id, sentence, decides;  // decides: what would decide the claim
  std::string section = {};           // of the paper
  const Rule* rule = nullptr;         // null: no rule can decide the claim
  bool is_ours = false;               // our question, no claim of the paper
  std::vector<std::string> solvers;   // subjects of the claim; by default the paper's own solver
  std::vector<std::string> against;   // the solvers compared with; empty: all others
  std::vector<const judge::Metric*> metrics = {};
  Of of = Of::means;
  std::string study = {};  // "limits": of the companion NAME-limits
  From from = From::both;
  std::string note = {};  // added to the evidence
};

// A printed column of means, with a row per solver. If the metric is the share solved, the column has the number of
// targets that were not solved.
struct PrintedColumn {
  std::string name, table, column;
  const judge::Metric* metric = nullptr;
  std::string study = {};  // "searches": of the companion NAME-searches
};

// The printed tables of shares solved [%], with a row per arm and a column per solver; or printed columns of means.
struct Rates {
  std::map<std::string, std::string> tables = {};  // words for each table, the paper's own first: "README 1.4.6"
  std::vector<PrintedColumn> numbers = {};
  std::string note = {};
  double level = 0;                                 // of intervals
  std::vector<std::string> picked = {};             // arms whose file or side was chosen by their shares
  std::map<std::string, std::string> rows = {};     // our arm to the arm in a table's first column
  std::map<std::string, std::string> columns = {};  // solver to column
  std::string programs = {};                        // table of the programs' results by the clock, with a row per arm

  // Returns whether the tables are shares by arm, and not columns of means.
  bool is_of_arms() const { return !rows.empty(); }
};

// A printed table of the least and the largest number of answers to the same poses, with a row per arm and a column per
// program. The numbers of answers to each pose are stored in results/published/NAME/PROGRAM.csv (counts.hpp).
struct AnswerCounts {
  std::string table = {};                            // empty: none
  std::string note = {};                             // a sentence
  std::map<std::string, std::string> programs = {};  // stored programs, with words: "ssik 8.2.0"
  std::map<std::string, std::string> reasons = {};   // by arm: why ours differ
};

// A paper that is repeated.
struct Paper {
  std::string name;  // in a study's `published` and in results/published
  std::string in_short = {}, citation = {}, not_repeated = {};
  std::vector<std::string> studies = {};  // first the paper's own; "first-part" is a companion; none: only `counts`
  std::vector<std::string> runs = {};     // studies that take --runs
  std::string solver = {};                // the solver that the paper proposes
  std::string means = {};                 // the printed table of means; empty: none
  std::string means_note = {};            // below that table: a sentence
  std::map<std::string, std::string> readings = {};  // interpretations: studies of `means`, with words: "20 agents"
  Rates rates = {};
  AnswerCounts counts = {};
  std::vector<Claim> claims = {};
};

// Returns all papers, ordered by name, those with a table of means first.
const std::vector<Paper>& papers();
// Returns the paper of this name. Throws std::invalid_argument with a list of all papers if there is none.
const Paper& paper_named(std::string_view name);
// Returns the paper of a file's text. Throws std::invalid_argument with `source` and the line if a key is missing or
// unknown.
Paper read_paper(std::string_view name, std::string_view toml, std::string_view source);

}  // namespace ikbench::papers
