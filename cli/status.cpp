// ikbench status: shows the progress of a study's shards.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/reporting.hpp"
#include "cli/screen.hpp"
#include "cli/shards.hpp"

namespace ikbench::cli {

using namespace experiments;
using namespace report;

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

// The state of a shard; the shards of a division are counted by it.
enum class State { done, running, stopped, waiting };
constexpr std::array<std::string_view, 4> state_names{"done", "running", "stopped or failed", "not begun"};
using ShardsByState = std::array<std::vector<int>, state_names.size()>;

ShardsByState by_state(const Division& division) {
  ShardsByState shards;
  const auto of = [&](State state) -> std::vector<int>& { return shards[static_cast<std::size_t>(state)]; };
  int next = 1;
  for (const ShardState& state : division.shards) {
    for (; next < state.shard.index; ++next) of(State::waiting).push_back(next);
    ++next;
    const bool is_done = state.total > 0 && state.stored == state.total && state.trouble.empty();
    of(is_done ? State::done : state.is_running ? State::running : State::stopped).push_back(state.shard.index);
  }
  for (; next <= division.count; ++next) of(State::waiting).push_back(next);
  return shards;
}

// Solves per second of all shards, and the seconds that are left at that rate; none if nothing is running.
struct Pace {
  double rate = 0;
  std::optional<std::int64_t> seconds_left = {};
};

Pace pace_of(const Division& division) {
  Pace pace;
  for (const ShardState& state : division.shards) pace.rate += state.rate;
  if (pace.rate > 0) {
    const auto left = static_cast<double>(division.total - division.stored());
    pace.seconds_left = static_cast<std::int64_t>(std::ceil(left / pace.rate));
  }
  return pace;
}

void show(const Division& division) {
  constexpr std::array tones{Tone::good, Tone::plain, Tone::bad, Tone::open};
  const ShardsByState shards = by_state(division);
  Rows rows;
  Tones of_states;
  for (std::size_t state = 0; state < shards.size(); ++state) {
    if (shards[state].empty()) continue;
    rows.push_back({std::string(state_names[state]), std::to_string(shards[state].size()), ranges_of(shards[state])});
    of_states.of_rows.push_back(tones[state]);
  }
  fmt::print("{} of {} solves", division.stored(), division.total);
  if (const Pace pace = pace_of(division); pace.seconds_left) {
    const std::int64_t left = *pace.seconds_left;
    fmt::print(", {:.1f} per second, {}:{:02}:{:02} left", pace.rate, left / 3600, left / 60 % 60, left % 60);
  }
  fmt::print("\n{} shards\n", division.count);
  for (const std::string& line : aligned_rows(rows, text_width(), of_states)) fmt::print("{}\n", line);
  constexpr std::size_t most = 10;
  std::size_t troubles = 0;
  for (const ShardState& state : division.shards) {
    if (state.trouble.empty() || ++troubles > most) continue;
    fmt::print("{}\n", wrapped(fmt::format("Look at {}: {}", state.shard.text(), state.trouble)));
  }
  if (troubles > most) fmt::print("and at {} more, which --json lists\n", troubles - most);
}

report::Json json_of(const Division& division) {
  const Pace pace = pace_of(division);
  report::Json json{{"shards", division.count},
                    {"stored", division.stored()},
                    {"total", division.total},
                    {"solves_per_second", pace.rate},
                    {"seconds_left", pace.seconds_left ? report::Json(*pace.seconds_left) : report::Json(nullptr)},
                    {"troubles", report::Json::object()}};
  const ShardsByState shards = by_state(division);
  for (std::size_t state = 0; state < shards.size(); ++state) json[std::string(state_names[state])] = shards[state];
  for (const ShardState& state : division.shards)
    if (!state.trouble.empty()) json["troubles"][state.shard.text()] = state.trouble;
  return json;
}

bool is_complete(const Division& division) {
  return division.total > 0 &&
         std::ranges::all_of(division.shards, [](const ShardState& state) { return state.trouble.empty(); }) &&
         division.stored() == division.total;
}

struct MergedStore {
  std::int64_t stored = 0, total = 0;
};

MergedStore look_at(const std::filesystem::path& file) {
  const results::Store store(file, results::Store::Mode::read);
  MergedStore merged;
  for (const results::StudyEntry& study : store.studies()) {
    merged.stored += stored_by_shard(1, study, store).front();
    merged.total += solves_of({}, size_of(study));
  }
  return merged;
}

// Shows the shards and the merged store; true if all solves are there.
bool show_status(const std::filesystem::path& folder, const OutputArguments& output) {
  const std::vector<Division> all = divisions(folder);
  const std::filesystem::path file = store_in(folder);
  std::error_code error;
  const bool has_merged = std::filesystem::exists(file, error);
  if (all.empty() && !has_merged)
    throw std::invalid_argument(
        std::filesystem::is_directory(folder, error)
            ? fmt::format("no shard has begun in '{}'; expected stores as '{}'", (folder / "shards").string(),
                          store_in(shard_folder(folder, {.index = 1, .count = 12})).string())
            : fmt::format("'{}' is no folder; expected the folder of a study, in which there is a folder 'shards'",
                          folder.string()));
  if (!all.empty() && !output.is_json) show(all.front());
  for (std::size_t i = 1; i < all.size() && !output.is_json; ++i)
    fmt::print("{}\n", wrapped(fmt::format(
                           "Besides: {} solves in {} of {} shards, another division of the study; merge takes them too",
                           all[i].stored(), all[i].shards.size(), all[i].count)));
  const MergedStore merged = has_merged ? look_at(file) : MergedStore();
  if (output.is_json) {
    report::Json json{{"divisions", report::Json::array()}, {"merged", nullptr}};
    for (const Division& division : all) json["divisions"].push_back(json_of(division));
    if (has_merged) json["merged"] = {{"store", file.string()}, {"stored", merged.stored}, {"total", merged.total}};
    show_json(json);
  } else if (has_merged) {
    fmt::print("Merged: {} of {} solves in {}\n", merged.stored, merged.total, printable(file.string()));
  }
  const bool is_merged = merged.total > 0 && merged.stored == merged.total;
  return is_merged || (!all.empty() && is_complete(all.front()));
}

}  // namespace

void add_status(CLI::App& app, Invocation& invocation) {
  struct Arguments {
    std::string folder;
    OutputArguments output;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("status", "Show how far the shards of a study are");
  command->add_option("FOLDER", arguments->folder, "the folder of the study, whose shards are in FOLDER/shards")
      ->required();
  add_json_option(*command, arguments->output);
  command->footer(
      "Examples:\n"
      "  ikbench status out/slim2023\n\n"
      "Running is a shard that somebody writes to. Where a shard is stopped or failed, or not begun, the job may\n"
      "wait in the queue (squeue --me), or its output says why (FOLDER/log). The exit code is 0 where no solve\n"
      "is missing, in the shards or in FOLDER/store.sqlite, which merge makes; else 5.");
  command->callback([arguments, &invocation] {
    if (!show_status(arguments->folder, arguments->output)) invocation.exit_code = 5;
  });
}

}  // namespace ikbench::cli
