#include "analysis/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "analysis/files.hpp"
#include "analysis/limits_table.hpp"
#include "analysis/paper_figures.hpp"
#include "analysis/paper_tables.hpp"
#include "analysis/provenance.hpp"
#include "analysis/summary.hpp"
#include "analysis/text.hpp"
#include "results/published.hpp"

namespace ikbench {
namespace {

// The tables and figures of a report, by name, as Markdown.
class Pieces {
 public:
  void add(const Table& table) { markdown_[table.name] = to_markdown(table) + '\n'; }

  void add(const Figure& figure, bool rendered) {
    const std::string caption = markdown_text(figure.caption);
    const auto link = [&](std::string_view type) { return fmt::format("[{0}](figures/{1}.{0})", type, figure.name); };
    std::string& text = markdown_[figure.name];
    text = fmt::format("**{}**\n\n", markdown_text(title_of(figure)));
    if (rendered) {
      text += fmt::format("![{0}](figures/{1}.png)\n\n{0} ({2}, {3}; {4}, {5})\n\n", caption, figure.name, link("svg"),
                          link("pdf"), link("gp"), link("dat"));
    } else {
      text += fmt::format("{} Not drawn; gnuplot draws it from {} and {}.\n\n", caption, link("gp"), link("dat"));
    }
  }

  // All whose name begins so, in the order of their names; nothing where there are none.
  std::string starting(std::string_view prefix) const {
    std::string text;
    for (const auto& [name, markdown] : markdown_) {
      if (name.starts_with(prefix)) text += markdown;
    }
    return text;
  }
  std::string named(const std::string& name) const {
    const auto found = markdown_.find(name);
    return found == markdown_.end() ? "" : found->second;
  }

 private:
  // figure-9-a is Figure 9 a.
  static std::string title_of(const Figure& figure) {
    std::string title = figure.name;
    std::ranges::replace(title, '-', ' ');
    title[0] = 'F';
    return title;
  }

  // By length, then by letter: figure-9-z before figure-9-aa.
  struct InOrder {
    bool operator()(const std::string& a, const std::string& b) const {
      return a.size() != b.size() ? a.size() < b.size() : a < b;
    }
  };
  std::map<std::string, std::string, InOrder> markdown_;
};

std::string bullets(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) text += fmt::format("- {}\n", markdown_text(sentence));
  return text + '\n';
}

// Other studies of the store that were given the same targets, after the reported one.
std::vector<StudyResults> with_same_targets(const Store& store, const StudyResults& study) {
  std::vector<StudyResults> result{study};
  for (const StudyEntry& entry : store.studies()) {
    if (entry.name == study.name) continue;
    StudyResults other = make_study(entry, store.solves(entry.name));
    if (same_targets(study, other)) result.push_back(std::move(other));
  }
  return result;
}

std::vector<std::string> warnings_of(const StudyResults& study, const std::vector<FigureOutcome>& outcomes) {
  std::vector<std::string> warnings;
  const auto papers = published::papers();
  if (!study.published.empty() && std::ranges::find(papers, study.published) == papers.end()) {
    warnings.push_back(fmt::format("no published tables of '{}' to compare with; there are: {}", study.published,
                                   fmt::join(papers, ", ")));
  }
  for (const SolverCounts& count : counts(study)) {
    if (count.solves >= count.expected) continue;
    warnings.push_back(
        fmt::format("{}: {} of {} solves are there", one_line(count.solver), count.solves, count.expected));
  }
  if (std::string note = timing_note(study); !note.empty()) warnings.push_back(std::move(note));
  // The same message for many figures is one warning.
  std::vector<std::pair<std::string, std::string>> failures;
  for (const FigureOutcome& outcome : outcomes) {
    if (outcome.error.empty()) continue;
    const auto same = std::ranges::find(failures, outcome.error, &std::pair<std::string, std::string>::first);
    if (same != failures.end()) {
      same->second += ", " + outcome.name;
    } else {
      failures.emplace_back(outcome.error, outcome.name);
    }
  }
  for (const auto& [error, names] : failures) warnings.push_back(fmt::format("not drawn: {}: {}", names, error));
  return warnings;
}

}  // namespace

void write_table(const Table& table, const std::filesystem::path& folder) {
  write_file(folder / (table.name + ".md"), to_markdown(table));
  write_file(folder / (table.name + ".csv"), to_csv(table));
  write_file(folder / (table.name + ".tex"), to_latex(table));
}

Report write_report(const Store& store, const ReportRequest& request) {
  const StudyEntry entry = store.study(request.study);
  const StudyResults study = make_study(entry, store.solves(request.study));

  const std::vector<Session> sessions = store.sessions();
  std::vector<Table> tables{definition_table(entry), options_table(entry), environment_table(study, sessions)};
  for (Table& table : paper_tables(study, request.unit)) tables.push_back(std::move(table));
  const std::vector<StudyResults> together = with_same_targets(store, study);
  if (together.size() > 1) tables.push_back(perspective_table(together, request.unit));
  if (std::optional<Table> table = limits_table(together, request.unit)) tables.push_back(std::move(*table));
  Pieces pieces;
  for (const Table& table : tables) {
    write_table(table, request.folder / "tables");
    pieces.add(table);
  }

  const std::vector<Figure> figures = paper_figures(study, request.unit, request.quartiles);
  const std::vector<FigureOutcome> outcomes = write_figures(figures, request.folder / "figures", request.figures);
  for (std::size_t i = 0; i < figures.size(); ++i) pieces.add(figures[i], outcomes[i].rendered);

  Report report{.file = request.folder / "report.md",
                .results = *std::ranges::find(tables, "table-3", &Table::name),
                .summary = summary(study, request.unit),
                .warnings = warnings_of(study, outcomes)};
  for (std::size_t i = 1; i < together.size(); ++i) report.summary.push_back(perspective(together[i], request.unit));
  std::string text = fmt::format("# {}\n\n", markdown_text(study.title.empty() ? study.name : study.title));
  text += fmt::format("Report of the study {}.\n\n## Summary\n\n", markdown_text(study.name));
  text += bullets(report.summary);
  if (!report.warnings.empty()) text += "### Warnings\n\n" + bullets(report.warnings);
  if (const std::string command = command_of(study, sessions); !command.empty()) {
    text += fmt::format("To get these numbers again:\n\n    {}\n\n", one_line(command));
  }
  text +=
      "Every table is in `tables/` as Markdown, CSV (all digits) and LaTeX; every figure in `figures/` as SVG, PDF and "
      "PNG, with the script and the data it is drawn from.\n\n";
  text += "## What was run\n\n" + pieces.named("definition") + pieces.named("options");
  text += "## Where it was run\n\n" + pieces.named("environment");
  text += "## What became of every solve\n\n" + pieces.named("status");
  text += "## Results\n\n" + pieces.named("figure-5") + pieces.named("table-3") + pieces.named("table-3-as-printed");
  for (const char* name : {"figure-6", "figure-7", "figure-8"}) text += pieces.named(name);
  text += pieces.starting("figure-9-");
  text += "## Analysis of variance\n\n";
  for (const char* name :
       {"figure-10", "figure-11", "figure-12", "table-4", "table-5", "table-6", "anova-from-printed-table-3"}) {
    text += pieces.named(name);
  }
  if (const std::string time = pieces.named("table-7"); !time.empty()) text += "## Computing time\n\n" + time;
  if (const std::string circle = pieces.named("figure-14"); !circle.empty()) {
    text += "## Circle\n\n" + pieces.named("table-8") + circle;
    for (const char* name : {"figure-15", "figure-16", "figure-17", "figure-18"}) text += pieces.named(name);
  }
  if (const std::string limits = pieces.named("limits"); !limits.empty()) text += "## Joint limits\n\n" + limits;
  if (together.size() > 1) text += "## Perspective\n\n" + pieces.named("perspective");
  write_file(report.file, text);
  return report;
}

}  // namespace ikbench
