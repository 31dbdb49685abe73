#include "cli/running.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <thread>

#include "base/names.hpp"
#include "cli/console.hpp"
#include "experiments/environment.hpp"
#include "results/merge.hpp"

namespace ikbench::cli {

namespace {

// Prints notes and warnings about the study's arm, targets and solvers.
void print_notes(const Study& study) {
  if (const auto& arm = study.robot_of_file; arm != nullptr) {
    if (!arm->tip_link.empty()) print_message(fmt::format("arm: {} ({})", arm->summary, robots::size_of(*arm)));
    for (const std::string& note : arm->notes) print_message(note);
    for (const std::string& warning : robots::doubts_of(*arm)) warn(warning);
  }
  for (const std::string& note : study.notes) print_message(note);
  if (const std::vector<UnreachableTarget> targets = unreachable_targets(study); !targets.empty()) {
    const auto& [point, distance, reach] = targets.front();
    warn(fmt::format("{} per run {} unreachable (target {} is {:.2f} cm from the shoulder; the arm reaches {:.2f} cm)",
                     counted(std::ssize(targets), "targets"), targets.size() == 1 ? "is" : "are", point, distance * 100,
                     reach * 100));
  }
  if (const TargetGrid* const grid = study.path->grid(); grid != nullptr && grid->left_out > 0)
    print_message(fmt::format("{} certainly out of reach, and {} not made",
                              counted(grid->left_out, "targets") + (grid->left_out == 1 ? " is" : " are"),
                              grid->left_out == 1 ? "is" : "are"));
  std::map<std::string, std::vector<std::string>> labels_by_reason;
  for (const SkippedSolver& entry : study.skipped) labels_by_reason[entry.reason].push_back(entry.label);
  std::vector<std::string> left_out;
  for (const auto& [reason, labels] : labels_by_reason)
    left_out.push_back(fmt::format("{} ({})", fmt::join(labels, ", "), reason));
  if (!left_out.empty()) warn(fmt::format("left out: {}", fmt::join(left_out, "; ")));
}

}  // namespace

void add_run_options(const Command& command, RunArguments& arguments) {
  add_out_option(command, arguments.out, "folder for the results; default: out/<study>");
  command.add("--jobs", &arguments.jobs, "number of parallel solves; times are compared only with 1")
      .whole_number({1, 1024});
}

std::filesystem::path store_path(const std::filesystem::path& folder) { return folder / "store.sqlite"; }

std::string run_study(const Study& study, const StoredStudy& stored, const std::filesystem::path& folder,
                      RunRequest request, Store::Mode mode) {
  print_notes(study);
  if (is_debug_build()) {
    warn("this is a debug build: its times are marked and not compared; use a release build to compare times");
  } else if (request.jobs > static_cast<int>(std::thread::hardware_concurrency())) {
    warn(fmt::format("{} jobs share {}", request.jobs, counted(std::thread::hardware_concurrency(), "processors")));
  }
  // A transaction per solve would cost more time than a fast solve. In a shared store each transaction waits for the
  // disk.
  request.flush_interval = std::chrono::milliseconds(mode == Store::Mode::write_shared ? 1000 : 20);
  Store store(store_path(folder), mode);
  for (const StoredStudy& earlier : store.studies(study.name)) {
    const std::string difference = difference_in_solves(earlier.definition.json, stored.definition.json);
    if (!difference.empty())
      warn(fmt::format(
          "{} has a different study named {} ({}); its solves stay there, but its {}; to keep both, rerun "
          "with --out NEW",
          folder.string(), study.name, difference,
          mode == Store::Mode::write_shared ? "definition is replaced, and merge refuses two studies of one name"
                                            : "report is overwritten"));
  }
  Progress progress;
  bool is_cancelled = false;
  {
    ProgressBar bar(study.name);
    request.progress = [&](const Progress& now) { bar.show(now); };
    CancelOnSignal signals;
    request.cancelled = &signals.requested();
    progress = run(study, stored, store, request);
    is_cancelled = signals.end();
  }
  for (const std::string& note : progress.anomalies) warn(note);
  if (const auto files = store.close(); files.size() > 1)
    warn(fmt::format(
        "another program has {0} open, so part of the data is still in {1}; copy both files together, or close "
        "that program and run this command again to merge them",
        files[0].string(), files[1].string()));
  // A program can write wherever the user can, also into the store, so the solves of a study with programs are counted
  // again.
  const auto is_external = [](const SolverEntry& entry) { return entry.program != nullptr; };
  if (study.checker || std::ranges::any_of(study.solvers, is_external)) {
    const std::int64_t stored_solves = Store(store_path(folder), Store::Mode::read).solve_count(stored);
    if (stored_solves < progress.done)
      throw std::runtime_error(
          fmt::format("{} has only {} of the {} solves: another process changed it; run the same command again",
                      store_path(folder).string(), stored_solves, progress.done));
  }
  if (is_cancelled) {
    print_message(fmt::format("Stopped: {} of {} solves are kept in {}; run the same command again to continue.",
                              progress.done, progress.total, store_path(folder).string()));
    throw Cancelled();
  }
  return fmt::format("{}{}: {} in {}{}", study.name,
                     request.shard.count == 1 ? "" : fmt::format(", shard {}", request.shard.text()),
                     counted(progress.total, "solves"), store_path(folder).string(),
                     progress.reused == 0 ? "" : fmt::format(" ({} were already stored)", progress.reused));
}

}  // namespace ikbench::cli
