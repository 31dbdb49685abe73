#include "analysis/inference/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <span>

namespace ikbench::inference {
namespace {

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

// Length of the valid UTF-8 sequence at the front, 0 if there is none (RFC 3629).
std::size_t sequence_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xC2 && lead < 0xE0   ? 2
                             : lead >= 0xE0 && lead < 0xF0 ? 3
                             : lead >= 0xF0 && lead < 0xF5 ? 4
                                                           : 0;
  if (length == 0 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if (!is_continuation(text[i])) return 0;
  }
  const bool overlong = (lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xF0 && byte(1) < 0x90);
  const bool surrogate = lead == 0xED && byte(1) > 0x9F;
  const bool beyond = lead == 0xF4 && byte(1) > 0x8F;
  const bool noncharacter = lead == 0xEF && byte(1) == 0xBF && byte(2) >= 0xBE;  // not allowed in XML
  return overlong || surrogate || beyond || noncharacter ? 0 : length;
}

bool is_control(std::string_view sequence) {
  const auto lead = static_cast<unsigned char>(sequence[0]);
  if (sequence.size() == 1) return lead < 0x20 || lead == 0x7F;
  // U+061C, 200E, 200F, 202A to 202E and 2066 to 2069 turn the direction of writing; 2028 and 2029 end a line.
  if (sequence.size() == 2)
    return (lead == 0xC2 && static_cast<unsigned char>(sequence[1]) < 0xA0) || sequence == "\u061C";
  return (sequence >= "\u200E" && sequence <= "\u200F") || (sequence >= "\u2028" && sequence <= "\u202E") ||
         (sequence >= "\u2066" && sequence <= "\u2069");
}

bool is_word(char c) { return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

struct Substitute {
  char character;
  std::string_view text;
};

std::string escaped(char c, std::span<const Substitute> substitutes, std::string_view after_a_backslash) {
  const auto found = std::ranges::find(substitutes, c, &Substitute::character);
  if (found != substitutes.end()) return std::string(found->text);
  return after_a_backslash.find(c) == std::string_view::npos ? std::string(1, c) : std::string{'\\', c};
}

}  // namespace

std::string one_line(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = sequence_length(text);
    const std::string_view sequence = text.substr(0, length == 0 ? 1 : length);
    if (length == 0) {
      result += "\uFFFD";
    } else if (is_control(sequence)) {
      result += ' ';
    } else {
      result += sequence;
    }
    text.remove_prefix(sequence.size());
  }
  return result;
}

std::size_t character_count(std::string_view utf8) {
  std::size_t count = 0;
  for (const char c : utf8) count += is_continuation(c) ? 0 : 1;
  return count;
}

std::string shortened(std::string_view text, std::size_t length) {
  std::string line = one_line(text);
  if (character_count(line) <= length) return line;
  std::size_t characters = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (is_continuation(line[i])) continue;
    if (++characters == length) {
      line.resize(i);
      break;
    }
  }
  return line + "…";
}

std::string row_label(std::string_view text, std::size_t length) {
  if (text.empty()) return "(empty)";
  const std::string line = one_line(text);
  const std::size_t characters = character_count(line);
  if (characters <= length) return line;
  const std::size_t head = length / 2;
  const std::size_t tail = characters - (length - head - 1);
  std::string label;
  std::size_t count = 0;
  for (const char c : line) {
    if (!is_continuation(c) && ++count == head + 1) label += "…";
    if (count <= head || count > tail) label += c;
  }
  return label;
}

std::string markdown_text(std::string_view text) {
  constexpr std::array<Substitute, 5> substitutes{{
      {'&', "&amp;"},
      {'<', "&lt;"},
      {'>', "&gt;"},
      {'`', "&#96;"},
      {'|', "&#124;"}  // an entity, because table parsers split at pipes before they look at backslashes
  }};
  const std::string line = one_line(text);
  std::string result;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool inside_word = i > 0 && i + 1 < line.size() && is_word(line[i - 1]) && is_word(line[i + 1]);
    result += escaped(line[i], substitutes, inside_word ? "\\*[]#~$" : "\\*[]#~$_");
  }
  return result;
}

std::string latex_text(std::string_view text) {
  constexpr std::array<Substitute, 11> substitutes{{
      {'\\', "\\textbackslash{}"},
      {'~', "\\textasciitilde{}"},
      {'^', "\\textasciicircum{}"},
      {'<', "\\textless{}"},
      {'>', "\\textgreater{}"},
      {'|', "\\textbar{}"},
      {'`', "\\textasciigrave{}"},
      {'"', "{\\char34}"},
      {'[', "{[}"},
      {']', "{]}"},
      {'*', "{*}"}  // after \\ a bracket or a star would be an argument
  }};
  std::string result;
  for (const char c : one_line(text)) {
    if (c == '-' && result.ends_with('-')) result += "{}";  // no ligatures: -- is two hyphens
    result += escaped(c, substitutes, "{}$&#_%");
  }
  return result;
}

std::string gnuplot_string(std::string_view text) {
  constexpr std::string_view harmless = " -_.,:()+*/=<>[]&|?^~%";
  std::string result = "'";
  for (const char c : one_line(text)) {
    const bool ascii = static_cast<unsigned char>(c) < 0x80;
    if (!ascii || is_word(c) || harmless.find(c) != std::string_view::npos) {
      result += c;
    } else {
      result += fmt::format("'.character[{}].'", static_cast<int>(c));
    }
  }
  return result + "'";
}

std::string rounded_number(double value, int significant_digits) {
  const std::string text = fmt::format("{:.{}g}", value, significant_digits);
  const double size = std::abs(value);
  const bool has_exponent = text.find('e') != std::string::npos;
  return has_exponent && size >= 1 && size < 1e7 ? fmt::format("{:.0f}", value) : text;
}

std::string degrees_words(double degrees) {
  return std::isfinite(degrees) ? rounded_number(degrees, 3) + " deg" : "more than 1e308 deg";
}

std::string short_number(double value) { return std::isfinite(value) ? rounded_number(value, 3) : "not defined"; }

std::string capitalised(std::string_view text) {
  std::string result(text);
  result[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(result[0])));
  return result;
}

std::string percent(double share) { return rounded_number(100 * share, 3) + " %"; }
std::string points(double share) { return rounded_number(100 * share, 3) + " percentage points"; }

NameWithUnit split_unit(std::string_view name) {
  constexpr std::array<std::string_view, 6> units{"cm", "deg", "rad", "ms", "s", "m"};
  const bool is_bracketed = name.ends_with(']');
  const std::size_t at = name.rfind(is_bracketed ? '[' : '_');
  if (at == std::string_view::npos || at == 0) return {std::string(name), ""};
  const std::string_view unit = name.substr(at + 1, name.size() - at - (is_bracketed ? 2 : 1));
  if (!is_bracketed && std::ranges::find(units, unit) == units.end()) return {std::string(name), ""};
  name = name.substr(0, at);
  return {std::string(name.substr(0, name.find_last_not_of(' ') + 1)), std::string(unit)};
}

std::string in_words(std::string_view id) {
  std::string words(id);
  std::ranges::replace(words, '_', ' ');
  return words;
}

std::string text_of(const NameWithUnit& quantity) {
  return quantity.unit.empty() ? quantity.name : fmt::format("{} [{}]", quantity.name, quantity.unit);
}

}  // namespace ikbench::inference
