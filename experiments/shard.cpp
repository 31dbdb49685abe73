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
std::int64_t part(const Study& study, int run, int point) {
  return study.is_chained() ? run - 1 : std::int64_t{run - 1} * study.path->points() + point - 1;
}

}  // namespace

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

bool contains(Shard shard, const Study& study, int run, int point) {
  return part(study, run, point) % shard.count == shard.index - 1;
}

bool has_any(Shard shard, const Study& study, int run) {
  for (int point = 1; point <= (study.is_chained() ? 1 : study.path->points()); ++point)
    if (contains(shard, study, run, point)) return true;
  return false;
}

std::int64_t parts_of(const Study& study) {
  return study.is_chained() ? study.runs : std::int64_t{study.runs} * study.path->points();
}

std::int64_t solves_of(Shard shard, const Study& study) {
  const std::int64_t mine = (parts_of(study) + shard.count - shard.index) / shard.count;
  return mine * (study.is_chained() ? study.path->points() : 1) * std::ssize(study.solvers);
}

}  // namespace ikbench::experiments
