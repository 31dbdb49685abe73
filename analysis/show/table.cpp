#include "analysis/show/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "analysis/show/text.hpp"
#include "base/csv.hpp"
#include "base/json.hpp"
#include "base/number.hpp"

namespace ikbench::show {

using Json = base::OrderedJson;

namespace {

using Rows = std::vector<std::vector<std::string>>;
using Escape = std::string (*)(std::string_view);
using Number = std::string (*)(double, int digits);

// A cell for readers.
struct Readable {
  Number number;
  const Column& column;
  std::string at_most = "≤ ", dash = "-", plus_minus = "± ",
              unit = column.unit_of_cells.empty() ? "" : ' ' + column.unit_of_cells;

  std::string operator()(std::monostate) const { return "-"; }
  std::string operator()(const Absent&) const { return "-"; }
  std::string operator()(const Judgement& judgement) const { return judgement.words; }
  std::string operator()(const std::string& text) const { return text; }
  std::string operator()(std::int64_t count) const { return fmt::to_string(count) + unit; }
  std::string operator()(double value) const {
    const std::string text =
        column.role == Role::p ? p_text(value, column.ends) : number(value, digits_apart(value, column.ends));
    return text == "-" ? text : text + unit;
  }
  std::string operator()(const judge::Interval& interval) const {
    return interval_text(interval, number, column.ends) + unit;
  }
  std::string operator()(const Printed& printed) const {
    return printed.printed + (printed.sign.empty() ? "" : ' ' + printed.sign);
  }
  std::string operator()(const Marked& marked) const {
    const auto digits = [](double size, double small) { return std::abs(size) < small ? 3 : 2; };
    std::string text = marked.words.empty() ? (marked.is_bound ? at_most : "") + (*this)(marked.value) : marked.words;
    if (marked.to_reference == judge::Scale::ratio)
      text = number(marked.value, digits(marked.value - 1, 0.1)) + " times";
    if (marked.to_reference == judge::Scale::difference && marked.value > 0) text.insert(0, "+");
    if (const std::string around = spread(marked); !around.empty()) text += ' ' + around;
    return text + (marked.mark.empty() ? "" : ' ' + marked.mark);
  }
  // "(98-100)" or "± 0.2", of a marked number.
  std::string spread(const Marked& marked) const {
    if (marked.sd) return plus_minus + number(*marked.sd, 2);
    if (!marked.interval) return "";
    const judge::Interval& its = *marked.interval;
    const int wide = std::abs(its.high - its.low) < 3 ? 3 : 2;
    return fmt::format("({}{}{})", number(its.low, wide), its.low < 0 ? " to " : dash, number(its.high, wide));
  }
};

bool excludes_end(const Cell& cell) {
  const auto* interval = std::get_if<judge::Interval>(&cell);
  return interval && (interval->excludes_low || interval->excludes_high);
}

// Of which kinds the cells of a column are: what files of numbers have columns for.
struct Kinds {
  bool texts = false, intervals = false, excluded = false, printed = false;
  bool long_texts = false;
  bool ratios = false, differences = false, spreads = false, deviations = false, marks = false,
       best = false;  // of Marked
};
std::vector<Kinds> kinds_of(const Table& table) {
  std::vector<Kinds> kinds(table.columns.size());
  for (std::size_t c = 0; c < kinds.size(); ++c)
    kinds[c].intervals = kinds[c].excluded = table.columns[c].role == Role::interval;
  for (const auto& row : table.rows) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      const Marked its = std::holds_alternative<Marked>(row[c]) ? std::get<Marked>(row[c]) : Marked{};
      const auto* const judgement = std::get_if<Judgement>(&row[c]);
      const auto* const text = judgement ? &judgement->words : std::get_if<std::string>(&row[c]);
      kinds[c].texts |= text != nullptr;
      kinds[c].long_texts |= text != nullptr && character_count(*text) > 60;
      kinds[c].intervals |= std::holds_alternative<judge::Interval>(row[c]);
      kinds[c].excluded |= excludes_end(row[c]);
      kinds[c].printed |= std::holds_alternative<Printed>(row[c]);
      kinds[c].ratios |= its.to_reference == judge::Scale::ratio;
      kinds[c].differences |= its.to_reference == judge::Scale::difference;
      kinds[c].spreads |= its.interval.has_value();
      kinds[c].deviations |= its.sd.has_value();
      kinds[c].marks |= !its.mark.empty();
      kinds[c].best |= its.is_best;
    }
  }
  return kinds;
}

std::string head(const Column& column) {
  return column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit);
}

// Readers see printed numbers in a column of their own, no column that is empty in every row, and where some cells are
// ratios, the unit at the other numbers.
Table for_readers(Table table) {
  const std::vector<Kinds> kinds = kinds_of(table);
  for (std::size_t c = table.columns.size(); c-- > 0;) {
    if (kinds[c].ratios) table.columns[c].unit_of_cells = std::exchange(table.columns[c].unit, "");
    if (kinds[c].printed) {
      const auto next = static_cast<std::ptrdiff_t>(c + 1);
      table.columns.insert(table.columns.begin() + next, {"printed"});
      for (auto& row : table.rows) {
        const bool is_printed = std::holds_alternative<Printed>(row[c]);
        const Cell ours = is_printed ? Cell(std::get<Printed>(row[c]).ours) : row[c];
        row.insert(row.begin() + next, is_printed ? row[c] : Cell());
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
      row.push_back(escape(std::visit(Readable{number_text, table.columns[c]}, cells[c])));
  }
  return rows;
}

constexpr std::string_view its_times = "times", its_mark = "mark";  // have no unit

// The members of a cell in files of numbers, with the words that follow the name of its column.
std::vector<std::pair<std::string_view, Json>> members(const Kinds& kinds, const Cell& cell) {
  const auto* const printed = std::get_if<Printed>(&cell);
  const auto* const marked = std::get_if<Marked>(&cell);
  const auto* const interval = std::get_if<judge::Interval>(&cell);
  const auto* const spread = interval ? interval : marked && marked->interval ? &*marked->interval : nullptr;
  const auto to_reference = [&](judge::Scale scale) {
    return marked && marked->to_reference == scale ? base::json_of(marked->value) : Json();
  };
  Json value;
  if (const auto* text = std::get_if<std::string>(&cell)) value = *text;
  if (const auto* judgement = std::get_if<Judgement>(&cell)) value = judgement->words;
  if (const auto* count = std::get_if<std::int64_t>(&cell)) value = *count;
  if (const auto* plain = std::get_if<double>(&cell)) value = base::json_of(*plain);
  if (printed) value = base::json_of(printed->ours);
  if (marked && !marked->to_reference) value = base::json_of(marked->value);
  std::vector<std::pair<std::string_view, Json>> all;
  if (!kinds.intervals) all.emplace_back("", value);
  if (kinds.printed) all.emplace_back("printed", printed ? Json(printed->printed) : Json());
  if (kinds.ratios) all.emplace_back(its_times, to_reference(judge::Scale::ratio));
  if (kinds.differences) all.emplace_back("difference", to_reference(judge::Scale::difference));
  if (kinds.intervals || kinds.spreads) {
    all.emplace_back("low", spread ? base::json_of(spread->low) : Json());
    all.emplace_back("high", spread ? base::json_of(spread->high) : Json());
  }
  if (kinds.deviations) all.emplace_back("sd", marked && marked->sd ? base::json_of(*marked->sd) : Json());
  if (kinds.excluded)
    all.emplace_back("excluded", !excludes_end(cell) ? Json() : interval->excludes_low ? "low" : "high");
  if (kinds.marks) all.emplace_back(its_mark, marked && !marked->mark.empty() ? Json(marked->mark) : Json());
  return all;
}

// "error low", but "low" alone of a column that has nothing else.
std::string member_name(const Column& column, std::string_view member) {
  if (member.empty()) return column.name;
  return column.role == Role::interval ? std::string(member) : fmt::format("{} {}", column.name, member);
}

// -1.2e-05 as $-1.2 \times 10^{-5}$, which no escaping may touch.
std::string latex_number(double value, int digits) {
  const std::string text = number_text(value, digits);
  if (text.find('e') != std::string::npos) return latex_text(text);
  return text.size() > 1 && text[0] == '-' ? fmt::format("${}$", text) : text;
}

std::string latex_cell(const Cell& cell, const Column& column) {
  const Readable read{latex_number, column, "$\\le$ ", "--", "$\\pm$ "};
  if (std::holds_alternative<std::string>(cell) || std::holds_alternative<Printed>(cell) ||
      std::holds_alternative<Judgement>(cell))
    return latex_text(std::visit(read, cell));
  if (const auto* marked = std::get_if<Marked>(&cell)) {
    std::string text = read(Marked{.value = marked->value,
                                   .is_bound = marked->is_bound,
                                   .to_reference = marked->to_reference,
                                   .words = latex_text(marked->words)});
    if (marked->is_best) text = fmt::format("{{\\boldmath\\textbf{{{}}}}}", text);
    if (const std::string around = read.spread(*marked); !around.empty())
      text += fmt::format(" & {{\\scriptsize {}}}", around);
    if (!marked->mark.empty())
      text += fmt::format("\\rlap{{\\,\\scriptsize {}}}", latex_text(marked->mark));  // digits align
    return text;
  }
  if (const auto* p = std::get_if<double>(&cell); p && column.role == Role::p && *p < 0.0001) return "$<$ 0.0001";
  return std::visit(read, cell);
}

}  // namespace

std::vector<Column> columns_of(const std::vector<std::string>& names) {
  std::vector<Column> columns;
  for (const std::string& name : names) columns.push_back({name});
  return columns;
}

std::string interval_text(const judge::Interval& interval, Number number, const Ends& ends) {
  const auto end = [&](double value) { return std::isinf(value) ? "no bound" : number(value, 3); };
  // Of an end so near that three digits do not tell it, what was read.
  const auto read = [&](double value) {
    const double shown = base::number_from(number_text(value)).value_or(value);
    return std::ranges::count(ends, shown) > 0 ? shown : value;
  };
  return fmt::format("{}{} to {}{}", interval.excludes_low || interval.low > read(interval.low) ? "above " : "",
                     end(interval.low), interval.excludes_high || interval.high < read(interval.high) ? "below " : "",
                     end(interval.high));
}

std::string to_csv(const Table& table) {
  const std::vector<Kinds> kinds = kinds_of(table);
  std::string text;
  std::vector<std::string> heads;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const Column& column = table.columns[c];
    const std::string unit = column.unit.empty() ? "" : fmt::format(" [{}]", column.unit);
    for (const auto& [member, value] : members(kinds[c], {}))
      heads.push_back(member_name(column, member) + (member == its_times || member == its_mark ? "" : unit));
  }
  base::append_csv_row(text, heads);
  for (const auto& row : table.rows) {
    std::vector<std::string> cells;
    for (std::size_t c = 0; c < row.size(); ++c) {
      for (const auto& [member, value] : members(kinds[c], row[c]))
        cells.push_back(value.is_null() ? "" : value.is_string() ? value.get<std::string>() : value.dump());
    }
    base::append_csv_row(text, cells);
  }
  return text;
}

Json to_json(const Table& table) {
  const std::vector<Kinds> kinds = kinds_of(table);
  Json rows = Json::array();
  for (const auto& row : table.rows) {
    Json object = Json::object();
    for (std::size_t c = 0; c < row.size(); ++c) {
      for (const auto& [member, value] : members(kinds[c], row[c])) {
        std::string name = member_name(table.columns[c], member);
        for (char& letter : name) letter = letter == ' ' ? '_' : static_cast<char>(std::tolower(letter));
        object[name] = value;
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
    for (const Kinds& its : kinds_of(table)) text += its.texts ? "|---" : "|--:";
    text += "|\n";
  }
  for (const std::string& note : table.notes) text += fmt::format("\n{}\n", markdown_text(note));
  return text;
}

std::string to_latex(const Table& whole) {
  Table table = for_readers(whole);
  for (Column& column : table.columns) column.unit_of_cells = latex_text(column.unit_of_cells);
  std::string letters;
  std::vector<std::string> heads;
  const auto has_spreads = [](const Kinds& its) { return its.spreads || its.deviations; };
  const std::vector<Kinds> kinds = kinds_of(table);  // spreads have a column of their own, so that the numbers align
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    letters += kinds[c].long_texts ? "p{5cm}" : kinds[c].texts ? "l" : has_spreads(kinds[c]) ? "r@{ }l" : "r";
    const std::string room = kinds[c].marks ? "@{\\hspace{14pt}}" : "";  // for them
    const std::string name = latex_text(head(table.columns[c]));
    letters += room;
    heads.push_back(has_spreads(kinds[c]) ? fmt::format("\\multicolumn{{2}}{{c{}}}{{{}}}", room, name) : name);
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
      if (kinds[c].long_texts) cells.back() = "\\raggedright\\let\\\\\\tabularnewline " + cells.back();
      if (has_spreads(kinds[c]) && cells.back().find(" & ") == std::string::npos) cells.back() += " &";
    }
    rows[r * parts / table.rows.size()] += fmt::format("{} \\\\\n", fmt::join(cells, " & "));
  }
  if (std::ranges::any_of(kinds, &Kinds::best)) table.notes.emplace_back("Bold: none is shown to be better.");
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
  const std::vector<Kinds> kinds = kinds_of(table);
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
  const auto line = [&](std::size_t r, std::string_view tag) {
    const std::vector<std::string>& row = rows[r];
    std::string text;
    for (std::size_t c = 0; c < row.size(); ++c) {
      const bool is_judgement = r > 0 && std::holds_alternative<Judgement>(table.rows[r - 1][c]);
      text += fmt::format("<{}{}>{}</{}>", tag,
                          kinds[c].printed                                       ? " class=\"number printed\""
                          : !kinds[c].texts                                      ? " class=\"number\""
                          : !is_judgement && character_count(row[c]) > long_text ? " class=\"long\""
                                                                                 : "",
                          cell_of(r, c), tag.substr(0, tag.find(' ')));
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
