// Comma-separated values: RFC 4180, https://www.rfc-editor.org/rfc/rfc4180.
#include "results/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "numerics/number.hpp"

namespace ikbench::results {

using namespace numerics;

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

// Walks over the text once, a row at a time, and counts lines for its messages.
class Reader {
 public:
  Reader(std::string_view text, std::string_view source) : rest_(text), source_(source) {
    if (text.size() > max_csv_bytes) refuse(fmt::format("{} bytes; expected at most {}", text.size(), max_csv_bytes));
    take(byte_order_mark);
  }

  // The next row that is not an empty line; nothing at the end.
  std::vector<std::string> row() {
    while (take_line_end()) {
    }
    row_line_ = line_;
    std::vector<std::string> cells;
    if (rest_.empty()) return cells;
    do {
      if (cells.size() == max_csv_columns)
        refuse(fmt::format("too many columns; expected at most {}", max_csv_columns));
      cells.push_back(take("\"") ? quoted_cell() : plain_cell());
    } while (take(","));
    if (!rest_.empty() && !take_line_end()) {
      refuse(rest_.front() == '\r' ? "a lone carriage return; expected lines to end in LF or CRLF"
                                   : "text after a closing quote; expected a comma or the end of the line");
    }
    return cells;
  }

  // Of the row read last: the line on which it begins.
  [[noreturn]] void refuse_row(const std::string& what) {
    line_ = row_line_;
    refuse(what);
  }

 private:
  std::string plain_cell() {
    const std::size_t length = std::min(rest_.find_first_of(",\"\r\n"), rest_.size());
    if (rest_.substr(length).starts_with('"'))
      refuse("a quote inside an unquoted cell; expected the cell in quotes and the quote doubled");
    return std::string(take_front(length));
  }

  // Behind the opening quote.
  std::string quoted_cell() {
    std::string cell;
    do {
      const std::size_t length = rest_.find('"');
      if (length == std::string_view::npos) refuse_row("a quote is never closed; expected a closing quote");
      line_ += static_cast<std::size_t>(std::count(rest_.begin(), rest_.begin() + static_cast<long>(length), '\n'));
      cell += take_front(length + 1);  // with the quote, which is text if another follows
    } while (take("\""));
    cell.pop_back();
    return cell;
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

  std::string_view rest_;
  std::string_view source_;
  std::size_t line_ = 1;
  std::size_t row_line_ = 1;
};

void append_cell(std::string& text, std::string_view cell) {
  const bool plain = cell.find_first_of(",\"\r\n") == std::string_view::npos && !cell.starts_with(byte_order_mark);
  if (plain) {
    text += cell;
    return;
  }
  text += '"';
  for (const char c : cell) text.append(c == '"' ? 2 : 1, c);
  text += '"';
}

}  // namespace

std::size_t CsvTable::column(std::string_view name) const {
  const auto found = std::find(header.begin(), header.end(), name);
  if (found == header.end())
    throw std::invalid_argument(fmt::format("no column '{}'; expected one of: {}", name, fmt::join(header, ", ")));
  if (std::find(found + 1, header.end(), name) != header.end())
    throw std::invalid_argument(fmt::format("two columns '{}'; expected one", name));
  return static_cast<std::size_t>(found - header.begin());
}

double CsvTable::number(std::size_t row, std::string_view column_name) const {
  const std::string& cell = rows.at(row)[column(column_name)];
  if (const auto value = number_from(cell)) return *value;
  throw std::invalid_argument(
      fmt::format("row {} below the header, column '{}': '{}'; expected a number", row + 1, column_name, cell));
}

CsvTable parse_csv(std::string_view text, std::string_view source) {
  Reader reader(text, source);
  CsvTable table;
  table.header = reader.row();
  if (table.header.empty()) reader.refuse_row("the file is empty; expected a line with the names of the columns");
  for (auto row = reader.row(); !row.empty(); row = reader.row()) {
    if (row.size() != table.header.size())
      reader.refuse_row(fmt::format("{} cells; expected {} as in the header", row.size(), table.header.size()));
    table.rows.push_back(std::move(row));
  }
  return table;
}

void append_csv_row(std::string& text, const std::vector<std::string>& cells) {
  const bool lone_empty_cell = cells.size() == 1 && cells.front().empty();  // would be an empty line, which is no row
  if (lone_empty_cell) text += "\"\"";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) text += ',';
    append_cell(text, cells[i]);
  }
  text += '\n';
}

std::string to_csv(const CsvTable& table) {
  std::string text;
  append_csv_row(text, table.header);
  for (const auto& row : table.rows) append_csv_row(text, row);
  return text;
}

}  // namespace ikbench::results
