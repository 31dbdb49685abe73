#include "analysis/inference/csv_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "analysis/inference/text.hpp"
#include "numerics/names.hpp"
#include "numerics/number.hpp"

namespace ikbench::inference {

using namespace numerics;
using namespace results;

namespace {

constexpr std::size_t longest_quotation = 60;
constexpr std::size_t longest_slug = 60;
constexpr std::size_t longest_list = 200;  // longest list of columns in a message [characters]

// Refuses UTF-16, NUL bytes, and a header with semicolons or tabs but no comma, as spreadsheets in other languages
// write it.
void expect_text_with_commas(std::string_view text, std::string_view source) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    throw std::invalid_argument(fmt::format("{}: the text is UTF-16; expected UTF-8", source));
  }
  if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos) {
    throw std::invalid_argument(fmt::format("{}:{}: a NUL byte; expected text in UTF-8", source,
                                            1 + std::ranges::count(text.substr(0, nul), '\n')));
  }
  std::array<std::size_t, 3> found{};
  constexpr std::string_view separators = ",;\t";
  bool inside_quotes = false;
  for (const char c : text.substr(0, text.find_first_of("\r\n"))) {
    if (c == '"') inside_quotes = !inside_quotes;
    const std::size_t separator = separators.find(c);
    if (!inside_quotes && separator != std::string_view::npos) ++found[separator];
  }
  if (found[0] > 0 || (found[1] == 0 && found[2] == 0)) return;
  throw std::invalid_argument(
      fmt::format("{}:1: {} between the columns; expected commas (and a point, not a comma, in a number)", source,
                  found[1] > 0 ? "semicolons" : "tabs"));
}

// Says what to write instead of an unreadable number.
std::string remedy(std::string_view cell) {
  const auto commas = std::ranges::count(cell, ',');
  if (commas == 0) return "expected a number within the range of a double, or NA if it is missing";
  std::string with_point(cell);
  std::ranges::replace(with_point, ',', '.');
  std::string without_commas(cell);
  std::erase(without_commas, ',');
  if (commas == 1 && number_from(with_point)) return fmt::format("a decimal comma; write {}", with_point);
  if (number_from(without_commas)) return fmt::format("commas between the digits; write {}", without_commas);
  return "expected a number with a decimal point";
}

}  // namespace

void CsvFile::refuse(std::string_view what) const { throw std::invalid_argument(fmt::format("{}: {}", source, what)); }

void CsvFile::refuse_cell(std::size_t row, std::size_t column, std::string_view what) const {
  refuse(fmt::format("row {} below the header, column {}: {}, {}", row + 1, in_quotes(table.header[column]),
                     in_quotes(table.cell(row, column)), what));
}

std::size_t CsvFile::column(std::string_view name) const {
  const auto found = std::ranges::find(table.header, name);
  if (found == table.header.end())
    refuse(fmt::format("no column {}; expected one of: {}{}", in_quotes(name), columns(),
                       numerics::did_you_mean(name, table.header)));
  if (std::find(found + 1, table.header.end(), name) != table.header.end()) {
    refuse(fmt::format("two columns {}; expected one", in_quotes(name)));
  }
  return static_cast<std::size_t>(found - table.header.begin());
}

std::string CsvFile::columns() const {
  std::vector<std::string> titles;
  for (const std::string& title : table.header) titles.push_back(title.empty() ? "(empty)" : title);
  return shortened(fmt::format("{}", fmt::join(titles, ", ")), longest_list);
}

std::string CsvFile::group_name(std::size_t row, std::size_t column) const {
  const std::string_view name = trimmed(table.cell(row, column));
  if (name.size() > longest_name) {
    refuse_cell(row, column, fmt::format("{} bytes; expected a name of at most {}", name.size(), longest_name));
  }
  return name.empty() ? "(empty)" : std::string(name);
}

std::optional<std::size_t> CsvFile::column_like(std::span<const std::string_view> names) const {
  const auto found = std::ranges::find_if(table.header, [&](const std::string& title) {
    return std::ranges::find(names, lower_case(title)) != names.end();
  });
  if (found == table.header.end()) return std::nullopt;
  return static_cast<std::size_t>(found - table.header.begin());
}

std::optional<double> CsvFile::number(std::size_t row, std::size_t column) const {
  const std::string_view cell = table.cell(row, column);
  if (is_missing(cell)) return std::nullopt;
  const auto value = number_from(cell);
  if (!value) refuse_cell(row, column, remedy(cell));
  return std::isnan(*value) ? std::nullopt : value;
}

bool CsvFile::is_blank(std::size_t row) const { return blank[row]; }

std::string CsvFile::name() const { return one_line(std::string_view(source).substr(source.find_last_of('/') + 1)); }

CsvFile open_csv(std::string_view text, std::string_view source) {
  expect_text_with_commas(text, source);
  CsvFile file{.source = std::string(source), .table = view_csv(text, source)};
  if (file.table.rows() == 0) file.refuse("no rows below the header; expected at least one");
  file.blank.assign(file.table.rows(), true);
  for (std::size_t row = 0; row < file.table.rows(); ++row) {
    for (std::size_t column = 0; file.blank[row] && column < file.table.header.size(); ++column)
      file.blank[row] = file.table.cell(row, column).empty();
  }
  return file;
}

std::string_view trimmed(std::string_view name) {
  const std::size_t first = name.find_first_not_of(' ');
  return first == std::string_view::npos ? std::string_view()
                                         : name.substr(first, name.find_last_not_of(' ') + 1 - first);
}

bool is_missing(std::string_view cell) {
  constexpr std::string_view blanks = " \t";
  constexpr std::array<std::string_view, 8> words{"", "na", "n/a", "nan", "-nan", "null", "none", "<na>"};
  cell.remove_prefix(std::min(cell.find_first_not_of(blanks), cell.size()));
  cell = cell.substr(0, cell.find_last_not_of(blanks) + 1);
  return cell.size() <= 4 && std::ranges::find(words, lower_case(cell)) != words.end();
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

std::string slug(std::string_view text) {
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

std::string in_quotes(std::string_view text) { return fmt::format("'{}'", shortened(text, longest_quotation)); }

}  // namespace ikbench::inference
