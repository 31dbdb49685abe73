#include "cli/series.hpp"

#include <cmath>
#include <utility>

#include "analysis/inference/make_study.hpp"
#include "analysis/statistics/quantile.hpp"
#include "cli/console.hpp"
#include "cli/plan_options.hpp"
#include "cli/reporting.hpp"

namespace ikbench::cli {

using namespace results;
using namespace experiments;
using namespace inference;

namespace {

RunMeans run_means(const Study& study, std::vector<SolveRecord> solves) {
  const StudyResults results = make_study(study.name, std::move(solves));
  const auto means = [&](Metric metric) {
    std::vector<double> values = samples(results, metric).front().values;
    for (double& value : values) value = std::isfinite(value) ? value : statistics::worse_than_every_number;
    return values;
  };
  return {.error_cm = means(Metric::position_error_cm), .variation_deg = means(Metric::variation_deg)};
}

}  // namespace

void add_series_options(CLI::App& command, int& seeds, int& jobs) {
  command.add_option("--seeds", seeds, "number of seeds, counted from 1; each is a study of its own")
      ->check(whole_number({1, 1000}))
      ->capture_default_str();
  command.add_option("--jobs", jobs, "number of series at once; the results do not depend on it")
      ->check(whole_number({1, 1024}))
      ->capture_default_str();
}

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
