// A paper is data, and so are its claims: the file of its name here.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/judge/data/sampling.hpp"

namespace ikbench::papers {

// The statistic of a metric that a claim compares: the means, or the standard deviations of the runs.
enum class Of { means, spread };
// Whose numbers come from the companion that a claim names; those of the rest come from the study.
enum class From { both, solvers, others };

struct Rule;  // rules.hpp

struct Claim {
  std::string id, sentence, decides;  // decides: what would decide it
  std::string section = {};           // of the paper
  const Rule* rule = nullptr;         // null: nothing here can decide it
  bool is_ours = false;               // our question, no claim of the paper
  std::vector<std::string> solvers;   // it says something of; by default the paper's own
  std::vector<std::string> against;   // these; empty: all others
  std::vector<const judge::Metric*> metrics = {};
  Of of = Of::means;
  std::string study = {};  // "limits": of the companion NAME-limits
  From from = From::both;
  std::string note = {};  // added to the evidence
};

// A printed column of means, a row a solver; of "solved" the number of targets that are not.
struct PrintedColumn {
  std::string name, table, column;
  const judge::Metric* metric = nullptr;
  std::string study = {};  // "searches": of the companion NAME-searches
};

// Printed tables of shares solved [%], where a row is an arm, with a column for each solver; or columns of means.
struct Rates {
  std::map<std::string, std::string> tables = {};  // with words, the paper's own first: "README 1.4.6"
  std::vector<PrintedColumn> numbers = {};
  std::string note = {};
  double level = 0;                                 // of intervals
  std::vector<std::string> picked = {};             // arms whose file or side was chosen by their shares
  std::map<std::string, std::string> rows = {};     // name of our arm to that in its first column
  std::map<std::string, std::string> columns = {};  // solver to column
  std::string programs = {};                        // table of what programs did by the clock, an arm a row

  bool is_of_arms() const { return !rows.empty(); }
};

struct Paper {
  std::string name;  // in a study's `published` and in results/published
  std::string in_short = {}, citation = {}, not_repeated = {};
  std::vector<std::string> studies = {};             // the first is its own, "first-part" its companion
  std::vector<std::string> runs = {};                // those that take --runs
  std::string solver = {};                           // that it proposes
  std::string means = {};                            // its table of means; empty: none is printed
  std::map<std::string, std::string> readings = {};  // studies of which that table may be, with words: "20 agents"
  Rates rates = {};
  std::vector<Claim> claims = {};
};

const std::vector<Paper>& papers();  // by name; those with a table of means first
// Throws std::invalid_argument, which lists all, if there is none.
const Paper& paper_named(std::string_view name);
// Throws std::invalid_argument with `source` and line for what is missing or unknown.
Paper read_paper(std::string_view name, std::string_view toml, std::string_view source);

}  // namespace ikbench::papers
