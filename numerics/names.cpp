#include "numerics/names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>
#include <sstream>

#include "numerics/utf8.hpp"

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

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return lower;
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

std::map<std::string, std::string> short_names(const std::vector<std::string>& names, std::size_t length) {
  constexpr std::size_t longest = 60;
  std::map<std::string, std::map<std::string, std::size_t>> counts;  // of words, by the first word of their names
  const auto words_of = [](const std::string& name) {
    std::istringstream all(name);
    std::vector<std::string> words(std::istream_iterator<std::string>(all), {});
    if (words.empty()) words.push_back(name);
    return words;
  };
  for (const std::string& name : names) {
    const std::vector<std::string> words = words_of(name);
    for (const std::string& word : std::set<std::string>(words.begin(), words.end())) ++counts[words.front()][word];
  }
  std::map<std::string, std::string> short_of;
  for (std::set<std::string> different; different.size() < names.size() && length <= longest; ++length) {
    different.clear();
    for (const std::string& name : names) {
      const std::vector<std::string> words = words_of(name);
      std::string own;
      for (const std::string& word : words) {
        if (counts[words.front()][word] < counts[words.front()][words.front()]) own += ' ' + word;
      }
      const bool is_long = character_count(name) > length && !own.empty();
      if (is_long) own = (character_count(words.front() + " …" + own) <= length ? words.front() + " …" : "…") + own;
      different.insert(short_of[name] = is_long ? shortened(own, longest) : shortened(name, length));
    }
    if (length == longest && different.size() < names.size()) return {};  // they look the same, and stay as they are
  }
  return short_of;
}

std::string unknown_name(std::string_view kind, std::string_view name, const std::vector<std::string>& candidates) {
  const std::string nearest = did_you_mean(name, candidates);
  return fmt::format("unknown {} \"{}\"{}{}", kind, front(name, 100),
                     nearest.empty() ? "; there are: " : nearest + " There are: ", fmt::join(candidates, ", "));
}

}  // namespace ikbench::numerics
