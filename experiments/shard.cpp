#include "experiments/shard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace ikbench::experiments {

using namespace results;

namespace {

// From 0; of a chain all points are one part.
std::int64_t part(const Work& work, int run, int point) {
  return work.is_chained ? run - 1 : std::int64_t{run - 1} * work.points + point - 1;
}

}  // namespace

Work work_of(const Study& study) {
  return {.runs = study.runs,
          .points = study.path->points(),
          .solvers = static_cast<int>(study.solvers.size()),
          .is_chained = study.start == Start::previous};
}

Work work_of(const StudyEntry& study) {
  const auto definition = nlohmann::json::parse(study.definition);  // the store has checked it
  return {.runs = definition.at("runs").get<int>(),
          .points = definition.value("points", 1),
          .solvers = static_cast<int>(study.series.size()),
          .is_chained = definition.value("start", nlohmann::json("previous")) == "previous"};
}

Shard shard_from(std::string_view text) {
  const auto number = [](std::string_view digits) {
    int value = 0;
    const char* const last = digits.data() + digits.size();
    const auto [end, error] = std::from_chars(digits.data(), last, value);
    return error == std::errc() && end == last ? value : 0;
  };
  const std::size_t slash = std::min(text.find('/'), text.size());
  const Shard shard{.index = number(text.substr(0, slash)),
                    .count = number(text.substr(std::min(slash + 1, text.size())))};
  if (shard.index >= 1 && shard.index <= shard.count && shard.count <= most_shards) return shard;
  throw std::invalid_argument(
      fmt::format("'{}' is no shard; expected I/N with 1 <= I <= N <= {}, as 3/12", text.substr(0, 100), most_shards));
}

std::string Shard::text() const { return fmt::format("{}/{}", index, count); }

bool has(Shard shard, const Work& work, int run, int point) {
  return part(work, run, point) % shard.count == shard.index - 1;
}

bool has_any(Shard shard, const Work& work, int run) {
  for (int point = 1; point <= (work.is_chained ? 1 : work.points); ++point)
    if (has(shard, work, run, point)) return true;
  return false;
}

std::int64_t solves_of(Shard shard, const Work& work) {
  const std::int64_t points = work.points;
  const std::int64_t parts = work.is_chained ? work.runs : work.runs * points;
  const std::int64_t mine = (parts + shard.count - shard.index) / shard.count;
  return mine * (work.is_chained ? points : 1) * work.solvers;
}

std::vector<std::int64_t> stored_by_shard(int count, const StudyEntry& study, const Store& store) {
  const Work work = work_of(study);
  std::vector<std::int64_t> stored(static_cast<std::size_t>(count));
  for (const Series& series : study.series) {
    store.each_place(series.key, [&](int run, int point) {
      if (run < 1 || run > work.runs || point < 1 || point > work.points) return;
      ++stored[static_cast<std::size_t>(part(work, run, point) % count)];
    });
  }
  return stored;
}

}  // namespace ikbench::experiments
