#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <iterator>
#include <span>
#include <sstream>
#include <string_view>
#include <variant>
#include <vector>

#include "analysis/inference/text.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::report {

using namespace inference;

namespace {

constexpr std::size_t longest_line = 24;   // longest line of a cell [characters]; longer texts may break
constexpr std::size_t longest_head = 12;   // longest line of a head [characters]
constexpr std::size_t longest_chunk = 10;  // longest unbroken word [characters]
constexpr std::size_t widest_upright = 9;  // most columns upright; a wider table is turned

std::vector<std::string> words_of(std::string_view text) {
  std::istringstream words{std::string(text)};
  return {std::istream_iterator<std::string>(words), {}};
}

// "mean_reached_ms" as "mean reached [ms]".
std::string in_words(std::string_view name) {
  NameWithUnit words = split_unit(name);
  std::ranges::replace(words.name, '_', ' ');
  return text_of(words);
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
  bool wraps = false;
};

std::string cell_latex(const Cell& cell, const LatexColumn& column) {
  if (const auto* range = std::get_if<Range>(&cell)) {
    return latex_number(readable_end(range->low)) + " to " + latex_number(readable_end(range->high));
  }
  const std::string text = readable(cell);
  if (!is_number(cell)) return column.wraps ? breakable_latex(text, longest_chunk) : latex_text(text);
  return text.starts_with('<') ? "$<10^{-300}$" : latex_number(text);
}

std::vector<LatexColumn> columns_of(const Table& table) {
  std::vector<LatexColumn> columns;
  for (const std::size_t c : columns_in_use(table)) {
    const bool is_text = is_left(table, c);
    const bool is_long =
        std::ranges::any_of(table.rows, [c](const auto& row) { return readable(row[c]).size() > longest_line; });
    columns.push_back({.index = c, .is_text = is_text, .wraps = is_long});
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

std::string head_of(const LatexColumn& column, const std::string& name) {
  std::vector<std::string> lines;
  for (const std::string& word : words_of(in_words(name))) {
    const bool fits = !lines.empty() && lines.back().size() + 1 + word.size() <= longest_head;
    fits ? lines.back() += ' ' + word : lines.emplace_back(word);
  }
  for (std::string& line : lines) line = latex_text(line);
  if (lines.size() == 1) return lines.front();
  return fmt::format("\\shortstack[{}]{{{}}}", column.is_text ? "l" : "r", fmt::join(lines, "\\\\"));
}

using Rows = std::span<const std::vector<Cell>>;

std::string tabular(const Table& table, const std::vector<LatexColumn>& columns, Rows rows) {
  std::vector<std::string> heads;
  for (const LatexColumn& column : columns) heads.push_back(head_of(column, table.columns[column.index]));
  std::string text = fmt::format("\\begin{{tabular}}{{{}}}\n\\toprule\n{} \\\\\n\\midrule\n", preamble(columns),
                                 fmt::join(heads, " & "));
  for (const auto& row : rows) {
    std::vector<std::string> cells;
    for (const LatexColumn& column : columns) cells.push_back(cell_latex(row[column.index], column));
    text += fmt::format("{} \\\\\n", fmt::join(cells, " & "));
  }
  return text + "\\bottomrule\n\\end{tabular}";
}

// Leaves out the number: LaTeX counts tables itself.
std::string caption_of(const Table& table, bool is_first) {
  return is_first ? fmt::format("\\caption{{{}}}\\label{{tab:{}}}\n", latex_text(table.caption), table.name)
                  : fmt::format("Table~\\ref{{tab:{}}}, continued\n\n\\smallskip\n", table.name);
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

// Returns whether pdflatex lacks a letter: it has those of Europe and general punctuation.
bool needs_another_engine(std::string_view latex) {
  for (std::size_t i = 0; i < latex.size(); ++i) {
    const auto lead = static_cast<unsigned char>(latex[i]);
    if (lead >= 0xC6 && latex.substr(i, 2) != "\xE2\x80") return true;  // U+0180 and above
  }
  return false;
}

}  // namespace

std::string breakable_latex(std::string_view text, std::size_t longest_word) {
  std::string result;
  for (const std::string& word : words_of(text)) {
    if (!result.empty()) result += ' ';
    std::string chunk;
    for (std::size_t i = 0; i < word.size(); ++i) {
      chunk += word[i];
      const bool inside = i + 1 < word.size() && (static_cast<unsigned char>(word[i + 1]) & 0xC0) != 0x80;
      const bool at_sign = chunk.size() > 3 && std::string_view(",;:/_.=-").find(word[i]) != std::string_view::npos;
      if (!inside || (!at_sign && chunk.size() < longest_chunk)) continue;
      if (word.size() <= longest_word) continue;
      result += latex_text(chunk) + "\\allowbreak{}";
      chunk.clear();
    }
    result += latex_text(chunk);
  }
  return result;
}

std::string to_latex(const Table& table) {
  const std::vector<LatexColumn> columns = columns_of(table);
  const bool is_turned = columns.size() > widest_upright;
  const bool has_long_texts = std::ranges::count(columns, true, &LatexColumn::wraps) > 0;
  const std::string_view environment = is_turned ? "sidewaystable" : "table";
  const std::size_t all = table.rows.size(), rows_that_fit = has_long_texts ? 15 : is_turned ? 25 : 40;
  const std::size_t pages = std::max<std::size_t>(1, (all + rows_that_fit - 1) / rows_that_fit);
  const std::size_t rows_a_page = (all + pages - 1) / pages;
  std::string text = fmt::format("% Needs \\usepackage{{booktabs,array,adjustbox{}}}\n", is_turned ? ",rotating" : "");
  for (std::size_t page = 0; page < pages; ++page) {
    const std::size_t first = page * rows_a_page;
    const Rows rows = Rows(table.rows).subspan(first, std::min(rows_a_page, all - first));
    const bool is_last = page + 1 == pages;
    text += fmt::format(
        "\\begin{{{0}}}{1}\n\\centering\n{2}"
        "\\begin{{adjustbox}}{{max width=\\linewidth,max totalheight=0.6\\{3}}}\n{4}\n\\end{{adjustbox}}\n{5}\\end{{{0}}}\n",
        environment, pages > 1 ? "[p]" : "", caption_of(table, page == 0), is_turned ? "textwidth" : "textheight",
        tabular(table, columns, rows), is_last ? notes_of(table) : "");
    if (!is_last) text += "\\clearpage\n";
  }
  if (needs_another_engine(text)) text = "% Needs lualatex or xelatex, and a font that has its letters\n" + text;
  return text;
}

}  // namespace ikbench::report
