#include "analysis/csv/layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "analysis/csv/question.hpp"
#include "base/names.hpp"

namespace ikbench::csv {
namespace {

[[noreturn]] void refuse_one_column(const Sheet& sheet, const Known& known) {
  std::string how;
  if (!known.indices.empty()) {
    const std::string title = in_quotes(sheet.titles()[known.indices.front()]);
    how = fmt::format(
        ", because {} numbers the rows; if its numbers are values, name all columns of values with --value", title);
  }
  sheet.refuse("--label columns compares columns of numbers, but there is only one" + how);
}

void refuse_blocks_of_one_row(const Sheet& sheet, const Request& request, const Known& known) {
  if (known.is_wide || request.block.size() != 1) return;
  const std::string& block = request.block.front();
  const bool is_number = block == "row" && std::ranges::count(sheet.titles(), block) == 0;
  const auto is_block = [&](std::size_t column) { return sheet.titles()[column] == block; };
  if (is_number || std::ranges::any_of(known.indices, is_block))
    sheet.refuse(
        "a block of one row has only one label; use --run row, or --label columns if each column of numbers is one label");
}

void refuse_repeated(const Sheet& sheet, const std::vector<std::string>& titles) {
  for (auto title = titles.begin(); title != titles.end(); ++title)
    if (std::find(titles.begin(), title, *title) != title)
      sheet.refuse(fmt::format("--label and --block name {} twice; name each column once", in_quotes(*title)));
}

void expect_one_unit(Sheet& sheet, const Columns& values) {
  const std::string first = sheet.titles()[values.front()];
  for (const std::size_t value : values) {
    const std::string title = sheet.titles()[value];
    sheet.column(title);  // refuses a title that two columns have
    if (base::Title(title).unit != base::Title(first).unit)
      sheet.refuse(fmt::format("{} and {} differ in units; convert them", in_quotes(first), in_quotes(title)));
  }
}

// Sets the columns of the sheet, without empty ones outside the bars of a Markdown table, and the indices among them.
void find_columns(const Sheet& sheet, Known& known) {
  for (std::size_t i = 0; i < sheet.titles().size(); ++i) {
    const auto is_empty = [&](std::uint32_t row) { return sheet.cell(row, i).empty(); };
    if (sheet.titles()[i] == base::unnamed(i) && std::ranges::all_of(sheet.rows(), is_empty)) continue;
    known.columns.push_back(i);
    if (is_index(sheet, i)) known.indices.push_back(i);
  }
}

}  // namespace

SummaryColumns summary_columns_of(const Sheet& sheet) {
  return {.n = sheet.column_like({"n", "count", "n_runs", "rounds"}),
          .mean = sheet.column_like({"mean", "avg", "average"}),
          .sd = sheet.column_like({"sd", "std", "stddev", "std_dev"})};
}

Layout layout_of(Sheet& sheet, const Request& request) {
  Known known;
  find_columns(sheet, known);  // before --where removes rows
  const auto has_title = [&](std::string_view title) { return std::ranges::count(sheet.titles(), title) > 0; };
  known.is_wide =
      !request.are_summaries && request.label == std::vector<std::string>{"columns"} && !has_title("columns");
  const bool is_each_row = request.run == "row" && !has_title("row");
  refuse_blocks_of_one_row(sheet, request, known);
  Columns& named = known.named;
  Columns texts, numbers;
  for (const std::string& condition : request.where) named.push_back(sheet.choose(condition));
  Layout layout;
  for (const std::string& value : request.values) {
    named.push_back(sheet.column(value));
    if (!has(layout.values, named.back())) layout.values.push_back(named.back());
  }
  std::vector<std::string> others = request.block;
  if (!known.is_wide) others.insert(others.end(), request.label.begin(), request.label.end());
  refuse_repeated(sheet, others);
  if (!is_each_row && !request.run.empty()) {
    others.push_back(request.run);
    layout.run = sheet.column(request.run);
  }
  for (const std::string& title : others) named.push_back(sheet.column(title));
  if (!known.is_wide && !request.label.empty()) layout.label = sheet.joined(request.label);
  if (!request.block.empty()) layout.block = sheet.joined(request.block);
  std::erase_if(known.indices, [&](std::size_t column) { return has(named, column); });
  for (const std::size_t column : known.columns)
    if (!has(named, column) && !has(known.indices, column))
      (sheet.has_numbers(column) ? numbers : texts).push_back(column);
  if (numbers.empty() && layout.values.empty()) numbers.swap(known.indices);  // a file must have values
  const bool has_no_other = request.are_summaries || numbers.size() == (layout.values.empty() ? 1 : 0);
  if (request.label.empty() && texts.size() == 1 && has_no_other) {
    layout.label = texts.front();
    texts.clear();
  }
  if (layout.values.empty() && (known.is_wide || (layout.label && numbers.size() == 1))) layout.values.swap(numbers);
  if (known.is_wide && layout.values.size() == 1) refuse_one_column(sheet, known);
  known.label = layout.label;
  known.values = layout.values;
  if ((!known.is_wide && !layout.label) || layout.values.empty()) ask_for_columns(sheet, request, known);
  if (known.is_wide) expect_one_unit(sheet, layout.values);
  layout.unused = texts;
  layout.unused.insert(layout.unused.end(), numbers.begin(), numbers.end());
  if (!layout.block && request.run.empty() && (known.is_wide || !layout.unused.empty()))
    ask_for_rows(sheet, request, known);
  layout.unused.insert(layout.unused.end(), known.indices.begin(), known.indices.end());
  return layout;
}

}  // namespace ikbench::csv
