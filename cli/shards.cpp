#include "cli/shards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <iomanip>
#include <numeric>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "cli/console.hpp"
#include "cli/reporting.hpp"

namespace ikbench::cli {

using namespace results;
using namespace experiments;

namespace {

namespace fs = std::filesystem;

// A command that solved one shard, for another of them. Its folder changes where its name says which shard it has.
std::string command_for(std::string command, Shard solved, Shard wanted) {
  const auto replace_all = [&](const std::string& what, const std::string& by) {
    for (std::size_t at = command.find(what); at != std::string::npos; at = command.find(what, at + by.size()))
      command.replace(at, what.size(), by);
  };
  replace_all(fmt::format("--shard {}", solved.text()), fmt::format("--shard {}", wanted.text()));
  replace_all(fmt::format("--shard={}", solved.text()), fmt::format("--shard={}", wanted.text()));
  replace_all(fmt::format("/{}-of-{}", solved.index, solved.count),
              fmt::format("/{}-of-{}", wanted.index, wanted.count));
  return command;
}

// The last session that solved a shard: which, and how.
struct Example {
  Shard shard;
  std::string command;
};

Example example_of(const Store& store) {
  Example example;
  for (const Session& session : store.sessions()) {
    const auto shard = session.environment.find("shard"), command = session.environment.find("command");
    if (shard == session.environment.end() || command == session.environment.end()) continue;
    example = {.shard = shard_from(shard->second), .command = command->second};
  }
  return example;
}

}  // namespace

fs::path shard_folder(const fs::path& folder, Shard shard) {
  return folder / "shards" / fmt::format("{}-of-{}", shard.index, shard.count);
}

std::vector<fs::path> stores_in(const fs::path& place) {
  std::error_code error;
  if (!fs::is_directory(place, error)) return {place};  // opening it says what is wrong
  if (fs::exists(store_in(place), error)) return {store_in(place)};
  std::vector<fs::path> stores;
  for (fs::directory_iterator entry(place, error), end; !error && entry != end; entry.increment(error))
    if (fs::exists(store_in(entry->path()), error)) stores.push_back(store_in(entry->path()));
  if (stores.empty())
    throw std::invalid_argument(fmt::format("'{}' has no store.sqlite, and no folder in it has one", place.string()));
  std::ranges::sort(stores);
  return stores;
}

std::vector<std::string> missing_parts(const Store& store, const StudyEntry& study, const fs::path& out) {
  const Work work = work_of(study);
  const Example example = example_of(store);
  const std::vector<std::int64_t> stored = stored_by_shard(example.shard.count, study, store);
  const std::int64_t all = solves_of({}, work),
                     lacks = all - std::accumulate(stored.begin(), stored.end(), std::int64_t{0});
  if (lacks == 0) return {};
  std::vector<std::string> lines{fmt::format("{} lacks {} of {} solves; make them with", study.name, lacks, all)};
  if (example.shard.count == 1) {
    lines.push_back("  " + shell_command("ikbench", {"run", study.name, "--out", out.string()}));
    return lines;
  }
  constexpr std::size_t most = 20;
  std::size_t missing = 0;
  for (Shard shard{.index = 1, .count = example.shard.count}; shard.index <= shard.count; ++shard.index) {
    if (stored[static_cast<std::size_t>(shard.index - 1)] == solves_of(shard, work)) continue;
    if (++missing <= most) lines.push_back("  " + command_for(example.command, example.shard, shard));
  }
  if (missing > most) lines.push_back(fmt::format("  and {} more shards", missing - most));
  lines.push_back("then merge again");
  return lines;
}

namespace {

// What the name I-of-N of a folder says.
std::optional<Shard> shard_named(std::string name) {
  const std::size_t middle = name.find("-of-");
  if (middle == std::string::npos) return std::nullopt;
  try {
    return shard_from(name.replace(middle, 4, "/"));
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

double seconds_since(const std::string& began) {
  std::tm date{};
  std::istringstream text(began);
  text >> std::get_time(&date, "%Y-%m-%dT%H:%M:%SZ");
  return text ? std::difftime(std::time(nullptr), timegm(&date)) : 0;
}

ShardState state_of(const fs::path& file, Shard shard) {
  ShardState state{.shard = shard, .is_open = is_open(file)};
  const Store store(file, Store::Mode::read);
  for (const StudyEntry& study : store.studies()) {
    state.stored += stored_by_shard(shard.count, study, store)[static_cast<std::size_t>(shard.index - 1)];
    state.total += solves_of(shard, work_of(study));
  }
  const std::vector<Session> sessions = store.sessions();
  if (!state.is_open || sessions.empty()) return state;
  const double seconds = seconds_since(sessions.back().began);
  if (seconds > 0) state.rate = static_cast<double>(store.solves_of_session(sessions.back().id)) / seconds;
  return state;
}

}  // namespace

std::vector<ShardState> shard_states(const fs::path& folder) {
  std::vector<ShardState> states;
  std::error_code error;
  for (fs::directory_iterator entry(folder / "shards", error), end; !error && entry != end; entry.increment(error)) {
    const std::optional<Shard> shard = shard_named(entry->path().filename().string());
    std::error_code none;
    if (shard && fs::exists(store_in(entry->path()), none)) states.push_back(state_of(store_in(entry->path()), *shard));
  }
  if (states.empty())
    throw std::invalid_argument(fmt::format("no shard has begun in '{}'; expected stores as '{}'",
                                            (folder / "shards").string(),
                                            store_in(shard_folder(folder, {.index = 1, .count = 12})).string()));
  std::ranges::sort(states, {},
                    [](const ShardState& state) { return std::pair(state.shard.count, state.shard.index); });
  return states;
}

}  // namespace ikbench::cli
