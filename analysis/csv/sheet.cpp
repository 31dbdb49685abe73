#include "analysis/csv/sheet.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "numerics/names.hpp"
#include "numerics/number.hpp"

namespace ikbench::csv {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

bool is_missing(std::string_view cell) {
  return cell.size() <= 4 &&
         is_one_of(cell, {"", "-", "--", "na", "n/a", "#n/a", "nan", "-nan", "null", "none", "<na>"});
}

std::optional<double> parsed(std::string_view text, char decimal) {
  if (decimal == '.') return numerics::number_from(text);
  if (text.find('.') != std::string_view::npos) return std::nullopt;
  std::string pointed(text);
  std::ranges::replace(pointed, ',', '.');
  return numerics::number_from(pointed);
}

// What the header has most often outside quotes.
char separator_of(std::string_view text) {
  std::string header;
  bool is_quoted = false;
  for (const char c : text.substr(0, text.find('\n'))) {
    if (c == '"') is_quoted = !is_quoted;
    if (!is_quoted) header += c;
  }
  const auto count = [&](char separator) { return std::ranges::count(header, separator); };
  constexpr std::string_view separators = "\t;,";
  return *std::ranges::max_element(separators, {}, count);
}

}  // namespace

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return lower;
}

bool is_one_of(std::string_view text, const Words& words) {
  return std::ranges::find(words, lower_case(text)) != words.end();
}

std::string in_quotes(std::string_view text) {
  std::string line(numerics::front(text, 60));
  std::ranges::replace_if(
      line, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return fmt::format("'{}'", line);
}

Sheet::Sheet(std::string_view text, std::string_view source, char separator, char decimal)
    : source_(source), view_(text), decimal_(decimal) {
  results::expect_text(text, source);
  if (std::ranges::count(text, '\n') > most_lines + 1)
    refuse(fmt::format("more than {} rows; expected at most that: compare a part, or means of runs", most_lines));
  if (separator == 0) separator = separator_of(text);
  if (decimal_ == 0 && separator == ',') decimal_ = '.';  // "1,234" may be a thousand
  view_ = results::view_csv(text, source, separator);
  for (const std::string& title : view_.header) titles_.emplace_back(trimmed(title));
  for (std::uint32_t row = 0; row < view_.rows(); ++row) {
    std::size_t empty = 0;
    while (empty < titles_.size() && cell(row, empty).empty()) ++empty;
    if (empty < titles_.size()) rows_.push_back(row);
  }
  if (rows_.empty()) refuse("no rows below the header; expected at least one");
}

void Sheet::choose(std::string_view condition) {
  const std::size_t equals = condition.find('=');
  if (equals == std::string_view::npos) refuse(fmt::format("--where {}; expected COLUMN=VALUE", in_quotes(condition)));
  const std::size_t chosen = column(trimmed(condition.substr(0, equals)));
  const std::string_view value = trimmed(condition.substr(equals + 1));
  const std::string first(cell(rows_.front(), chosen));
  std::erase_if(rows_, [&](std::uint32_t row) { return cell(row, chosen) != value; });
  if (rows_.empty())
    refuse(
        fmt::format("no row has {}; the first has {}", in_quotes(condition), in_quotes(titles_[chosen] + "=" + first)));
}

std::string_view Sheet::cell(std::size_t row, std::size_t column) const { return trimmed(view_.cell(row, column)); }

std::size_t Sheet::column(std::string_view name) const {
  const auto number = std::ranges::count(titles_, name);
  if (number > 1) refuse(fmt::format("{} columns {}; give them different names", number, in_quotes(name)));
  if (number == 0)
    refuse(fmt::format("no column {}{}; there are {}", in_quotes(name), numerics::did_you_mean(name, titles_),
                       numerics::front(fmt::format("{}", fmt::join(titles_, ", ")), 300)));
  return static_cast<std::size_t>(std::ranges::find(titles_, name) - titles_.begin());
}

std::optional<std::size_t> Sheet::column_like(const Words& names) const {
  for (const std::string_view name : names) {
    for (std::size_t i = 0; i < titles_.size(); ++i) {
      if (lower_case(titles_[i]) == name) return i;
    }
  }
  return std::nullopt;
}

std::string Sheet::names_of(const std::vector<std::size_t>& columns) const {
  std::string names;
  for (const std::size_t each : columns) names += (names.empty() ? "" : ", ") + titles_[each];
  return std::string(numerics::front(names, 300));
}

bool Sheet::has_numbers(std::size_t column) const {
  const auto is_lost = [&](std::uint32_t row) { return is_missing(cell(row, column)); };
  const auto is_number = [&](std::uint32_t row) {
    return is_lost(row) || parsed(cell(row, column), '.') || parsed(cell(row, column), ',');
  };
  return std::ranges::all_of(rows_, is_number) && !std::ranges::all_of(rows_, is_lost);
}

double Sheet::number(std::size_t row, std::size_t column) {
  const std::string_view text = cell(row, column);
  if (is_missing(text)) return std::numeric_limits<double>::quiet_NaN();
  const bool has_comma = text.find(',') != std::string_view::npos;
  if (decimal_ == 0 && (has_comma || text.find('.') != std::string_view::npos)) decimal_ = has_comma ? ',' : '.';
  const auto value = parsed(text, decimal_ == 0 ? '.' : decimal_);
  if (!value)
    refuse(
        row, column,
        fmt::format("is no number with a decimal {}: write NA where there is none, and say with --decimal what marks "
                    "decimals",
                    decimal_ == ',' ? "comma" : "point"));
  const double size = std::abs(*value);  // tests take squares of squares
  if (std::isfinite(size) && size != 0 && (size < 1e-60 || size > 1e60))
    refuse(row, column, "is beyond what can be compared, 1e-60 to 1e60");
  return std::isfinite(*value) ? *value : std::numeric_limits<double>::quiet_NaN();
}

void Sheet::refuse(std::string_view what) const { throw std::invalid_argument(fmt::format("{}: {}", source_, what)); }

void Sheet::refuse(std::size_t row, std::size_t column, std::string_view what) const {
  throw std::invalid_argument(fmt::format("{}:{}:{}: {} in column {} {}", source_, view_.line(row), column + 1,
                                          in_quotes(cell(row, column)), in_quotes(titles_[column]), what));
}

}  // namespace ikbench::csv
