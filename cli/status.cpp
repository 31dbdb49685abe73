// ikbench status: shows the progress of a study's shards.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/reporting.hpp"
#include "cli/shards.hpp"

namespace ikbench::cli {

using namespace experiments;

namespace {

// Sorted numbers as ranges: 1-4, 6, 8-9.
std::string ranges_of(const std::vector<int>& numbers) {
  constexpr std::size_t most = 200;
  std::string text;
  for (std::size_t i = 0; i < numbers.size() && text.size() < most;) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", numbers[i]);
    if (last > i) text += fmt::format("-{}", numbers[last]);
    i = last + 1;
  }
  return text.size() < most ? text : text + ", ...";
}

void show(const Division& division) {
  std::vector<int> done, running, stopped, waiting;
  double rate = 0;
  int next = 1;
  for (const ShardState& state : division.shards) {
    for (; next < state.shard.index; ++next) waiting.push_back(next);
    ++next;
    const bool is_done = state.total > 0 && state.stored == state.total && state.trouble.empty();
    (is_done ? done : state.is_running ? running : stopped).push_back(state.shard.index);
    rate += state.rate;
  }
  for (; next <= division.count; ++next) waiting.push_back(next);
  std::vector<std::vector<std::string>> rows;
  const auto add = [&](const char* what, const std::vector<int>& shards) {
    if (!shards.empty()) rows.push_back({what, std::to_string(shards.size()), ranges_of(shards)});
  };
  add("done", done);
  add("running", running);
  add("stopped or failed", stopped);
  add("not begun", waiting);
  fmt::print("{} shards\n{}{} of {} solves", division.count, aligned(rows), division.stored(), division.total);
  if (rate > 0) {
    const auto left =
        static_cast<std::int64_t>(std::ceil(static_cast<double>(division.total - division.stored()) / rate));
    fmt::print(", {:.1f} per second, {}:{:02}:{:02} left", rate, left / 3600, left / 60 % 60, left % 60);
  }
  fmt::print("\n");
  for (const ShardState& state : division.shards)
    if (!state.trouble.empty()) fmt::print("Look at {}: {}\n", state.shard.text(), printable(state.trouble));
}

bool is_complete(const Division& division) {
  return division.total > 0 &&
         std::ranges::all_of(division.shards, [](const ShardState& state) { return state.trouble.empty(); }) &&
         division.stored() == division.total;
}

// Shows the merged store; true if it is complete.
bool show_merged(const std::filesystem::path& file) {
  const results::Store store(file, results::Store::Mode::read);
  std::int64_t stored = 0, total = 0;
  for (const results::StudyEntry& study : store.studies()) {
    stored += stored_by_shard(1, study, store).front();
    total += solves_of({}, size_of(study));
  }
  fmt::print("Merged: {} of {} solves in {}\n", stored, total, printable(file.string()));
  return total > 0 && stored == total;
}

// Shows the shards; true if all solves are there.
bool show_status(const std::filesystem::path& folder) {
  const std::vector<Division> all = divisions(folder);
  std::error_code error;
  const bool has_merged = std::filesystem::exists(store_in(folder), error);
  if (all.empty() && !has_merged)
    throw std::invalid_argument(
        std::filesystem::is_directory(folder, error)
            ? fmt::format("no shard has begun in '{}'; expected stores as '{}'", (folder / "shards").string(),
                          store_in(shard_folder(folder, {.index = 1, .count = 12})).string())
            : fmt::format("'{}' is no folder; expected the folder of a study, in which there is a folder 'shards'",
                          folder.string()));
  if (!all.empty()) show(all.front());
  for (std::size_t i = 1; i < all.size(); ++i)
    fmt::print("Besides: {} solves in {} of {} shards, another division of the study; merge takes them too\n",
               all[i].stored(), all[i].shards.size(), all[i].count);
  const bool is_merged = has_merged && show_merged(store_in(folder));
  return is_merged || (!all.empty() && is_complete(all.front()));
}

}  // namespace

void add_status(CLI::App& app, Invocation& invocation) {
  auto folder = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("status", "Show how far the shards of a study are");
  command->add_option("FOLDER", *folder, "the folder of the study, whose shards are in FOLDER/shards")->required();
  command->footer(
      "Examples:\n"
      "  ikbench status out/slim2023\n\n"
      "Running is a shard that somebody writes to. Where a shard is stopped or failed, or not begun, the job may\n"
      "wait in the queue (squeue --me), or its output says why (FOLDER/log). The exit code is 0 where no solve\n"
      "is missing, in the shards or in FOLDER/store.sqlite, which merge makes; else 5.");
  command->callback([folder, &invocation] {
    if (!show_status(*folder)) invocation.exit_code = 5;
  });
}

}  // namespace ikbench::cli
