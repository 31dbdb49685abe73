// A paper's study, repeated: tables and figures with our means and rates beside the printed ones. The reports of
// published studies and `reproduce` are made of these.
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/judge/judge.hpp"
#include "analysis/papers/counts.hpp"
#include "analysis/papers/multiverse.hpp"
#include "analysis/papers/paper.hpp"
#include "analysis/papers/published.hpp"
#include "analysis/show/table.hpp"
#include "base/csv.hpp"

namespace ikbench::papers {

// The results of a paper's study and of the study's companions.
struct Repeated {
  const Paper& paper;
  std::span<const judge::JudgedStudy> studies;     // the first is the paper's own
  const base::CsvTable* programs = nullptr;        // robot, solver, n, solved, mean_ms; null: none
  std::map<std::string, CountsByArm> counts = {};  // stored answers, by program

  const judge::JudgedStudy& study() const { return studies.front(); }
  // Returns the companion NAME-part; null if there is none.
  const judge::JudgedStudy* part(std::string_view part) const;
  // Returns the interpretations: each study from which the paper's table of means may be, by itself, the paper's own
  // study first.
  std::vector<Repeated> readings() const;
  // Returns the words for this interpretation: "20 agents (Sec. 5.3.2)". Empty if the paper has only one.
  std::string reading() const;
  // Returns the part of the study's name behind the paper's, for names of tables and figures: "-50".
  std::string suffix() const { return study().study.name.substr(paper.name.size()); }
};

// Returns the rows of the paper's table of means for this metric.
PrintedRows printed_rows(const Paper& paper, const judge::JudgedMetric& judged);
// Returns our number beside the printed digits. Without printed digits the cell has only our number.
show::Cell beside(double ours, std::string_view printed);
// Returns a solver's statistics beside a printed row, with signs. A statistic is unknown if values are missing. Times
// have no sign, because machines differ.
std::vector<show::Cell> beside(const judge::JudgedMetric& judged, const std::string& solver, const PrintedRow* row);
constexpr std::string_view meaning_of_signs =
    "~ in the range of about 95 % of our reruns; ? in a range wider than a factor of ten; x outside.";

// Returns our means beside the printed ones, with a row per solver, and how many numbers of each solver repeat by seed.
show::Table means_table(const Repeated& repeated, const SeedCounts& counts = {});

// A number of ours beside a printed one, in the printed unit. The interval is around our number and as wide as the
// interval of the difference: the printed number lies within if the two numbers do not differ.
struct Rate {
  std::string row;  // the arm as printed, or the solver
  std::string digits;
  double printed, ours;
  judge::Interval interval;
  double margin;                                              // the smallest difference that matters
  double n, n_printed = 0;                                    // values of ours, and of the paper (only for shares)
  double mean_ms = std::numeric_limits<double>::quiet_NaN();  // of a program's solves
  std::string printed_ms = {};

  // Returns "~" if the number is as printed, "x" if not, and "?" if the interval is too wide to decide: wider than
  // twice the margin.
  std::string_view sign() const {
    if (printed < interval.low || interval.high < printed) return "x";
    return interval.high - interval.low <= 2 * margin ? "~" : "?";
  }
};
// A column of rates.
struct RateColumn {
  std::string name;  // a solver, or what is counted
  std::vector<Rate> rates = {};
};

// Returns the shares solved by solver, for the arms of a printed table that our studies have, in the table's order. An
// empty `name` stands for the paper's own table. For a paper with columns of means those columns are returned.
std::vector<RateColumn> rates_of(const Repeated& repeated, std::string name = "");
// Returns "We reproduce the rates of README 1.4.6 for KDL on 11 of 13 arms and for KDL-RR on 12 of 13.", then the arms
// on which a solver's rate is not reproduced. Empty if the paper prints no rates.
std::vector<std::string> rates_sentences(const Repeated& repeated);
// Returns our rates beside the printed ones. Without rows if the paper prints no rates.
show::Table rates_table(const Repeated& repeated, const std::string& name = "");
// Returns the figure of our rates minus the printed ones, with intervals. Of columns of means only the first is shown.
// Nullopt if the figure would have no rate.
std::optional<figures::Figure> rates_figure(const Repeated& repeated);

}  // namespace ikbench::papers
