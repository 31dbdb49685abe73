// Comma-separated values: RFC 4180, https://www.rfc-editor.org/rfc/rfc4180.
#include "base/csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <iostream>
#include <stdexcept>
#include <utility>

#include "base/files.hpp"
#include "base/names.hpp"
#include "base/number.hpp"

namespace ikbench::base {

namespace {

// Reads the text once, row by row, and counts lines for messages.
class Reader {
 public:
  Reader(std::string_view text, std::string_view source, const CsvForm& form,
         std::vector<std::unique_ptr<const std::string>>& unquoted)
      : rest_(text), source_(source), separator_(form.separator), unquoted_(unquoted), line_(form.first_line) {
    if (text.size() > form.max_bytes) refuse(fmt::format("{} bytes; expected at most {}", text.size(), form.max_bytes));
    take(byte_order_mark);
  }

  // Returns the next row that is not an empty line; empty at the end.
  const std::vector<std::string_view>& row() {
    while (take_line_end()) {
    }
    row_line_ = line_;
    row_ = rest_.data();
    cells_.clear();
    if (rest_.empty()) return cells_;
    do {
      while (separator_ == ' ' && take(" ")) {
      }
      if (cells_.size() == max_csv_columns)
        refuse(fmt::format("there are too many columns; expected at most {}", max_csv_columns));
      cells_.push_back(take("\"") ? quoted_cell() : plain_cell());
    } while (take({&separator_, 1}));
    if (separator_ == ' ' && cells_.size() > 1 && cells_.back().empty()) cells_.pop_back();  // blanks at the end
    if (!rest_.empty() && !take_line_end()) {
      refuse(rest_.front() == '\r' ? "a lone carriage return; expected lines to end in LF or CRLF"
                                   : "text after a closing quote; expected a separator or the end of the line");
    }
    return cells_;
  }

  // The line where the last row begins.
  std::size_t row_line() const { return row_line_; }
  std::string_view row_text() const { return {row_, static_cast<std::size_t>(rest_.data() - row_)}; }
  [[noreturn]] void refuse_row(const std::string& what) {
    line_ = row_line_;
    refuse(what);
  }

 private:
  std::string_view plain_cell() {
    const std::array<char, 4> ends{separator_, '"', '\r', '\n'};
    const std::size_t length = std::min(rest_.find_first_of({ends.data(), ends.size()}), rest_.size());
    if (rest_.substr(length).starts_with('"'))
      refuse("a quote inside an unquoted cell; expected the cell in quotes and the quote doubled");
    return take_front(length);
  }

  // Reads a quoted cell behind its opening quote.
  std::string_view quoted_cell() {
    std::string cell;
    do {
      const std::size_t length = rest_.find('"');
      if (length == std::string_view::npos) refuse_row("a quote is never closed; expected a closing quote");
      line_ += static_cast<std::size_t>(std::count(rest_.begin(), rest_.begin() + static_cast<long>(length), '\n'));
      cell += take_front(length + 1);  // includes the quote, which is text if another one follows
    } while (take("\""));
    cell.pop_back();
    return *unquoted_.emplace_back(std::make_unique<const std::string>(std::move(cell)));
  }

  bool take_line_end() {
    const bool taken = take("\n") || take("\r\n");
    line_ += taken ? 1 : 0;
    return taken;
  }

  bool take(std::string_view token) {
    const bool taken = rest_.starts_with(token);
    if (taken) rest_.remove_prefix(token.size());
    return taken;
  }

  std::string_view take_front(std::size_t length) {
    const std::string_view front = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return front;
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw std::invalid_argument(fmt::format("{}:{}: {}", source_, line_, what));
  }

  std::vector<std::string_view> cells_;
  std::string_view rest_;
  std::string_view source_;
  char separator_;
  std::vector<std::unique_ptr<const std::string>>& unquoted_;
  std::size_t line_;
  std::size_t row_line_ = 1;
  const char* row_ = nullptr;
};

// Returns true if spreadsheets take the text for a formula, which may do anything.
bool is_formula(std::string_view cell) {
  return !cell.empty() && std::string_view("=+-@").find(cell.front()) != std::string_view::npos && !number_from(cell);
}

// Returns advice on a first row that has another number of cells than the header.
std::string_view advice_on_title(std::size_t cells, std::size_t columns) {
  return cells == columns + 1 ? "; write a title above the names of rows, too"
                              : "; begin a title above the header with #";
}

}  // namespace

void append_csv_cell(std::string& text, std::string_view cell) {
  const std::string as_text = is_formula(cell) ? fmt::format("'{}", cell) : "";
  if (!as_text.empty()) cell = as_text;
  const bool plain = cell.find_first_of(",\"\r\n") == std::string_view::npos && !cell.starts_with(byte_order_mark);
  if (plain) return void(text += cell);
  text += '"';
  for (const char c : cell) text.append(c == '"' ? 2 : 1, c);
  text += '"';
}

std::size_t CsvTable::column(std::string_view name) const {
  const auto found = std::find(header.begin(), header.end(), name);
  if (found == header.end())
    throw std::invalid_argument(
        fmt::format("there is no column '{}'; expected one of: {}", name, fmt::join(header, ", ")));
  if (std::find(found + 1, header.end(), name) != header.end())
    throw std::invalid_argument(fmt::format("there are two columns '{}'; expected one", name));
  return static_cast<std::size_t>(found - header.begin());
}

double CsvTable::number(std::size_t row, std::string_view column_name) const {
  const std::string_view text = cell(row, column(column_name));
  if (const auto value = number_from(text)) return *value;
  throw std::invalid_argument(
      fmt::format("row {} below the header, column '{}': '{}'; expected a number", row + 1, column_name, text));
}

void expect_text(std::string_view text, std::string_view source) {
  const std::size_t broken = first_broken(text);
  if (broken == std::string_view::npos) return;
  throw std::invalid_argument(fmt::format("{}:{}: {}; expected text in UTF-8", source,
                                          1 + std::ranges::count(text.substr(0, broken), '\n'),
                                          text[broken] == 0 ? "a NUL byte" : "letters in another encoding"));
}

std::string csv_text(std::istream& stream, const std::string& source) {
  std::string text;
  std::array<char, 1 << 13> buffer{};
  while (text.size() <= max_csv_bytes && stream) {
    stream.read(buffer.data(), buffer.size());
    const std::string_view part(buffer.data(), static_cast<std::size_t>(stream.gcount()));
    text += part;
    if (part.find('\0') != std::string_view::npos) break;  // this is no text, and may have no end
  }
  // To the stream, a failed read of standard input is its end; only C tells that it was a fault.
  if (stream.bad() || (&stream == &std::cin && std::ferror(stdin) != 0)) refuse_place("read", source, errno);
  return text;
}

CsvTable parse_csv(std::string_view text, std::string_view source, const CsvForm& form) {
  CsvTable table;
  Reader reader(text, source, form, table.unquoted_);
  const std::vector<std::string_view>* row = &reader.row();
  if (row->empty()) reader.refuse_row("the file is empty; expected a line with the names of the columns");
  table.header.assign(row->begin(), row->end());
  if (form.has_header) row = &reader.row();
  for (std::size_t i = 0; i < table.header.size() && !form.has_header; ++i) table.header[i] = std::to_string(i + 1);
  for (; !row->empty(); row = &reader.row()) {
    const bool has_all = row->size() == table.header.size();
    const bool is_none = is_rule(reader.row_text()) || (!has_all && is_comment(row->front()));
    if (!form.is_ours && is_none) continue;
    if (!has_all)
      reader.refuse_row(fmt::format("{}; expected {} as in the header{}", counted(std::ssize(*row), "cells"),
                                    table.header.size(),
                                    table.rows() > 0 ? "" : advice_on_title(row->size(), table.header.size())));
    table.lines_.push_back(reader.row_line());
    table.cells_.insert(table.cells_.end(), row->begin(), row->end());
  }
  return table;
}

bool is_comment(std::string_view text) { return text.starts_with('#') || text.starts_with('%'); }

bool is_rule(std::string_view text) {
  return text.find_first_not_of("-=:+| \t\r\n") == std::string_view::npos &&
         (text.find("---") != std::string_view::npos || text.find("===") != std::string_view::npos ||
          text.find("-:") != std::string_view::npos || text.find(":-") != std::string_view::npos);
}

void append_csv_row(std::string& text, const std::vector<std::string>& cells) {
  // Without quotes a lone empty cell would be an empty line, which is no row.
  const bool lone_empty_cell = cells.size() == 1 && cells.front().empty();
  if (lone_empty_cell) text += "\"\"";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) text += ',';
    append_csv_cell(text, cells[i]);
  }
  text += '\n';
}

}  // namespace ikbench::base
