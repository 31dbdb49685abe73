#include "numerics/utf8.hpp"

#include <algorithm>

namespace ikbench::numerics {
namespace {

unsigned char byte(std::string_view text, std::size_t at) { return static_cast<unsigned char>(text[at]); }
bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

// Bytes of the first character of a text, if it is one of UTF-8 and of XML; else 0.
std::size_t length_of_first(std::string_view text) {
  const unsigned char lead = byte(text, 0);
  const std::size_t length = lead < 0x80                   ? 1
                             : lead >= 0xC2 && lead < 0xE0 ? 2
                             : lead >= 0xE0 && lead < 0xF0 ? 3
                             : lead >= 0xF0 && lead < 0xF5 ? 4
                                                           : 0;
  if (length < 2) return length;
  if (text.size() < length || !std::ranges::all_of(text.substr(1, length - 1), is_continuation)) return 0;
  const unsigned char next = byte(text, 1);
  const bool is_overlong = (lead == 0xE0 && next < 0xA0) || (lead == 0xF0 && next < 0x90);
  const bool is_no_character = (lead == 0xED && next > 0x9F) || (lead == 0xF4 && next > 0x8F) ||
                               (lead == 0xEF && next == 0xBF && byte(text, 2) >= 0xBE);
  return is_overlong || is_no_character ? 0 : length;
}

// Controls, and characters that end a line, turn its direction or cannot be seen; LaTeX stops at them.
bool is_control(std::string_view character) {
  const unsigned char lead = byte(character, 0);
  if (character.size() == 1) return lead < 0x20 || lead == 0x7F;
  if (character.size() == 2)
    return (lead == 0xC2 && byte(character, 1) < 0xA0) || character == "\u00AD" || character == "\u061C";
  return (character >= "\u200B" && character <= "\u200F") || (character >= "\u2028" && character <= "\u202E") ||
         (character >= "\u2060" && character <= "\u206F") || character == "\uFEFF";
}

}  // namespace

std::string one_line(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = length_of_first(text);
    const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
    result += length == 0 ? "\uFFFD" : is_control(character) ? " " : character;
    text.remove_prefix(character.size());
  }
  return result;
}

std::size_t character_count(std::string_view utf8) {
  return utf8.size() - static_cast<std::size_t>(std::ranges::count_if(utf8, is_continuation));
}

std::string shortened(std::string_view text, std::size_t length) {
  const std::string line = one_line(text);
  const std::size_t characters = character_count(line), head = length / 2;
  if (characters <= length) return line;
  std::string result;
  std::size_t at = 0;  // of a character, from 1
  for (const char c : line) {
    if (!is_continuation(c) && ++at == head + 1) result += "…";
    if (at <= head || at > characters - (length - head - 1)) result += c;
  }
  return result;
}

}  // namespace ikbench::numerics
