#include "analysis/report/latex_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <sstream>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/inference/text.hpp"

namespace ikbench::report {

using namespace inference;

namespace {

// Lengths are in em of the table's own font. They are estimates from above: LaTeX alone knows its fonts.
constexpr double gap = 0.4;                // on both sides of a column
constexpr double worth_wrapping = 10;      // texts that are wider may be broken into lines
constexpr double narrowest_text = 7;       // of a column of such texts
constexpr std::size_t longest_chunk = 10;  // of an unbroken word, in characters

double width_of(char c) {
  constexpr std::string_view narrow = " ijlt.,:;'|!()[]", wide = "mwMW%@<>=+-^_~";
  if (narrow.find(c) != std::string_view::npos) return 0.4;
  if (wide.find(c) != std::string_view::npos) return 0.85;
  if (c >= '0' && c <= '9') return 0.5;
  if ((static_cast<unsigned char>(c) & 0xC0) == 0x80) return 0;  // the rest of a character
  return c >= 'a' && c <= 'z' ? 0.56 : 0.8;
}

double width_of(std::string_view text) {
  double width = 0;
  for (const char c : text) width += width_of(c);
  return width;
}

std::vector<std::string> words_of(std::string_view text) {
  std::istringstream words{std::string(text)};
  return {std::istream_iterator<std::string>(words), {}};
}

// "mean_reached_ms" as "mean reached [ms]".
std::string in_words(std::string name) {
  for (const std::string_view unit : {"cm", "deg", "rad", "ms", "s", "m"}) {
    const std::string end = fmt::format("_{}", unit);
    if (name.size() <= end.size() || !name.ends_with(end)) continue;
    name.replace(name.size() - end.size(), end.size(), fmt::format(" [{}]", unit));
    break;
  }
  std::ranges::replace(name, '_', ' ');
  return name;
}

// A note that names columns names them as their heads do.
std::string with_columns_in_words(std::string note, const Table& table) {
  const auto is_part_of_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  for (const Column& column : table.columns) {
    const std::string words = in_words(column.name);
    if (words == column.name) continue;
    for (std::size_t at = note.find(column.name); at != std::string::npos; at = note.find(column.name, at)) {
      const std::size_t end = at + column.name.size();
      const bool is_whole =
          (at == 0 || !is_part_of_name(note[at - 1])) && (end == note.size() || !is_part_of_name(note[end]));
      if (is_whole) note.replace(at, column.name.size(), words);
      at += is_whole ? words.size() : 1;
    }
  }
  return note;
}

// Greek letters where the text spells statistics out.
std::string with_symbols(std::string latex) {
  for (const std::string_view letter : {"chi", "omega", "epsilon", "eta"}) {
    const std::string spelt = fmt::format("{}\\textasciicircum{{}}2", letter);
    const std::string symbol = fmt::format("$\\{}^2$", letter);
    for (std::size_t at = latex.find(spelt); at != std::string::npos; at = latex.find(spelt, at + symbol.size())) {
      if (at > 0 && std::isalpha(static_cast<unsigned char>(latex[at - 1])) != 0) continue;
      latex.replace(at, spelt.size(), symbol);
    }
  }
  return latex;
}

std::string words_in_latex(std::string_view text) { return with_symbols(latex_text(text)); }

// -1.2e-05 as $-1.2 \times 10^{-5}$.
std::string latex_number(const std::string& number) {
  const std::size_t e = number.find('e');
  if (e != std::string::npos) {
    return fmt::format("${} \\times 10^{{{}}}$", number.substr(0, e), std::stoi(number.substr(e + 1)));
  }
  return number.starts_with('-') ? fmt::format("${}$", number) : number;
}

// Words that are too long to be left whole may be broken, after punctuation where there is any.
std::string breakable(std::string_view text) {
  std::string result;
  for (const std::string& word : words_of(text)) {
    if (!result.empty()) result += ' ';
    std::string chunk;
    for (std::size_t i = 0; i < word.size(); ++i) {
      chunk += word[i];
      const bool inside = i + 1 < word.size() && (static_cast<unsigned char>(word[i + 1]) & 0xC0) != 0x80;
      const bool at_sign = chunk.size() > 3 && std::string_view(",;:/_.=-").find(word[i]) != std::string_view::npos;
      if (!inside || (!at_sign && chunk.size() < longest_chunk)) continue;
      if (word.size() <= longest_chunk) continue;
      result += words_in_latex(chunk) + "\\allowbreak{}";
      chunk.clear();
    }
    result += words_in_latex(chunk);
  }
  return result;
}

bool is_words(const Cell& cell, const std::string& text) {
  return std::holds_alternative<std::string>(cell) || std::holds_alternative<Beside>(cell) || text.empty() ||
         text == "not defined";
}

double cell_width(const Cell& cell) {
  const std::string text = readable(cell);
  if (is_words(cell, text)) return width_of(text);
  if (text.starts_with('<')) return 4.5;
  return width_of(text) + static_cast<double>(std::ranges::count(text, 'e'));
}

struct LatexColumn {
  std::size_t index;  // in the table
  bool is_text;
  std::vector<std::string> head;  // its lines
  double head_width = 0;
  double natural = 0;  // of the widest cell, unbroken
  bool wraps() const { return is_text && natural > worth_wrapping; }
  double width(double widest_text) const {
    return std::max(head_width, wraps() ? std::min(natural, widest_text) : natural);
  }
};

std::string cell_latex(const Cell& cell, const LatexColumn& column) {
  const std::string text = readable(cell);
  if (is_words(cell, text)) return column.wraps() ? breakable(text) : words_in_latex(text);
  if (text.starts_with('<')) return "$<10^{-300}$";
  const std::size_t to = text.find(" to ");  // of a range
  return to == std::string::npos ? latex_number(text)
                                 : latex_number(text.substr(0, to)) + " to " + latex_number(text.substr(to + 4));
}

// A head is as wide as its cells are, or as its longest word.
void break_head(LatexColumn& column, const std::string& name) {
  const std::vector<std::string> words = words_of(in_words(name));
  for (const std::string& word : words) column.head_width = std::max(column.head_width, width_of(word));
  const double width = std::max(column.head_width, std::min(column.natural, 2 * worth_wrapping));
  column.head_width = 0;
  for (const std::string& word : words) {
    if (!column.head.empty() && width_of(column.head.back() + ' ' + word) <= width) {
      column.head.back() += ' ' + word;
    } else {
      column.head.push_back(word);
    }
    column.head_width = std::max(column.head_width, width_of(column.head.back()));
  }
}

std::vector<LatexColumn> columns_of(const Table& table) {
  std::vector<LatexColumn> columns;
  for (const std::size_t c : columns_in_use(table)) {
    LatexColumn column{.index = c, .is_text = table.columns[c].align == Align::left, .head = {}};
    for (const auto& row : table.rows) column.natural = std::max(column.natural, cell_width(row[c]));
    break_head(column, table.columns[c].name);
    columns.push_back(std::move(column));
  }
  return columns;
}

double total_width(const std::vector<LatexColumn>& columns, double widest_text) {
  double total = 0;
  for (const LatexColumn& column : columns) total += column.width(widest_text) + 2 * gap;
  return total;
}

// How wide texts may be so that the table fits; the narrowest where it does not.
double fitting_text(const std::vector<LatexColumn>& columns, double available) {
  double widest = narrowest_text;
  for (const LatexColumn& column : columns) widest = std::max(widest, column.natural);
  while (widest > narrowest_text && total_width(columns, widest) > available) widest -= 0.5;
  return std::max(widest, narrowest_text);
}

double lines_of(std::string_view text, double width) { return std::max(1.0, std::ceil(width_of(text) / width)); }

double lines_of_rows(const Table& table, const std::vector<LatexColumn>& columns, double widest_text) {
  double lines = 0;
  for (const LatexColumn& column : columns) lines = std::max(lines, static_cast<double>(column.head.size()));
  for (const auto& row : table.rows) {
    double most = 1;
    for (const LatexColumn& column : columns) {
      if (column.wraps()) most = std::max(most, lines_of(readable(row[column.index]), column.width(widest_text)));
    }
    lines += most;
  }
  return lines;
}

// "Table 3: errors" as "errors": LaTeX counts tables itself.
std::string without_number(const std::string& caption) {
  const std::size_t colon = caption.find(": ");
  const bool numbered = caption.starts_with("Table ") && colon != std::string::npos &&
                        caption.find_first_not_of("0123456789", 6) == colon;
  return numbered ? caption.substr(colon + 2) : caption;
}

std::string caption_of(const Table& table) {
  return fmt::format("\\caption{{{}}}\\label{{tab:{}}}", words_in_latex(without_number(table.caption)), table.name);
}

std::string preamble(const std::vector<LatexColumn>& columns, double widest_text) {
  std::string text;
  for (const LatexColumn& column : columns) {
    text += column.wraps()   ? fmt::format(">{{\\raggedright\\arraybackslash}}p{{{:.1f}em}}", column.width(widest_text))
            : column.is_text ? "l"
                             : "r";
  }
  return text;
}

std::string head_of(const std::vector<LatexColumn>& columns) {
  std::string text;
  for (const LatexColumn& column : columns) {
    std::vector<std::string> lines;
    for (const std::string& line : column.head) lines.push_back(words_in_latex(line));
    if (!text.empty()) text += " & ";
    text += lines.size() == 1
                ? lines.front()
                : fmt::format("\\shortstack[{}]{{{}}}", column.is_text ? "l" : "r", fmt::join(lines, "\\\\"));
  }
  return text + " \\\\\n";
}

std::string rows_of(const Table& table, const std::vector<LatexColumn>& columns) {
  std::string text;
  for (const auto& row : table.rows) {
    std::vector<std::string> cells;
    for (const LatexColumn& column : columns) cells.push_back(cell_latex(row[column.index], column));
    text += fmt::format("{} \\\\\n", fmt::join(cells, " & "));
  }
  return text;
}

// Under the table, each a paragraph.
std::string notes_of(const Table& table, std::string_view font) {
  if (table.notes.empty()) return "";
  std::string text = fmt::format("\\par\\smallskip{}\\raggedright\n", font);
  for (const std::string& note : table.notes) {
    text += fmt::format("{}\\par\n", words_in_latex(with_columns_in_words(note, table)));
  }
  return text;
}

// A page of A4 with margins of 2 cm, upright or turned, in points.
struct Page {
  double width;
  double height;
};
constexpr Page upright{483, 731}, turned{731, 483};

double notes_height(const Table& table, double width) {
  double lines = 0;
  for (const std::string& note : table.notes) lines += lines_of(note, width / 8.5) + 0.2;
  return 9.5 * lines;
}

// On one page, scaled into the line.
std::string floating(const Table& table, const std::vector<LatexColumn>& columns, double widest_text,
                     const char* environment) {
  return fmt::format(
      "\\begin{{{0}}}\n\\centering\n{1}\n\\setlength{{\\tabcolsep}}{{{6}em}}\n"
      "\\resizebox{{\\ifdim\\width>\\linewidth\\linewidth\\else\\width\\fi}}{{!}}{{%\n"
      "\\begin{{tabular}}{{{2}}}\n\\toprule\n{3}\\midrule\n{4}\\bottomrule\n\\end{{tabular}}}}\n"
      "{5}\\end{{{0}}}\n",
      environment, caption_of(table), preamble(columns, widest_text), head_of(columns), rows_of(table, columns),
      notes_of(table, "\\footnotesize"), gap);
}

// Over as many pages as it takes, in a font in which it fits.
std::string paged(const Table& table, const std::vector<LatexColumn>& columns) {
  struct Way {
    Page page;
    int points;   // of the font
    double em;    // [pt]
    double text;  // the narrowest that is still read with ease [em]
  };
  constexpr std::array<Way, 7> ways{{{upright, 9, 9.25, 18},
                                     {upright, 8, 8.5, 14},
                                     {turned, 9, 9.25, 14},
                                     {turned, 8, 8.5, 12},
                                     {upright, 7, 7.97, 10},
                                     {turned, 7, 7.97, 9},
                                     {turned, 5, 6.81, narrowest_text}}};
  const auto fits = [&](const Way& way) { return total_width(columns, way.text) <= way.page.width / way.em; };
  const auto found = std::ranges::find_if(ways, fits);
  const Way& way = found == ways.end() ? ways.back() : *found;
  const std::string_view landscape = way.page.width > upright.width ? "landscape" : "";
  const auto bracket = [&](const char* which) {
    return landscape.empty() ? std::string() : fmt::format("\\{}{{{}}}\n", which, landscape);
  };
  const std::string head = fmt::format("\\toprule\n{}\\midrule\n", head_of(columns));
  return fmt::format(
      "{0}\\begingroup\n\\fontsize{{{1}}}{{{2}}}\\selectfont\n\\setlength{{\\tabcolsep}}{{{3}em}}\n"
      "\\setlength{{\\LTcapwidth}}{{\\linewidth}}\n\\begin{{longtable}}{{{4}}}\n{5}\\\\\n{6}\\endfirsthead\n"
      "{6}\\endhead\n\\bottomrule\n\\endlastfoot\n{7}\\end{{longtable}}\n{8}\\endgroup\n{9}",
      bracket("begin"), way.points, way.points + 2, gap,
      preamble(columns, fitting_text(columns, way.page.width / way.em)), caption_of(table), head,
      rows_of(table, columns), notes_of(table, ""), bracket("end"));
}

std::string needs(std::vector<std::string> packages, const std::string& text) {
  if (text.find("{sidewaystable}") != std::string::npos) packages.emplace_back("rotating");
  if (text.find("\\arraybackslash") != std::string::npos) packages.emplace_back("array");
  if (text.find("{landscape}") != std::string::npos) packages.emplace_back("pdflscape");
  return fmt::format("% Needs \\usepackage{{{}}}\n{}", fmt::join(packages, ","), text);
}

}  // namespace

std::string to_latex(const Table& table) {
  const std::vector<LatexColumn> columns = columns_of(table);
  constexpr double em = 10, line = 12, caption = 40, smallest_scale = 0.6;
  for (const Page& page : {upright, turned}) {
    const double available = page.width / em;
    const double widest_text = std::max(fitting_text(columns, available), 2 * worth_wrapping);
    const double scale = std::min(1.0, available / total_width(columns, widest_text));
    const double height =
        scale * line * lines_of_rows(table, columns, widest_text) + notes_height(table, page.width) + caption;
    const bool is_turned = page.width > upright.width;
    if (height > 0.95 * page.height || (scale < smallest_scale && !is_turned)) continue;
    return needs({"booktabs", "graphicx"},
                 floating(table, columns, widest_text, is_turned ? "sidewaystable" : "table"));
  }
  return needs({"booktabs", "longtable"}, paged(table, columns));
}

}  // namespace ikbench::report
