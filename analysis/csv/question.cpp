#include "analysis/csv/question.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>

#include "base/names.hpp"
#include "base/number.hpp"

namespace ikbench::csv {
namespace {

using Options = std::vector<std::string>;

constexpr std::size_t most_counted = 1'000'000;  // cells; a question reads all rows of a table with no more cells
constexpr std::size_t few_rows = 1000;           // rows of a larger table that a question reads
constexpr std::size_t most_shown = 15;           // columns
constexpr std::size_t most_labels = 100;
constexpr std::size_t most_answers = 6;
constexpr std::size_t most_crossed = 2;  // columns; combinations of more are too many to be listed

Options joined(Options options, const Options& more) {
  options.insert(options.end(), more.begin(), more.end());
  return options;
}

struct Facts {
  std::size_t column = 0;
  std::size_t different = 0, filled = 0;
  bool has_numbers = false, are_whole = true, is_index = false;
  bool is_each_repeated = true;  // each of the different texts occurs again

  bool may_be_labels(std::size_t rows) const {
    const bool is_repeated = different < filled || rows == 2;  // two rows may be a sketch
    return different > 1 && different <= most_labels && is_repeated && 2 * filled >= rows;
  }
};

class Asking {
 public:
  Asking(const Sheet& sheet, const Request& request, const Known& known)
      : sheet_(sheet),
        request_(request),
        known_(known),
        is_long_(sheet.rows().size() * known.columns.size() > most_counted),
        rows_(std::span(sheet.rows()).first(is_long_ ? few_rows : sheet.rows().size())) {
    for (const std::size_t column : known.columns) facts_.push_back(facts_of(column));
  }

  MissingOption question(std::string_view what) const {
    const std::string counted_in = is_long_ ? fmt::format(" (the first {} are described)", few_rows) : "";
    MissingOption asked(sheet_.said(
        fmt::format("{} It has {}{} with", what, base::counted(std::ssize(sheet_.rows()), "rows"), counted_in)));
    asked.columns = described();
    return asked;
  }

  // Adds the possible answers, given the known labels and values.
  void answer_columns(MissingOption& asked) const {
    const Columns labels = possible_labels(), values = possible_values();
    if (!request_.are_summaries && !known_.label && known_.values.empty() && are_summaries(sheet_) && has_unique_name())
      return answer_by_summaries(sheet_, asked, better());
    Columns wide = known_.values;
    Options wide_options = {"--label", "columns"};
    if (wide.empty()) {
      wide = means();
      for (const std::size_t mean : wide) wide_options = joined(wide_options, {"--value", title(mean)});
    }
    if (wide.empty()) wide = numbers();
    if (!request_.are_summaries && !known_.label && labels.empty() && has_same_units(wide) && wide.size() > 1) {
      for (const Options& answer : answers_of_numbers()) add_answer(asked, {}, answer);
      return add_answers_of_rows(asked, wide_options, {}, wide);
    }
    const bool is_value_known = !known_.values.empty() || values.size() == 1;
    Options value_option;
    if (known_.values.empty()) value_option = {"--value", is_value_known ? title(values[0]) : "VALUE"};
    const Columns& its_values = known_.values.empty() ? values : known_.values;
    if (is_value_known && known_.label) return add_answers_of_rows(asked, value_option, known_.label, its_values);
    if (is_value_known) {
      for (const std::size_t label : labels)
        add_answers_of_rows(asked, joined({"--label", title(label)}, value_option), label, its_values);
      const bool are_few = !asked.answers.empty() && asked.answers.size() <= most_answers;
      if (labels.size() == 1 || (are_few && asked.options.empty())) return;
      asked.answers.clear();
    }
    if (add_answers_of_columns(asked, labels)) return;
    Options label_option;
    if (!known_.label) label_option = {"--label", labels.size() == 1 ? title(labels[0]) : "LABEL"};
    asked.options = joined(joined(label_option, value_option), better());
  }

  // Returns the columns of means, if each column of numbers has means or spreads: "alpha_mean" and "alpha_std".
  Columns means() const {
    Columns means;
    const Columns all = numbers();
    std::set<std::string> titles;
    for (const std::size_t column : all) titles.insert(base::lower_case(title(column)));
    for (const std::size_t column : all) {
      const std::string name = base::lower_case(title(column));
      for (const std::string_view mean : {"mean", "avg", "average"}) {
        if (!name.ends_with(mean)) continue;
        const std::string stem = name.substr(0, name.size() - mean.size());
        for (const char* spread : {"sd", "std", "stddev", "std_dev"})
          if (!stem.empty() && titles.contains(stem + spread)) means.push_back(column);
      }
    }
    return means.size() > 1 && 2 * means.size() == all.size() ? means : Columns();
  }

  void answer_rows(MissingOption& asked) const { add_answers_of_rows(asked, {}, known_.label, known_.values); }

 private:
  Facts facts_of(std::size_t column) const {
    std::unordered_map<std::string_view, std::size_t> counts;
    Facts facts{.column = column, .has_numbers = sheet_.has_numbers(column), .is_index = has(known_.indices, column)};
    for (const std::uint32_t row : rows_) {
      const std::string_view text = sheet_.cell(row, column);
      if (text.empty()) continue;
      ++counts[text];
      ++facts.filled;
      facts.are_whole = facts.are_whole && text.find_first_of(".,eEnN") == std::string_view::npos;
    }
    facts.different = counts.size();
    facts.is_each_repeated = std::ranges::all_of(counts, [](const auto& count) { return count.second > 1; });
    return facts;
  }

  static std::string kind_of(const Facts& facts) {
    if (facts.is_index) return "index";
    if (!facts.has_numbers) return "text";
    return facts.are_whole ? "whole number" : "number";
  }

  // Returns the columns as a table. If there are many columns, those that may be labels or values come first.
  std::vector<Options> described() const {
    std::vector<Options> shown, others;
    for (const Facts& facts : facts_) {
      const bool may_be = facts.different > 1 && (facts.has_numbers || facts.different < rows_.size());
      (may_be || facts_.size() <= most_shown ? shown : others)
          .push_back({"  " + base::shortened(title(facts.column), 30), kind_of(facts),
                      fmt::format("{} different", facts.different),
                      base::shortened(sheet_.cell(sheet_.rows().front(), facts.column), 30)});
    }
    shown.insert(shown.end(), others.begin(), others.end());
    if (shown.size() <= most_shown) return shown;
    shown.resize(most_shown - 1);
    shown.push_back({fmt::format("  and {} more", facts_.size() - shown.size())});
    return shown;
  }

  const std::string& title(std::size_t column) const { return sheet_.titles()[column]; }
  bool is_free(const Facts& facts) const { return !facts.is_index && !has(known_.named, facts.column); }
  bool has_column_row() const { return std::ranges::count(sheet_.titles(), "row") > 0; }

  Columns possible_labels() const {
    Columns labels;
    for (const Facts& facts : facts_)
      if (is_free(facts) && !facts.has_numbers && facts.may_be_labels(rows_.size())) labels.push_back(facts.column);
    return labels;
  }

  // Returns whether one column of texts, or one beside "metric", has no text twice, so that the column names each row.
  bool has_unique_name() const {
    const Column metric = sheet_.column_like({"metric"});
    const Columns metrics = metric ? Columns{*metric} : Columns();
    return std::ranges::any_of(facts_, [&](const Facts& facts) {
      return !facts.has_numbers && facts.column != metric && facts.filled == rows_.size() &&
             are_unique(facts.column, metrics);
    });
  }

  Columns numbers() const {
    Columns numbers;
    for (const Facts& facts : facts_)
      if (is_free(facts) && facts.has_numbers) numbers.push_back(facts.column);
    return numbers;
  }

  // Returns the columns of numbers with decimals if there are several: whole numbers may also name and count.
  Columns possible_values() const {
    const Columns all = numbers();
    Columns decimals;
    for (const Facts& facts : facts_)
      if (has(all, facts.column) && !facts.are_whole && facts.different > 1) decimals.push_back(facts.column);
    return all.size() > 1 && decimals.size() == 1 ? decimals : all;
  }

  bool has_same_units(const Columns& columns) const {
    std::set<std::string> units;
    for (const std::size_t column : columns) units.insert(base::Title(title(column)).unit);
    return units.size() == 1;
  }

  // Adds an answer per possible label and value, if few are possible. Whole commands would be too many, so each answer
  // leads to the question what a row is. Returns whether an answer was added.
  bool add_answers_of_columns(MissingOption& asked, const Columns& labels) const {
    std::vector<Options> of_labels, of_values;
    for (const std::size_t label : known_.label ? Columns() : labels) of_labels.push_back({"--label", title(label)});
    for (const std::size_t value : known_.values.empty() ? varying_values() : Columns())
      of_values.push_back({"--value", title(value)});
    if (known_.label) of_labels = {Options()};
    if (!known_.values.empty()) of_values = {Options()};
    const std::size_t answers = of_labels.size() * of_values.size();
    if (answers == 0 || answers > most_answers) return false;
    asked.answers.clear();
    asked.options.clear();
    for (const Options& label : of_labels)
      for (const Options& value : of_values) add_answer(asked, label, value);
    return true;
  }

  // Returns the columns of numbers that differ from row to row: those with decimals, if there are any.
  Columns varying_values() const {
    Columns varying, decimals;
    const Columns possible = possible_values();
    for (const Facts& facts : facts_) {
      if (!has(possible, facts.column) || facts.different < 2) continue;
      varying.push_back(facts.column);
      if (!facts.are_whole) decimals.push_back(facts.column);
    }
    return decimals.empty() ? varying : decimals;
  }

  // Takes each of two columns of numbers for the labels in turn.
  std::vector<Options> answers_of_numbers() const {
    std::vector<Options> answers;
    const Columns two = numbers();
    if (two.size() != 2 || !known_.values.empty()) return answers;
    for (const Facts& facts : facts_) {
      const bool may_be = facts.are_whole && facts.is_each_repeated && facts.may_be_labels(rows_.size());
      if (!has(two, facts.column) || !may_be) continue;
      const std::size_t value = two[0] == facts.column ? two[1] : two[0];
      answers.push_back({"--label", title(facts.column), "--value", title(value)});
    }
    return answers;
  }

  Options better() const { return request_.better.empty() ? Options{"--better", "smaller"} : Options(); }

  void add_answer(MissingOption& asked, const Options& options, const Options& more) const {
    asked.answers.push_back(joined(joined(options, more), better()));
  }

  // Adds the answers to what a row is, to options that settle labels and values. If `label` is empty, each column is a
  // label.
  void add_answers_of_rows(MissingOption& asked, const Options& options, Column label, const Columns& values) const {
    if (!request_.block.empty() || !request_.run.empty()) return add_answer(asked, options, {});
    if (!label && known_.columns.size() == values.size() + known_.indices.size()) {
      for (const Options& row : {each_row(), Options{"--block", "row"}})
        if (!row.empty() && !(has_column_row() && row[0] == "--block")) add_answer(asked, options, row);
      return;
    }
    Columns others;  // possible blocks and runs
    for (const Facts& facts : facts_) {
      const bool is_taken = facts.column == label || has(values, facts.column) || !is_free(facts);
      const bool has_names = !facts.has_numbers || facts.are_whole;
      if (!is_taken && has_names && facts.different > 1 && facts.filled == rows_.size()) others.push_back(facts.column);
    }
    if (is_long_ || others.size() > most_crossed) {
      asked.options = joined(joined(options, {"--block", "BLOCK", "--run", "RUN"}), better());
      others.clear();
    }
    Columns texts;  // columns that must be the same in all rows of a mean
    for (const Facts& facts : facts_)
      if (is_free(facts) && !facts.has_numbers && facts.column != label) texts.push_back(facts.column);
    for (std::size_t chosen = std::size_t{1} << others.size(); chosen-- > 0;) {  // the most blocks first
      Columns blocks, rest;
      for (std::size_t i = 0; i < others.size(); ++i) ((chosen >> i & 1) != 0 ? blocks : rest).push_back(others[i]);
      for (const Options& row : answers_with(blocks, rest, label, texts)) add_answer(asked, options, row);
    }
  }

  // Returns the options by which each row is one value; empty if a column `row` of the file takes that name.
  Options each_row() const {
    if (!has_column_row()) return {"--run", "row"};
    return known_.indices.empty() ? Options() : Options{"--run", title(known_.indices.front())};
  }

  // Returns the texts of several cells of a row as one.
  std::string key(std::uint32_t row, Column label, const Columns& columns) const {
    std::string text(label ? sheet_.cell(row, *label) : "");
    for (const std::size_t column : columns) text.append(1, '\0').append(sheet_.cell(row, column));
    return text;
  }

  bool are_unique(Column label, const Columns& columns) const {
    std::set<std::string> seen;
    return std::ranges::all_of(rows_, [&](std::uint32_t row) { return seen.insert(key(row, label, columns)).second; });
  }

  // Returns whether most labels have a row in most of these blocks. Otherwise the columns name what only one label has.
  bool are_crossed(Column label, const Columns& blocks) const {
    if (!label) return true;
    std::set<std::string> labels, of_blocks, cells;
    for (const std::uint32_t row : rows_) {
      labels.insert(key(row, label, {}));
      of_blocks.insert(key(row, std::nullopt, blocks));
      cells.insert(key(row, label, blocks));
    }
    return 2 * cells.size() > labels.size() * of_blocks.size();
  }

  // Returns whether no text differs within a mean, except in columns that are named.
  bool are_alike(Column label, const Columns& means, const Columns& named, const Columns& texts) const {
    std::map<std::string, std::string> first;
    Columns others;
    for (const std::size_t text : texts)
      if (!has(means, text) && !has(named, text)) others.push_back(text);
    return std::ranges::all_of(rows_, [&](std::uint32_t row) {
      const std::string mean = key(row, label, means), text = key(row, std::nullopt, others);
      return first.try_emplace(mean, text).first->second == text;
    });
  }

  std::vector<Options> answers_with(const Columns& blocks, const Columns& rest, Column label,
                                    const Columns& texts) const {
    std::vector<Options> answers;
    Options options;
    for (const std::size_t block : blocks) options = joined(options, {"--block", title(block)});
    if (blocks.empty()) {
      for (const std::size_t run : rest)
        if (!are_unique(label, {run}) && are_alike(label, {run}, {}, texts)) answers.push_back({"--run", title(run)});
      if (const Options row = each_row(); !row.empty()) answers.push_back(row);
      return answers;
    }
    if (!are_crossed(label, blocks)) return answers;
    if (are_unique(label, blocks)) {
      answers.push_back(options);
    } else if (!each_row().empty() && are_alike(label, blocks, {}, texts)) {
      answers.push_back(joined(options, each_row()));
    } else {
      for (const std::size_t run : rest)
        if (are_alike(label, blocks, {run}, texts)) answers.push_back(joined(options, {"--run", title(run)}));
    }
    return answers;
  }

  const Sheet& sheet_;
  const Request& request_;
  const Known& known_;
  bool is_long_;
  std::span<const std::uint32_t> rows_;
  std::vector<Facts> facts_;
};

std::string advice_of(const MissingOption& asked, const Request& request, bool is_of_rows) {
  const auto has_option = [&](std::string_view option) { return std::ranges::count(asked.options, option) > 0; };
  std::string advice;
  if (!is_of_rows)
    advice += "--label: column with the names of what is compared, or `columns` if each column of numbers is one. ";
  if (has_option("BLOCK")) advice += "One of --block and --run is enough. ";
  advice +=
      "--block: column of the problem that all of them had. --run: column of repeats, which are averaged; `--run row`: "
      "each row is one repeat. If the rows are of several quantities, choose one: --where COLUMN=VALUE.";
  if (request.better.empty()) advice += " If larger is better: --better larger.";
  return is_of_rows ? advice : advice + " If the table has published means: --summaries.";
}

}  // namespace

bool are_summaries(const Sheet& sheet) {
  const SummaryColumns columns = summary_columns_of(sheet);
  return columns.mean && columns.sd;
}

void answer_by_summaries(const Sheet& sheet, MissingOption& asked, const Options& better) {
  const Options options = joined({"--summaries"}, better);
  if (summary_columns_of(sheet).n)
    asked.answers.push_back(options);
  else
    asked.options = joined(options, {"--n", "N"});
}

bool is_index(const Sheet& sheet, std::size_t column) {
  constexpr std::size_t least = 3;  // rows
  const auto first = base::number_from(sheet.cell(sheet.rows().front(), column));
  if (sheet.rows().size() < least || !first || (*first != 0 && *first != 1)) return false;
  double expected = *first;
  return std::ranges::all_of(
      sheet.rows(), [&](std::uint32_t row) { return base::number_from(sheet.cell(row, column)) == expected++; });
}

void ask_for_columns(const Sheet& sheet, const Request& request, const Known& known) {
  for (const std::size_t column : known.columns)
    if (!has(known.named, column)) sheet.refuse_units(column);
  const Asking asking(sheet, request, known);
  std::vector<std::string> means;
  for (const std::size_t column : asking.means()) means.push_back(in_quotes(sheet.titles()[column]));
  std::string what = "which columns have the labels and the values?";
  if (!means.empty())
    what += fmt::format(" Columns of means stand beside their spreads; compare the means {}.", base::names_of(means));
  MissingOption asked = asking.question(what);
  asking.answer_columns(asked);
  asked.advice = advice_of(asked, request, false);
  throw asked;
}

void ask_for_rows(const Sheet& sheet, const Request& request, const Known& known) {
  const Asking asking(sheet, request, known);
  MissingOption asked = asking.question("what does one row stand for?");
  asking.answer_rows(asked);
  asked.advice = advice_of(asked, request, true);
  throw asked;
}

}  // namespace ikbench::csv
