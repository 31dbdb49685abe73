#include "analysis/claims/printed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "numerics/number.hpp"
#include "results/published.hpp"

namespace ikbench::claims {

using namespace numerics;
using namespace results;
using namespace statistics;
using namespace inference;

namespace {

Words words_of(const CsvTable& table, std::size_t row) {
  Words words;
  for (std::size_t column = 0; column < table.header.size(); ++column) {
    words[table.header[column]] = table.rows[row][column];
  }
  return words;
}

// A row whose statistics are in columns such as mean_ms.
PrintedRow row_of(const CsvTable& table, std::size_t row, const std::string& name, std::string_view unit) {
  PrintedRow printed{.algorithm = filled(name, words_of(table, row)),
                     .printed = {.n = static_cast<int>(table.number(row, "n"))}};
  for (std::size_t s = 0; s < printed_statistics.size(); ++s) {
    const auto& [statistic, field] = printed_statistics[s];
    const std::string column = fmt::format("{}{}", statistic, unit);
    if (std::ranges::count(table.header, column) == 0) continue;
    printed.printed.*field = table.number(row, column);
    printed.digits[s] = table.rows[row][table.column(column)];
  }
  return printed;
}

// The mantissa of "1.7824e-4", and "e-4".
std::pair<std::string_view, std::string_view> parts_of(std::string_view printed) {
  const std::size_t e = std::min(printed.find_first_of("eE"), printed.size());
  return {printed.substr(0, e), printed.substr(e)};
}

double parsed(std::string_view text) {
  const std::optional<double> number = number_from(text);
  return number ? *number : throw std::runtime_error(fmt::format("'{}' is no number", text));
}

// Digits after the point: 4 of "1.7824e-4".
int decimals_of(std::string_view printed) {
  const std::string_view mantissa = parts_of(printed).first;
  const std::size_t point = mantissa.find('.');
  return point == std::string_view::npos ? 0 : static_cast<int>(mantissa.size() - point - 1);
}

}  // namespace

double half_unit(std::string_view printed) {
  parsed(printed);  // refuses other texts as they are
  return parsed(fmt::format("0.5e-{}", decimals_of(printed))) * parsed(fmt::format("1{}", parts_of(printed).second));
}

bool agrees(double ours, std::string_view printed) {
  constexpr double room = 1 + 1e-9;  // 2.5 printed as 2 is half a unit off, and doubles are not exact
  return std::abs(ours - parsed(printed)) <= half_unit(printed) * room;
}

bool can_be(double low, double high, std::string_view printed) {
  const double number = parsed(printed), half = half_unit(printed);
  return low <= number + half && number - half <= high;
}

CsvTable printed_table(std::string_view paper, std::string_view name) {
  const auto names = published::tables(paper);
  return std::ranges::count(names, name) > 0 ? published::table(paper, name) : CsvTable();
}

std::vector<PrintedRow> printed_rows(std::string_view paper, std::string_view name, Metric metric) {
  std::vector<PrintedRow> rows;
  const CsvTable table = printed_table(paper, name);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    if (table.rows[i][table.column("metric")] == name_of(metric)) rows.push_back(row_of(table, i, "{algorithm}", ""));
  }
  return rows;
}

std::vector<PrintedRow> printed_times(std::string_view paper, std::string_view name, const std::string& row) {
  std::vector<PrintedRow> rows;
  const CsvTable table = printed_table(paper, name);
  for (std::size_t i = 0; i < table.rows.size(); ++i) rows.push_back(row_of(table, i, row, "_ms"));
  return rows;
}

std::optional<AnovaTable> comparable_anova(const StudyResults& study, const std::vector<PrintedRow>& rows,
                                           std::string_view name) {
  std::set<std::string> ours(study.solvers.begin(), study.solvers.end()), theirs;
  for (const PrintedRow& row : rows) theirs.insert(row.algorithm);
  const CsvTable table = printed_table(study.facts.published, name);
  if (study.plan.unit != Unit::run || ours != theirs || table.rows.empty()) return std::nullopt;
  constexpr std::size_t between = 0, within = 1, total = 2;
  AnovaTable printed;
  printed.ss_between = table.number(between, "ss");
  printed.ss_within = table.number(within, "ss");
  printed.ss_total = table.number(total, "ss");
  printed.df = table.number(between, "df");
  printed.df_within = table.number(within, "df");
  printed.ms_between = table.number(between, "ms");
  printed.ms_within = table.number(within, "ms");
  printed.statistic = table.number(between, "f");
  printed.p = table.number(between, "p");
  return printed;
}

std::string filled(const std::string& text, const Words& words) {
  std::string result;
  std::size_t end = 0;
  for (std::size_t open = text.find('{'); open != std::string::npos; open = text.find('{', end)) {
    const std::size_t close = std::min(text.find('}', open), text.size() - 1);
    const std::string name = text.substr(open + 1, close - open - 1);
    const auto found = words.find(name);
    if (found == words.end()) throw std::runtime_error(fmt::format("no column {{{}}}", name));
    result += text.substr(end, open - end) + found->second;
    end = close + 1;
  }
  return result + text.substr(end);
}

}  // namespace ikbench::claims
