// Counts all answers of a study: the known answers of each target, and how many of them each solver gave. `run` calls
// count_answers once the solves are made. A target costs 100 solves by Levenberg and Marquardt's method, once.
// Definitions: docs/explanation/methods.md#all-answers.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "base/files.hpp"
#include "experiments/study/study.hpp"
#include "experiments/task.hpp"
#include "results/store.hpp"

namespace ikbench::experiments {

constexpr int restarts_per_target = 100;

// Returns why the answers of a study cannot be counted, such as "7 joints for 6 freedoms: infinitely many answers";
// empty if they can.
std::string why_not_countable(const Study& study, const Robot& arm);

// Finds the different true answers to a goal. The target, the arm and the study must outlive the finder.
class AnswerFinder {
 public:
  AnswerFinder(const Study& study, const Robot& arm, const Pose& target);

  bool is_true(const Configuration& answer) const;  // [rad, m], within the tolerance
  // Adds a true answer, unless it is known. Returns the index among the known answers, or nullopt if the exact answer
  // is outside the limits. The exact answer decides, because an answer at a rounded limit, such as 3.14159 for pi, may
  // be within the tolerance of one that is outside.
  std::optional<std::size_t> add(const Configuration& answer);
  const std::vector<Configuration>& known() const { return known_; }
  // Returns whether a known answer is singular. There may then be a continuum of answers, or several that coincide.
  bool is_continuum() const { return is_continuum_; }

 private:
  // Returns the answer turned into the limits by whole turns where that is possible.
  Configuration turned(Configuration answer) const;
  bool is_inside(const Configuration& answer) const;  // the limits, if the study enforces them
  // Returns the answer after Newton's steps, whose error is about 1e-15 m.
  Configuration polished(const Configuration& answer) const;
  // Returns whether the Jacobian at a polished answer has a singular value [m, rad] below 1e-4.
  bool is_singular(const Configuration& exact) const;

  const Study& study_;
  const Robot& arm_;
  const Pose& target_;
  const Task task_;
  std::vector<Configuration> known_ = {};  // polished
  bool is_continuum_ = false;
  std::size_t beyond_ = 0;  // answers of a continuum that were not kept
};

// Counts the answers of a study and saves the counts in the store. Does nothing if the targets are a grid, if the
// study's answers cannot be counted, or if no solver gave several answers to a target. Restarts that the store has are
// not made again.
void count_answers(const Study& study, const results::StoredStudy& stored, results::Store& store, int jobs,
                   const std::atomic<bool>* cancelled = nullptr);

// Counts the answers of a stored study again, its restarts included. Returns nullopt if the restarts of this version
// are others, or if the targets cannot be made again. Throws std::invalid_argument if the stored study cannot be read.
std::optional<results::CountedAnswers> recounted_answers(const results::StoredStudy& stored,
                                                         const results::Store& store);

// Writes all answers of a stored study as CSV: run, point, label, number, q1 to qN [rad, m], and whether each answer is
// within the tolerance. Throws std::invalid_argument if the stored arm cannot be read.
void write_answers(const results::Store& store, const results::StoredStudy& stored, const base::Write& write);

}  // namespace ikbench::experiments
