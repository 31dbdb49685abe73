#include "cli/running.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>
#include <thread>

#include "analysis/judge/observe.hpp"
#include "base/names.hpp"
#include "cli/console.hpp"
#include "experiments/environment.hpp"
#include "results/merge.hpp"

namespace ikbench::cli {

namespace {

// Explains why solves that look done are made anew.
void warn_of_left_aside(const StoredStudy& study, const Store& store) {
  const LeftAside aside = left_aside(study, store);
  if (aside.solves == 0) return;
  warn(fmt::format(
      "another version of {} or of shared code made {}; the store keeps them, and this run solves those points again",
      fmt::join(aside.labels, ", "), counted(aside.solves, "solves")));
}

// Warns if somebody else has the store open, so that it is more than one file.
void tell_of_log(const std::vector<std::filesystem::path>& files) {
  if (files.size() < 2) return;
  warn(fmt::format(
      "another program has {0} open, so part of the data is still in {1}; copy both files together, or close "
      "that program and run this command again to merge them",
      files[0].string(), files[1].string()));
}

void warn_of_unreachable(const Study& study) {
  const std::vector<Unreachable> beyond = unreachable(study);
  if (beyond.empty()) return;
  const Unreachable& first = beyond.front();
  warn(fmt::format(
      "{} of a run are out of reach; point {} is {:.2f} cm from the shoulder, and the arm reaches {:.2f} cm",
      counted(std::ssize(beyond), "points"), first.point, first.distance * 100, first.reach * 100));
}

}  // namespace

void add_run_options(CLI::App& command, RunArguments& arguments) {
  add_out_option(command, arguments.out, "folder for the results; default: out/<study>");
  add_number(command, "--jobs", arguments.jobs, {1, 1024}, "number of solves at once; times are compared only with 1");
}

void check_plan(const Study& study) {
  if (!study.plan.metric.empty()) static_cast<void>(judge::metric_named(study.plan.metric));
}

std::filesystem::path store_in(const std::filesystem::path& folder) { return folder / "store.sqlite"; }

std::string run_study(const Study& study, const StoredStudy& stored, const std::filesystem::path& folder,
                      RunRequest request, Store::Mode mode) {
  if (const auto& arm = study.robot_of_file; arm != nullptr) {
    if (!arm->tip_link.empty()) say(fmt::format("arm: {} ({})", arm->summary, robots::size_of(*arm)));
    for (const std::string& note : arm->notes) say(note);
    for (const std::string& doubt : robots::doubts_of(*arm)) warn(doubt);
  }
  for (const std::string& note : study.notes) say(note);
  warn_of_unreachable(study);
  std::map<std::string, std::vector<std::string>> left_out;  // labels by why
  for (const LeftOut& entry : study.left_out) left_out[entry.why].push_back(entry.label);
  std::string without;
  for (const auto& [why, labels] : left_out)
    without += fmt::format("{}{} ({})", without.empty() ? "" : "; ", fmt::join(labels, ", "), why);
  if (!without.empty()) warn("left out: " + without);
  if (is_debug_build()) {
    warn("this is a debug build; its times are marked and not comparable");
  } else if (request.jobs > static_cast<int>(std::thread::hardware_concurrency())) {
    warn(fmt::format("{} jobs share {}", request.jobs, counted(std::thread::hardware_concurrency(), "processors")));
  }
  // A transaction for each solve would cost more than many a solve; in a shared store each waits for the disk.
  request.patience = std::chrono::milliseconds(mode == Store::Mode::write_shared ? 1000 : 20);
  Store store(store_in(folder), mode);
  for (const StoredStudy& earlier : store.studies(study.name)) {
    const std::string difference = difference_in_solves(earlier.definition.json, stored.definition.json);
    if (!difference.empty())
      warn(
          fmt::format("{} has a different study named {} ({}); its solves stay there, but its {}; use another name or "
                      "--out to keep both",
                      folder.string(), study.name, difference,
                      mode == Store::Mode::write_shared ? "definition is replaced, and merge takes no two of one name"
                                                        : "report is overwritten"));
  }
  warn_of_left_aside(stored, store);
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
  for (const std::string& note : progress.notes) warn(note);
  tell_of_log(store.finish());
  const auto may_meddle = [](const SolverEntry& entry) { return entry.program != nullptr; };
  if (std::ranges::any_of(study.solvers, may_meddle)) {  // a program can write where its user can
    const std::int64_t there = Store(store_in(folder), Store::Mode::read).number_of_solves(stored);
    if (there < progress.done)
      throw std::runtime_error(fmt::format(
          "{} has {} of the {} solves: one of the programs or somebody else changed it; run the same command again",
          store_in(folder).string(), there, progress.done));
  }
  if (is_cancelled) {
    say(fmt::format("Stopped: {} of {} solves are kept in {}; run the same command again to continue.", progress.done,
                    progress.total, store_in(folder).string()));
    throw Cancelled();
  }
  return fmt::format("{}{}: {} in {}{}", study.name,
                     request.shard.count == 1 ? "" : fmt::format(", shard {}", request.shard.text()),
                     counted(progress.total, "solves"), store_in(folder).string(),
                     progress.reused == 0 ? "" : fmt::format(" ({} were already stored)", progress.reused));
}

papers::SolvedMultiverse solved_multiverse(const std::string& study, const std::vector<Dimension>& varied,
                                           MultiverseRequest request, int jobs) {
  CancelOnSignal signals;
  request.cancelled = &signals.requested();
  const MultiversePlan plan = plan_multiverse(study, varied, request);
  std::optional<ProgressBar> bar("readings");
  const std::vector<PartMeans> means =
      solve_parts(plan.parts, {.jobs = jobs,
                               .progress = [&](const Progress& progress) { bar->show(progress); },
                               .cancelled = request.cancelled});
  bar.reset();  // leaves its line to the next words
  if (signals.end()) {
    say("Stopped. Readings are judged together, so none is kept; the same command solves them anew.");
    throw Cancelled();
  }
  papers::SolvedMultiverse multiverse{plan, {}};
  for (const PartMeans& part : means)
    multiverse.means.push_back({papers::group_of(part.error_cm), papers::group_of(part.variation_deg)});
  return multiverse;
}

}  // namespace ikbench::cli
