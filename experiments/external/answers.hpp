// Answers that were made elsewhere: a CSV file that a study names in place of a program. The reader of studies reads
// the file once; GivenSolver looks answers up by run and point. The file is documented in docs/answers.md.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/external/external_solver.hpp"
#include "robots/robot.hpp"
#include "solvers/solver.hpp"

namespace ikbench::experiments {

constexpr std::uintmax_t max_answer_bytes = 1'000'000'000;

// One row of the file. Rows of one target are several answers.
struct GivenRow {
  int run = 1, point = 1;
  std::size_t line = 0;     // of the file, from 1
  double seconds = 0;       // [s], self-reported; NaN: the row has none
  std::string target = {};  // digest of the target; empty: the file has none
};

// The rows from `first` on that answer one target.
struct RowRange {
  std::size_t first = 0, count = 0;
};

// A file of answers, in memory: 100 bytes per row and 8 per joint.
struct GivenAnswers {
  std::string file;              // as the study names it
  std::string path = {};         // of the file; empty: the answers are of a text
  std::string digest;            // of its text
  std::vector<GivenRow> rows;    // by run and point; rows of one target in the order of the file
  robots::Candidates q;          // [rad, m], a column per row; NaN for a cell that is no number
  robots::Candidates poses;      // x, y, z [m], qx, qy, qz, qw, a column per row; no column if the file has no poses
  bool names_targets = false;    // the file has a column `target`
  bool has_times = false;        // the file has a column `ms`
  std::string no_number = {};    // "line 11: q3", the first cell of a joint that is no number; empty: there is none
  std::size_t lacking_rows = 0;  // rows with such a cell

  RowRange of(int run, int point) const;
};

// Reads a file. `name` is its name in the study, and `folder` the study's folder. Returns null if there is no such
// file. Throws std::invalid_argument if the file is no table of answers for this arm, is too large, or is outside the
// folder without a full path.
std::shared_ptr<const GivenAnswers> read_answers(const std::string& name, const std::filesystem::path& folder,
                                                 const Robot& arm);
// Returns the answers of a text, as read_answers does.
GivenAnswers answers_in(std::string_view text, const std::string& name, const Robot& arm);

// Returns the digest of a file of answers that a store names; nullopt if the current folder has no such file.
std::optional<std::string> digest_of_answers(const std::string& name);

// Returns, with the line, which answer is to a target that the study does not have; empty if there is none.
std::string difference_in_targets(const GivenAnswers& answers, const Study& study, const Robot& arm);

// Answers from a file as a solver. Call `select` before each solve.
class GivenSolver final : public solvers::Searcher {
 public:
  // The answers must outlive the solver. `policy` is how the study wraps answers.
  GivenSolver(const GivenAnswers& answers, results::WrapPolicy policy) : answers_(answers), wrap_(policy) {}

  void select(int run, int point) { rows_ = answers_.of(run, point); }
  void start(const solvers::Problem& problem, solvers::Objective& objective, numerics::Random& random) override;
  void step(solvers::Objective&, numerics::Random&) override {}
  bool finished() const override { return true; }
  bool gave_up() const override { return rows_.count == 0; }
  ProcessReport report() const;             // `declined` if the file has no answer
  double seconds() const;                   // [s], self-reported; NaN if the file has none
  std::vector<double> all_answers() const;  // [rad, m], if there are several; otherwise empty

 private:
  const GivenAnswers& answers_;
  const results::WrapPolicy wrap_;
  RowRange rows_;
  robots::Candidates turned_;  // answers to this target, turned into the limits by whole turns
};

}  // namespace ikbench::experiments
