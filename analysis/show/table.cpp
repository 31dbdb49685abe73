#include "analysis/show/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/show/text.hpp"
#include "base/csv.hpp"
#include "base/json.hpp"
#include "base/number.hpp"

namespace ikbench::show {

using Json = base::OrderedJson;

namespace {

using Rows = std::vector<std::vector<std::string>>;
using Escape = std::string (*)(std::string_view);

// A cell for readers.
struct Readable {
  const Column& column;
  std::string unit = column.unit_of_cells.empty() ? "" : ' ' + column.unit_of_cells;

  std::string operator()(std::monostate) const { return "-"; }
  std::string operator()(const Absent&) const { return "-"; }
  std::string operator()(const Judgement& judgement) const { return judgement.words; }
  std::string operator()(const std::string& text) const { return text; }
  std::string operator()(std::int64_t count) const { return fmt::to_string(count) + unit; }
  std::string operator()(double value) const {
    const std::string text = column.role == Role::p ? p_text(value, column.ends) : number_beside(value, column.ends);
    return text == "-" ? text : text + unit;
  }
  std::string operator()(const judge::Interval& interval) const { return interval_text(interval, column.ends) + unit; }
  std::string operator()(const Printed& printed) const {
    return printed.printed + (printed.sign.empty() ? "" : ' ' + printed.sign);
  }
  std::string operator()(const Marked& marked) const {
    const std::string around = spread(marked, "-", "± ");
    return (marked.is_bound ? "≤ " : "") + plain(marked) + (around.empty() ? "" : ' ' + around) +
           (marked.mark.empty() ? "" : ' ' + marked.mark);
  }
  // Without what stands around it.
  std::string plain(const Marked& marked) const {
    if (marked.to_reference == judge::Scale::ratio)
      return number_text(marked.value, std::abs(marked.value - 1) < 0.1 ? 3 : 2) + " times";
    return (marked.to_reference && marked.value > 0 ? "+" : "") + (*this)(marked.value);
  }
  // "(98-100)" or "± 0.2".
  static std::string spread(const Marked& marked, std::string_view dash, std::string_view plus_minus) {
    if (marked.sd) return fmt::format("{}{}", plus_minus, number_text(*marked.sd, 2));
    if (!marked.interval) return "";
    const judge::Interval& its = *marked.interval;
    const int wide = std::abs(its.high - its.low) < 3 ? 3 : 2;
    return fmt::format("({}{}{})", number_text(its.low, wide), its.low < 0 ? " to " : dash,
                       number_text(its.high, wide));
  }
};

// Whether a cell of a column is so.
bool has(const Table& table, std::size_t column, auto is_so) {
  return std::ranges::any_of(table.rows, [&](const auto& row) { return is_so(row[column]); });
}
const std::string* text_of(const Cell& cell) {
  const auto* const judgement = std::get_if<Judgement>(&cell);
  return judgement ? &judgement->words : std::get_if<std::string>(&cell);
}
bool is_text(const Cell& cell) { return text_of(cell) != nullptr; }
bool is_printed(const Cell& cell) { return std::holds_alternative<Printed>(cell); }
const Marked& marked_of(const Cell& cell) {
  static const Marked none{};
  const auto* const marked = std::get_if<Marked>(&cell);
  return marked ? *marked : none;
}
bool is_ratio(const Cell& cell) { return marked_of(cell).to_reference == judge::Scale::ratio; }
bool is_best(const Cell& cell) { return marked_of(cell).is_best; }

std::string head(const Column& column) {
  return column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit);
}

// Readers see printed numbers in a column of their own, no column that is empty in every row, and where some cells are
// ratios, the unit at the other numbers.
Table for_readers(Table table) {
  for (std::size_t c = table.columns.size(); c-- > 0;) {
    if (has(table, c, is_ratio)) table.columns[c].unit_of_cells = std::exchange(table.columns[c].unit, "");
    if (has(table, c, is_printed)) {
      const auto next = static_cast<std::ptrdiff_t>(c + 1);
      table.columns.insert(table.columns.begin() + next, {"printed"});
      for (auto& row : table.rows) {
        const Cell ours = is_printed(row[c]) ? Cell(std::get<Printed>(row[c]).ours) : row[c];
        row.insert(row.begin() + next, is_printed(row[c]) ? row[c] : Cell());
        row[c] = ours;
      }
    }
    const auto is_empty = [=](const auto& row) {
      const auto* const text = std::get_if<std::string>(&row[c]);
      return std::holds_alternative<std::monostate>(row[c]) || std::holds_alternative<Absent>(row[c]) ||
             (text && text->empty());
    };
    const bool is_remark = table.columns[c].role == Role::remark;
    if (!is_remark && (table.rows.empty() || !std::ranges::all_of(table.rows, is_empty))) continue;
    const auto at = static_cast<std::ptrdiff_t>(c);
    table.columns.erase(table.columns.begin() + at);
    for (auto& row : table.rows) row.erase(row.begin() + at);
  }
  return table;
}

// The table as texts; the first row is the head.
Rows readable(const Table& table, Escape escape) {
  Rows rows(1);
  for (const Column& column : table.columns) rows[0].push_back(escape(head(column)));
  for (const auto& cells : table.rows) {
    auto& row = rows.emplace_back();
    for (std::size_t c = 0; c < cells.size(); ++c)
      row.push_back(escape(std::visit(Readable{table.columns[c]}, cells[c])));
  }
  return rows;
}

constexpr std::string_view its_times = "times", its_mark = "mark";  // have no unit
constexpr std::string_view all_members[]{"",     "printed", its_times,  "difference", "low",
                                         "high", "sd",      "excluded", its_mark};

// The members of a cell in files of numbers, by the words that follow the name of its column.
std::map<std::string_view, Json> members(const Cell& cell) {
  const Marked& marked = marked_of(cell);
  const auto* const interval = std::get_if<judge::Interval>(&cell);
  const auto* const spread = interval ? interval : marked.interval ? &*marked.interval : nullptr;
  std::map<std::string_view, Json> all;
  if (const auto* const text = text_of(cell)) all[""] = *text;
  if (const auto* const judgement = std::get_if<Judgement>(&cell); judgement && !judgement->key.empty())
    all[""] = judgement->key;
  if (const auto* const count = std::get_if<std::int64_t>(&cell)) all[""] = *count;
  if (const auto* const plain = std::get_if<double>(&cell)) all[""] = base::json_of(*plain);
  if (const auto* const printed = std::get_if<Printed>(&cell))
    all[""] = base::json_of(printed->ours), all["printed"] = printed->printed;
  if (std::holds_alternative<Marked>(cell))
    all[is_ratio(cell) ? its_times : marked.to_reference ? "difference" : ""] = base::json_of(marked.value);
  if (spread) all["low"] = base::json_of(spread->low), all["high"] = base::json_of(spread->high);
  if (marked.sd) all["sd"] = base::json_of(*marked.sd);
  if (interval && (interval->excludes_low || interval->excludes_high))
    all["excluded"] = interval->excludes_low ? "low" : "high";
  if (!marked.mark.empty()) all[its_mark] = marked.mark;
  return all;
}

// A column of files of numbers: a member that cells of a column have.
struct Flat {
  std::string name, unit;  // "error low", but "low" alone of a column that has nothing else
  std::vector<Json> values = {};
};

std::vector<Flat> flat(const Table& table) {
  std::vector<Flat> all;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const auto& [title, unit, role, unit_of_cells, ends] = table.columns[c];
    const bool is_interval = role == Role::interval,
               has_intervals = has(table, c, [](auto&cell) { return std::holds_alternative<judge::Interval>(cell); });
    std::vector<std::map<std::string_view, Json>> cells;
    for (const auto& row : table.rows) cells.push_back(members(row[c]));
    for (const std::string_view member : all_members) {
      const bool is_end = member == "low" || member == "high" || member == "excluded";
      const auto is_there = [&](const auto& its) { return its.contains(member); };
      if (!(is_interval ? is_end : member.empty() && !has_intervals) && std::ranges::none_of(cells, is_there)) continue;
      Flat& its = all.emplace_back(Flat{member.empty() ? title
                                        : is_interval  ? std::string(member)
                                                       : fmt::format("{} {}", title, member),
                                        member == its_times || member == its_mark ? "" : unit});
      for (auto& cell : cells) its.values.push_back(std::move(cell[member]));
    }
  }
  return all;
}

std::string latex_cell(const Cell& cell, const Column& column) {
  const Readable read{column};
  const auto* const marked = std::get_if<Marked>(&cell);
  if (marked == nullptr) return latex_text(std::visit(read, cell));
  std::string text = (marked->is_bound ? "$\\le$ " : "") + latex_text(read.plain(*marked));
  if (marked->is_best) text = fmt::format("{{\\boldmath\\textbf{{{}}}}}", text);
  if (const std::string around = Readable::spread(*marked, "--", "$\\pm$ "); !around.empty())
    text += fmt::format(" & {{\\scriptsize {}}}", around);
  if (!marked->mark.empty()) text += fmt::format("\\rlap{{\\,\\scriptsize {}}}", latex_text(marked->mark));
  return text;  // digits align
}

}  // namespace

std::vector<Column> columns_of(const std::vector<std::string>& names) {
  std::vector<Column> columns;
  for (const std::string& name : names) columns.push_back({name});
  return columns;
}

std::string interval_text(const judge::Interval& interval, const Ends& ends) {
  const auto end = [&](double value, bool is_excluded, const char* beyond, char sign) {
    if (std::isinf(value)) return std::string("no bound");
    const std::string text = number_beside(value, ends);
    return text[0] == sign ? beyond + text.substr(2) : (is_excluded ? beyond : "") + number_text(value);
  };
  return fmt::format("{} to {}", end(interval.low, interval.excludes_low, "above ", '>'),
                     end(interval.high, interval.excludes_high, "below ", '<'));
}

std::string to_csv(const Table& table) {
  const std::vector<Flat> columns = flat(table);
  std::vector<std::vector<std::string>> rows(1 + table.rows.size());
  for (const Flat& column : columns) {
    rows[0].push_back(column.name + (column.unit.empty() ? "" : fmt::format(" [{}]", column.unit)));
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
      const Json& value = column.values[r];
      rows[r + 1].push_back(value.is_null() ? "" : value.is_string() ? value.get<std::string>() : value.dump());
    }
  }
  std::string text;
  for (const auto& row : rows) base::append_csv_row(text, row);
  return text;
}

Json to_json(const Table& table) {
  std::vector<Json> rows(table.rows.size(), Json::object());
  for (Flat& column : flat(table)) {
    for (char& letter : column.name) letter = letter == ' ' ? '_' : static_cast<char>(std::tolower(letter));
    for (std::size_t r = 0; r < rows.size(); ++r) rows[r][column.name] = std::move(column.values[r]);
  }
  return rows;
}

std::string to_markdown(const Table& whole) {
  const Table table = for_readers(whole);
  std::string text;
  const Rows rows = readable(table, markdown_text);
  for (const auto& row : rows) {
    text += fmt::format("| {} |\n", fmt::join(row, " | "));
    if (&row != &rows.front()) continue;
    for (std::size_t c = 0; c < row.size(); ++c) text += has(table, c, is_text) ? "|---" : "|--:";
    text += "|\n";
  }
  for (const std::string& note : table.notes) text += fmt::format("\n{}\n", markdown_text(note));
  return text;
}

std::string to_latex(const Table& whole) {
  Table table = for_readers(whole);
  std::string letters;
  std::vector<std::string> heads;
  const auto is_long = [](const Cell& cell) { return is_text(cell) && character_count(*text_of(cell)) > 60; };
  const auto has_spread = [](const Cell& cell) { return marked_of(cell).interval || marked_of(cell).sd; };
  std::vector<bool> are_long, have_spreads;  // which have a column of their own, so that the numbers align
  bool is_any_best = false;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    are_long.push_back(has(table, c, is_long)), have_spreads.push_back(has(table, c, has_spread));
    is_any_best |= has(table, c, is_best);
    letters += are_long[c] ? "p{5cm}" : has(table, c, is_text) ? "l" : have_spreads[c] ? "r@{ }l" : "r";
    const bool has_mark = has(table, c, [](const Cell& cell) { return !marked_of(cell).mark.empty(); });
    const std::string room = has_mark ? "@{\\hspace{14pt}}" : "";  // for them
    const std::string name = latex_text(head(table.columns[c]));
    letters += room;
    heads.push_back(have_spreads[c] ? fmt::format("\\multicolumn{{2}}{{c{}}}{{{}}}", room, name) : name);
  }
  const std::string head_row = fmt::format("{} \\\\\n\\midrule\n", fmt::join(heads, " & "));
  constexpr std::size_t most_rows = 50;  // on a page
  const std::size_t parts = std::max<std::size_t>(1, (table.rows.size() + most_rows - 1) / most_rows);
  std::vector<std::string> rows(parts);
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    const auto& row = table.rows[r];
    std::vector<std::string> cells;
    for (std::size_t c = 0; c < row.size(); ++c) {
      cells.push_back(latex_cell(row[c], table.columns[c]));
      if (are_long[c]) cells.back() = "\\raggedright\\let\\\\\\tabularnewline " + cells.back();
      if (have_spreads[c] && cells.back().find(" & ") == std::string::npos) cells.back() += " &";
    }
    rows[r * parts / table.rows.size()] += fmt::format("{} \\\\\n", fmt::join(cells, " & "));
  }
  if (is_any_best) table.notes.emplace_back("Bold: none is shown to be better.");
  const std::string notes = latex_text(fmt::format("{}", fmt::join(table.notes, " ")));
  // No journal's capitals change names in a caption. A table shrinks to fit a column, to four fifths at the most; else
  // it takes both, and shrinks down to the size of \\scriptsize.
  std::string text = "% Needs \\usepackage{booktabs,graphicx}\n";
  for (std::size_t part = 0; part < parts; ++part)
    text += fmt::format(
        "\\begingroup\\tabcolsep5pt{}\n"
        "\\sbox0{{\\begin{{tabular}}{{{}}}\n\\toprule\n{}\\bottomrule\n\\end{{tabular}}}}%\n"
        "\\edef\\wide{{\\ifdim.8\\wd0>\\columnwidth*\\fi}}%\n"
        "\\csname table\\wide\\endcsname\n\\centering\n{}\\smallskip\n"
        "\\ifdim.7\\wd0>\\linewidth\\scalebox{{.7}}{{\\usebox0}}\\else\n"
        "\\ifdim\\wd0>\\linewidth\\resizebox{{\\linewidth}}{{!}}{{\\usebox0}}\\else\\usebox0\\fi\\fi\n{}\n"
        "\\csname endtable\\wide\\endcsname\n\\endgroup\n",
        table.rows.size() > 45   ? "\\scriptsize"
        : table.rows.size() > 30 ? "\\footnotesize"
                                 : "",
        letters, head_row + rows[part],
        part == 0
            ? fmt::format("\\caption{{\\textnormal{{{}}}}}\\label{{tab:{}}}", latex_text(table.caption), table.name)
            : "\\addtocounter{table}{-1}\\caption{\\textnormal{Continued.}}",
        notes.empty() || part + 1 < parts ? "" : "\\par\\smallskip\\footnotesize " + notes);
  return text;
}

std::string to_html(const Table& whole) {
  constexpr std::size_t long_text = 28;                                         // breaks anywhere
  constexpr std::array<const char*, 3> pills{"pill", "pill good", "pill bad"};  // by tone
  const Table table = for_readers(whole);
  const Rows rows = readable(table, html_text);
  const auto cell_of = [&](std::size_t r, std::size_t c) {  // digits align, without the mark
    const Cell* const cell = r == 0 ? nullptr : &table.rows[r - 1][c];
    std::string text = rows[r][c];
    if (const auto* const judgement = std::get_if<Judgement>(cell))
      return fmt::format("<span class=\"{}\">{}</span>", pills[static_cast<std::size_t>(judgement->tone)], text);
    const auto* const marked = std::get_if<Marked>(cell);
    if (marked && !marked->mark.empty())
      text.replace(text.size() - marked->mark.size() - 1, std::string::npos,
                   fmt::format("<i>{}</i>", html_text(marked->mark)));
    if (c == 0)  // a long name may break after these
      for (std::size_t at = 0; (at = text.find('_', at)) != std::string::npos;) text.insert(++at, "<wbr>");
    return text;
  };
  std::vector<std::string> classes;
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    classes.emplace_back(has(table, c, is_printed) ? "number printed" : has(table, c, is_text) ? "" : "number");
  const auto line = [&](std::size_t r, std::string_view tag) {
    const std::vector<std::string>& row = rows[r];
    std::string text;
    for (std::size_t c = 0; c < row.size(); ++c) {
      const bool is_judgement = r > 0 && std::holds_alternative<Judgement>(table.rows[r - 1][c]),
                 is_long = classes[c].empty() && !is_judgement && character_count(row[c]) > long_text;
      const std::string its = is_long ? std::string("long") : classes[c];
      text += fmt::format("<{}{}>{}</{}>", tag, its.empty() ? "" : fmt::format(" class=\"{}\"", its), cell_of(r, c),
                          tag.substr(0, tag.find(' ')));
    }
    return fmt::format("<tr>{}</tr>\n", text);
  };
  std::string text = fmt::format("<table><caption>{}</caption>\n<thead>{}</thead>\n<tbody>\n", html_text(table.caption),
                                 line(0, "th scope=\"col\""));
  for (std::size_t r = 1; r < rows.size(); ++r) text += line(r, "td");
  return text + "</tbody></table>\n";
}

std::string to_text(const Table& whole) {
  Table table = for_readers(whole);
  constexpr std::size_t longest = 60;
  for (Column& column : table.columns) {
    column.name = shortened(column.name, longest);
    if (!column.unit.empty()) column.unit_of_cells = std::exchange(column.unit, "");
  }
  for (auto& row : table.rows) {
    if (auto* const name = std::get_if<std::string>(&row[0])) *name = shortened(*name, longest);
  }
  std::string text = in_columns(readable(table, one_line));
  for (const std::string& note : table.notes) text += paragraph(note, "");
  return text;
}

}  // namespace ikbench::show
