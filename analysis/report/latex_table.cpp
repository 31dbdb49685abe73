#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
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

// Returns whether it begins with a Hebrew or an Arabic letter, or another of their kind.
bool is_written_to_the_left(std::string_view text) {
  return (text >= "\u0590" && text < "\u0900") || (text >= "\uFB1D" && text < "\uFEFF");
}

std::string_view last_letter(std::string_view word) {
  std::size_t at = word.size();
  while (at > 0 && (static_cast<unsigned char>(word[--at]) & 0xC0) == 0x80) {
  }
  return word.substr(at);
}

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
  bool wraps = false;
};

std::string cell_latex(const Cell& cell, const LatexColumn& column) {
  if (const auto* range = std::get_if<Range>(&cell); range && !is_empty(cell)) {
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

std::vector<std::string> lines_of(const std::string& head, std::size_t longest) {
  std::vector<std::string> lines;
  for (const std::string& word : words_of(head)) {
    const bool fits = !lines.empty() && lines.back().size() + 1 + word.size() <= longest;
    fits ? lines.back() += ' ' + word : lines.emplace_back(word);
  }
  return lines;
}

std::string head_of(const LatexColumn& column, const std::string& name) {
  std::vector<std::string> lines = lines_of(name, longest_head);
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

// Narrow tables. Widths are in points, hardly smaller than those of Computer Modern with 8 points in the body and 7 in
// the spreads.

constexpr double column_of_article = 219, between_columns = 6;
constexpr double em = 8.5, smaller = 7.0 / 8, bolder = 1.16, star = 4;
constexpr double narrowest_name = 70;            // has room for lines of ten letters
constexpr std::size_t longest_narrow_head = 10;  // longest line of a head [characters]

double width_of(std::string_view text) {
  double width = 0;
  for (const char c : text) {
    const auto is_one_of = [c](std::string_view which) { return which.find(c) != std::string_view::npos; };
    const auto byte = static_cast<unsigned char>(c);
    width += (byte & 0xC0) == 0x80        ? 0
             : byte >= 0x80               ? 1.03
             : is_one_of("MW@")           ? 1.03
             : is_one_of("mw%")           ? 0.84
             : is_one_of("ijlf.,:;'|![]") ? 0.3
             : is_one_of("_")             ? 0.37
             : is_one_of("ce")            ? 0.46
             : is_one_of("agoz")          ? 0.51
             : is_one_of(" Irst()-")      ? 0.4
             : c >= '0' && c <= '9'       ? 0.5
             : c >= 'A' && c <= 'Z'       ? 0.78
                                          : 0.556;
  }
  return em * width;
}

double width_of_number(const std::string& number) {
  constexpr double power_of_ten = 28;
  const std::size_t e = number.find('e');
  return e == std::string::npos ? width_of(number) : width_of(number.substr(0, e)) + power_of_ten;
}

double width_of_spread(const AverageCell& average) {
  double width = average.spread.size() == 1 ? width_of("W ") : width_of("[, ]");  // a sign, or brackets
  for (const double each : average.spread) width += width_of_number(value_words({.value = each}));
  return smaller * width;
}

bool has_stars(const Table& table, std::size_t column) {
  return std::ranges::any_of(table.rows, [column](const std::vector<Cell>& row) {
    const auto* average = std::get_if<AverageCell>(&row[column]);
    return average && average->differs;
  });
}

// The width of a column, as narrow as its words let it be.
double width_of(const Table& table, std::size_t column) {
  double width = 0;
  for (const std::string& line : lines_of(table.columns[column], longest_narrow_head))
    width = std::max(width, width_of(line));
  const double of_star = has_stars(table, column) ? star : 0;
  for (const std::vector<Cell>& row : table.rows) {
    if (const auto* average = std::get_if<AverageCell>(&row[column]))
      width = std::max({width, (average->is_best ? bolder : 1) * width_of_number(value_words(*average)) + of_star,
                        width_of_spread(*average)});
    else
      width = std::max(width, std::min(table.widest_name, width_of(readable(row[column]))));
  }
  return width;
}

std::string spread_latex(const AverageCell& average) {
  std::vector<std::string> numbers;
  for (const double each : average.spread) numbers.push_back(latex_number(value_words({.value = each})));
  if (numbers.empty()) return "";
  return numbers.size() == 1 ? fmt::format("\\scriptsize$\\pm$ {}", numbers.front())
                             : fmt::format("\\scriptsize[{}]", fmt::join(numbers, ", "));
}

// In a column with stars all rows have the room of one, so that no star stands outside of it.
std::string value_latex(const AverageCell& average, bool has_stars) {
  const std::string value = latex_number(value_words(average));
  return (average.is_best ? fmt::format("\\textbf{{\\boldmath {}}}", value) : value) + (average.differs ? "$^{*}$"
                                                                                        : has_stars
                                                                                            ? "\\phantom{$^{*}$}"
                                                                                            : "");
}

// A row of averages, and below it their spreads.
std::string narrow_rows(const Table& table, const std::vector<Cell>& row, const std::vector<LatexColumn>& columns) {
  std::vector<std::string> values, spreads;
  bool has_spreads = false;
  for (const LatexColumn& column : columns) {
    const auto* average = std::get_if<AverageCell>(&row[column.index]);
    values.push_back(average ? value_latex(*average, has_stars(table, column.index))
                             : cell_latex(row[column.index], column));
    spreads.push_back(average ? spread_latex(*average) : "");
    has_spreads = has_spreads || !spreads.back().empty();
  }
  if (!has_spreads) return fmt::format("{} \\\\\n", fmt::join(values, " & "));
  return fmt::format("{} \\\\*\n{} \\\\[2pt]\n", fmt::join(values, " & "), fmt::join(spreads, " & "));
}

// Heads of several lines are rows, the last line of each in the last row.
std::string narrow_heads(const Table& table, const std::vector<LatexColumn>& columns) {
  std::vector<std::vector<std::string>> heads;
  std::size_t most = 0;
  for (const LatexColumn& column : columns) {
    heads.push_back(lines_of(table.columns[column.index], longest_narrow_head));
    most = std::max(most, heads.back().size());
  }
  std::string text;
  for (std::size_t left = most; left > 0; --left) {
    std::vector<std::string> cells;
    for (const std::vector<std::string>& lines : heads)
      cells.push_back(left > lines.size() ? "" : latex_text(lines[lines.size() - left]));
    text += fmt::format("{} \\\\\n", fmt::join(cells, " & "));
  }
  return text;
}

std::string narrow_latex(const Table& table) {
  std::vector<LatexColumn> columns = columns_of(table);
  std::string letters;
  for (LatexColumn& column : columns) {
    const auto is_wide = [&](const auto& row) { return width_of(readable(row[column.index])) > table.widest_name; };
    column.wraps = column.is_text && std::ranges::any_of(table.rows, is_wide);
    letters += column.wraps     ? fmt::format(">{{\\raggedright\\arraybackslash}}p{{{}pt}}", table.widest_name)
               : column.is_text ? "l"
                                : "r";
  }
  std::string text = fmt::format(
      "% Needs \\usepackage{{booktabs,array}}\n\\begin{{table}}\n\\centering\n{}"
      "\\smallskip\\footnotesize\\setlength{{\\tabcolsep}}{{{}pt}}\n"
      "\\begin{{tabular}}{{@{{}}{}@{{}}}}\n\\toprule\n{}\\midrule\n",
      caption_of(table, true), between_columns / 2, letters, narrow_heads(table, columns));
  for (const std::vector<Cell>& row : table.rows) text += narrow_rows(table, row, columns);
  return text + "\\bottomrule\n\\end{tabular}\n" + notes_of(table) + "\\end{table}\n";
}

std::string wide_latex(const Table& table) {
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
  return text;
}

}  // namespace

Table fitted(Table table, std::size_t needed) {
  const auto width = [](const Table& of) {
    const Table shown = for_people(of);
    double sum = -between_columns;
    for (std::size_t c = 0; c < shown.columns.size(); ++c) sum += width_of(shown, c) + between_columns;
    return sum;
  };
  while (table.columns.size() > 2 && width(table) > column_of_article) {
    if (table.columns.size() == needed && table.widest_name > narrowest_name) {
      table.widest_name = narrowest_name;
      continue;
    }
    table.columns.pop_back();
    for (std::vector<Cell>& row : table.rows) row.pop_back();
  }
  table.widest_name += std::floor(std::max(0.0, column_of_article - width(table)));  // names have what the others leave
  return table;
}

std::string breakable_latex(std::string_view text, std::size_t longest_word) {
  constexpr std::string_view left_to_right = "\u200E";
  std::string result;
  bool is_turned = false;  // the word before ends in a letter that is written to the left
  for (const std::string& word : words_of(text)) {
    if (is_turned && !is_written_to_the_left(word)) result += left_to_right;  // else a number goes before that word
    is_turned = is_written_to_the_left(last_letter(word));
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

bool needs_another_engine(std::string_view latex) {
  for (std::size_t i = 0; i < latex.size(); ++i) {
    const auto lead = static_cast<unsigned char>(latex[i]);
    if (lead >= 0xC6 && latex.substr(i, 2) != "\xE2\x80") return true;  // U+0180 and above
  }
  return false;
}

std::string to_latex(const Table& given) {
  const Table table = for_people(given);
  const std::string text = table.is_narrow ? narrow_latex(table) : wide_latex(table);
  return needs_another_engine(text) ? "% Needs lualatex or xelatex, and a font that has its letters\n" + text : text;
}

}  // namespace ikbench::report
