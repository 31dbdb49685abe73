#include "experiments/series_means.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "experiments/study_writer.hpp"
#include "experiments/task.hpp"
#include "experiments/verifier.hpp"
#include "experiments/workers.hpp"
#include "numerics/number.hpp"
#include "numerics/random.hpp"
#include "numerics/units.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace results;

namespace {

constexpr std::string_view head_of_means = "series,position_error_cm,variation_deg,check\n";

std::string texts_of_numbers(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += fmt::format("{}{}", text.empty() ? "" : " ", text_of(value));
  return text;
}

// One number for each run; none if one of them is not 0 or more.
std::vector<double> numbers_in(std::string_view cell) {
  std::vector<double> values;
  for (std::size_t from = 0, end = 0; end < cell.size(); from = end + 1) {
    end = std::min(cell.find(' ', from), cell.size());
    const std::optional<double> value = number_from(cell.substr(from, end - from));
    if (!value || !(*value >= 0)) return {};
    values.push_back(*value);
  }
  return values;
}

// Means cannot be computed again without solving, so that an edited line is found by its hash.
std::string with_check(std::string_view line) { return fmt::format("{},{:016x}", line, Key(0).with(line).value()); }

// The series of a line, whose place is for the message.
std::pair<std::string, RunMeans> series_in(std::string_view whole, const std::string& place) {
  const std::string_view line = whole.substr(0, whole.rfind(','));
  const std::size_t first = line.find(','), second = line.rfind(',');
  if (first > 0 && first < second && whole == with_check(line)) {
    RunMeans means{.error_cm = numbers_in(line.substr(first + 1, second - first - 1)),
                   .variation_deg = numbers_in(line.substr(second + 1))};
    if (!means.error_cm.empty() && means.error_cm.size() == means.variation_deg.size())
      return {std::string(line.substr(0, first)), std::move(means)};
  }
  throw std::invalid_argument(fmt::format(
      "{}: the file was edited: remove this line to have its series solved again, or choose another --out", place));
}

// The key of the search alone: unless limits or wraps change where a solve starts, no search sees which way the wrist
// bends and turns. A program or library may be too late.
std::string search_key(Study study) {
  const SolverEntry& entry = study.solvers.front();
  const bool is_built_in = !entry.program && info_of(entry).library.empty();
  if (is_built_in && study.search == Search::wrist && study.limits == Limits::recorded && study.wrap == Wrap::no) {
    study.wrist_branch = WristBranch::nearest;
    study.wrist_turns = WristTurns::principal;
  }
  return series_key(study, study.solvers.front());
}

// Solves of one search with the wrist of another study: its errors and joint motion.
std::vector<SolveRecord> with_wrist_of(const Study& study, std::vector<SolveRecord> solves) {
  const robots::Robot arm = arm_of(study);
  const Task task(study, arm);
  std::vector<robots::Pose> poses;
  std::vector<robots::Configuration> own_starts;
  robots::Configuration start;
  for (int run = 0; SolveRecord & solve : solves) {
    if (solve.run != run) {
      run = solve.run;
      poses = targets(study, arm, run);
      own_starts = starts(study, arm, run);
      start = study.initial;
    }
    const auto place = static_cast<std::size_t>(solve.point - 1);
    if (!own_starts.empty()) start = own_starts[place];
    const robots::Configuration answer = task.completed(
        Eigen::Map<const Eigen::VectorXd>(solve.answer_rad.data(), task.arm().joints()), poses[place], start);
    const Verification verified = verify(arm, poses[place], start, answer);
    solve.position_error_cm = verified.position_error / centimetre;
    solve.variation_deg = verified.variation / degree;
    if (moves_arm(solve, study.start)) start = answer;
  }
  return solves;
}

std::int64_t solves_of_series(const Study& study) { return std::int64_t{study.runs} * study.path->points(); }

}  // namespace

SeriesMeans::SeriesMeans(std::filesystem::path file) : file_(std::move(file)) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::symlink_status(file_, error);
  if (!std::filesystem::exists(status)) return;
  if (!std::filesystem::is_regular_file(status)) {
    throw std::invalid_argument(fmt::format("{} is no regular file; choose another --out", file_.string()));
  }
  std::ifstream in(file_, std::ios::binary);
  if (!in) throw std::invalid_argument(fmt::format("cannot read {}", file_.string()));
  std::string line;
  std::uintmax_t whole = 0;
  for (int number = 1; std::getline(in, line) && !in.eof(); ++number) {
    whole += line.size() + 1;
    if (number == 1) {
      if (line + '\n' == head_of_means) continue;
      throw std::invalid_argument(fmt::format("{}:1: expected the header '{}'; remove the file or choose another --out",
                                              file_.string(), head_of_means.substr(0, head_of_means.size() - 1)));
    }
    auto [key, means] = series_in(line, fmt::format("{}:{}", file_.string(), number));
    RunMeans& known = known_[key];
    if (means.error_cm.size() > known.error_cm.size()) known = std::move(means);
  }
  in.close();
  if (whole < std::filesystem::file_size(file_, error) && !error) std::filesystem::resize_file(file_, whole, error);
  if (error) throw std::invalid_argument(fmt::format("cannot write {}: {}", file_.string(), error.message()));
}

const RunMeans* SeriesMeans::find(const std::string& key, std::size_t runs) const {
  const auto found = known_.find(key);
  return found == known_.end() || found->second.error_cm.size() < runs ? nullptr : &found->second;
}

void SeriesMeans::keep(const std::string& key, RunMeans means) {
  std::error_code error;
  if (file_.has_parent_path()) std::filesystem::create_directories(file_.parent_path(), error);
  errno = 0;
  std::ofstream out(file_, std::ios::binary | std::ios::app);
  out.seekp(0, std::ios::end);
  const std::string line =
      fmt::format("{},{},{}", key, texts_of_numbers(means.error_cm), texts_of_numbers(means.variation_deg));
  out << (out.tellp() == 0 ? head_of_means : "") << with_check(line) << '\n' << std::flush;
  if (!out) {
    throw std::runtime_error(fmt::format("cannot write {}: {}; make it writable, make room, or choose another --out",
                                         file_.string(), std::generic_category().message(errno)));
  }
  known_[key] = std::move(means);
}

std::vector<RunMeans> solve_series(const std::vector<Study>& series, SeriesMeans& kept, const SeriesRequest& request) {
  std::vector<std::optional<RunMeans>> solved(series.size());
  std::vector<std::string> keys;
  Progress progress;
  for (std::size_t i = 0; i < series.size(); ++i) {
    keys.push_back(series_key(series[i], series[i].solvers.front()));
    const std::int64_t solves = solves_of_series(series[i]);
    progress.total += solves;
    const auto runs = static_cast<std::size_t>(series[i].runs);
    if (const RunMeans* known = kept.find(keys.back(), runs)) {
      RunMeans& means = solved[i].emplace(*known);
      means.error_cm.resize(runs);
      means.variation_deg.resize(runs);
      progress.reused += solves;
    }
  }
  progress.done = progress.reused;
  std::mutex mutex;
  const auto take = [&](std::size_t place, RunMeans means) {
    const std::scoped_lock lock(mutex);
    kept.keep(keys[place], means);
    solved[place] = std::move(means);
    progress.done += solves_of_series(series[place]);
    if (request.progress) request.progress(progress);
  };
  if (request.progress) request.progress(progress);
  std::map<std::string, std::vector<std::size_t>> by_search;
  for (std::size_t i = 0; i < series.size(); ++i)
    if (!solved[i]) by_search[search_key(series[i])].push_back(i);
  std::vector<std::vector<std::size_t>> searches;
  for (auto& [key, places] : by_search) searches.push_back(std::move(places));
  std::ranges::sort(searches);  // in the order of the series
  std::atomic<std::size_t> next{0};
  std::atomic<bool> has_failed{false};
  const auto is_over = [&] { return has_failed || (request.cancelled != nullptr && *request.cancelled); };
  work_together(request.jobs, [&] {
    try {
      for (std::size_t s = next++; s < searches.size() && !is_over(); s = next++) {
        const Study& first = series[searches[s].front()];
        std::vector<SolveRecord> solves;
        solve_study(
            first, 1, [&](SolveRecord record) { solves.push_back(std::move(record)); }, request.cancelled);
        if (static_cast<std::int64_t>(solves.size()) < solves_of_series(first)) break;
        for (const std::size_t i : searches[s])
          take(i, request.means_of(series[i], &series[i] == &first ? solves : with_wrist_of(series[i], solves)));
      }
    } catch (...) {
      has_failed = true;
      throw;
    }
  });
  std::vector<RunMeans> means;
  for (std::size_t i = 0; i < series.size() && solved[i]; ++i) means.push_back(std::move(*solved[i]));
  return means;
}

}  // namespace ikbench::experiments
