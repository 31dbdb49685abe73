// The numbers that the analysis keeps of a solve. They take about a hundred bytes, so that a study may have ten million
// solves. Facts from lists (angles, targets, traces) are taken while the record is read (solve_data.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "results/record.hpp"

namespace ikbench::inference {

// Data that few solves have.
struct RareData {
  std::vector<double> trace_cm = {};
  std::vector<double> improved_at = {}, improved_to_cm = {};
  double variation_m = 0;
};

// Fields without a comment have the name and meaning of the record's column.
struct Solve {
  double position_error_cm = 0;
  double orientation_error = 0;
  double variation_deg = 0;
  double largest_move_deg = 0;
  double seconds = 0;
  std::int64_t evaluations = 0;
  const RareData* rare = nullptr;  // owned by SolveData; null if the solve has none
  int run = 1;
  int point = 1;
  std::uint32_t problem = 0;  // index of its target and start in SolveData::problems
  std::uint32_t answer = 0;   // digest of answer_rad; no_digest if it is empty or has a NaN
  std::uint32_t iterations = 0;
  std::uint16_t solver = 0;   // index in SolveData::labels
  std::uint16_t session = 0;  // index in SolveData::sessions
  results::Status status = results::Status::ok;
  results::Timing timing = results::Timing::clean;
  results::StopReason stop_reason = results::StopReason::iterations;
  results::CountedBy counted_by = results::CountedBy::suite;
  bool is_outside_limits : 1 = false;
  bool is_disturbed : 1 = false;  // other programs took the processor while it was timed
  bool is_repeated : 1 = false;   // it was repeated for timing; its shortest time is known
};
static_assert(sizeof(Solve) <= 88);

constexpr std::uint32_t no_digest = 0;

// Returns whether the verifier accepts the answer: within the study's tolerance, if any, and inside the joint limits.
inline bool is_ok(const Solve& solve) { return solve.status == results::Status::ok; }

// Returns whether two answers are the same bit for bit. Compares digest and both errors.
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

  // Returns the solves for writing; copies keep their own.
  std::vector<Solve>& to_change() {
    if (!shared_ || shared_.use_count() > 1) *this = SolveList(shared_ ? *shared_ : std::vector<Solve>());
    return *shared_;
  }

 private:
  std::shared_ptr<std::vector<Solve>> shared_;
};

}  // namespace ikbench::inference
