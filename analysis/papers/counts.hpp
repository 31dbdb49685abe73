// Numbers of answers to the poses of a printed table, by stored solves of programs: ours beside the printed ones.
// `reproduce` shows them for a paper that has such a table and no study. Documented in docs/papers/ssik2026.md.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/show/table.hpp"
#include "base/csv.hpp"

namespace ikbench::papers {

struct Paper;     // paper.hpp
struct Repeated;  // repeated.hpp

// The number of answers to each pose, by arm; empty if the program refuses the arm.
using CountsByArm = std::map<std::string, std::vector<int>>;

// Returns the counts of a table with a row per pose and a column per arm. `source` is the table's name in messages.
// Throws std::invalid_argument if a cell is no whole number from 0 to 10000, or if a column has only some numbers.
CountsByArm read_counts(const base::CsvTable& table, std::string_view source);
// Returns the stored counts of the paper's programs, by program.
std::map<std::string, CountsByArm> stored_counts(const Paper& paper);

// An arm of the printed table, with the answers of a program.
struct CountedArm {
  std::string arm;
  std::string printed, ours;  // "2-8", the least and the largest number; "8" if both are the same; "refuses"
  int poses = 0, unanswered = 0;
  bool is_as_printed() const { return printed == ours; }
};
// Returns the arms of the printed table that have both a printed range in `column` and counts of the program.
std::vector<CountedArm> counted_arms(const Repeated& repeated, const std::string& program, const std::string& column);

// Returns "13 of 16 rows of ssik and 7 of 9 of EAIK are the published ones.", then on which arms a program
// differs and why, and the note of the paper's file.
std::vector<std::string> counts_sentences(const Repeated& repeated);
// Returns our ranges beside the printed ones, with a row per arm.
show::Table counts_table(const Repeated& repeated);

}  // namespace ikbench::papers
