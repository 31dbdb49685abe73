#include "experiments/shard.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "experiments/study.hpp"

namespace ikbench::experiments {

namespace {

constexpr int most_shards = 100'000;

// The part of a point, from 0; all points of a chain are one part.
std::int64_t part(const StudySize& size, int run, int point) {
  return size.is_chained ? run - 1 : std::int64_t{run - 1} * size.points + point - 1;
}

}  // namespace

StudySize size_of(const Study& study) {
  return {.runs = study.runs,
          .points = study.path->points(),
          .solvers = static_cast<int>(study.solvers.size()),
          .is_chained = study.is_chained()};
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

bool contains(Shard shard, const StudySize& size, int run, int point) {
  return part(size, run, point) % shard.count == shard.index - 1;
}

bool has_any(Shard shard, const StudySize& size, int run) {
  for (int point = 1; point <= (size.is_chained ? 1 : size.points); ++point)
    if (contains(shard, size, run, point)) return true;
  return false;
}

std::int64_t parts_of(const StudySize& size) {
  return size.is_chained ? size.runs : std::int64_t{size.runs} * size.points;
}

std::int64_t solves_of(Shard shard, const StudySize& size) {
  const std::int64_t mine = (parts_of(size) + shard.count - shard.index) / shard.count;
  return mine * (size.is_chained ? size.points : 1) * size.solvers;
}

}  // namespace ikbench::experiments
