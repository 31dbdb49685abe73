#include "cli/shards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

#include "cli/console.hpp"
#include "cli/reporting.hpp"
#include "results/same_solves.hpp"
#include "results/writer_mark.hpp"

namespace ikbench::cli {

using namespace results;
using namespace experiments;

namespace {

namespace fs = std::filesystem;

// Turns the command that solved one shard into that of another. Its folder changes if its name contains the shard.
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

// The commands that solved the study's shards, by shard number: those of the last N, with as many runs as the study has
// now.
struct Commands {
  int count = 1;
  std::map<int, std::string> of_shard;

  // Empty if none is known.
  std::string of(Shard wanted) const {
    const auto own = of_shard.find(wanted.index);
    if (own != of_shard.end()) return own->second;
    if (of_shard.empty()) return "";
    const auto& [index, command] = *of_shard.begin();
    const std::string text = command_for(command, {.index = index, .count = count}, wanted) + ' ';
    const bool is_of_it = text.find(fmt::format("--shard {} ", wanted.text())) != std::string::npos ||
                          text.find(fmt::format("--shard={} ", wanted.text())) != std::string::npos;
    return is_of_it ? text.substr(0, text.size() - 1) : "";
  }
};

// The shard that a text names; nothing if it names none. Folders and stores are not trusted.
std::optional<Shard> shard_said(const std::string& text) {
  try {
    return shard_from(text);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

Commands commands_of(const Store& store, const StudyEntry& study) {
  const std::vector<std::int64_t> of_study = store.sessions_of(study.series);
  const std::string runs = std::to_string(size_of(study).runs);
  Commands commands;
  for (const Session& session : store.sessions()) {
    const auto fact = [&](const char* key) {
      const auto found = session.environment.find(key);
      return found == session.environment.end() ? std::string() : found->second;
    };
    if (!std::ranges::binary_search(of_study, session.id)) continue;
    if (fact("study") != study.name || fact("runs") != runs || fact("command").empty()) continue;
    const std::optional<Shard> shard = fact("shard").empty() ? Shard{} : shard_said(fact("shard"));
    if (!shard) continue;
    if (shard->count != commands.count) commands = {.count = shard->count, .of_shard = {}};
    commands.of_shard[shard->index] = fact("command");
  }
  return commands;
}

// The shard that a folder's name I-of-N gives.
std::optional<Shard> shard_named(std::string name) {
  const std::size_t middle = name.find("-of-");
  return middle == std::string::npos ? std::nullopt : shard_said(name.replace(middle, 4, "/"));
}

// The entries of a folder; none if it does not exist. Throws std::invalid_argument if it cannot be read.
std::vector<fs::path> entries_of(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    entries.push_back(entry->path());
  if (error && error != std::errc::no_such_file_or_directory && error != std::errc::not_a_directory)
    throw std::invalid_argument(fmt::format("cannot read '{}': {}", folder.string(), error.message()));
  std::ranges::sort(entries);
  return entries;
}

// True also if the store cannot be looked at; opening it then says why.
bool has_store(const fs::path& folder) {
  std::error_code error;
  return fs::exists(store_in(folder), error) || error;
}

}  // namespace

fs::path shard_folder(const fs::path& folder, Shard shard) {
  return folder / "shards" / fmt::format("{}-of-{}", shard.index, shard.count);
}

void refuse_empty_shards(const Study& study, const std::string& option, int count) {
  const std::int64_t parts = parts_of(size_of(study));
  if (count <= parts) return;
  const bool is_by_run = size_of(study).is_chained;
  throw std::invalid_argument(fmt::format("{}: {} has only {} {}{} to share out, so give at most that many shards",
                                          option, study.name, parts, is_by_run ? "run" : "target",
                                          parts == 1 ? "" : "s"));
}

std::vector<fs::path> stores_in(const fs::path& place) {
  std::error_code error;
  if (!fs::is_directory(place, error)) return {place};  // opening it says what is wrong
  if (fs::exists(store_in(place), error)) return {store_in(place)};
  std::vector<fs::path> stores;
  for (const fs::path& folder : entries_of(place))
    if (has_store(folder)) stores.push_back(store_in(folder));
  if (stores.empty())
    throw std::invalid_argument(fmt::format("'{}' has no store.sqlite, and no folder in it has one", place.string()));
  return stores;
}

std::int64_t solves_missing(const Store& store, const StudyEntry& study) {
  return solves_of({}, size_of(study)) - stored_by_shard(1, study, store).front();
}

std::vector<std::string> missing_parts(const Store& store, const StudyEntry& study) {
  const StudySize size = size_of(study);
  const Commands commands = commands_of(store, study);
  const std::vector<std::int64_t> stored = stored_by_shard(commands.count, study, store);
  const std::int64_t all = solves_of({}, size),
                     lacks = all - std::accumulate(stored.begin(), stored.end(), std::int64_t{0});
  if (lacks == 0) return {};
  std::vector<std::string> lines;
  constexpr std::size_t most = 20;
  std::size_t missing = 0;
  for (Shard shard{.index = 1, .count = commands.count}; shard.index <= shard.count; ++shard.index) {
    if (stored[static_cast<std::size_t>(shard.index - 1)] == solves_of(shard, size)) continue;
    const std::string command = commands.of(shard);
    if (!command.empty() && ++missing <= most) lines.push_back("  " + command);
  }
  if (missing > most) lines.push_back(fmt::format("  and {} more shards", missing - most));
  if (missing > 0) lines.push_back("then merge again");
  lines.insert(lines.begin(), fmt::format("{} lacks {} of {} solves{}", study.name, lacks, all,
                                          missing > 0 ? "; make them with" : ""));
  return lines;
}

namespace {

// A store's state as a shard.
struct Looked {
  ShardState state;
  std::vector<StudyEntry> studies = {};
};

void look_into(const fs::path& file, Looked& looked) {
  auto& [state, studies] = looked;
  const Store store(file, Store::Mode::read);
  studies = store.studies();
  std::int64_t others = 0;
  for (const StudyEntry& study : studies) {
    const std::vector<std::int64_t> stored = stored_by_shard(state.shard.count, study, store);
    const std::int64_t own = stored[static_cast<std::size_t>(state.shard.index - 1)];
    state.stored += own;
    others += std::accumulate(stored.begin(), stored.end(), std::int64_t{0}) - own;
  }
  if (others > 0)
    state.trouble =
        fmt::format("'{}' has {} solves of other shards: give each shard an --out of its own", file.string(), others);
}

Looked look_at(const fs::path& file, Shard shard) {
  const std::optional<double> rate = writing_rate(file);
  Looked looked{.state = {.shard = shard, .is_running = rate.has_value(), .rate = rate.value_or(0)}};
  try {
    look_into(file, looked);
  } catch (const std::exception& error) {
    if (!looked.state.is_running) looked.state.trouble = error.what();  // otherwise its creation is going on
  }
  return looked;
}

Division division_of(std::vector<Looked> looked) {
  std::ranges::sort(looked, {}, [](const Looked& each) { return each.state.shard.index; });
  Division division{.count = looked.front().state.shard.count};
  std::map<std::string, std::pair<StudyEntry, Shard>> studies;  // each with most runs, and its shard
  for (auto& [state, of_shard] : looked) {
    for (const StudyEntry& study : of_shard) {
      const auto [known, is_new] = studies.try_emplace(study.name, study, state.shard);
      const std::string why = why_not_one(known->second.first, study);
      if (!why.empty())
        state.trouble = fmt::format("the study {} is not the same in shard {} and shard {}: {}; merge refuses that",
                                    study.name, known->second.second.text(), state.shard.text(), why);
      if (size_of(study).runs > size_of(known->second.first).runs) known->second = {study, state.shard};
    }
  }
  for (const auto& [name, study] : studies) {
    division.total += solves_of({}, size_of(study.first));
    for (Looked& each : looked) each.state.total += solves_of(each.state.shard, size_of(study.first));
  }
  for (Looked& each : looked) division.shards.push_back(std::move(each.state));
  return division;
}

}  // namespace

std::int64_t Division::stored() const {
  return std::accumulate(shards.begin(), shards.end(), std::int64_t{0},
                         [](std::int64_t sum, const ShardState& state) { return sum + state.stored; });
}

std::vector<Division> divisions(const fs::path& folder) {
  std::map<int, std::vector<Looked>> by_count;
  for (const fs::path& entry : entries_of(folder / "shards")) {
    const std::optional<Shard> shard = shard_named(entry.filename().string());
    if (shard && has_store(entry)) by_count[shard->count].push_back(look_at(store_in(entry), *shard));
  }
  std::vector<Division> all;
  for (auto& [count, looked] : by_count) all.push_back(division_of(std::move(looked)));
  std::ranges::stable_sort(all, std::ranges::greater(), &Division::stored);
  return all;
}

}  // namespace ikbench::cli
