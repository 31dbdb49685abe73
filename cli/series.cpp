#include "cli/series.hpp"

#include <utility>

#include "analysis/inference/study.hpp"
#include "cli/console.hpp"

namespace ikbench::cli {

using namespace results;
using namespace experiments;
using namespace inference;

namespace {

RunMeans run_means(const Study& study, std::vector<SolveRecord> solves) {
  const StudyResults results = make_study(study.name, std::move(solves));
  return {samples(results, Metric::position_error_cm).front().values,
          samples(results, Metric::variation_deg).front().values};
}

}  // namespace

std::vector<RunMeans> solved(const std::vector<Study>& series, const SeriesArguments& arguments) {
  SeriesMeans kept(arguments.folder.empty() ? arguments.folder : arguments.folder / "series.csv");
  ProgressBar bar(arguments.title);
  return solve_series(series, kept,
                      {.means_of = run_means,
                       .jobs = arguments.jobs,
                       .progress = [&](const Progress& progress) { bar.show(progress); },
                       .cancelled = arguments.cancelled});
}

}  // namespace ikbench::cli
