#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <sstream>
#include <string_view>
#include <variant>
#include <vector>

#include "analysis/inference/text.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::report {

using namespace inference;

namespace {

constexpr std::size_t longest_line = 24;  // longest line of a cell [characters]; longer texts may break
constexpr std::size_t longest_head = 12;  // longest line of a head [characters]

std::vector<std::string> words_of(std::string_view text) {
  std::istringstream words{std::string(text)};
  return {std::istream_iterator<std::string>(words), {}};
}

// -1.2e-05 as $-1.2 \times 10^{-5}$.
std::string latex_number(const std::string& number) {
  const std::size_t e = number.find('e');
  if (e != std::string::npos) {
    return fmt::format("${} \\times 10^{{{}}}$", number.substr(0, e), std::stoi(number.substr(e + 1)));
  }
  return number.starts_with('-') ? fmt::format("${}$", number) : number;
}

struct LatexColumn {
  std::size_t index;  // index in the table
  bool is_text;
  bool wraps;
};

std::string cell_latex(const Cell& cell) {
  if (const auto* range = std::get_if<Range>(&cell); range && !is_empty(cell)) {
    return latex_number(readable_end(range->low)) + " to " + latex_number(readable_end(range->high));
  }
  const std::string text = readable(cell);
  if (!is_number(cell)) return latex_text(text);
  return text.starts_with('<') ? "$<10^{-300}$" : latex_number(text);
}

std::vector<LatexColumn> columns_of(const Table& table) {
  std::vector<LatexColumn> columns;
  for (const std::size_t c : columns_in_use(table)) {
    const bool is_text = is_left(table, c);
    const auto is_longer = [](const std::string& text) { return text.size() > longest_line; };
    const auto any_text = [&](const auto& is_it) {
      return std::ranges::any_of(table.rows, [&](const auto& row) { return is_it(readable(row[c])); });
    };
    const auto has_longer_word = [&](const std::string& text) {
      return std::ranges::any_of(words_of(text), is_longer);
    };
    // Lines break between words only: with a longer one the table is scaled instead.
    columns.push_back({.index = c, .is_text = is_text, .wraps = any_text(is_longer) && !any_text(has_longer_word)});
  }
  return columns;
}

// Divides the line among columns of long texts.
std::string preamble(const std::vector<LatexColumn>& columns) {
  const std::ptrdiff_t wrapping = std::ranges::count(columns, true, &LatexColumn::wraps);
  std::string text;
  for (const LatexColumn& column : columns) {
    text += column.wraps     ? fmt::format(">{{\\raggedright\\arraybackslash}}p{{{}em}}",
                                           std::max<std::ptrdiff_t>(12, 36 / wrapping))
            : column.is_text ? "l"
                             : "r";
  }
  return text;
}

std::vector<std::string> lines_of(const std::string& head) {
  std::vector<std::string> lines;
  for (const std::string& word : words_of(head)) {
    const bool fits = !lines.empty() && lines.back().size() + 1 + word.size() <= longest_head;
    fits ? lines.back() += ' ' + word : lines.emplace_back(word);
  }
  return lines;
}

std::string head_of(const LatexColumn& column, const std::string& name) {
  std::vector<std::string> lines = lines_of(name);
  for (std::string& line : lines) line = latex_text(line);
  if (lines.size() == 1) return lines.front();
  return fmt::format("\\shortstack[{}]{{{}}}", column.is_text ? "l" : "r", fmt::join(lines, "\\\\"));
}

std::string tabular(const Table& table) {
  const std::vector<LatexColumn> columns = columns_of(table);
  std::vector<std::string> heads;
  for (const LatexColumn& column : columns) heads.push_back(head_of(column, table.columns[column.index]));
  std::string text = fmt::format("\\begin{{tabular}}{{{}}}\n\\toprule\n{} \\\\\n\\midrule\n", preamble(columns),
                                 fmt::join(heads, " & "));
  for (const auto& row : table.rows) {
    std::vector<std::string> cells;
    for (const LatexColumn& column : columns) cells.push_back(cell_latex(row[column.index]));
    text += fmt::format("{} \\\\\n", fmt::join(cells, " & "));
  }
  return text + "\\bottomrule\n\\end{tabular}";
}

// Notes stand under the table, one paragraph each.
std::string notes_of(const Table& table) {
  if (table.notes.empty()) return "";
  std::string text = "\\par\\smallskip\\footnotesize\\raggedright\n";
  for (const std::string& note : table.notes) {
    text += fmt::format("{}\\par\n", latex_text(note));
  }
  return text;
}

}  // namespace

std::string to_latex(const Table& given) {
  const Table table = for_people(given);
  return fmt::format(
      "% Needs \\usepackage{{booktabs,array,adjustbox}}\n"
      "\\begin{{table}}\n\\centering\n\\caption{{{}}}\\label{{tab:{}}}\n"
      "\\begin{{adjustbox}}{{max width=\\columnwidth,max totalheight=0.8\\textheight}}\n{}\n"
      "\\end{{adjustbox}}\n{}\\end{{table}}\n",
      latex_text(table.caption), table.name, tabular(table), notes_of(table));
}

}  // namespace ikbench::report
