// Names that people type: choices of them, lists of them in messages, the nearest one to a misspelt name, and any text
// (labels and titles come from files of users) as one line of whole characters, short or cut.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ikbench::base {

// The candidate with the smallest edit distance, or else one that contains the name; empty if none is near.
std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates);

// `; did you mean "ik_bat"?`; empty if no candidate is near.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates);

// "A, B and C"; "A; B, C and D" where one is "B, C".
std::string listed(const std::vector<std::string>& names, std::string_view last = " and ");
// The same of a few, else "A, B, C and 5 more".
constexpr std::size_t most_named = 4;
std::string names_of(const std::vector<std::string>& names, std::string_view last = " and ");

// "1 run" and "20 runs", of the plural.
std::string counted(std::int64_t count, std::string_view nouns);

// The first bytes, at most `most`, without a cut character of UTF-8 at the end.
std::string_view front(std::string_view text, std::size_t most);

std::string_view trimmed(std::string_view text);  // without blanks and tabs at its ends
std::string lower_case(std::string_view text);    // ASCII letters

// True for a text that is safe in a message, a table or a file's name.
bool is_plain(std::string_view text);
constexpr std::string_view plain_text = "a text of at most 200 bytes without control characters";

// Each name by a short one of about this length, all different. Of a name that is too long, the words go that all names
// have that begin with the same word; else it is cut in the middle.
std::map<std::string, std::string> short_names(const std::vector<std::string>& names, std::size_t length = 32);

// `unknown solver "ik_bta"; did you mean "ik_bat"? There are: ik_bat, bat, ...`
std::string unknown_name(std::string_view kind, std::string_view name, const std::vector<std::string>& candidates);

// The one of all that has this name. Throws std::invalid_argument, which lists all, if there is none.
template <class All, class NameOf>
const auto& find_named(std::string_view kind, std::string_view name, const All& all, NameOf name_of) {
  std::vector<std::string> names;
  for (const auto& each : all) {
    if (name_of(each) == name) return each;
    names.emplace_back(name_of(each));
  }
  throw std::invalid_argument(unknown_name(kind, name, names));
}

// One line of valid UTF-8: control characters become blanks, bytes that are none U+FFFD.
std::string one_line(std::string_view text);
std::string in_quotes(std::string_view text);  // one line, cut, for messages
// The first byte that is of no character; npos: all are.
std::size_t first_broken(std::string_view text);
std::size_t character_count(std::string_view utf8);
// One line of at most so many characters; an ellipsis stands for its middle, because variants differ at their ends.
std::string shortened(std::string_view text, std::size_t length);

}  // namespace ikbench::base
