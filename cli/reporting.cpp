#include "cli/reporting.hpp"

#include <fmt/format.h>

#include <thread>

#include "analysis/report.hpp"
#include "cli/console.hpp"
#include "experiments/environment.hpp"
#include "experiments/runner.hpp"

namespace ikbench::cli {

void add_report_options(CLI::App& command, ReportArguments& arguments) {
  command.add_option("--unit", arguments.unit, "what one observation is: a run's mean over its points, or a point")
      ->check(CLI::IsMember({"run", "point"}))
      ->capture_default_str();
  command.add_option("--quartiles", arguments.quartiles, "Hyndman-Fan type of the boxes' quartiles; 5 is MATLAB's")
      ->check(CLI::Range(1, 9))
      ->capture_default_str();
  command.add_flag("--no-figures", arguments.without_figures, "tables only");
}

void add_run_options(CLI::App& command, RunArguments& arguments) {
  command.add_option("--out", arguments.out, "folder of the results; out/<study> if not given");
  command
      .add_option("--jobs", arguments.jobs, "solves at once; the same numbers, but times are comparable with 1 only")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
}

void write_and_announce(const Store& store, const std::string& study, const std::filesystem::path& folder,
                        const ReportArguments& arguments) {
  const Unit unit = arguments.unit == "run" ? Unit::run : Unit::point;
  const Report report = write_report(store, {.study = study,
                                             .folder = folder,
                                             .unit = unit,
                                             .quartiles = quantile_type(arguments.quartiles),
                                             .figures = {.render = !arguments.without_figures}});
  fmt::print("\n{}\n", aligned(readable_cells(report.results)));
  for (const std::string& sentence : report.summary) fmt::print("{}\n", printable(sentence));
  for (const std::string& warning : report.warnings) fmt::print(stderr, "warning: {}\n", printable(warning));
  fmt::print("Report: {}\n", printable(report.file.string()));
}

StudyEntry chosen_study(const Store& store, const std::string& name) {
  if (!name.empty()) return store.study(name);
  std::vector<StudyEntry> studies = store.studies();
  if (studies.empty()) throw std::invalid_argument("the store holds no study");
  return std::move(studies.front());
}

Ended run_and_tell(const Study& study, const std::filesystem::path& folder, RunRequest request) {
  for (const Unreachable& target : unreachable(study)) {
    fmt::print(stderr, "warning: point {} is out of reach: {:.2f} cm from the shoulder, reach {:.2f} cm\n",
               target.point, target.distance * 100, target.reach * 100);
  }
  if (is_debug_build()) {
    fmt::print(stderr, "warning: this is a debug build; times are marked as such\n");
  } else if (request.jobs > static_cast<int>(std::thread::hardware_concurrency())) {
    fmt::print(stderr, "warning: {} jobs on {} processors\n", request.jobs, std::thread::hardware_concurrency());
  }
  Store store(store_in(folder), Store::Mode::write);
  Progress progress;
  {
    ProgressBar bar(study.name);
    request.progress = [&](const Progress& now) { bar.show(now); };
    const CancelOnSignal signals;
    request.cancelled = &signals.requested();
    progress = run(study, store, request);
  }
  const std::string place = printable(store_in(folder).string());
  if (progress.done < progress.total) {
    fmt::print(stderr, "Stopped: {} of {} solves are kept in {}; the same command goes on from there.\n", progress.done,
               progress.total, place);
    return Ended::stopped;
  }
  fmt::print("{}: {} solves in {}{}\n", printable(study.name), progress.total, place,
             progress.reused == 0 ? "" : fmt::format(" ({} were there already)", progress.reused));
  return Ended::complete;
}

std::filesystem::path store_in(const std::filesystem::path& folder) { return folder / "store.sqlite"; }

}  // namespace ikbench::cli
