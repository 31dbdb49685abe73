#include "analysis/inference/csv_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "analysis/inference/text.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "numerics/names.hpp"
#include "numerics/number.hpp"

namespace ikbench::inference {

using namespace numerics;
using namespace results;
using namespace statistics;

namespace {

constexpr std::size_t longest_name = 1000;  // of a group [bytes]

// Refuses what is no text, and a header with semicolons or tabs, as spreadsheets in other languages write it.
std::string_view expect_commas(std::string_view text, std::string_view source) {
  if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos) {
    throw std::invalid_argument(fmt::format("{}:{}: a NUL byte; expected text in UTF-8", source,
                                            1 + std::ranges::count(text.substr(0, nul), '\n')));
  }
  const std::string_view titles = text.substr(0, text.find_first_of("\r\n"));
  if (titles.find_first_of(",\"") == std::string_view::npos && titles.find_first_of(";\t") != std::string_view::npos) {
    throw std::invalid_argument(fmt::format(
        "{}:1: no commas between the columns; expected them (and a point, not a comma, in a number)", source));
  }
  return text;
}

}  // namespace

CsvFile::CsvFile(std::string_view text, std::string_view source)
    : source_(source), table_(view_csv(expect_commas(text, source), source)) {
  for (Index row = 0; row < table_.rows(); ++row) {
    std::size_t column = 0;
    while (column < header().size() && cell(row, column).empty()) ++column;
    if (column < header().size()) rows_.push_back(row);
  }
  if (rows_.empty()) refuse("no rows below the header; expected at least one");
}

double CsvFile::number(std::size_t row, std::size_t column) const {
  const std::string_view text = cell(row, column);
  if (is_missing(text)) return not_defined;
  const auto value = number_from(text);
  if (!value)
    refuse_cell(row, column, "expected a number with a decimal point, of at most 1.7e308, or NA if it is missing");
  return *value;
}

std::string CsvFile::name_in(std::string_view text) const {
  const std::string_view name = trimmed(text);
  if (name.size() > longest_name) {
    refuse(fmt::format("{} has {} bytes; expected a name of at most {}", in_quotes(name), name.size(), longest_name));
  }
  return name.empty() ? "(empty)" : std::string(name);
}

std::size_t CsvFile::column(std::string_view name) const {
  const auto number = std::ranges::count(header(), name);
  if (number > 1) refuse(fmt::format("two columns {}; expected one", in_quotes(name)));
  if (number == 0) {
    refuse(
        fmt::format("no column {}; expected one of: {}{}", in_quotes(name), columns(), did_you_mean(name, header())));
  }
  return static_cast<std::size_t>(std::ranges::find(header(), name) - header().begin());
}

std::optional<std::size_t> CsvFile::column_like(std::initializer_list<std::string_view> names) const {
  for (std::size_t column = 0; column < header().size(); ++column) {
    if (std::ranges::find(names, lower_case(header()[column])) != names.end()) return column;
  }
  return std::nullopt;
}

std::string CsvFile::columns() const {
  constexpr std::size_t longest_list = 200;
  std::vector<std::string> titles = header();
  std::ranges::replace(titles, "", "(empty)");
  return shortened(fmt::format("{}", fmt::join(titles, ", ")), longest_list);
}

std::string CsvFile::file_name() const { return one_line(std::string_view(source_).substr(source_.rfind('/') + 1)); }

void CsvFile::refuse(std::string_view what) const { throw std::invalid_argument(fmt::format("{}: {}", source_, what)); }

void CsvFile::refuse_cell(std::size_t row, std::size_t column, std::string_view what) const {
  refuse(fmt::format("row {} below the header, column {}: {}, {}", row + 1, in_quotes(header()[column]),
                     in_quotes(cell(row, column)), what));
}

bool is_missing(std::string_view cell) {
  constexpr std::array<std::string_view, 8> words{"", "na", "n/a", "nan", "-nan", "null", "none", "<na>"};
  cell = trimmed(cell);
  return cell.size() <= 4 && std::ranges::find(words, lower_case(cell)) != words.end();
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

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest_quotation = 60;
  return fmt::format("'{}'", shortened(text, longest_quotation));
}

std::string slug(std::string_view text) {
  constexpr std::size_t longest_slug = 60;
  std::string result;
  for (const char c : lower_case(text)) {
    const bool kept = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    if (kept) result += c;
    if (!kept && !result.empty() && result.back() != '-') result += '-';
  }
  result.resize(std::min(result.size(), longest_slug));
  while (result.ends_with('-')) result.pop_back();
  return result.empty() ? "value" : result;
}

}  // namespace ikbench::inference
