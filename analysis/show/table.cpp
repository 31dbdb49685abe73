#include "analysis/show/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "analysis/show/text.hpp"
#include "base/csv.hpp"
#include "base/json.hpp"

namespace ikbench::show {

using Json = base::OrderedJson;

namespace {

using Rows = std::vector<std::vector<std::string>>;
using Escape = std::string (*)(std::string_view);

// The rules of an output format: how texts are escaped, and what stands around a number, as formats of fmt.
struct Format {
  Escape escape;
  const char *at_most = "≤ {}", *dash = "-", *plus_minus = "± ", *spread = " {}", *mark = " {}";
};
constexpr Format of_screen{one_line}, of_markdown{markdown_text},
    of_html{.escape = html_text, .mark = "<i>{}</i>"},  // digits align without the mark
    of_latex{latex_text, "$\\le$ {}", "--", "$\\pm$ ", " & {{\\scriptsize {}}}", "\\rlap{{\\,\\scriptsize {}}}"};

// Writes a cell for readers as a text, without the mark and the spread around a number.
struct Plain {
  const Column& column;
  std::string unit = column.cell_unit.empty() ? "" : ' ' + column.cell_unit;

  std::string operator()(std::monostate) const { return "-"; }
  std::string operator()(const MissingCell&) const { return "-"; }
  std::string operator()(const VerdictCell& judgement) const { return judgement.text; }
  std::string operator()(const std::string& text) const { return text; }
  std::string operator()(std::int64_t count) const { return fmt::to_string(count) + unit; }
  std::string operator()(double value) const { return number(value, 3); }
  std::string operator()(const judge::Interval& interval) const {
    return interval_text(interval, column.boundaries) + unit;
  }
  std::string operator()(const PublishedNumber& printed) const {
    return printed.printed + (printed.sign.empty() ? "" : ' ' + printed.sign);
  }
  std::string operator()(const ValueCell& marked) const {
    if (marked.relative_to_reference == judge::EffectScale::ratio) return ratio_text(marked.value);
    return (marked.relative_to_reference && marked.value > 0 ? "+" : "") + number(marked.value, marked.digits);
  }
  std::string number(double value, int digits) const {
    const std::string text = column.role == ColumnRole::p ? p_text(value, column.boundaries)
                                                          : number_within(value, column.boundaries, digits);
    return text == "-" ? text : text + unit;
  }
};

// Returns the interval or the standard deviation of a cell: "(98-100)" or "± 0.2".
std::string spread_of(const ValueCell& marked, const Format& format) {
  if (marked.sd) return format.plus_minus + number_text(*marked.sd, 2);
  if (!marked.interval) return "";
  const double low = marked.interval->low, high = marked.interval->high;
  const int digits = std::abs(high - low) < 3 ? 3 : 2;
  return fmt::format("({}{}{})", number_text(low, digits), low < 0 ? " to " : format.dash, number_text(high, digits));
}

std::string written(const Cell& cell, const Column& column, const Format& format) {
  std::string text = format.escape(std::visit(Plain{column}, cell));
  if (const auto* const marked = std::get_if<ValueCell>(&cell)) {
    if (marked->is_bound) text = fmt::format(fmt::runtime(format.at_most), text);
    if (const std::string spread = spread_of(*marked, format); !spread.empty())
      text += fmt::format(fmt::runtime(format.spread), spread);
    if (!marked->mark.empty()) text += fmt::format(fmt::runtime(format.mark), format.escape(marked->mark));
  }
  return text;
}

// Returns whether `is_so` holds for a cell of a column.
bool has(const Table& table, std::size_t column, auto is_so) {
  return std::ranges::any_of(table.rows, [&](const auto& row) { return is_so(row[column]); });
}
const std::string* shown_text(const Cell& cell) {
  const auto* const judgement = std::get_if<VerdictCell>(&cell);
  return judgement ? &judgement->text : std::get_if<std::string>(&cell);
}
bool is_text(const Cell& cell) { return shown_text(cell) != nullptr; }
bool is_printed(const Cell& cell) { return std::holds_alternative<PublishedNumber>(cell); }
// Returns the value cell, or for any other cell a value cell without mark, interval and scale.
const ValueCell& value_cell_of(const Cell& cell) {
  static const ValueCell none{};
  const auto* const value = std::get_if<ValueCell>(&cell);
  return value ? *value : none;
}
bool is_ratio(const Cell& cell) { return value_cell_of(cell).relative_to_reference == judge::EffectScale::ratio; }
// Returns our number for readers. If three digits would round the number onto an end, the number has as many decimals
// as the printed one.
ValueCell ours_of(const PublishedNumber& cell, const Boundaries& ends) {
  if (number_within(cell.ours, ends) == number_text(cell.ours)) return {.value = cell.ours};
  const std::size_t point = std::min(cell.printed.find('.') + 1, cell.printed.size());
  const double digits = std::floor(std::log10(std::abs(cell.ours))) + 1 +
                        static_cast<double>(point > 0 ? cell.printed.size() - point : 0);
  return {.value = cell.ours, .digits = std::max(3, static_cast<int>(digits))};
}

std::string head(const Column& column) {
  return column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit);
}

// Returns the table for readers. Printed numbers have a column of their own, and columns that are empty in every row or
// only for files of numbers are removed. If some cells are ratios, the unit stands at the other numbers.
Table for_readers(Table table) {
  for (std::size_t c = table.columns.size(); c-- > 0;) {
    if (has(table, c, is_ratio)) table.columns[c].cell_unit = std::exchange(table.columns[c].unit, "");
    if (has(table, c, is_printed)) {
      const auto next = static_cast<std::ptrdiff_t>(c + 1);
      table.columns.insert(table.columns.begin() + next, {"paper"});
      for (auto& row : table.rows) {
        const auto* const published = std::get_if<PublishedNumber>(&row[c]);
        Cell printed = published ? Cell(*published) : Cell();
        if (published) row[c] = ours_of(*published, table.columns[c].boundaries);
        row.insert(row.begin() + next, std::move(printed));
      }
    }
    const auto is_empty = [=](const auto& row) {
      const auto* const text = std::get_if<std::string>(&row[c]);
      return std::holds_alternative<std::monostate>(row[c]) || std::holds_alternative<MissingCell>(row[c]) ||
             (text && text->empty());
    };
    const bool is_remark = table.columns[c].role == ColumnRole::machine_only;
    if (!is_remark && (table.rows.empty() || !std::ranges::all_of(table.rows, is_empty))) continue;
    const auto at = static_cast<std::ptrdiff_t>(c);
    table.columns.erase(table.columns.begin() + at);
    for (auto& row : table.rows) row.erase(row.begin() + at);
  }
  return table;
}

// Returns the cells as texts. The first row is the head.
Rows readable(const Table& table, const Format& format) {
  Rows rows(1);
  for (const Column& column : table.columns) rows[0].push_back(format.escape(head(column)));
  for (const auto& cells : table.rows) {
    auto& row = rows.emplace_back();
    for (std::size_t c = 0; c < cells.size(); ++c) row.push_back(written(cells[c], table.columns[c], format));
  }
  return rows;
}

constexpr std::string_view times_member = "times", mark_member = "mark";  // without unit
constexpr std::string_view all_members[]{"",     "printed", times_member, "difference", "low",
                                         "high", "sd",      "excluded",   mark_member};

using Members = std::map<std::string_view, Json>;

void add_interval(Members& members, const judge::Interval& interval) {
  members["low"] = base::json_of(interval.low);
  members["high"] = base::json_of(interval.high);
}

std::string_view scale_member(const ValueCell& cell) {
  if (!cell.relative_to_reference) return "";
  return *cell.relative_to_reference == judge::EffectScale::ratio ? times_member : "difference";
}

void add_value(Members& members, const ValueCell& cell) {
  members[scale_member(cell)] = base::json_of(cell.value);
  if (cell.interval) add_interval(members, *cell.interval);
  if (cell.sd) members["sd"] = base::json_of(*cell.sd);
  if (!cell.mark.empty()) members[mark_member] = cell.mark;
}

// Returns the members of a cell in files of numbers, by the words that follow the name of the cell's column.
Members members_of(const Cell& cell) {
  Members members;
  if (const auto* const text = shown_text(cell)) members[""] = *text;
  if (const auto* const verdict = std::get_if<VerdictCell>(&cell); verdict && !verdict->key.empty())
    members[""] = verdict->key;
  if (const auto* const count = std::get_if<std::int64_t>(&cell)) members[""] = *count;
  if (const auto* const number = std::get_if<double>(&cell)) members[""] = base::json_of(*number);
  if (const auto* const published = std::get_if<PublishedNumber>(&cell)) {
    members[""] = base::json_of(published->ours);
    members["printed"] = published->printed;
  }
  if (const auto* const value = std::get_if<ValueCell>(&cell)) add_value(members, *value);
  if (const auto* const interval = std::get_if<judge::Interval>(&cell)) {
    add_interval(members, *interval);
    if (interval->excludes_low || interval->excludes_high)
      members["excluded"] = interval->excludes_low ? "low" : "high";
  }
  return members;
}

// A column of files of numbers: one member of the cells of a column.
struct FlatColumn {
  std::string name, unit;  // "error low", but only "low" in a column of intervals
  std::vector<Json> values = {};
};

// True if files of numbers have the member although no cell has it, so that the columns of a table do not depend on its
// values.
bool has_always(std::string_view member, const Table& table, std::size_t column) {
  if (table.columns[column].role == ColumnRole::interval)
    return member == "low" || member == "high" || member == "excluded";
  const auto is_interval = [](const Cell& cell) { return std::holds_alternative<judge::Interval>(cell); };
  return member.empty() && !has(table, column, is_interval);
}

std::string flat_name(const Column& column, std::string_view member) {
  if (member.empty()) return column.name;
  if (column.role == ColumnRole::interval) return std::string(member);
  return fmt::format("{} {}", column.name, member);
}

std::vector<FlatColumn> flat_columns(const Table& table) {
  std::vector<FlatColumn> flat;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const Column& column = table.columns[c];
    std::vector<Members> cells;
    for (const auto& row : table.rows) cells.push_back(members_of(row[c]));
    for (const std::string_view member : all_members) {
      const auto has_member = [&](const Members& members) { return members.contains(member); };
      if (!has_always(member, table, c) && std::ranges::none_of(cells, has_member)) continue;
      const bool has_unit = member != times_member && member != mark_member;
      FlatColumn& added =
          flat.emplace_back(FlatColumn{.name = flat_name(column, member), .unit = has_unit ? column.unit : ""});
      for (Members& members : cells) added.values.push_back(std::move(members[member]));
    }
  }
  return flat;
}

// Returns LaTeX's letters for a column.
const char* column_letters(bool is_long, bool holds_text, bool has_spreads) {
  if (is_long) return "p{5cm}";
  if (holds_text) return "l";
  return has_spreads ? "r@{ }l" : "r";
}

// Returns the class of a column's cells on a page.
const char* column_class(const Table& table, std::size_t column) {
  if (has(table, column, is_printed)) return "number printed";
  return has(table, column, is_text) ? "" : "number";
}

std::string csv_text(const Json& value) {
  if (value.is_null()) return "";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

}  // namespace

std::vector<Column> named_columns(const std::vector<std::string>& names) {
  std::vector<Column> columns;
  for (const std::string& name : names) columns.push_back({name});
  return columns;
}

std::string interval_text(const judge::Interval& interval, const Boundaries& ends) {
  const auto end = [&](double value, bool is_excluded, const char* beyond, char sign) {
    if (std::isinf(value)) return std::string("no bound");
    const std::string text = number_within(value, ends);
    if (text[0] == sign) return beyond + text.substr(2);
    return (is_excluded ? beyond : "") + number_text(value);
  };
  return fmt::format("{} to {}", end(interval.low, interval.excludes_low, "above ", '>'),
                     end(interval.high, interval.excludes_high, "below ", '<'));
}

std::string to_csv(const Table& table) {
  const std::vector<FlatColumn> columns = flat_columns(table);
  std::vector<std::vector<std::string>> rows(1 + table.rows.size());
  for (const FlatColumn& column : columns) {
    rows[0].push_back(column.name + (column.unit.empty() ? "" : fmt::format(" [{}]", column.unit)));
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
      rows[r + 1].push_back(csv_text(column.values[r]));
    }
  }
  std::string text;
  for (const auto& row : rows) base::append_csv_row(text, row);
  return text;
}

Json to_json(const Table& table) {
  std::vector<Json> rows(table.rows.size(), Json::object());
  for (FlatColumn& column : flat_columns(table)) {
    for (char& letter : column.name) letter = letter == ' ' ? '_' : static_cast<char>(std::tolower(letter));
    for (std::size_t r = 0; r < rows.size(); ++r) rows[r][column.name] = std::move(column.values[r]);
  }
  return rows;
}

std::string to_markdown(const Table& whole) {
  const Table table = for_readers(whole);
  std::string text;
  const Rows rows = readable(table, of_markdown);
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
  const Table table = for_readers(whole);
  const auto is_long = [](const Cell& cell) { return is_text(cell) && character_count(*shown_text(cell)) > 60; };
  const auto has_spread = [](const Cell& cell) { return value_cell_of(cell).interval || value_cell_of(cell).sd; };
  const auto has_mark = [](const Cell& cell) { return !value_cell_of(cell).mark.empty(); };
  Rows rows = readable(table, of_latex);
  std::string letters, lines;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const bool are_long = has(table, c, is_long), have_spreads = has(table, c, has_spread);
    letters += column_letters(are_long, has(table, c, is_text), have_spreads);
    const std::string room = has(table, c, has_mark) ? "@{\\hspace{14pt}}" : "";  // for the marks
    letters += room;
    for (std::size_t r = 1; r < rows.size(); ++r) {
      if (are_long) rows[r][c].insert(0, "\\raggedright\\let\\\\\\tabularnewline ");
      if (have_spreads && !has_spread(table.rows[r - 1][c])) rows[r][c] += " &";  // so that the numbers align
    }
    if (have_spreads) rows[0][c] = fmt::format("\\multicolumn{{2}}{{c{}}}{{{}}}", room, rows[0][c]);
  }
  for (const auto& row : rows)
    lines += fmt::format("{} \\\\\n{}", fmt::join(row, " & "), &row == &rows.front() ? "\\midrule\n" : "");
  const std::string notes = latex_text(fmt::format("{}", fmt::join(table.notes, " ")));
  // \\textnormal keeps journals that set captions in capitals from changing names. A table shrinks to the height of a
  // page, and to the width of a column if four fifths of the table's size suffice. Otherwise the table takes both
  // columns, and shrinks down to the size of \\scriptsize.
  return fmt::format(
      "% Needs \\usepackage{{booktabs,graphicx}}\n\\begingroup\\tabcolsep5pt\n"
      "\\sbox0{{\\begin{{tabular}}{{{}}}\n\\toprule\n{}\\bottomrule\n\\end{{tabular}}}}%\n"
      "\\ifdim\\dimexpr\\ht0+\\dp0>.85\\textheight\\sbox0{{\\resizebox*{{!}}{{.85\\textheight}}{{\\usebox0}}}}\\fi\n"
      "\\edef\\wide{{\\ifdim.8\\wd0>\\columnwidth*\\fi}}%\n"
      "\\csname table\\wide\\endcsname\n\\centering\n"
      "\\caption{{\\textnormal{{{}}}}}\\label{{tab:{}}}\\smallskip\n"
      "\\ifdim.7\\wd0>\\linewidth\\scalebox{{.7}}{{\\usebox0}}\\else\n"
      "\\ifdim\\wd0>\\linewidth\\resizebox{{\\linewidth}}{{!}}{{\\usebox0}}\\else\\usebox0\\fi\\fi\n{}\n"
      "\\csname endtable\\wide\\endcsname\n\\endgroup\n",
      letters, lines, latex_text(table.caption), table.name,
      notes.empty() ? "" : "\\par\\smallskip\\footnotesize " + notes);
}

std::string to_html(const Table& whole) {
  constexpr std::size_t long_text = 28;                                         // breaks anywhere
  constexpr std::array<const char*, 3> pills{"pill", "pill good", "pill bad"};  // by tone
  const Table table = for_readers(whole);
  const Rows rows = readable(table, of_html);
  std::vector<std::string> classes;
  for (std::size_t c = 0; c < table.columns.size(); ++c) classes.emplace_back(column_class(table, c));
  const auto line = [&](std::size_t r, std::string_view tag) {
    std::string text;
    for (std::size_t c = 0; c < rows[r].size(); ++c) {
      const auto* const judgement = r == 0 ? nullptr : std::get_if<VerdictCell>(&table.rows[r - 1][c]);
      const bool is_long = classes[c].empty() && !judgement && character_count(rows[r][c]) > long_text;
      const std::string cell_class = is_long ? "long" : classes[c];
      text += fmt::format("<{}{}>", tag, cell_class.empty() ? "" : fmt::format(" class=\"{}\"", cell_class));
      text += judgement ? fmt::format("<span class=\"{}\">{}</span>", pills[static_cast<std::size_t>(judgement->tone)],
                                      rows[r][c])
                        : rows[r][c];
      text += fmt::format("</{}>", tag.substr(0, tag.find(' ')));
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
    if (!column.unit.empty()) column.cell_unit = std::exchange(column.unit, "");
  }
  std::set<std::string> names;
  for (const auto& row : table.rows)
    if (is_text(row[0])) names.insert(*shown_text(row[0]));
  const auto short_of = base::short_names({names.begin(), names.end()});
  for (auto& row : table.rows)
    if (is_text(row[0])) row[0] = short_of.at(*shown_text(row[0]));
  std::string text = align_columns(readable(table, of_screen));
  for (const std::string& note : table.notes) text += wrapped_paragraph(note, "");
  return text;
}

}  // namespace ikbench::show
