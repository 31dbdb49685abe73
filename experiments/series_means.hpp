// The means of series by run, which decide between readings. A file keeps them, so that a series is solved once
// for all commands that need it.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "experiments/runner.hpp"

namespace ikbench::experiments {

// One value >= 0 per run, the mean over its points; infinite if an answer is not finite.
struct RunMeans {
  std::vector<double> error_cm, variation_deg;
};

// A file with one line per series: key, errors, variations. A last line without its end, from a process that was
// stopped, is cut off.
class SeriesMeans {
 public:
  // Reads the file, if there is one. Throws std::invalid_argument for a line that is none of ours.
  explicit SeriesMeans(std::filesystem::path file);
  // The means of the first `runs` runs of a series; null if fewer were solved.
  const RunMeans* find(const std::string& key, std::size_t runs) const;
  void keep(const std::string& key, RunMeans means);  // appends to the file at once

 private:
  std::filesystem::path file_;
  std::map<std::string, RunMeans> known_;
};

struct SeriesRequest {
  std::function<RunMeans(const Study&, std::vector<results::SolveRecord>)> means_of;  // called by several threads
  int jobs = 1;                                                                       // series to solve at once
  std::function<void(const Progress&)> progress = {};  // called after every series, by one thread at a time
  const std::atomic<bool>* cancelled = nullptr;
};

// The means of series of one solver each, in their order; after Ctrl-C, those before the first missing one. Each is
// kept at once.
std::vector<RunMeans> solve_series(const std::vector<Study>& series, SeriesMeans& kept, const SeriesRequest& request);

}  // namespace ikbench::experiments
