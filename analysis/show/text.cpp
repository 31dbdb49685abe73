#include "analysis/show/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <regex>
#include <span>
#include <utility>

#include "base/number.hpp"

namespace ikbench::show {
namespace {

using Rows = std::vector<std::vector<std::string>>;

using Substitute = std::pair<char, std::string_view>;

std::string replaced(std::string_view text, std::span<const Substitute> substitutes, std::string_view after_backslash) {
  std::string result;
  for (const char c : one_line(text)) {
    const auto found = std::ranges::find(substitutes, c, &Substitute::first);
    if (after_backslash.find(c) != std::string_view::npos) result += '\\';
    result += found == substitutes.end() ? std::string_view(&c, 1) : found->second;
  }
  return result;
}

// Returns whether the words beside a blank stay on one line: a number and the next word, "* worse", "p < 0.05".
bool is_inseparable(std::string_view text, std::size_t blank) {
  if (blank == 0 || blank >= text.size() - 1) return false;
  const char before = text[blank - 1], after = text[blank + 1];
  return (before >= '0' && before <= '9') || before == '<' || before == '*' || after == '<';
}

// Narrows the widest columns until a row fits; no column becomes narrower than its longest word.
void narrow(std::vector<std::size_t>& widths, const Rows& rows, std::size_t gap, std::size_t width) {
  std::vector<std::size_t> least(widths.size(), 1);
  for (const auto& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      for (const std::string& word : wrap_words(row[c], 1, 1)) least[c] = std::max(least[c], character_count(word));
    }
  }
  const std::size_t gaps = gap * (widths.size() - std::min<std::size_t>(widths.size(), 1));
  const auto spare = [&](std::size_t c) { return widths[c] > least[c] ? widths[c] : 0; };
  for (std::size_t all = std::accumulate(widths.begin(), widths.end(), gaps); all > width; --all) {
    std::size_t widest = 0;
    for (std::size_t c = 1; c < widths.size(); ++c) widest = spare(c) > spare(widest) ? c : widest;
    if (spare(widest) == 0) return;
    --widths[widest];
  }
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
                                                    {'~', "\\raisebox{-.6ex}{\\textasciitilde}"},
                                                    {'^', "\\textasciicircum{}"},
                                                    {'<', "\\textless{}"},
                                                    {'>', "\\textgreater{}"},
                                                    {'|', "\\textbar{}"},
                                                    {'`', "\\textasciigrave{}"},
                                                    {'"', "''"},
                                                    {'[', "{[}"},
                                                    {']', "{]}"},
                                                    {'*', "{*}"}}};  // after \\ it would be an argument
  // TeX would set an opening quote as a closing one, and a minus sign as a hyphen. Repetitions are bounded, because
  // std::regex calls itself for each character that it repeats.
  static const std::regex quote("(^|[ (])'(?=[^ ])"), quotes("(^|[ (])''(?=[^ ])"),
      power("(^|[ (}])(-?[0-9.]{1,30})e[+]?(-?)0{0,3}([0-9]{1,3})(?=$|[ ),;{])"), sign("(^|[ (}])-(?=[0-9])");
  std::string result = std::regex_replace(replaced(text, substitutes, "{}$&#_%"), quotes, "$1``");
  result = std::regex_replace(result, quote, "$1`");
  result = std::regex_replace(result, power, "$1$$$2 \\times 10^{$3$4}$$");
  return std::regex_replace(result, sign, "$1$$-$$");
}

std::string with_spaces(std::string_view name) {
  std::string text(name);
  std::ranges::replace(text, '_', ' ');
  return text;
}

std::string anchor_id(std::string_view name) {
  std::string id;
  for (const char c : name) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (is_letter || (!id.empty() && id.back() != '-')) id += is_letter ? c : '-';
  }
  return id;
}

std::string number_text(double value, int digits) {
  if (std::isnan(value)) return "-";
  std::string text = fmt::format("{:.{}g}", value, digits);
  const bool is_long = text.find('e') != std::string::npos && std::abs(value) >= 1 && std::abs(value) < 1e7;
  return is_long ? fmt::format("{:.0f}", value) : text;
}

std::string ratio_text(double ratio) { return number_text(ratio, std::abs(ratio - 1) < 0.1 ? 3 : 2) + 'x'; }

std::string number_within(double value, const Boundaries& ends, int digits) {
  const std::string text = number_text(value, digits);
  const double read = base::number_from(text).value_or(value);
  if (read == value || std::ranges::count(ends, read) == 0) return text;
  return (value < read ? "< " : "> ") + text;
}

std::string p_text(double p, const Boundaries& ends) {
  if (p < 0.0001) return "< 0.0001";
  return number_within(p, ends, p < 0.001 ? 2 : 3);
}

std::string number_word(std::size_t number) {
  constexpr std::array<const char*, 13> words{"no",    "one",   "two",  "three", "four",   "five",  "six",
                                              "seven", "eight", "nine", "ten",   "eleven", "twelve"};
  return number < words.size() ? words[number] : fmt::to_string(number);
}

std::string name_in_sentence(const std::string& name) {
  return name.find(',') == std::string::npos ? name : fmt::format("\"{}\"", name);
}

std::string enumerated(const std::vector<std::string>& texts) {
  if (texts.size() < 2) return fmt::format("{}", fmt::join(texts, ""));
  return fmt::format("{} and {}", fmt::join(texts.begin(), texts.end() - 1, ", "), texts.back());
}

std::string as_sentence(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

std::vector<std::string> wrap_words(std::string_view text, std::size_t first, std::size_t others) {
  std::vector<std::string> lines{""};
  std::size_t used = 0;
  for (std::size_t at = 0; at <= text.size();) {
    std::size_t end = text.find(' ', at);
    while (is_inseparable(text, end)) end = text.find(' ', end + 1);
    end = std::min(end, text.size());
    const std::string_view word = text.substr(at, end - at);
    const std::size_t length = character_count(word), width = lines.size() == 1 ? first : others;
    if (used > 0 && used + 1 + length > width) {
      lines.emplace_back();
      used = 0;
    } else if (at > 0) {
      lines.back() += ' ';
      ++used;
    }
    lines.back() += word;
    used += length;
    at = end + 1;
  }
  for (std::string& line : lines) line.erase(line.find_last_not_of(' ') + 1);
  return lines;
}

std::string align_columns(const Rows& rows, std::size_t gap, std::size_t width) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], character_count(row[c]));
  }
  const std::size_t gaps = widths.empty() ? 0 : widths.size() - 1;
  if (std::accumulate(widths.begin(), widths.end(), gaps * gap) > width) gap = 2;
  narrow(widths, rows, gap, width);
  std::string text;
  for (const auto& row : rows) {
    std::vector<std::vector<std::string>> cells;
    std::size_t lines = 1;
    for (std::size_t c = 0; c < row.size(); ++c) {
      lines = std::max(lines, cells.emplace_back(wrap_words(row[c], widths[c], widths[c])).size());
    }
    for (std::size_t line = 0; line < lines; ++line) {
      std::size_t missing = 0;  // blanks before the next cell
      for (std::size_t c = 0; c < row.size(); ++c) {
        const std::string cell = line < cells[c].size() ? cells[c][line] : "";
        if (!cell.empty()) text += std::string(std::exchange(missing, 0), ' ') + cell;
        missing += widths[c] - std::min(widths[c], character_count(cell)) + gap;
      }
      text += '\n';
    }
  }
  return text;
}

std::string wrapped_paragraph(const std::string& text, const std::string& indent, const std::string& first) {
  constexpr std::size_t width = 100;
  std::string lines;
  for (const std::string& line : wrap_words(one_line(text), width - character_count(first), width - indent.size()))
    lines += (lines.empty() ? first : indent) + line + '\n';
  return lines;
}

}  // namespace ikbench::show
