#include "analysis/csv/layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <unordered_set>

#include "base/names.hpp"

namespace ikbench::csv {
namespace {

constexpr std::size_t most_counted = 1'000'000;  // cells, all of which are looked at for a question
constexpr std::size_t few_rows = 1000;           // of more
constexpr std::size_t most_shown = 15;           // columns

bool has(const Columns& columns, std::size_t column) { return std::ranges::count(columns, column) > 0; }

// The columns, as a question tells them, of many those first that may be labels or values.
std::vector<std::vector<std::string>> described(const Sheet& sheet, const Columns& columns, std::size_t rows) {
  std::vector<std::vector<std::string>> shown, others;
  for (const std::size_t column : columns) {
    std::unordered_set<std::string_view> texts;
    bool are_whole = true;
    for (const std::uint32_t row : std::span(sheet.rows()).first(rows)) {
      const std::string_view text = sheet.cell(row, column);
      if (!text.empty()) texts.insert(text);
      are_whole = are_whole && text.find_first_of(".,eEnN") == std::string_view::npos;
    }
    const bool has_numbers = sheet.has_numbers(column);
    const bool may_be = texts.size() > 1 && (has_numbers || texts.size() < rows);
    const char* const kind = !has_numbers ? "text" : are_whole ? "whole" : "number";
    (may_be || columns.size() <= most_shown ? shown : others)
        .push_back({"  " + base::shortened(sheet.titles()[column], 30), kind, fmt::format("{} different", texts.size()),
                    base::shortened(sheet.cell(sheet.rows().front(), column), 30)});
  }
  shown.insert(shown.end(), others.begin(), others.end());
  if (shown.size() <= most_shown) return shown;
  shown.resize(most_shown - 1);
  shown.push_back({fmt::format("  and {} more", columns.size() - shown.size())});
  return shown;
}

[[noreturn]] void ask(const Sheet& sheet, const Request& request, const Columns& columns, std::string_view what,
                      bool is_of_rows) {
  const bool is_long = sheet.rows().size() * columns.size() > most_counted;
  const std::size_t rows = is_long ? few_rows : sheet.rows().size();
  Question question(sheet.said(fmt::format("{} It has {}{} of", what, base::counted(std::ssize(sheet.rows()), "rows"),
                                           is_long ? fmt::format(", counted in the first {},", rows) : "")));
  question.columns = described(sheet, columns, rows);
  const auto add = [&](bool is_open, std::initializer_list<const char*> options) {
    if (is_open) question.options.insert(question.options.end(), options.begin(), options.end());
  };
  add(request.label.empty(), {"--label", "LABEL"});
  add(request.values.empty() && !is_of_rows, {"--value", "VALUE"});
  add(is_of_rows, {"--block", "BLOCK", "--run", "RUN"});
  add(request.better.empty(), {"--better", "smaller"});
  question.advice = fmt::format(
      "{}LABEL: who is compared, or `columns` if each column of numbers is one. --block: what each of them did, such "
      "as a problem. --run: repeats, which count by their mean; `--run row`: each row is one. Printed means: --summaries.",
      is_of_rows ? "One of --block and --run is enough. " : "");
  throw question;
}

}  // namespace

Layout layout_of(Sheet& sheet, const Request& request) {
  Columns columns;  // without what stands outside the bars of a Markdown table
  for (std::size_t i = 0; i < sheet.titles().size(); ++i) {
    const auto is_empty = [&](std::uint32_t row) { return sheet.cell(row, i).empty(); };
    if (sheet.titles()[i] != base::unnamed(i) || !std::ranges::all_of(sheet.rows(), is_empty)) columns.push_back(i);
  }
  const auto has_title = [&](std::string_view title) { return std::ranges::count(sheet.titles(), title) > 0; };
  const bool is_wide =
      !request.are_summaries && request.label == std::vector<std::string>{"columns"} && !has_title("columns");
  const bool is_each_row = request.run == "row" && !has_title("row");
  if (!is_wide && request.block == std::vector<std::string>{"row"} && !has_title("row"))
    sheet.refuse("a block of one row has one label alone; say --run row, or --label columns");
  Columns named, texts, numbers;
  for (const std::string& condition : request.where) named.push_back(sheet.choose(condition));
  Layout layout;
  for (const std::string& value : request.values) {
    named.push_back(sheet.column(value));
    if (!has(layout.values, named.back())) layout.values.push_back(named.back());
  }
  std::vector<std::string> others = request.block;
  if (!is_wide) others.insert(others.end(), request.label.begin(), request.label.end());
  if (!is_each_row && !request.run.empty()) others.push_back(request.run), layout.run = sheet.column(request.run);
  for (const std::string& title : others) named.push_back(sheet.column(title));
  if (!is_wide && !request.label.empty()) layout.label = sheet.joined(request.label);
  if (!request.block.empty()) layout.block = sheet.joined(request.block);
  for (const std::size_t column : columns)
    if (!has(named, column)) (sheet.has_numbers(column) ? numbers : texts).push_back(column);
  const bool has_no_other = request.are_summaries || numbers.size() == (layout.values.empty() ? 1 : 0);
  if (request.label.empty() && texts.size() == 1 && has_no_other) layout.label = texts.front(), texts.clear();
  if (layout.values.empty() && (is_wide || (layout.label && numbers.size() == 1))) layout.values.swap(numbers);
  if (is_wide && layout.values.size() == 1)
    sheet.refuse("--label columns compares columns of numbers, and there is only one");
  if ((!is_wide && !layout.label) || layout.values.empty())
    ask(sheet, request, columns, "which columns are what?", false);
  for (const std::size_t value : is_wide ? layout.values : Columns()) {
    const std::string &first = sheet.titles()[layout.values[0]], &title = sheet.titles()[value];
    sheet.column(title);  // refuses a title of two columns
    if (base::Title(title).unit != base::Title(first).unit)
      sheet.refuse(fmt::format("{} and {} differ in units; convert them", in_quotes(first), in_quotes(title)));
  }
  layout.unused = texts;
  layout.unused.insert(layout.unused.end(), numbers.begin(), numbers.end());
  if (!layout.block && request.run.empty() && (is_wide || !layout.unused.empty()))
    ask(sheet, request, columns, "what is a row?", true);
  return layout;
}

}  // namespace ikbench::csv
