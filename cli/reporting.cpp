#include "cli/reporting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "analysis/report.hpp"
#include "cli/console.hpp"
#include "experiments/environment.hpp"
#include "experiments/runner.hpp"
#include "experiments/study_file.hpp"

namespace ikbench::cli {

CLI::Validator whole_number() {
  return CLI::Validator(
      [](const std::string& text) {
        const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
        return digits && text.size() <= 18 && (text == "0" || text[0] != '0')
                   ? std::string()
                   : fmt::format("{} is not a whole number without leading zeros", text.substr(0, 100));
      },
      "");
}

void add_report_options(CLI::App& command, ReportArguments& arguments) {
  command.add_option("--unit", arguments.unit, "what one observation is: a run's mean over its points, or a point")
      ->check(CLI::IsMember({"run", "point"}))
      ->capture_default_str();
  command.add_option("--quartiles", arguments.quartiles, "Hyndman-Fan type of the boxes' quartiles; 5 is MATLAB's")
      ->check(whole_number())
      ->check(CLI::Range(1, 9))
      ->capture_default_str();
  command.add_flag("--no-figures", arguments.without_figures, "tables only");
}

void add_run_options(CLI::App& command, RunArguments& arguments) {
  command.add_option("--out", arguments.out, "folder of the results; out/<study> if not given");
  command
      .add_option("--jobs", arguments.jobs, "solves at once; the same numbers, but times are comparable with 1 only")
      ->check(whole_number())
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
}

void write_and_announce(const Store& store, const std::string& study, const std::filesystem::path& folder,
                        const ReportArguments& arguments, Additions additions) {
  const Unit unit = arguments.unit == "run" ? Unit::run : Unit::point;
  const Report report = write_report(store, {.study = study,
                                             .folder = folder,
                                             .unit = unit,
                                             .quartiles = quantile_type(arguments.quartiles),
                                             .figures = {.render = !arguments.without_figures},
                                             .extra_tables = std::move(additions.tables),
                                             .extra_figures = std::move(additions.figures)});
  fmt::print("\n{}\n", aligned(readable_cells(report.results)));
  for (const std::string& sentence : report.summary) fmt::print("{}\n", printable(sentence));
  for (const std::string& remark : additions.remarks) fmt::print("{}\n", printable(remark));
  for (const std::string& warning : report.warnings) say("warning: " + warning);
  fmt::print("Report: {}\n", printable(report.page.string()));
}

StudyEntry chosen_study(const Store& store, const std::string& name) {
  if (!name.empty()) return store.study(name);
  std::vector<StudyEntry> studies = store.studies();
  if (studies.empty()) throw std::invalid_argument("the store holds no study");
  return std::move(studies.front());
}

void warn_of_unreachable(const Study& study) {
  const std::vector<Unreachable> found = unreachable(study);
  constexpr std::size_t most = 10;
  for (std::size_t i = 0; i < std::min(found.size(), most); ++i) {
    say(fmt::format("warning: point {} is out of reach: {:.2f} cm from the shoulder, reach {:.2f} cm", found[i].point,
                    found[i].distance * 100, found[i].reach * 100));
  }
  if (found.size() > most) say(fmt::format("warning: and {} more points are out of reach", found.size() - most));
}

Ended run_and_tell(const Study& study, const std::filesystem::path& folder, RunRequest request) {
  warn_of_unreachable(study);
  if (is_debug_build()) {
    say("warning: this is a debug build; times are marked as such");
  } else if (request.jobs > static_cast<int>(std::thread::hardware_concurrency())) {
    say(fmt::format("warning: {} jobs on {} processors", request.jobs, std::thread::hardware_concurrency()));
  }
  Store store(store_in(folder), Store::Mode::write);
  for (const StudyEntry& earlier : store.studies()) {
    if (earlier.name == study.name && earlier.definition != to_json(study)) {
      say(fmt::format(
          "warning: {} has another study named {}; its solves stay there, its report is written anew (another "
          "name or --out keeps both)",
          folder.string(), study.name));
    }
  }
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
    say(fmt::format("Stopped: {} of {} solves are kept in {}; the same command goes on from there.", progress.done,
                    progress.total, place));
    return Ended::stopped;
  }
  fmt::print("{}: {} solves in {}{}\n", printable(study.name), progress.total, place,
             progress.reused == 0 ? "" : fmt::format(" ({} were there already)", progress.reused));
  return Ended::complete;
}

std::filesystem::path store_in(const std::filesystem::path& folder) { return folder / "store.sqlite"; }

}  // namespace ikbench::cli
