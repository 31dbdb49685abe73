// Names that people type: choices among them, lists of them in messages, the nearest one to a misspelt name. And any
// text from files of users, such as labels and titles, as one line of whole characters, short or cut.
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

// Returns the candidate with the smallest edit distance, otherwise one that contains the name; empty if none is near.
std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates);

// Returns `then is now called tie_breakers` for the former name of a candidate; empty for other names. Use it for names
// of the program: keys, values, options and metrics.
std::string renaming(std::string_view name, const std::vector<std::string>& candidates);

// Returns `; did you mean "ik_bat"?`; empty if no candidate is near.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates);

// Returns "A, B and C", or "A; B, C and D" if one name is "B, C".
std::string listed(const std::vector<std::string>& names, std::string_view last = " and ");
// Returns the names as `listed` does, or "A, B, C and 5 more" if there are more than `max_named`.
constexpr std::size_t max_named = 4;
std::string names_of(const std::vector<std::string>& names, std::string_view last = " and ");

// Returns "1 run" or "20 runs", made of the plural.
std::string counted(std::int64_t count, std::string_view nouns);

// Returns the first bytes, at most `max_bytes`, without a cut UTF-8 character at the end.
std::string_view front(std::string_view text, std::size_t max_bytes);

std::string_view trimmed(std::string_view text);  // without blanks and tabs at both ends
std::string lower_case(std::string_view text);    // changes ASCII letters only

// Returns true for a text that is safe in a message, a table or the name of a file.
bool is_plain(std::string_view text);
constexpr std::string_view plain_text = "a text of at most 200 bytes without control characters";

// Returns a short name, of about this length, for each name; all are different. A name that is too long loses the words
// that all names with the same first word have; otherwise it is cut in the middle.
std::map<std::string, std::string> short_names(const std::vector<std::string>& names, std::size_t length = 32);

// Returns `unknown solver "ik_bta"; did you mean "ik_bat"? There are: ik_bat, bat, ...`, or for the former name of a
// candidate `then is now called tie_breakers`.
std::string unknown_name(std::string_view kind, std::string_view name, const std::vector<std::string>& candidates);

// Returns the element with this name. Throws std::invalid_argument, which lists all names, if there is none.
template <class All, class NameOf>
const auto& find_named(std::string_view kind, std::string_view name, const All& all, NameOf name_of) {
  std::vector<std::string> names;
  for (const auto& each : all) {
    if (name_of(each) == name) return each;
    names.emplace_back(name_of(each));
  }
  throw std::invalid_argument(unknown_name(kind, name, names));
}

// Returns one line of valid UTF-8: control characters become blanks, and bytes that belong to no character become
// U+FFFD.
std::string one_line(std::string_view text);
std::string in_quotes(std::string_view text);  // one line in quotes, cut, for messages
// Returns the position of the first byte that belongs to no character; npos if all do.
std::size_t first_broken(std::string_view text);
std::size_t character_count(std::string_view utf8);
// Returns one line of at most so many characters. An ellipsis replaces the middle, because names of variants differ at
// their ends.
std::string shortened(std::string_view text, std::size_t length);

}  // namespace ikbench::base
