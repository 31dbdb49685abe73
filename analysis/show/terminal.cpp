#include "analysis/show/terminal.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <utility>

#include "analysis/show/hard_targets.hpp"
#include "analysis/show/headline.hpp"
#include "analysis/show/phrases.hpp"
#include "analysis/show/requirements.hpp"
#include "analysis/show/result_tables.hpp"
#include "analysis/show/text.hpp"
#include "base/names.hpp"

namespace ikbench::show {

using namespace judge;

namespace {

constexpr std::size_t max_rows = 20;  // of a table

// Shortens a table to max_rows - 1 rows: the first ones, with the row of the reference. Returns the line that says how
// many are left out; empty if none are.
std::string shorten_table(Table& table, const std::string& reference) {
  const std::size_t rows = table.rows.size();
  if (rows <= max_rows) return "";
  const auto last = table.rows.begin() + (max_rows - 2);
  const auto is_reference = [&](const auto& row) { return std::get<std::string>(row[0]) == reference; };
  const auto own = std::find_if(last, table.rows.end(), is_reference);
  if (own != table.rows.end()) std::rotate(last, own, own + 1);
  table.rows.resize(max_rows - 1);
  return fmt::format("  and {} more solvers\n", rows - max_rows + 1);
}

// Replaces long names of solvers by short ones.
class NameShortener {
 public:
  explicit NameShortener(const std::vector<std::string>& solvers) : short_names_(base::short_names(solvers)) {}

  std::string text(std::string text) const {
    for (const auto& [name, shorter] : short_names_) {
      if (name == shorter) continue;
      for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + shorter.size()))
        text.replace(at, name.size(), shorter);
    }
    return text;
  }
  std::string table(Table table) const {
    for (auto& row : table.rows)
      for (Cell& cell : row)
        if (auto* const words = std::get_if<std::string>(&cell)) *words = text(*words);
    return to_text(table);
  }

 private:
  std::map<std::string, std::string> short_names_;
};

// Returns the notes below the table of results, and which metrics decide.
std::string notes_text(const Table& table, const ReportModel& model) {
  std::string notes = fmt::format("{}", fmt::join(table.notes, " "));
  const std::string ranking = ranking_note(model);
  if (ranking.empty()) return notes;
  return fmt::format("{}{}{}.", notes, notes.empty() ? "" : " ", ranking);
}

// Returns the warnings. If there is a page, only the first of each kind, and how many more of the kind the page has.
std::string warnings_text(const ReportModel& model, const NameShortener& shortener, bool has_page) {
  std::string text;
  const std::vector<Warning> warnings = model.all_warnings();  // in the order of their kinds
  for (std::size_t i = 0; i < warnings.size(); ++i) {
    const WarningKind kind = warnings[i].kind;
    const bool is_first = i == 0 || warnings[i - 1].kind != kind;
    if (kind == WarningKind::wrong_answers || (has_page && !is_first)) continue;
    const auto alike = std::ranges::count(warnings, kind, &Warning::kind);
    const std::string more = has_page && alike > 1 ? fmt::format("; {} more on the page", alike - 1) : "";
    text += wrapped_paragraph("! " + shortener.text(warning_text(warnings[i])) + more, "  ");
  }
  return text;
}

// Returns the known causes of wrong answers, which stand above the verdict because they make it void.
std::string causes_text(const ReportModel& model, const NameShortener& shortener) {
  std::string text;
  for (const Warning& warning : model.warnings)
    if (warning.kind == WarningKind::wrong_answers)
      text += wrapped_paragraph("! " + shortener.text(warning_text(warning)), "  ");
  return text;
}

}  // namespace

std::string terminal_report(const ReportModel& model, const std::string& page) {
  const NameShortener shortener(model.solvers());
  const std::string reference = reference_of(model);
  Table table = results_table(model, model.direction.empty());
  table.columns[0].name = "";
  const std::string more_solvers = shorten_table(table, reference);
  const std::string notes = notes_text(table, model);
  table.notes.clear();
  std::string text = causes_text(model, shortener);
  text += wrapped_paragraph(shortener.text(headline(model)), "");
  if (model.hard_targets) text += wrapped_paragraph(shortener.text(hard_targets_sentence(*model.hard_targets)), "");
  for (const std::string& sentence : requirement_sentences(model))
    text += wrapped_paragraph(shortener.text(sentence), "  ");
  text += '\n';
  text += shortener.table(std::move(table)) + more_solvers;
  if (!notes.empty()) text += wrapped_paragraph(shortener.text(notes), "");
  if (!model.rejections_text.empty()) text += wrapped_paragraph("! " + shortener.text(model.rejections_text), "  ");
  if (!model.answers_text.empty()) text += wrapped_paragraph(model.answers_text, "");
  for (auto [heading, extra_table] : model.extra_tables) {
    if (extra_table.rows.empty()) continue;
    text += fmt::format("\n{}\n", extra_table.caption);
    const std::string left_out = shorten_table(extra_table, reference);
    text += shortener.table(std::move(extra_table)) + left_out + '\n';
  }
  if (page.empty() && model.primary().comparisons.size() <= max_pairs) {
    Table pairs = tested_pairs_table(model);
    if (!pairs.rows.empty()) text += shortener.table(std::move(pairs));
  }
  text += warnings_text(model, shortener, !page.empty());
  return page.empty() ? text : fmt::format("{}Report: {}\n", text, one_line(page));
}

}  // namespace ikbench::show
