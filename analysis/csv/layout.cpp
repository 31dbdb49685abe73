#include "analysis/csv/layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <unordered_set>

#include "base/names.hpp"

namespace ikbench::csv {
namespace {

constexpr std::size_t most_counted = 1'000'000;  // cells, all of which are looked at for a question
constexpr std::size_t few_rows = 1000;           // of more
constexpr std::size_t most_shown = 15;           // columns

bool has(const Columns& columns, std::size_t column) { return std::ranges::count(columns, column) > 0; }

std::size_t different_in(const Sheet& sheet, std::size_t column, std::size_t rows) {
  std::unordered_set<std::string_view> texts;
  for (std::size_t i = 0; i < rows; ++i) texts.insert(sheet.cell(sheet.rows()[i], column));
  return texts.size();
}

// The first columns of the file, as a question tells them; what may be a label or a value comes first of many.
std::vector<std::vector<std::string>> described(const Sheet& sheet, std::size_t columns, std::size_t rows) {
  std::vector<std::pair<int, std::vector<std::string>>> all;
  for (std::size_t column = 0; column < columns; ++column) {
    const bool has_numbers = sheet.has_numbers(column);
    bool is_whole = true;
    for (std::size_t i = 0; i < rows; ++i)
      is_whole = is_whole && sheet.cell(sheet.rows()[i], column).find_first_of(".,eEnN") == std::string_view::npos;
    const std::size_t different = different_in(sheet, column, rows);
    const bool is_label = !has_numbers && different > 1 && different < rows, is_value = has_numbers && different > 1;
    all.push_back(
        {is_label                ? 0
         : is_value && !is_whole ? 1
         : is_value              ? 2
                                 : 3,
         {"  " + base::shortened(sheet.titles()[column], 30),
          !has_numbers ? "text"
          : is_whole   ? "whole"
                       : "number",
          fmt::format("{} different", different), base::shortened(sheet.cell(sheet.rows().front(), column), 30)}});
  }
  if (columns > most_shown) std::ranges::stable_sort(all, {}, [](const auto& each) { return each.first; });
  std::vector<std::vector<std::string>> shown;
  for (auto& each : all) shown.push_back(std::move(each.second));
  if (columns <= most_shown) return shown;
  shown.resize(most_shown - 1);
  shown.push_back({fmt::format("  and {} more", columns - shown.size())});
  return shown;
}

[[noreturn]] void ask(const Sheet& sheet, const Request& request, std::size_t columns, std::string_view what,
                      bool is_of_rows) {
  const bool is_long = sheet.rows().size() * columns > most_counted;
  const std::size_t rows = is_long ? few_rows : sheet.rows().size();
  Question question(sheet.said(fmt::format("{} It has {} rows{} of", what, sheet.rows().size(),
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
      "{}LABEL: who is compared, or `columns` if each column of numbers is one. BLOCK: what each of them "
      "did, such as a problem. RUN: repeats, whose mean counts; `row` if each row is one.{}",
      is_of_rows ? "One of --block and --run is enough. " : "",
      !request.are_summaries && sheet.column_like({"sd", "std", "stddev", "std_dev"}) ? " Printed means: --summaries."
                                                                                      : "");
  throw question;
}

}  // namespace

Layout layout_of(Sheet& sheet, const Request& request) {
  const std::size_t columns = sheet.titles().size();  // of the file
  const auto has_title = [&](std::string_view title) { return std::ranges::count(sheet.titles(), title) > 0; };
  const bool is_wide = request.label == std::vector<std::string>{"columns"} && !has_title("columns");
  const bool is_each_row = request.run == "row" && !has_title("row");
  Columns named, texts, numbers;
  for (const std::string& condition : request.where) named.push_back(sheet.choose(condition));
  Layout layout;
  for (const std::string& value : request.values) {
    named.push_back(sheet.column(value));
    if (!has(layout.values, named.back())) layout.values.push_back(named.back());
  }
  for (const std::string& part : request.label)
    if (!is_wide) named.push_back(sheet.column(part));
  for (const std::string& part : request.block) named.push_back(sheet.column(part));
  if (!request.run.empty() && !is_each_row) named.push_back(*(layout.run = sheet.column(request.run)));
  if (!request.label.empty() && !is_wide) layout.label = sheet.joined(request.label);
  if (!request.block.empty()) layout.block = sheet.joined(request.block);
  for (std::size_t column = 0; column < columns; ++column)
    if (!has(named, column)) (sheet.has_numbers(column) ? numbers : texts).push_back(column);
  const bool has_no_other = request.are_summaries || numbers.size() == (layout.values.empty() ? 1 : 0);
  if (request.label.empty() && texts.size() == 1 && has_no_other) layout.label = texts.front(), texts.clear();
  if (layout.values.empty() && (is_wide || (layout.label && numbers.size() == 1))) layout.values.swap(numbers);
  if ((!is_wide && !layout.label) || layout.values.size() < (is_wide ? 2 : 1))
    ask(sheet, request, columns, "which columns are what?", false);
  for (const std::size_t column : is_wide ? layout.values : Columns()) {
    sheet.column(sheet.titles()[column]);  // refuses a title of two columns
    const auto unit_of = [&](std::size_t at) { return base::Title(sheet.titles()[at]).unit; };
    if (unit_of(column) != unit_of(layout.values.front()))
      sheet.refuse(fmt::format("{} and {} have different units; convert them",
                               in_quotes(sheet.titles()[layout.values.front()]), in_quotes(sheet.titles()[column])));
  }
  layout.unused = texts;
  layout.unused.insert(layout.unused.end(), numbers.begin(), numbers.end());
  if (!layout.block && request.run.empty() && (is_wide || !layout.unused.empty()))
    ask(sheet, request, columns, "what is a row?", true);
  const std::size_t rows = sheet.rows().size();
  if (layout.label && !request.are_summaries && rows > 2 && different_in(sheet, *layout.label, rows) == rows)
    sheet.refuse(fmt::format("{} names each row, so no group has two values; did you mean --block?",
                             in_quotes(sheet.titles()[*layout.label])));
  return layout;
}

}  // namespace ikbench::csv
