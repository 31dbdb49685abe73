// A paper's study, repeated: our means and rates beside the printed ones.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/judge/judge.hpp"
#include "analysis/papers/multiverse.hpp"
#include "analysis/papers/paper.hpp"
#include "analysis/papers/published.hpp"
#include "analysis/show/table.hpp"
#include "base/csv.hpp"

namespace ikbench::papers {

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
  // Returns the part of the study's name behind the paper's, for names of tables and figures: "-50".
  std::string suffix() const { return study().study.name.substr(paper.name.size()); }
};

// Returns the rows of the paper's table of means for this metric.
PrintedRows printed_rows(const Paper& paper, const judge::JudgedMetric& judged);
// Ours beside the printed digits, if there are any.
show::Cell beside(double ours, std::string_view printed);
// A solver's statistics beside a printed row, with signs; unknown where values are lost. Times have no sign, for
// machines differ.
std::vector<show::Cell> beside(const judge::JudgedMetric& judged, const std::string& solver, const PrintedRow* row);
constexpr std::string_view meaning_of_signs =
    "~ in the range that holds 92 % of such numbers of new studies by our program; x outside";

// Means beside the printed ones, a row a solver, and how many of its numbers repeat by seed.
show::Table means_table(const Repeated& repeated, const SeedCounts& counts = {});

// A number of ours beside a printed one, in its unit. The interval is ours, as wide as that of the difference of the
// two: it has the printed one where they do not differ.
struct Rate {
  std::string row;  // the arm as printed, or the solver
  std::string digits;
  double printed, ours;
  judge::Interval interval;
  double margin;                                              // what matters
  double n, n_printed = 0;                                    // printed: of shares
  double mean_ms = std::numeric_limits<double>::quiet_NaN();  // of a program's solves
  std::string printed_ms = {};

  // "~": as printed; "x": not; "?": not decided, the interval is wider than twice the margin.
  std::string_view sign() const {
    if (printed < interval.low || interval.high < printed) return "x";
    return interval.high - interval.low <= 2 * margin ? "~" : "?";
  }
};
struct RateColumn {
  std::string name;  // a solver, or what is counted
  std::vector<Rate> rates = {};
};

// By solver, of the arms of all studies that a printed table has (empty: the paper's own), in its order; or the columns
// of means.
std::vector<RateColumn> rates_of(const Repeated& repeated, std::string table = "");
// "KDL's printed rates repeat on 11 of 13 arms, KDL-RR's on 12.", then who fails where; none if none is printed.
std::vector<std::string> rates_sentences(const Repeated& repeated);
// Without rows if none is printed.
show::Table rates_table(const Repeated& repeated, const std::string& table = "");
// Ours minus the printed ones, with their intervals.
std::optional<figures::Figure> rates_figure(const Repeated& repeated);

}  // namespace ikbench::papers
