#include "numerics/names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

namespace ikbench::numerics {

namespace {

// Levenshtein's distance, one row of the table at a time.
std::size_t edit_distance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= from.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= to.size(); ++j) {
      const std::size_t substituted = diagonal + (from[i - 1] == to[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates) {
  name = name.substr(0, 100);  // a longer one is no misspelling
  std::string nearest;
  std::size_t smallest = name.size() / 3 + 2;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = edit_distance(name, candidate);
    if (distance < smallest) {
      smallest = distance;
      nearest = candidate;
    }
  }
  constexpr std::size_t fewest = 3;  // shorter names match too much
  if (!nearest.empty() || name.size() < fewest) return nearest;
  const auto longer =
      std::ranges::find_if(candidates, [&](const std::string& each) { return each.find(name) != std::string::npos; });
  return longer == candidates.end() ? "" : *longer;
}

std::string counted(std::int64_t count, std::string_view nouns) {
  return fmt::format("{} {}", count, nouns.substr(0, nouns.size() - (count == 1 ? 1 : 0)));
}

std::string_view front(std::string_view text, std::size_t most) {
  if (text.size() <= most) return text;
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80) --most;
  return text.substr(0, most);
}

std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates) {
  const std::string nearest = nearest_name(name, candidates);
  return nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest);
}

bool is_plain(std::string_view text) {
  const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
  const auto is_c1 = [](unsigned char first, unsigned char second) { return first == 0xc2 && second < 0xa0; };
  return text.size() <= 200 && std::none_of(text.begin(), text.end(), is_control) &&
         std::adjacent_find(text.begin(), text.end(), is_c1) == text.end();
}

std::string unknown_name(std::string_view kind, std::string_view name, const std::vector<std::string>& candidates) {
  const std::string nearest = did_you_mean(name, candidates);
  return fmt::format("unknown {} \"{}\"{}{}", kind, front(name, 100),
                     nearest.empty() ? "; there are: " : nearest + " There are: ", fmt::join(candidates, ", "));
}

}  // namespace ikbench::numerics
