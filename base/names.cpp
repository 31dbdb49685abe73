#include "base/names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>
#include <sstream>

namespace ikbench::base {

namespace {

// Former names of keys and values of studies, of options and of metrics, each with its new name.
constexpr std::pair<std::string_view, std::string_view> new_names[]{
    {"then", "tie_breakers"},
    {"turns", "rounds"},
    {"patience_s", "timeout_s"},
    {"leave_out", "skip"},
    {"hot", "warm"},
    {"--patience", "--timeout"},
    {"seconds_per_solved", "seconds_per_success"},
    {"evaluations_per_solved", "evaluations_per_success"},
    {"bend_deg", "second_difference_deg"},
};

unsigned char byte(std::string_view text, std::size_t at) { return static_cast<unsigned char>(text[at]); }
bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

// Returns the number of bytes of a UTF-8 character that begins with this byte; 0 if no character does.
std::size_t length_by_lead(unsigned char lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead < 0xE0) return 2;
  if (lead >= 0xE0 && lead < 0xF0) return 3;
  if (lead >= 0xF0 && lead < 0xF5) return 4;
  return 0;
}

// Returns the number of bytes of the first character, if it belongs to UTF-8 and to XML; 0 otherwise.
std::size_t length_of_first(std::string_view text) {
  const unsigned char lead = byte(text, 0);
  const std::size_t length = length_by_lead(lead);
  if (length < 2) return length;
  if (text.size() < length || !std::ranges::all_of(text.substr(1, length - 1), is_continuation)) return 0;
  const unsigned char next = byte(text, 1);
  const bool is_overlong = (lead == 0xE0 && next < 0xA0) || (lead == 0xF0 && next < 0x90);
  const bool is_no_character = (lead == 0xED && next > 0x9F) || (lead == 0xF4 && next > 0x8F) ||
                               (lead == 0xEF && next == 0xBF && byte(text, 2) >= 0xBE);
  return is_overlong || is_no_character ? 0 : length;
}

// Returns true for controls, and for characters that end a line, turn its direction or cannot be seen. LaTeX stops at
// them.
bool is_control(std::string_view character) {
  const unsigned char lead = byte(character, 0);
  if (character.size() == 1) return lead < 0x20 || lead == 0x7F;
  if (character.size() == 2)
    return (lead == 0xC2 && byte(character, 1) < 0xA0) || character == "\u00AD" || character == "\u061C";
  return (character >= "\u200B" && character <= "\u200F") || (character >= "\u2028" && character <= "\u202E") ||
         (character >= "\u2060" && character <= "\u206F") || character == "\uFEFF";
}

// Returns the Levenshtein distance. Only one row of the table is kept.
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

std::string one_line(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = length_of_first(text);
    const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
    if (length == 0)
      result += "\uFFFD";
    else
      result += is_control(character) ? " " : character;
    text.remove_prefix(character.size());
  }
  return result;
}

std::string in_quotes(std::string_view text) { return fmt::format("'{}'", one_line(front(text, 60))); }

std::size_t first_broken(std::string_view text) {
  for (std::size_t at = 0, length = 0; at < text.size(); at += length) {
    const bool is_ascii = static_cast<signed char>(text[at]) > 0;
    length = is_ascii ? 1 : length_of_first(text.substr(at));
    if (length == 0 || text[at] == 0) return at;
  }
  return std::string_view::npos;
}

std::size_t character_count(std::string_view utf8) {
  return utf8.size() - static_cast<std::size_t>(std::ranges::count_if(utf8, is_continuation));
}

std::string shortened(std::string_view text, std::size_t length) {
  const std::string line = one_line(text);
  const std::size_t characters = character_count(line), head = length / 2;
  if (characters <= length) return line;
  std::string result;
  std::size_t at = 0;  // position of a character, from 1
  for (const char c : line) {
    if (!is_continuation(c) && ++at == head + 1) result += "…";
    if (at <= head || at > characters - (length - head - 1)) result += c;
  }
  return result;
}

std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates) {
  name = name.substr(0, 100);  // a longer text is no misspelling
  std::string nearest;
  std::size_t smallest = name.size() / 3 + 2;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = edit_distance(name, candidate);
    if (distance >= smallest) continue;
    smallest = distance;
    nearest = candidate;
  }
  constexpr std::size_t min_length = 3;  // shorter names match too much
  if (!nearest.empty() || name.size() < min_length) return nearest;
  const auto contains_name = [&](const std::string& candidate) { return candidate.find(name) != std::string::npos; };
  const auto longer = std::ranges::find_if(candidates, contains_name);
  return longer == candidates.end() ? "" : *longer;
}

std::string listed(const std::vector<std::string>& names, std::string_view last) {
  const auto has_comma = [](const std::string& name) { return name.find(',') != std::string::npos; };
  const std::string_view comma = std::ranges::any_of(names, has_comma) ? "; " : ", ";
  if (names.size() < 2 || last == ", ") return fmt::format("{}", fmt::join(names, comma));
  return fmt::format("{}{}{}", fmt::join(names.begin(), names.end() - 1, comma), last, names.back());
}

std::string names_of(const std::vector<std::string>& names, std::string_view last) {
  if (names.size() <= max_named) return listed(names, last);
  return fmt::format("{} and {} more", listed({names.begin(), names.begin() + 3}, ", "), names.size() - 3);
}

std::string counted(std::int64_t count, std::string_view nouns) {
  return fmt::format("{} {}", count, nouns.substr(0, nouns.size() - (count == 1 ? 1 : 0)));
}

std::string_view front(std::string_view text, std::size_t max_bytes) {
  if (text.size() <= max_bytes) return text;
  while (max_bytes > 0 && is_continuation(text[max_bytes])) --max_bytes;
  return text.substr(0, max_bytes);
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

std::string renaming(std::string_view name, const std::vector<std::string>& candidates) {
  for (const auto& [former, now] : new_names) {
    if (former == name && std::ranges::find(candidates, now) != candidates.end())
      return fmt::format("{} is now called {}", former, now);
  }
  return "";
}

std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates) {
  const std::string nearest = nearest_name(name, candidates);
  return nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest);
}

bool is_plain(std::string_view text) {
  const auto is_ascii_control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
  const auto is_c1 = [](unsigned char first, unsigned char second) { return first == 0xc2 && second < 0xa0; };
  return text.size() <= 200 && std::none_of(text.begin(), text.end(), is_ascii_control) &&
         std::adjacent_find(text.begin(), text.end(), is_c1) == text.end();
}

std::map<std::string, std::string> short_names(const std::vector<std::string>& names, std::size_t length) {
  constexpr std::size_t max_length = 60;
  std::map<std::string, std::map<std::string, std::size_t>> counts;  // counts of words, by the first word of the name
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
  for (std::set<std::string> different; different.size() < names.size() && length <= max_length; ++length) {
    different.clear();
    for (const std::string& name : names) {
      const std::vector<std::string> words = words_of(name);
      std::string own;
      for (const std::string& word : words) {
        if (counts[words.front()][word] < counts[words.front()][words.front()]) own += ' ' + word;
      }
      const bool is_long = character_count(name) > length && !own.empty() && words.front() + own != name;
      if (is_long) {  // a few letters of the first word stay
        constexpr std::size_t few = 8;
        const std::size_t taken = character_count(" …" + own);
        own = shortened(words.front(), std::max(few, length - std::min(length, taken))) + " …" + own;
      }
      different.insert(short_of[name] = is_long ? shortened(own, max_length) : shortened(name, length));
    }
    if (length < max_length || different.size() == names.size()) continue;
    for (const std::string& name : names) short_of[name] = name;  // names that would look the same stay as they are
  }
  return short_of;
}

std::string unknown_name(std::string_view kind, std::string_view name, const std::vector<std::string>& candidates) {
  // Labels, columns and the like are the user's own, so that a former name of ours means nothing there.
  const bool is_of_program = kind == "key" || kind == "value" || kind == "metric" || kind.starts_with("option of");
  if (std::string sentence = renaming(name, candidates); is_of_program && !sentence.empty()) return sentence;
  const std::string nearest = did_you_mean(name, candidates);
  return fmt::format("unknown {} \"{}\"{}{}", kind, front(name, 100),
                     nearest.empty() ? "; there are: " : nearest + " There are: ", fmt::join(candidates, ", "));
}

}  // namespace ikbench::base
