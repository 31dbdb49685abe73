// ikbench status: how far the shards of a study are.
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/shards.hpp"

namespace ikbench::cli {

using namespace experiments;

namespace {

// Numbers in order, neighbours together: 1-4, 6, 8-9.
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

// Those of one N; `total` solves are asked for where shards have not begun, as far as the others say.
void show(const std::vector<ShardState>& states) {
  const int count = states.front().shard.count;
  std::vector<int> done, running, stopped, waiting;
  std::int64_t stored = 0, total = 0;
  double rate = 0;
  int next = 1;
  for (const ShardState& state : states) {
    for (; next < state.shard.index; ++next) waiting.push_back(next);
    ++next;
    (state.stored == state.total ? done : state.is_open ? running : stopped).push_back(state.shard.index);
    stored += state.stored;
    total += state.total;
    rate += state.rate;
  }
  for (; next <= count; ++next) waiting.push_back(next);
  total += total / static_cast<std::int64_t>(states.size()) * static_cast<std::int64_t>(waiting.size());
  std::vector<std::vector<std::string>> rows;
  const auto add = [&](const char* what, const std::vector<int>& shards) {
    if (!shards.empty()) rows.push_back({what, std::to_string(shards.size()), ranges_of(shards)});
  };
  add("done", done);
  add("running", running);
  add("stopped or failed", stopped);
  add("not begun", waiting);
  fmt::print("{} shards\n{}{}{} of {} solves", count, aligned(rows), waiting.empty() ? "" : "about ", stored, total);
  if (rate > 0) {
    const auto left = static_cast<std::int64_t>(std::ceil(static_cast<double>(total - stored) / rate));
    fmt::print(", {:.1f} per second, {}:{:02}:{:02} left", rate, left / 3600, left / 60 % 60, left % 60);
  }
  fmt::print("\n");
}

}  // namespace

void add_status(CLI::App& app) {
  auto folder = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("status", "Show how far the shards of a study are");
  command->add_option("FOLDER", *folder, "the folder of the study, whose shards are in FOLDER/shards")->required();
  command->footer(
      "Examples:\n"
      "  ikbench status out/slim2023\n\n"
      "Running is a shard whose store another program has open. Where a shard is stopped or failed, or not begun, the\n"
      "job may wait in the queue (squeue --me), or its output says why (FOLDER/log).");
  command->callback([folder] {
    const std::vector<ShardState> states = shard_states(*folder);
    for (auto first = states.begin(); first != states.end();) {
      const auto last = std::find_if(first, states.end(),
                                     [&](const ShardState& state) { return state.shard.count != first->shard.count; });
      show({first, last});
      first = last;
    }
  });
}

}  // namespace ikbench::cli
