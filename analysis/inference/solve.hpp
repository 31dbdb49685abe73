// What the analysis keeps of a solve: numbers in little more than a hundred bytes, so that a study may have ten million
// of them. What it needs of lists (angles, targets, traces) is taken from the record when that is read (gathered.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "results/record.hpp"

namespace ikbench::inference {

// What few solves have.
struct Extras {
  std::vector<double> trace_cm = {};
  double variation_m = 0;
};

// Names are those of the record's columns; all else is said here.
struct Solve {
  double position_error_cm = 0;
  double orientation_error = 0;
  double variation_deg = 0;
  double largest_move_deg = 0;
  double seconds = 0;
  double limit_margin = 0;
  double smallest_singular_value = 0;
  double manipulability = 0;
  std::int64_t evaluations = 0;
  const Extras* extras = nullptr;  // null where there is nothing of it; the study's (Gathered)
  int run = 1;
  int point = 1;
  std::uint32_t problem = 0;  // its target and start: the number in Gathered::problems
  std::uint32_t answer = 0;   // digest of answer_rad; no_digest where there is none, or a number of it is NaN
  std::uint32_t iterations = 0;
  std::uint16_t solver = 0;   // its number in Gathered::labels
  std::uint16_t session = 0;  // its number in Gathered::sessions
  results::Status status = results::Status::ok;
  results::Timing timing = results::Timing::clean;
  results::StopReason stop_reason = results::StopReason::iterations;
  results::CountedBy counted_by = results::CountedBy::suite;
  bool is_outside_limits : 1 = false;
  bool is_disturbed : 1 = false;  // other programs kept the processor from it while it was timed
  bool is_repeated : 1 = false;   // to time it, and its shortest time is known
  bool is_following : 1 = false;  // it starts from the answer to the point before it
};
static_assert(sizeof(Solve) <= 112);

constexpr std::uint32_t no_digest = 0;

// Whether the verifier finds the answer in order: in a study with a tolerance within it, and inside the joint limits.
inline bool is_ok(const Solve& solve) { return solve.status == results::Status::ok; }

// To the last bit. Two answers that are not the same would have to meet in a digest and in both errors.
inline bool has_same_answer(const Solve& a, const Solve& b) {
  return a.answer == b.answer && a.answer != no_digest && a.position_error_cm == b.position_error_cm &&
         a.orientation_error == b.orientation_error;
}

// The solves of a study, in the order of its solvers, then run, then point. Copies share them until one is changed.
class SolveList {
 public:
  SolveList() = default;
  explicit SolveList(std::vector<Solve> solves) : shared_(std::make_shared<std::vector<Solve>>(std::move(solves))) {}

  const Solve* begin() const { return data(); }
  const Solve* end() const { return data() + size(); }
  const Solve* data() const { return shared_ ? shared_->data() : nullptr; }
  std::size_t size() const { return shared_ ? shared_->size() : 0; }
  bool empty() const { return size() == 0; }
  const Solve& front() const { return shared_->front(); }
  const Solve& operator[](std::size_t i) const { return (*shared_)[i]; }

  // To be changed, which no copy sees.
  std::vector<Solve>& to_change() {
    if (!shared_ || shared_.use_count() > 1) *this = SolveList(shared_ ? *shared_ : std::vector<Solve>());
    return *shared_;
  }

 private:
  std::shared_ptr<std::vector<Solve>> shared_;
};

}  // namespace ikbench::inference
