// A paper is data: the file of its name here, and its printed tables (results/published; read in published.cpp).
#pragma once

#include <array>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/judge/judge.hpp"
#include "analysis/show/block.hpp"
#include "base/csv.hpp"

namespace ikbench::papers {

// These throw std::invalid_argument for a text that is no number.
double half_unit(std::string_view printed);                              // of the last digit: 5e-9 of "1.7824e-4"
bool agrees(double ours, std::string_view printed);                      // our number rounds to the printed digits
bool can_be(const judge::Interval& interval, std::string_view printed);  // a number in it does

// What a table of means may have, by its columns.
struct Statistic {
  std::string_view column;
  double judge::Description::*of;
};
constexpr std::array<Statistic, 5> statistics{{{"mean", &judge::Description::mean},
                                               {"median", &judge::Description::median},
                                               {"std", &judge::Description::sd},
                                               {"max", &judge::Description::largest},
                                               {"min", &judge::Description::smallest}}};

// Of one solver and metric.
struct PrintedRow {
  std::string solver;
  judge::Description numbers = {};  // unknown where the table has no such column
  std::array<std::string, statistics.size()> digits = {};
};
using PrintedRows = std::vector<PrintedRow>;

const PrintedRow* row_of(const PrintedRows& rows, std::string_view solver);  // null if there is none

// Of a table with the columns algorithm, metric, n and the statistics.
PrintedRows printed_means(std::string_view paper, std::string_view table, std::string_view metric);
// Of a table with n, mean_ms, median_ms and so on; its solvers are named "12 bats" from its first column, bats.
PrintedRows printed_times(std::string_view paper, std::string_view table);

// The range of each statistic in most studies of so many runs, by Hill's A(n) (JASA 63 (1968) 677) on the logarithms of
// the values: the next one is equally likely in each gap of the known ones, and then is known itself; beyond the last
// there is an exponential tail of Hill's slope (Annals of Statistics 3 (1975) 1163). It is made for 95 % of studies,
// and holds 92 % (tests/papers/published.test.cpp). None for fewer than five values, or one that is not above 0.
using Ranges = std::array<judge::Interval, statistics.size()>;
std::optional<Ranges> predicted_ranges(const std::vector<double>& values, int runs);

// Ours beside the printed digits, if there are any.
show::Cell beside(double ours, const PrintedRow* row, std::size_t statistic);

// What a claim compares of its metrics: the means; the standard deviations of the runs; or the same metric in the
// study and in each companion.
enum class Of { means, spread, each_study };
// Whose numbers come from the companion that a claim names; those of the rest come from the study.
enum class From { both, solvers, others };

struct Rule;  // claims.hpp

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

// A printed table of shares solved [%]. A row is an arm, with a column for each solver, or a solver.
struct Rates {
  std::string table = {}, note = {};
  double level = 0;                                 // of intervals
  std::vector<std::string> picked = {};             // arms whose file or side was chosen by their shares
  std::map<std::string, std::string> rows = {};     // name of our arm to that in its first column
  std::map<std::string, std::string> columns = {};  // solver to column
  std::string column = {};                          // of shares, where rows are solvers
  std::string programs = {};                        // table of what programs did by the clock, an arm a row

  bool is_of_arms() const { return column.empty(); }
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
// Throws std::invalid_argument with `source` and line for what is missing, unknown or repeated.
Paper read_paper(std::string_view name, std::string_view toml, std::string_view source);

// Of its table of means.
PrintedRows printed_rows(const Paper& paper, const judge::JudgedMetric& judged);

// A solver's share of solved targets. The interval is ours, as wide as that of the difference of the two
// shares: it has the printed one where the two do not differ.
struct Rate {
  std::string row;  // the arm as printed, or the solver
  bool is_picked;
  double printed, share;
  judge::Interval interval;
  double margin;                                              // of the study, which matters
  double mean_ms = std::numeric_limits<double>::quiet_NaN();  // of a program's solves
  std::string printed_ms = {};

  // "~": as printed; "x": not; "?": not decided, the interval is wider than twice the margin.
  std::string_view sign() const {
    if (printed < interval.low || interval.high < printed) return "x";
    return interval.high - interval.low <= 2 * margin ? "~" : "?";
  }
};

// A paper's study with its companions.
struct Repeated {
  const Paper& paper;
  std::span<const judge::JudgedStudy> studies;  // the first is the paper's own
  const base::CsvTable* programs = nullptr;     // robot, solver, n, solved, mean_ms; null: none

  const judge::JudgedStudy& study() const { return studies.front(); }
  // The companion NAME-part; null if there is none.
  const judge::JudgedStudy* part(std::string_view part) const;
  // Each study of which the paper's table of means may be, by itself, the paper's own first.
  std::vector<Repeated> readings() const;
  // "20 agents (Sec. 5.3.2)"; empty if the paper's table is of one study.
  std::string reading() const;
  // What its name adds to the paper's, for names of tables and figures: "-50".
  std::string suffix() const { return study().study.name.substr(paper.name.size()); }
};

// By solver, of the arms of all studies that the printed table has, in its order; or of its solvers in the paper's own
// study, under "solved".
std::map<std::string, std::vector<Rate>> rates_of(const Repeated& repeated);
// "KDL's printed rates repeat on 11 of 13 arms, KDL-RR's on 12.", then who fails where; none if none is printed.
std::vector<std::string> rates_sentences(const Repeated& repeated);

// A solver's statistics beside a printed row, with signs; unknown where values are lost. Times have no sign, for
// machines differ.
std::vector<show::Cell> beside(const judge::JudgedMetric& judged, const std::string& solver, const PrintedRow* row);
// Whether a statistic of ours rounds to the printed digits, or a new study's may.
bool repeats(double ours, const judge::Interval& range, std::string_view printed);
constexpr double share_in_ranges = 0.92;  // of numbers of the same program
constexpr std::string_view meaning_of_signs =
    "~ in the range that holds 92 % of such numbers of new studies by our program; x outside";
// How many of the printed numbers have the sign ~, of how many with a sign.
struct Explained {
  std::string reading = {};  // Repeated::reading()
  std::size_t explained = 0, all = 0;
  std::vector<std::string> own_missed = {};  // means of the paper's own solver: "error 0.0017 cm (printed 0.0019)"

  void add(const show::Cell& cell);
};
Explained explained_by(const Repeated& repeated);

// Means beside the printed ones, a row a solver.
show::Table means_table(const Repeated& repeated);
// The same of shares solved; without rows if none is printed.
show::Table rates_table(const Repeated& repeated);
// Ours minus the printed ones, with their intervals.
std::optional<figures::Figure> rates_figure(const Repeated& repeated);

}  // namespace ikbench::papers
