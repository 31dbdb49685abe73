#include "analysis/papers/counts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/papers/repeated.hpp"
#include "analysis/show/text.hpp"
#include "base/names.hpp"
#include "base/number.hpp"
#include "results/published.hpp"

namespace ikbench::papers {

namespace {

constexpr double freedoms_of_pose = 6;  // an arm with more joints has infinitely many answers

base::CsvTable printed_counts(const Paper& paper) { return results::published::table(paper.name, paper.counts.table); }

// Returns the names of the programs whose answers the printed table counts, in the order of the table's columns.
std::vector<std::string> printed_programs(const Paper& paper) {
  std::vector<std::string> programs;
  for (const std::string& column : printed_counts(paper).header)
    if (paper.counts.programs.contains(column)) programs.push_back(column);
  return programs;
}

// Returns the range of the counts above 0.
std::string range_text(const std::vector<int>& counts) {
  std::vector<int> answered = counts;
  std::erase(answered, 0);
  if (answered.empty()) return counts.empty() ? "refuses" : "0";
  const auto [least, most] = std::ranges::minmax(answered);
  return least == most ? fmt::to_string(least) : fmt::format("{}-{}", least, most);
}

std::int64_t as_printed_among(const std::vector<CountedArm>& arms) {
  return std::ranges::count_if(arms, &CountedArm::is_as_printed);
}

}  // namespace

CountsByArm read_counts(const base::CsvTable& table, std::string_view source) {
  constexpr double most = 10'000;
  CountsByArm counts;
  for (std::size_t column = 1; column < table.header.size(); ++column) {
    std::vector<int>& of_arm = counts[table.header[column]];
    for (std::size_t row = 0; row < table.rows(); ++row) {
      const std::string_view cell = table.cell(row, column);
      if (cell.empty()) continue;
      const double count = base::number_from(cell).value_or(-1);
      if (!(0 <= count && count <= most) || count != std::floor(count))
        throw std::invalid_argument(fmt::format("{}:{}: {} is \"{}\"; expected a number of answers from 0 to {}",
                                                source, table.line(row), table.header[column], cell, most));
      of_arm.push_back(static_cast<int>(count));
    }
    if (!of_arm.empty() && of_arm.size() != table.rows())
      throw std::invalid_argument(fmt::format("{}: {} has {} for {} poses; expected one per pose, or none", source,
                                              table.header[column], base::counted(std::ssize(of_arm), "numbers"),
                                              table.rows()));
  }
  return counts;
}

std::map<std::string, CountsByArm> stored_counts(const Paper& paper) {
  std::map<std::string, CountsByArm> counts;
  for (const auto& [program, words] : paper.counts.programs)
    counts[program] = read_counts(results::published::table(paper.name, program), program);
  return counts;
}

std::vector<CountedArm> counted_arms(const Repeated& repeated, const std::string& program, const std::string& column) {
  const base::CsvTable table = printed_counts(repeated.paper);
  const auto counts = repeated.counts.find(program);
  std::vector<CountedArm> arms;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string arm(table.cell(row, 0)), printed(table.cell(row, table.column(column)));
    if (printed.empty() || counts == repeated.counts.end() || !counts->second.contains(arm)) continue;
    const std::vector<int>& ours = counts->second.at(arm);
    arms.push_back({.arm = arm,
                    .printed = printed,
                    .ours = range_text(ours),
                    .poses = static_cast<int>(ours.size()),
                    .unanswered = static_cast<int>(std::ranges::count(ours, 0))});
  }
  return arms;
}

std::vector<std::string> counts_sentences(const Repeated& repeated) {
  const std::map<std::string, std::string>& reasons = repeated.paper.counts.reasons;
  std::vector<std::string> counted, sentences;
  for (const std::string& program : printed_programs(repeated.paper)) {
    const std::vector<CountedArm> arms = counted_arms(repeated, program, program);
    counted.push_back(
        fmt::format("{} of {}{} of {}", as_printed_among(arms), arms.size(), counted.empty() ? " rows" : "", program));
    std::map<std::string, std::vector<std::string>> different;  // arms by reason
    for (const CountedArm& arm : arms) {
      const auto reason = reasons.find(arm.arm);
      if (!arm.is_as_printed())
        different[reason == reasons.end() ? "no reason is known" : reason->second].push_back(arm.arm);
    }
    for (const auto& [reason, names] : different)
      sentences.push_back(fmt::format("{} differs on {}: {}.", program, show::listed(names), reason));
  }
  sentences.insert(sentences.begin(), fmt::format("{} are the published ones.", show::listed(counted)));
  sentences.push_back(repeated.paper.counts.note);
  return sentences;
}

show::Table counts_table(const Repeated& repeated) {
  const base::CsvTable printed = printed_counts(repeated.paper);
  const std::vector<std::string> programs = printed_programs(repeated.paper);
  show::Table table{.name = repeated.paper.counts.table, .columns = {{"arm"}, {"joints"}}, .is_of_study = false};
  for (std::size_t row = 0; row < printed.rows(); ++row) {
    const std::string joints(printed.cell(row, printed.column("joints")));
    const bool is_redundant = printed.number(row, "joints") > freedoms_of_pose;
    table.rows.push_back({std::string(printed.cell(row, 0)), joints + (is_redundant ? " (samples)" : "")});
  }
  std::vector<std::string> different(printed.rows());
  int poses = 0;
  for (const std::string& program : programs) {
    table.columns.push_back({program});
    table.columns.push_back({program + " printed"});
    const std::vector<CountedArm> arms = counted_arms(repeated, program, program);
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      const auto arm = std::ranges::find(arms, std::get<std::string>(table.rows[row][0]), &CountedArm::arm);
      const bool is_there = arm != arms.end();
      table.rows[row].push_back(is_there ? show::Cell(arm->ours) : show::Cell());
      table.rows[row].push_back(is_there ? show::Cell(arm->printed) : show::Cell());
      if (!is_there) continue;
      poses = std::max(poses, arm->poses);
      if (!arm->is_as_printed()) different[row] += (different[row].empty() ? "not " : ", ") + program;
    }
  }
  table.columns.push_back({"as printed"});
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    table.rows[row].emplace_back(different[row].empty() ? "yes" : different[row]);
  table.caption = fmt::format("Answers per pose, ours and printed: least and largest of {} poses", poses);
  return table;
}

}  // namespace ikbench::papers
