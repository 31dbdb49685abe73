#include "base/sheet.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>

#include "base/number.hpp"

namespace ikbench::base {

namespace {

bool means_none(std::string_view cell) {
  return cell.size() <= 4 &&
         is_one_of(cell, {"", "-", "--", "na", "n/a", "#n/a", "nan", "-nan", "null", "none", "<na>"});
}

// Returns true for digits in groups of three, such as "1,234,567".
bool is_grouped(std::string_view whole, char mark) {
  whole.remove_prefix(whole.starts_with('-') || whole.starts_with('+') ? 1 : 0);
  const std::size_t first = whole.find(mark);
  if (first == 0 || first > 3 || whole.front() == '0' || (whole.size() - first) % 4 != 0) return false;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (i >= first && (i - first) % 4 == 0 ? whole[i] != mark : whole[i] < '0' || whole[i] > '9') return false;
  }
  return true;
}

constexpr char of_truth = 't';  // stands in `decimals_` for a column of True and False

bool has_mark(std::string_view text) { return text.find_first_of(".,") != std::string_view::npos; }

// Returns the number of a text with this mark of decimals. The other mark separates thousands, as do ' and blanks:
// 1'234.5. A minus may be the printed one, and an exponent may be as in Fortran: 1.5D-01.
std::optional<double> parsed(std::string_view text, char decimal) {
  std::string plain(text);
  if (text.find_first_of("' \xE2\xC2") != text.npos) {
    boost::replace_all(plain, "\u2212", "-");
    for (const char* of_thousands : {"\u2019", "\u00a0", "\u2007", "\u2009", "\u202f", " "})
      boost::replace_all(plain, of_thousands, "'");
  }
  if (has_mark(text))  // without a mark, "2D-1" is no number
    for (const char* exponent : {"D-", "D+", "d-", "d+"})
      boost::replace_first(plain, exponent, std::string{'e', exponent[1]});
  for (const char thousand : {decimal == '.' ? ',' : '.', '\''}) {
    if (plain.find(thousand) == plain.npos) continue;
    const std::string_view whole = std::string_view(plain).substr(0, plain.find(decimal));
    if (!is_grouped(whole, thousand) || plain.find(thousand, whole.size()) != plain.npos) return std::nullopt;
    std::erase(plain, thousand);
  }
  std::ranges::replace(plain, ',', '.');
  return number_from(plain);
}

bool is_number(std::string_view text) { return parsed(text, '.') || parsed(text, ','); }

// Says what to do about "1.2 ms" or "1.2 ± 0.1"; empty for other texts.
std::string advice_on_unit(std::string_view text, std::string_view title) {
  const std::size_t end = std::min(text.find_first_not_of("+-0123456789.,eE'"), text.size());
  const std::string_view number = text.substr(0, end), rest = trimmed(text.substr(end));
  if (rest.empty() || !is_number(number)) return "";
  for (const char* spread : {"\u00b1", "+/-", "+-", "\\pm", "$\\pm", "("})
    if (rest.starts_with(spread))
      return fmt::format(
          "is a mean with its spread: write only {} to compare it as a value, or columns name, n, mean and sd for "
          "--summaries",
          number);
  if (!is_one_of(rest, {"%", "ns", "us", "\u00b5s", "\u03bcs", "ms", "s", "min", "h", "mm", "cm", "m", "deg", "rad"}))
    return "";
  return fmt::format(
      "is a number with its unit: write {} in the cell and the unit in the header, {} (or name the column in --label or --block)",
      number, in_quotes(fmt::format("{} [{}]", title, rest)));
}

// Returns the value of true and false as pandas and R write them.
std::optional<double> truth(std::string_view text) {
  if (is_one_of(text, {"true", "yes"})) return 1;
  if (is_one_of(text, {"false", "no"})) return 0;
  return std::nullopt;
}

// Returns the separator that occurs most often in the first line outside quotes; a blank if no other occurs.
char separator_of(std::string_view text) {
  std::string header;
  bool is_quoted = false;
  for (const char c : text.substr(0, text.find('\n'))) {
    if (c == '"') is_quoted = !is_quoted;
    if (!is_quoted) header += c;
  }
  const auto count = [&](char separator) { return std::ranges::count(header, separator); };
  constexpr std::string_view separators = ",\t;|";
  const char most = *std::ranges::max_element(separators, {}, count);
  return count(most) == 0 && count(' ') > 0 ? ' ' : most;
}

// Removes comments, rules and empty lines from the front and returns their number. The last comment stays, without its
// mark, if it has as many cells as the line that follows.
std::size_t take_comments(std::string_view& text) {
  std::size_t lines = 0;
  for (;; ++lines) {
    const std::string_view line = text.substr(0, text.find('\n'));
    const std::string_view after = text.substr(std::min(line.size() + 1, text.size()));
    if (const bool is_empty = line.find_first_not_of(" \t\r") == std::string_view::npos;
        !after.empty() && (is_empty || is_rule(line))) {
      text = after;
      continue;
    }
    if (!is_comment(line)) break;
    const std::string_view names = trimmed(line.substr(1));
    const char separator = separator_of(names);
    const auto cells = [&](std::string_view of) {
      std::string row(trimmed(of.substr(0, of.find_first_of("\r\n"))));
      if (separator == ' ') row.erase(std::unique(row.begin(), row.end()), row.end());
      return std::ranges::count(row, separator);
    };
    if (names.starts_with(separator)) break;  // the mark is itself a name
    const auto has_number = [&](std::string_view row) {
      for (std::size_t at = 0, end = 0; at <= row.size(); at = end + 1) {
        end = std::min(row.find(separator, at), row.size());
        if (is_number(trimmed(row.substr(at, end - at)))) return true;
      }
      return false;
    };
    // A comment that begins with a number is a row that was taken out, and no header.
    const bool is_header = !is_comment(after) && cells(names) > 0 && cells(names) == cells(after) &&
                           has_number(after.substr(0, after.find('\n'))) &&
                           !is_number(names.substr(0, names.find(separator)));
    text.remove_prefix(is_header ? static_cast<std::size_t>(names.data() - text.data()) : text.size() - after.size());
    if (is_header) break;
  }
  return lines;
}

}  // namespace

bool is_one_of(std::string_view text, const Words& words) {
  return std::ranges::find(words, lower_case(text)) != words.end();
}

std::string unnamed(std::size_t column) { return fmt::format("column {}", column + 1); }

Title::Title(std::string_view title) : name(title) {
  const bool is_open = title.ends_with(']'), is_bracketed = is_open || title.ends_with(')');
  const std::size_t at = is_bracketed ? title.find_last_of("[(") : title.rfind('_');
  if (at == std::string_view::npos || at == 0) return;
  const std::string_view end = title.substr(at + 1, title.size() - at - (is_bracketed ? 2 : 1));
  if (!is_open && !is_one_of(end, {"cm", "mm", "m", "deg", "rad", "ns", "us", "ms", "s"})) return;
  name = trimmed(title.substr(0, at));
  unit = end;
}

Sheet::Sheet(std::string_view text, std::string_view source, char decimal, Header header, std::size_t max_bytes)
    : source_(source), decimal_(decimal) {
  expect_text(text, source);
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  constexpr std::string_view sep = "sep=";  // a line of spreadsheets, also in quotes
  const bool has_sep = text.substr(text.starts_with('"')).starts_with(sep) && text.find('\n') < sep.size() + 5;
  const char said = has_sep ? text[text.find(sep) + sep.size()] : '\0';
  if (has_sep) text.remove_prefix(text.find('\n') + 1);
  CsvForm form{.first_line = 1 + has_sep + take_comments(text), .is_ours = false, .max_bytes = max_bytes};
  form.separator = separator_ = has_sep ? said : separator_of(text);
  if (const std::string_view line = trimmed(text.substr(0, text.find('\n')));
      line.starts_with('\\') || line.ends_with('\\'))
    refuse("this is a table in LaTeX; replace each & by a comma, and remove everything that begins with a backslash");
  if (std::ranges::count(text, '\n') > max_lines + 1)
    refuse(
        fmt::format("there are more than {} rows; expected at most that many; compare a part of them, or means of runs",
                    max_lines));
  table_ = parse_csv(text, source, form);
  form.has_header = header == Header::required || !std::ranges::all_of(table_.header, is_number);
  if (!form.has_header) table_ = parse_csv(text, source, form);
  for (const std::string& title : table_.header) titles_.emplace_back(trimmed(title));
  decimals_.assign(titles_.size(), 0);
  refuse_second_header();
  if (const auto empty = std::ranges::count(titles_, ""); empty > 1 && empty + 1 == std::ssize(titles_))
    refuse(fmt::format("the header has only {}; if this is a title, begin it with #", in_quotes(titles_.front())));
  for (std::size_t i = 0; i < titles_.size(); ++i)
    if (titles_[i].empty()) titles_[i] = unnamed(i);  // such as the index of pandas
  const auto number = std::ranges::find_if(titles_, is_number);
  if (form.has_header && number != titles_.end())
    refuse(fmt::format("the header has {}; expected names of columns in the first line{}", in_quotes(*number),
                       is_number(titles_.front()) ? "" : "; write the runs and steps of a curve below each other"));
  std::vector<std::uint32_t> marked;  // rows
  for (std::uint32_t row = 0; row < table_.rows(); ++row) {
    std::size_t filled = 0, last = 0;
    for (std::size_t i = 0; i < titles_.size(); ++i) {
      if (cell(row, i).empty()) continue;
      ++filled;
      last = i;
    }
    if (is_comment(table_.cell(row, 0))) marked.push_back(row);
    if (filled == 1 && titles_.size() > 2 && !is_number(cell(row, last)))
      refuse(row, last, "is the only cell of its row; remove it, or write NA for missing values");
    if (filled > 0) rows_.push_back(row);
  }
  if (!marked.empty() && marked.size() < table_.rows())
    refuse(marked.front(), 0, "begins like a comment; remove its row, or rename it");
  if (titles_.size() == 1)
    refuse(
        "there is only one column; expected one of names and one of values, separated by a comma, semicolon, tab, bar or blanks");
  if (rows_.empty()) refuse("there are no rows below the header; expected at least one");
}

std::size_t Sheet::choose(std::string_view condition) {
  std::size_t equals = condition.find('=');
  if (equals == std::string_view::npos) refuse(fmt::format("--where {}; expected COLUMN=VALUE", in_quotes(condition)));
  // A title may have the sign, too.
  for (std::size_t at = equals; at != std::string_view::npos; at = condition.find('=', at + 1))
    if (std::ranges::count(titles_, trimmed(condition.substr(0, at))) > 0) equals = at;
  const std::size_t chosen = column(trimmed(condition.substr(0, equals)));
  const std::string_view value = trimmed(condition.substr(equals + 1));
  const std::string first(cell(rows_.front(), chosen));
  std::erase_if(rows_, [&](std::uint32_t row) { return cell(row, chosen) != value; });
  if (rows_.empty())
    refuse(fmt::format("no row has {}; the first row has {}", in_quotes(condition),
                       in_quotes(titles_[chosen] + "=" + first)));
  return chosen;
}

void Sheet::leave_out(const std::vector<std::uint32_t>& rows) {
  const std::set<std::uint32_t> others(rows.begin(), rows.end());
  std::erase_if(rows_, [&](std::uint32_t row) { return others.contains(row); });
  if (rows_.empty()) refuse("every row summarises other rows; expected their values, too");
}

std::string_view Sheet::cell(std::size_t row, std::size_t column) const {
  const std::size_t in_file = table_.header.size();
  std::string_view text = column < in_file ? trimmed(table_.cell(row, column)) : joined_[column - in_file][row];
  while (separator_ == '|' && text.size() > 2 && text.starts_with('*') && text.ends_with('*'))
    text = text.substr(1, text.size() - 2);  // a table of Markdown
  return text;
}

std::size_t Sheet::column(std::string_view name) {
  const auto number = std::ranges::count(titles_, name);
  if (number == 0 && name == "row") {
    std::vector<std::string>& texts = joined_.emplace_back(table_.rows());
    for (std::size_t i = 0; i < texts.size(); ++i) texts[i] = fmt::to_string(i + 1);
    titles_.emplace_back(name);
    decimals_.push_back('.');
    return titles_.size() - 1;
  }
  const auto first = static_cast<std::size_t>(std::ranges::find(titles_, name) - titles_.begin());
  if (number > 1) refuse(fmt::format("{} columns are named {}; give them different names", number, in_quotes(name)));
  if (number == 0)
    refuse(fmt::format("there is no column {}{}; expected one of {}", in_quotes(name), did_you_mean(name, titles_),
                       front(listed(titles_, ", "), 300)));
  return first;
}

constexpr std::string_view joint = " / ";

std::size_t Sheet::joined(const std::vector<std::string>& names) {
  std::vector<std::size_t> parts;
  for (const std::string& name : names) parts.push_back(column(name));
  if (parts.size() == 1) return parts.front();
  std::vector<std::string>& texts = joined_.emplace_back(table_.rows());
  for (const std::uint32_t row : rows_) {
    const auto is_empty = [&](std::size_t part) { return cell(row, part).empty(); };
    if (std::ranges::any_of(parts, is_empty)) continue;
    for (const std::size_t part : parts) {
      if (cell(row, part).find(joint) != std::string_view::npos)
        refuse(row, part, fmt::format("has \"{}\", which joins the names of several columns; replace it", joint));
      texts[row].append(texts[row].empty() ? "" : joint).append(cell(row, part));
    }
  }
  titles_.push_back(fmt::format("{}", fmt::join(names, joint)));
  decimals_.push_back(0);
  return titles_.size() - 1;
}

std::optional<std::size_t> Sheet::column_like(const Words& names) const {
  for (const std::string_view name : names)
    for (std::size_t i = 0; i < titles_.size(); ++i)
      if (lower_case(titles_[i]) == name) return i;
  return std::nullopt;
}

bool Sheet::has_numbers(std::size_t column) const {
  constexpr std::size_t enough = 1000;  // rows
  std::size_t filled = 0, numbers = 0, truths = 0;
  for (const std::uint32_t row : std::span(rows_).first(std::min(rows_.size(), enough))) {
    filled += !means_none(cell(row, column));
    numbers += is_number(cell(row, column));
    truths += truth(cell(row, column)).has_value();
  }
  return 2 * numbers > filled || (filled > 0 && truths == filled);
}

char Sheet::decimal_of(std::size_t column) {
  const auto is_truth = [&](std::uint32_t row) { return means_none(cell(row, column)) || truth(cell(row, column)); };
  if (std::ranges::all_of(rows_, is_truth)) return of_truth;
  if (decimal_ != 0) return decimal_;
  std::optional<std::uint32_t> doubtful;      // row of a cell that is a number by both marks
  const auto mark_in = [&](std::size_t at) {  // the mark of the first cell that is a number by one mark only
    for (const std::uint32_t row : rows_) {
      const std::string_view text = cell(row, at);
      if (!has_mark(text)) continue;
      const bool is_by_point = parsed(text, '.').has_value(), is_by_comma = parsed(text, ',').has_value();
      if (is_by_point != is_by_comma) return is_by_point ? '.' : ',';
      if (at == column && is_by_point && !doubtful) doubtful = row;
    }
    return '\0';
  };
  if (const char mark = mark_in(column); mark != '\0' || !doubtful) return mark == '\0' ? '.' : mark;
  if (!marks_) {
    marks_.emplace();
    for (std::size_t i = 0; i < table_.header.size(); ++i)
      if (has_numbers(i)) marks_->insert(mark_in(i));
    marks_->erase('\0');
  }
  if (marks_->size() == 1) return *marks_->begin();
  const std::string_view text = cell(*doubtful, column);
  // If commas separate cells, points are of decimals.
  if (marks_->empty() && separator_ == ',' && text.find(',') == std::string_view::npos) return '.';
  refuse(*doubtful, column,
         fmt::format(
             "is {} with a decimal point and {} with a decimal comma, and no cell shows which is meant; write one more "
             "digit, or add --decimal (ikbench stats)",
             *parsed(text, '.'), *parsed(text, ',')));
}

double Sheet::number(std::size_t row, std::size_t column) {
  const std::string_view text = cell(row, column);
  if (means_none(text)) return std::numeric_limits<double>::quiet_NaN();
  if (decimals_[column] == 0) decimals_[column] = decimal_of(column);
  const auto value = decimals_[column] == of_truth ? truth(text) : parsed(text, decimals_[column]);
  if (!value && is_number(text))
    refuse(row, column,
           fmt::format("is not a number with a decimal {}; to choose the other decimal mark, add --decimal",
                       decimals_[column] == ',' ? "comma" : "point"));
  if (const std::string advice = value ? "" : advice_on_unit(text, titles_[column]); !advice.empty())
    refuse(row, column, advice);
  if (!value) refuse(row, column, "is not a number; " + advice_on_numbers_);
  const double size = std::abs(*value);  // tests compute squares of squares
  if (std::isfinite(size) && size != 0 && (size < 1e-60 || size > 1e60))
    refuse(row, column, "is out of range; expected 1e-60 to 1e60");
  return *value;
}

void Sheet::refuse_units(std::size_t column) const {
  constexpr std::size_t enough = 1000;  // rows
  std::optional<std::uint32_t> first;
  for (const std::uint32_t row : std::span(rows_).first(std::min(rows_.size(), enough))) {
    if (means_none(cell(row, column))) continue;
    if (advice_on_unit(cell(row, column), "").empty()) return;
    if (!first) first = row;
  }
  if (first) refuse(*first, column, advice_on_unit(cell(*first, column), titles_[column]));
}

// As pandas writes several levels of columns: below repeated or merged names stands a row of further ones.
void Sheet::refuse_second_header() const {
  const std::set<std::string> different(titles_.begin(), titles_.end());
  const auto is_unnamed = [](const std::string& title) { return title.empty(); };
  const std::size_t named = different.size() - different.contains("");
  if (named < 2 || different.size() == titles_.size() || table_.rows() < 2) return;
  std::size_t names = 0;  // above numbers
  for (std::size_t i = 0; i < titles_.size(); ++i) {
    if (is_number(cell(0, i)) || (i > 0 && cell(0, i).empty())) return;
    names += is_number(cell(table_.rows() - 1, i));
  }
  if (names < 2) return;
  const std::size_t last = titles_.size() - 1;
  const auto above = std::find_if_not(titles_.rbegin(), titles_.rend(), is_unnamed);
  throw std::invalid_argument(
      fmt::format("{}:{}: a second row of names below the header; write one row of them, such as {}", source_,
                  table_.line(0), in_quotes(fmt::format("{} {}", *above, cell(0, last)))));
}

std::string Sheet::said(std::string_view what) const { return fmt::format("{}: {}", source_, what); }

void Sheet::refuse(std::string_view what) const { throw std::invalid_argument(said(what)); }

void Sheet::refuse(std::size_t row, std::size_t column, std::string_view what) const {
  throw std::invalid_argument(fmt::format("{}:{}:{}: {} in column {} {}", source_, table_.line(row), column + 1,
                                          in_quotes(cell(row, column)), in_quotes(titles_[column]), what));
}

}  // namespace ikbench::base
