#include "analysis/show/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace ikbench::show {
namespace {

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

std::string p_text(double p) { return p < 0.0001 ? "< 0.0001" : number_text(p, p < 0.001 ? 2 : 3); }

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
