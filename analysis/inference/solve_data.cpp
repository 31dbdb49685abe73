#include "analysis/inference/solve_data.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

#include "analysis/inference/make_study.hpp"
#include "numerics/units.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

// Mixes the bits of each number as splitmix64 does.
std::uint64_t hash_of(std::span<const double> numbers) {
  std::uint64_t hash = numbers.size();
  for (const double number : numbers) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(number)) + 0x9e3779b97f4a7c15u;
    hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9u;
    hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebu;
    hash ^= hash >> 31;
  }
  return hash;
}

std::uint32_t digest_of(std::vector<double> numbers) {
  if (numbers.empty()) return no_digest;
  for (double& number : numbers) {
    if (std::isnan(number)) return no_digest;
    number += 0.0;  // -0 is 0
  }
  const auto digest = static_cast<std::uint32_t>(hash_of(numbers) >> 32);
  return digest == no_digest ? 1 : digest;
}

// Not defined if the answers have other numbers of joints, or are too few.
double mean_bend_deg(const std::vector<std::vector<double>>& answers) {
  const std::size_t joints = answers.front().size();
  const auto has_all = [&](const std::vector<double>& answer) { return answer.size() == joints; };
  if (answers.size() < 3 || !std::ranges::all_of(answers, has_all)) return not_defined;
  std::vector<double> bends;
  for (std::size_t k = 1; k + 1 < answers.size(); ++k) {
    const std::vector<double>&before = answers[k - 1], &here = answers[k], &after = answers[k + 1];
    for (std::size_t joint = 0; joint < joints; ++joint) {
      bends.push_back(std::abs(before[joint] / numerics::degree - 2 * (here[joint] / numerics::degree) +
                               after[joint] / numerics::degree));
    }
  }
  return mean(bends);
}

bool has_repeats(const SolveRecord& solve) { return solve.repeats > 1 && solve.smallest_seconds > 0; }

// Returns whether a clean solve took more than 10 % longer than its CPU time.
bool is_disturbed(const SolveRecord& solve) {
  constexpr double most = 0.1;  // largest accepted wait / time
  return solve.timing == Timing::clean && solve.seconds > (1 + most) * solve.cpu_seconds && solve.cpu_seconds > 0;
}

}  // namespace

bool same_target(const Problem& a, const Problem& b) {
  return std::ranges::equal(a.target_position_m, b.target_position_m) &&
         std::ranges::equal(a.target_rotation, b.target_rotation);
}

bool same_start(const Problem& a, const Problem& b) {
  return a.has_start && b.has_start && std::ranges::equal(a.start_rad, b.start_rad);
}

std::span<const double> Problems::list(std::size_t number) const {
  const std::size_t begin = number == 0 ? 0 : ends_[number - 1];
  return {numbers_.data() + begin, ends_[number] - begin};
}

// Puts the lengths first, because joined lists do not show them.
std::uint32_t Problems::number_of(const SolveRecord& solve, bool has_start) {
  asked_ = {static_cast<double>(solve.target_position_m.size()), static_cast<double>(solve.target_rotation.size()),
            has_start ? 1.0 : 0.0};
  asked_.insert(asked_.end(), solve.target_position_m.begin(), solve.target_position_m.end());
  asked_.insert(asked_.end(), solve.target_rotation.begin(), solve.target_rotation.end());
  if (has_start) asked_.insert(asked_.end(), solve.start_rad.begin(), solve.start_rad.end());
  const auto is_same = [](double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
  };
  // A list whose hash another one has gets the next free place.
  for (std::uint64_t place = hash_of(asked_);; ++place) {
    const auto [known, is_new] = index_.try_emplace(place, static_cast<std::uint32_t>(ends_.size()));
    if (is_new) {
      numbers_.insert(numbers_.end(), asked_.begin(), asked_.end());
      ends_.push_back(numbers_.size());
    }
    if (is_new || std::ranges::equal(list(known->second), asked_, is_same)) return known->second;
  }
}

void Problems::forget_index() { index_ = {}; }

Problem Problems::operator[](std::size_t number) const {
  constexpr std::size_t head = 3;
  const std::span<const double> all = list(number), lists = all.subspan(head);
  const auto position = static_cast<std::size_t>(all[0]), rotation = static_cast<std::size_t>(all[1]);
  return {.target_position_m = lists.first(position),
          .target_rotation = lists.subspan(position, rotation),
          .start_rad = lists.subspan(position + rotation),
          .has_start = all[2] != 0};
}

bool StudyMaker::is_following(const SolveRecord& record, std::uint16_t solver) const {
  if (answers_.empty()) return false;
  const Solve& last = solves_.back();
  return solver == last.solver && record.run == last.run && record.point == last.point + 1 &&
         !record.answer_rad.empty() && record.answer_rad.size() == record.start_rad.size() &&
         record.start_rad == answers_.back();
}

std::uint16_t StudyMaker::session_number(std::int64_t session) {
  std::vector<std::int64_t>& known = data_.sessions;
  if (known.empty() || known.back() != session) {
    const auto found = std::ranges::find(known, session);
    if (found != known.end()) return static_cast<std::uint16_t>(found - known.begin());
    if (known.size() > std::numeric_limits<std::uint16_t>::max()) {
      throw std::invalid_argument("the solves of a study come from more than 65536 sessions; expected no more");
    }
    known.push_back(session);
  }
  return static_cast<std::uint16_t>(known.size() - 1);
}

void StudyMaker::look_at(const SolveRecord& record, std::uint16_t solver) {
  SolverFacts& own = data_.of_solver[solver];
  const double longest = std::fmax(record.seconds, record.largest_seconds);
  own.uneven_repeats += has_repeats(record) && longest > much_longer * record.smallest_seconds ? 1 : 0;
  own.worst_outside_deg = std::max(own.worst_outside_deg, record.limit_violation_deg);
  data_.joints.insert({record.answer_rad.size(), record.start_rad.size()});
}

void StudyMaker::keep_drawn(const SolveRecord& record, bool is_first_of_solver) {
  std::vector<SolveRecord>& drawn = data_.drawn;
  if (!is_first_of_solver && drawn.back().run != record.run) return;
  drawn.push_back(record);
  drawn.back().trace_cm = {};
  drawn.back().improved_at = {};
  drawn.back().improved_to_cm = {};
}

void StudyMaker::end_run() {
  if (answers_.size() > 1) {
    const Solve& last = solves_.back();
    data_.shapes.push_back({.solver = last.solver, .run = last.run, .mean_bend_deg = mean_bend_deg(answers_)});
  }
  answers_.clear();
}

Solve StudyMaker::condensed(const SolveRecord& record, std::uint16_t solver) {
  const bool is_first_of_solver = solves_.empty() || solver != solves_.back().solver;
  if (data_.of_solver.size() <= solver) data_.of_solver.resize(solver + std::size_t{1});
  const bool is_following = this->is_following(record, solver);
  if (is_first_of_solver || record.run != solves_.back().run) end_run();
  if (data_.robot.empty()) data_.robot = record.robot;
  look_at(record, solver);
  keep_drawn(record, is_first_of_solver);
  Solve solve{.position_error_cm = record.position_error_cm,
              .orientation_error = record.orientation_error,
              .variation_deg = record.variation_deg,
              .largest_move_deg = record.largest_move_deg,
              .seconds = record.seconds,
              .evaluations = record.evaluations,
              .run = record.run,
              .point = record.point,
              .problem = data_.problems.number_of(record, study_.facts.starts_anew() || !is_following),
              .answer = digest_of(record.answer_rad),
              .iterations = static_cast<std::uint32_t>(
                  std::clamp<std::int64_t>(record.iterations, 0, std::numeric_limits<std::uint32_t>::max())),
              .solver = solver,
              .session = session_number(record.session),
              .status = record.status,
              .timing = record.timing,
              .stop_reason = record.stop_reason,
              .counted_by = record.counted_by,
              .is_outside_limits = record.limit_violation_deg > 0 || record.limit_violation_m > 0,
              .is_disturbed = is_disturbed(record),
              .is_repeated = has_repeats(record)};
  const bool has_course = record.improved_at.size() == record.improved_to_cm.size() && !record.improved_at.empty();
  if (!record.trace_cm.empty() || has_course || record.variation_m != 0) {
    RareData& rare = data_.rare.emplace_back(RareData{.trace_cm = record.trace_cm, .variation_m = record.variation_m});
    if (has_course) {
      rare.improved_at = record.improved_at;
      rare.improved_to_cm = record.improved_to_cm;
    }
    solve.rare = &data_.rare.back();
  }
  answers_.push_back(record.answer_rad);
  return solve;
}

}  // namespace ikbench::inference
