// What series came to, as far as interpretations are compared by it: the means of their runs. Kept in a file, so that a
// series is solved once for all commands that need it.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "experiments/runner.hpp"

namespace ikbench::experiments {

// A value from 0 for every run, over its points; infinite where an answer is not finite.
struct RunMeans {
  std::vector<double> error_cm, variation_deg;
};

// A file with a line for each series: key, errors, variations. What an earlier process could not finish, a last line
// without its end, is cut off.
class SeriesMeans {
 public:
  // No file is kept where its name is empty. A line that is none of ours is std::invalid_argument.
  explicit SeriesMeans(std::filesystem::path file);
  // The means of so many runs of a series; null where it was not solved so often.
  const RunMeans* find(const std::string& key, std::size_t runs) const;
  void keep(const std::string& key, RunMeans means);  // behind the others, at once
  // Brings the lines into the order of their keys, whatever the order in which they were kept.
  void sort();

 private:
  void read();

  std::filesystem::path file_;
  std::map<std::string, RunMeans> known_;
  bool is_sorted_ = true;  // the file's lines are
};

struct SeriesRequest {
  std::function<RunMeans(const Study&, std::vector<results::SolveRecord>)> means_of;  // called by several threads
  int jobs = 1;                                                                       // series at once
  std::function<void(const Progress&)> progress = {};  // called after every series, by one thread at a time
  const std::atomic<bool>* cancelled = nullptr;
};

// The means of series of one solver each, in their order; after Ctrl-C those before the first that is missing. Each is
// kept as soon as it is there; at the end the file is sorted, and so the same for any number of jobs.
std::vector<RunMeans> solve_series(const std::vector<Study>& series, SeriesMeans& kept, const SeriesRequest& request);

}  // namespace ikbench::experiments
