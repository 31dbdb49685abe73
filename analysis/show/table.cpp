// The writers of tables.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/show/block.hpp"
#include "analysis/show/text.hpp"
#include "numerics/json.hpp"
#include "results/csv.hpp"

namespace ikbench::show {

using Json = numerics::OrderedJson;

namespace {

using Rows = std::vector<std::vector<std::string>>;
using Escape = std::string (*)(std::string_view);
using Number = std::string (*)(double, int digits);

// A cell for readers. `unit` stands after a number.
struct Readable {
  Number number;
  const Column& column;
  std::string unit = {}, at_most = "≤ ", dash = "-";

  std::string operator()(std::monostate) const { return "-"; }
  std::string operator()(const std::string& text) const { return text; }
  std::string operator()(std::int64_t count) const { return fmt::to_string(count) + unit; }
  std::string operator()(double value) const {
    const std::string text = column.is_p ? p_text(value, column.ends) : number(value, digits_apart(value, column.ends));
    return text == "-" ? text : text + unit;
  }
  std::string operator()(const compare::Interval& interval) const {
    return interval_text(interval, number, column.ends) + unit;
  }
  std::string operator()(const Printed& printed) const {
    return printed.printed + (printed.sign.empty() ? "" : ' ' + printed.sign);
  }
  std::string operator()(const Marked& marked) const {
    const auto digits = [](double size, double small) { return std::abs(size) < small ? 3 : 2; };
    std::string text = (marked.is_bound ? at_most : "") + (*this)(marked.value);
    if (marked.to_reference == compare::Scale::ratio)
      text = number(marked.value, digits_apart(marked.value, {1}, digits(marked.value - 1, 0.1))) + " times";
    if (marked.to_reference == compare::Scale::difference && marked.value > 0) text.insert(0, "+");
    if (const auto& its = marked.interval) {
      const int wide = digits(its->high - its->low, 3);
      text += fmt::format(" ({}{}{})", number(its->low, wide), dash, number(its->high, wide));
    }
    return text + (marked.mark.empty() ? "" : ' ' + marked.mark);
  }
};

bool excludes_end(const Cell& cell) {
  const auto* of = std::get_if<compare::Interval>(&cell);
  return of && (of->excludes_low || of->excludes_high);
}

template <class Kind>
bool has(const Table& table, std::size_t column) {
  return std::ranges::any_of(table.rows, [=](const auto& row) { return std::holds_alternative<Kind>(row[column]); });
}
bool is_text(const Table& table, std::size_t column) { return has<std::string>(table, column); }

std::string head(const Column& column) {
  return column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit);
}

// Readers see printed numbers in a column of their own, and no column that is empty in every row.
Table for_readers(Table table) {
  for (std::size_t c = table.columns.size(); c-- > 0;) {
    if (has<Printed>(table, c)) {
      const auto next = static_cast<std::ptrdiff_t>(c + 1);
      table.columns.insert(table.columns.begin() + next, {"printed"});
      for (auto& row : table.rows) {
        const bool is_printed = std::holds_alternative<Printed>(row[c]);
        const Cell ours = is_printed ? Cell(std::get<Printed>(row[c]).ours) : row[c];
        row.insert(row.begin() + next, is_printed ? row[c] : Cell());
        row[c] = ours;
      }
    }
    const auto is_empty = [=](const auto& row) { return std::holds_alternative<std::monostate>(row[c]); };
    if (table.rows.empty() || !std::ranges::all_of(table.rows, is_empty)) continue;
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
      row.push_back(escape(std::visit(Readable{number_text, table.columns[c]}, cells[c])));
  }
  return rows;
}

constexpr std::string_view times = "times", mark = "mark";  // have no unit
constexpr std::string_view every_member[]{"", "printed", times, "difference", "low", "high", "excluded", mark};

// What a cell has of a member in files of numbers: the words that follow the name of its column. None: it has it not.
std::optional<Json> value_of(const Cell& cell, std::string_view member) {
  const auto number = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
  const auto* const printed = std::get_if<Printed>(&cell);
  const auto* const marked = std::get_if<Marked>(&cell);
  const auto* interval = std::get_if<compare::Interval>(&cell);
  if (member == "excluded" && excludes_end(cell)) return interval->excludes_low ? "low" : "high";
  if (marked && marked->interval) interval = &*marked->interval;
  if (member == "low" && interval) return number(interval->low);
  if (member == "high" && interval) return number(interval->high);
  if (member == "printed" && printed) return printed->printed;
  if (member == mark && marked && !marked->mark.empty()) return marked->mark;
  if (const auto scale = marked ? marked->to_reference : std::nullopt;
      marked && member == (!scale                           ? ""
                           : scale == compare::Scale::ratio ? times
                                                            : "difference"))
    return number(marked->value);
  if (!member.empty()) return std::nullopt;
  if (printed) return number(printed->ours);
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* count = std::get_if<std::int64_t>(&cell)) return *count;
  if (const auto* of = std::get_if<double>(&cell)) return number(*of);
  return std::nullopt;
}

// The members of each column: those that a cell has, and "" but for intervals.
std::vector<std::vector<std::string_view>> members_of(const Table& table) {
  std::vector<std::vector<std::string_view>> all(table.columns.size());
  for (std::size_t c = 0; c < all.size(); ++c)
    for (const std::string_view member : every_member)
      if ((member.empty() && !has<compare::Interval>(table, c)) ||
          std::ranges::any_of(table.rows, [&](const auto& row) { return value_of(row[c], member).has_value(); }))
        all[c].push_back(member);
  return all;
}

// "error low", but "low" alone of the column "interval".
std::string member_name(const std::string& column, std::string_view member) {
  if (member.empty()) return column;
  return column == "interval" ? std::string(member) : fmt::format("{} {}", column, member);
}

// The digits alone, without quotes of JSON.
std::string csv_text(const Json& value) {
  return value.is_null() ? "" : value.is_string() ? value.get<std::string>() : value.dump();
}

// -1.2e-05 as $-1.2 \times 10^{-5}$, which no escaping may touch.
std::string latex_number(double value, int digits) {
  const std::string text = number_text(value, digits);
  const std::size_t e = text.find('e');
  if (e != std::string::npos)
    return fmt::format("${} \\times 10^{{{}}}$", text.substr(0, e), std::stoi(text.substr(e + 1)));
  return text.size() > 1 && text[0] == '-' ? fmt::format("${}$", text) : text;
}

std::string latex_cell(const Cell& cell, const Column& column) {
  const Readable read{latex_number, column, "", "$\\le$ ", "--"};
  if (const auto* text = std::get_if<std::string>(&cell)) return latex_text(*text);
  if (std::holds_alternative<Printed>(cell)) return latex_text(std::visit(read, cell));
  if (const auto* of = std::get_if<Marked>(&cell)) {
    const auto bare = [&](Marked part) { return part.mark.clear(), part.interval.reset(), read(part); };
    std::string text = of->is_best ? fmt::format("\\textbf{{{}}}", bare(*of)) : bare(*of);
    if (of->interval) {
      const std::string whole = read(Marked{.value = of->value, .interval = of->interval});
      text += fmt::format(" & {{\\scriptsize {}}}", whole.substr(whole.find('(')));
    }
    return text + (of->mark.empty() ? "" : fmt::format("\\rlap{{\\,{}}}", latex_text(of->mark)));  // digits align
  }
  if (const auto* p = std::get_if<double>(&cell); p && column.is_p && *p < 0.0001) return "$<$ 0.0001";
  return std::visit(read, cell);
}

// A verdict of a page: green, red, or neither.
std::string pill(const std::string& verdict) {
  const bool is_good = verdict.starts_with("better") || (verdict.starts_with("holds") && !verdict.ends_with("part"));
  const bool is_bad = verdict.starts_with("worse") || verdict.starts_with("fails");
  return fmt::format("<span class=\"pill{}\">{}</span>", is_good ? " good" : is_bad ? " bad" : "", verdict);
}

}  // namespace

std::string interval_text(const compare::Interval& interval, Number number, const Ends& ends) {
  const auto end = [&](double value) {
    return std::isinf(value) ? "no bound" : number(value, digits_apart(value, ends));
  };
  return fmt::format("{}{} to {}{}", interval.excludes_low ? "above " : "", end(interval.low),
                     interval.excludes_high ? "below " : "", end(interval.high));
}

std::string to_csv(const Table& table) {
  const auto members = members_of(table);
  std::string text;
  std::vector<std::string> heads;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const Column& column = table.columns[c];
    const std::string unit = column.unit.empty() ? "" : fmt::format(" [{}]", column.unit);
    for (const std::string_view member : members[c])
      heads.push_back(member_name(column.name, member) + (member == times || member == mark ? "" : unit));
  }
  results::append_csv_row(text, heads);
  for (const auto& row : table.rows) {
    std::vector<std::string> cells;
    for (std::size_t c = 0; c < row.size(); ++c) {
      for (const std::string_view member : members[c])
        cells.push_back(csv_text(value_of(row[c], member).value_or(Json())));
    }
    results::append_csv_row(text, cells);
  }
  return text;
}

Json to_json(const Table& table) {
  const auto members = members_of(table);
  Json rows = Json::array();
  for (const auto& row : table.rows) {
    Json object = Json::object();
    for (std::size_t c = 0; c < row.size(); ++c) {
      for (const std::string_view member : members[c]) {
        std::string name = member_name(table.columns[c].name, member);
        for (char& letter : name) letter = letter == ' ' ? '_' : static_cast<char>(std::tolower(letter));
        object[name] = value_of(row[c], member).value_or(Json());
      }
    }
    rows.push_back(std::move(object));
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
    for (std::size_t c = 0; c < row.size(); ++c) text += is_text(table, c) ? "|---" : "|--:";
    text += "|\n";
  }
  for (const std::string& note : table.notes) text += fmt::format("\n{}\n", markdown_text(note));
  return text;
}

std::string to_latex(const Table& whole) {
  const Table table = for_readers(whole);
  std::string letters, text;
  std::vector<std::string> heads;
  std::vector<bool> have_spread;  // which has a column of its own, so that the numbers align
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    have_spread.push_back(std::ranges::any_of(table.rows, [=](const auto& row) {
      const auto* const marked = std::get_if<Marked>(&row[c]);
      return marked && marked->interval;
    }));
    letters += is_text(table, c) ? "l" : have_spread[c] ? "r@{ }l" : "r";
    const std::string name = latex_text(head(table.columns[c]));
    heads.push_back(have_spread[c] ? fmt::format("\\multicolumn{{2}}{{c}}{{{}}}", name) : name);
  }
  text += fmt::format("{} \\\\\n\\midrule\n", fmt::join(heads, " & "));
  for (const auto& row : table.rows) {
    std::vector<std::string> cells;
    for (std::size_t c = 0; c < row.size(); ++c) {
      cells.push_back(latex_cell(row[c], table.columns[c]));
      if (have_spread[c] && cells.back().find(" & ") == std::string::npos) cells.back() += " &";
    }
    text += fmt::format("{} \\\\\n", fmt::join(cells, " & "));
  }
  const std::string notes = latex_text(fmt::format("{}", fmt::join(table.notes, " ")));
  // A table that is wider than a column takes both, and shrinks down to the size of \\scriptsize if that is too narrow.
  return fmt::format(
      "% Needs \\usepackage{{booktabs,graphicx}}\n\\begingroup{}\n"
      "\\sbox0{{\\begin{{tabular}}{{{}}}\n\\toprule\n{}\\bottomrule\n\\end{{tabular}}}}%\n"
      "\\edef\\wide{{\\ifdim\\wd0>\\columnwidth*\\fi}}%\n"
      "\\csname table\\wide\\endcsname\n\\centering\n\\caption{{{}}}\\label{{tab:{}}}\\smallskip\n"
      "\\ifdim.7\\wd0>\\linewidth\\scalebox{{.7}}{{\\usebox0}}\\else\n"
      "\\ifdim\\wd0>\\linewidth\\resizebox{{\\linewidth}}{{!}}{{\\usebox0}}\\else\\usebox0\\fi\\fi\n{}{}\n"
      "\\csname endtable\\wide\\endcsname\n\\endgroup\n",
      table.rows.size() > 45   ? "\\scriptsize"
      : table.rows.size() > 30 ? "\\footnotesize"
                               : "",
      letters, text, latex_text(table.caption), table.name, notes.empty() ? "" : "\\par\\smallskip\\footnotesize ",
      notes);
}

std::string to_html(const Table& whole) {
  constexpr std::size_t long_text = 20;  // breaks anywhere
  const Table table = for_readers(whole);
  const Rows rows = readable(table, html_text);
  std::vector<std::string_view> classes;
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    classes.push_back(has<Printed>(table, c) ? " class=\"number printed\""
                      : is_text(table, c)    ? ""
                                             : " class=\"number\"");
  const auto cell_of = [&](std::size_t r, std::size_t c) {  // digits align, without the mark
    const auto* const of = r == 0 ? nullptr : std::get_if<Marked>(&table.rows[r - 1][c]);
    std::string text = rows[r][c];
    if (of && !of->mark.empty())
      text.replace(text.size() - of->mark.size() - 1, std::string::npos, fmt::format("<i>{}</i>", html_text(of->mark)));
    return of && of->is_best ? fmt::format("<b>{}</b>", text) : text;
  };
  const auto line = [&](std::size_t r, std::string_view tag) {
    const std::vector<std::string>& row = rows[r];
    std::string text;
    for (std::size_t c = 0; c < row.size(); ++c) {
      const bool is_verdict = tag == "td" && table.columns[c].name == "verdict";
      text += fmt::format(
          "<{}{}>{}</{}>", tag,
          classes[c].empty() && !is_verdict && character_count(row[c]) > long_text ? " class=\"long\"" : classes[c],
          is_verdict ? pill(row[c]) : cell_of(r, c), tag.substr(0, tag.find(' ')));
    }
    return fmt::format("<tr>{}</tr>\n", text);
  };
  std::string text = fmt::format("<table><caption>{}</caption>\n<thead>{}</thead>\n<tbody>\n", html_text(table.caption),
                                 line(0, "th scope=\"col\""));
  for (std::size_t r = 1; r < rows.size(); ++r) text += line(r, "td");
  return text + "</tbody></table>\n";
}

std::string to_text(const Table& whole) {
  const Table table = for_readers(whole);
  constexpr std::size_t longest_first = 60, longest = 200, width = 100;
  Rows rows(1);
  for (const Column& column : table.columns) rows[0].push_back(shortened(column.name, longest));
  for (const auto& cells : table.rows) {
    auto& row = rows.emplace_back();
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const Column& column = table.columns[c];
      const Readable read{number_text, column, column.unit.empty() ? "" : ' ' + column.unit};
      row.push_back(shortened(std::visit(read, cells[c]), c == 0 ? longest_first : longest));
    }
  }
  std::string text = aligned(rows, 3, width);
  for (const std::string& note : table.notes) {
    for (const std::string& line : wrapped(note, "")) text += line + '\n';
  }
  return text;
}

}  // namespace ikbench::show
