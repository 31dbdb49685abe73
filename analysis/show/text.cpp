#include "analysis/show/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace ikbench::show {
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

// Controls, and characters that end a line or turn its direction.
bool is_control(std::string_view character) {
  const unsigned char lead = byte(character, 0);
  if (character.size() == 1) return lead < 0x20 || lead == 0x7F;
  if (character.size() == 2) return (lead == 0xC2 && byte(character, 1) < 0xA0) || character == "\u061C";
  return (character >= "\u200E" && character <= "\u200F") || (character >= "\u2028" && character <= "\u202E") ||
         (character >= "\u2066" && character <= "\u2069");
}

struct Substitute {
  char character;
  std::string_view text;
};

std::string replaced(std::string_view text, std::span<const Substitute> substitutes, std::string_view after_backslash) {
  std::string result;
  for (const char c : one_line(text)) {
    const auto found = std::ranges::find(substitutes, c, &Substitute::character);
    if (found != substitutes.end()) {
      result += found->text;
    } else {
      if (after_backslash.find(c) != std::string_view::npos) result += '\\';
      result += c;
    }
  }
  return result;
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

std::string html_text(std::string_view text) {
  constexpr std::array<Substitute, 5> substitutes{
      {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}}};
  return replaced(text, substitutes, "");
}

std::string markdown_text(std::string_view text) {
  // A pipe is an entity, because readers of tables split at pipes before they look at backslashes.
  constexpr std::array<Substitute, 5> substitutes{
      {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'`', "&#96;"}, {'|', "&#124;"}}};
  return replaced(text, substitutes, "\\*[]#~$_");
}

std::string latex_text(std::string_view text) {
  constexpr std::array<Substitute, 11> substitutes{{{'\\', "\\textbackslash{}"},
                                                    {'~', "\\textasciitilde{}"},
                                                    {'^', "\\textasciicircum{}"},
                                                    {'<', "\\textless{}"},
                                                    {'>', "\\textgreater{}"},
                                                    {'|', "\\textbar{}"},
                                                    {'`', "\\textasciigrave{}"},
                                                    {'"', "{\\char34}"},
                                                    {'[', "{[}"},
                                                    {']', "{]}"},
                                                    {'*', "{*}"}}};  // after \\ it would be an argument
  return replaced(text, substitutes, "{}$&#_%");
}

std::string number_text(double value, int digits) {
  if (!std::isfinite(value)) return "-";
  std::string text = fmt::format("{:.{}g}", value, digits);
  const bool is_long = text.find('e') != std::string::npos && std::abs(value) >= 1 && std::abs(value) < 1e7;
  return is_long ? fmt::format("{:.0f}", value) : text;
}

std::string p_text(double p) {
  if (!std::isfinite(p)) return "-";
  return p < 0.0001 ? "< 0.0001" : fmt::format("{:.{}g}", p, p < 0.001 ? 2 : 3);
}

std::string p_sentence(double p) { return (p < 0.0001 ? "p " : "p = ") + p_text(p); }

std::string listed(const std::vector<std::string>& names, std::string_view last) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? last : ", ";
    text += names[i];
  }
  return text;
}

std::string aligned(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], character_count(row[c]));
  }
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c)
      text += row[c] + std::string(widths[c] - character_count(row[c]) + 3, ' ');
    text.resize(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text;
}

}  // namespace ikbench::show
