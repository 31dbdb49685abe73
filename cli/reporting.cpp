#include "cli/reporting.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "analysis/figures/of_study.hpp"
#include "analysis/judge/data/imported.hpp"
#include "analysis/judge/judge.hpp"
#include "analysis/show/publish.hpp"
#include "analysis/show/result_tables.hpp"
#include "analysis/show/terminal.hpp"
#include "base/embedded_file.hpp"
#include "base/inputs.hpp"
#include "base/json.hpp"
#include "base/names.hpp"
#include "cli/console.hpp"
#include "experiments/environment.hpp"
#include "experiments/stored_checks.hpp"
#include "experiments/study/reader.hpp"
#include "experiments/study/writer.hpp"
#include "results/export.hpp"

namespace ikbench::cli {

namespace {

constexpr EmbeddedFile references[]{
#include "references.inc"
};
constexpr EmbeddedFile styles[]{
#include "styles.inc"
};

using figures::is_meant;

// Before anything is solved; a study may lack a figure that others have.
void refuse_unknown_figures(const std::vector<std::string>& names) {
  std::vector<std::string> all;
  for (const auto& [name, meaning] : show::figure_list()) all.push_back(name);
  for (const std::string& name : names)
    if (std::ranges::none_of(all, [&](const auto& figure) { return is_meant(figure, name) || is_meant(name, figure); }))
      throw std::invalid_argument(unknown_name("figure", name, all));
}

std::vector<std::string> shipped_styles() {
  std::vector<std::string> names;
  for (const EmbeddedFile& style : styles) names.emplace_back(style.stem());
  return names;
}

// The shipped style of this name, else of a file.
std::string style_text(const std::string& name) {
  constexpr std::uintmax_t largest = 100'000;
  if (const EmbeddedFile* const shipped = find_embedded(styles, name)) return std::string(shipped->text);
  if (std::error_code none; !std::filesystem::exists(name, none))
    throw std::invalid_argument(unknown_name("style", name, shipped_styles()) + "; or name a file that is there");
  return text_of_file(name, largest);
}

// Solvers whose program failed in every solve; one that only misses, or declines, did answer.
std::vector<std::string> never_answering(const judge::StudyResults& study) {
  std::vector<std::string> labels;
  for (const std::string& label : study.labels) {
    const auto failed = [](const judge::SolveSummary& solve) {
      return solve.status >= Status::crashed && solve.status <= Status::protocol_error;
    };
    const judge::Solves all = study.of(label);
    if (!all.empty() && std::ranges::all_of(all, failed)) labels.push_back(label);
  }
  return labels;
}

// Says which solvers gave no answer in any solve; returns whether there are such.
bool tell_silent(const judge::StudyResults& solved, bool is_json) {
  const std::vector<std::string> silent = never_answering(solved);
  if (silent.empty()) return false;
  const std::string text =
      fmt::format("{} gave no answer in any solve (crash, time-out or protocol).", base::listed(silent));
  if (is_json)
    print_message(text);
  else
    fmt::print("{}\n", wrapped(text));
  return true;
}

}  // namespace

void add_report_options(const Command& command, ReportArguments& arguments, bool is_of_study) {
  if (is_of_study)
    command.add("--beside", &arguments.beside, "tell also what others did in the same study: libraries, or a store");
  command.add("--figures", &arguments.figures, "draw only these: error,solved; none: draw nothing")
      .separated_by_commas();
  command.add("--style", &arguments.styles,
              "ieee, springer, slide, or a TOML file of keys of [figures], in place of the study's (list figures); "
              "repeat: the last counts");
  add_json_option(command, arguments.is_json);
}

std::string figure_list_text() {
  Rows rows{{"FIGURE", "OF"}};
  for (const auto& [name, meaning] : show::figure_list()) rows.push_back({name, meaning});
  return align_columns(rows) + fmt::format("\nStyles (--style): {}\n", fmt::join(shipped_styles(), ", ")) +
         "\nKeys of [figures] in a study, or of a file (--style FILE)\n" + to_toml(FigureStyle()) +
         "\n[words.FIGURE]  # of a file, with x, y and caption: what its axes and its caption say\n";
}

FigureStyle apply_style(FigureStyle style, const std::vector<std::string>& labels, const ReportArguments& arguments) {
  for (const std::string& name : arguments.styles) read_style_text(style_text(name), name, style);
  std::vector<std::string> named, texts = labels;
  for (const auto& [name, words] : style.words) {
    named.push_back(name);
    for (const auto& [of, text] : words) texts.push_back(text);
  }
  refuse_unknown_figures(named);
  for (const std::string& label : style.solvers)
    if (std::ranges::find(labels, label) == labels.end())
      throw std::invalid_argument(fmt::format("solvers of [figures]: {}", unknown_name("solver", label, labels)));
  if (std::ranges::count(arguments.figures, "none") == 0) {
    refuse_unknown_figures(arguments.figures);
    figures::refuse_missing_font(style, texts);
  }
  return style;
}

std::vector<std::string> labels_of(const StoredStudy& stored) {
  std::vector<std::string> labels;
  for (const Series& series : stored.series) labels.push_back(series.label);
  return labels;
}

std::vector<std::string> citation_keys_of(std::string_view name) {
  std::vector<std::string> keys;
  std::istringstream lines{std::string(references[0].text)};
  for (std::string line, key; std::getline(lines, line);) {
    if (line.starts_with('@')) key = line.substr(line.find('{') + 1, line.find(',') - line.find('{') - 1);
    if (line.find("keywords = ") == std::string::npos) continue;
    std::ranges::replace_if(
        line, [](unsigned char c) { return std::isalnum(c) == 0 && c != '_'; }, ' ');
    if (line.find(fmt::format(" {} ", name)) != std::string::npos) keys.push_back(key);
  }
  return keys;
}

void write_and_print(show::Report reported, const std::filesystem::path& folder, const ReportArguments& arguments,
                     const FigureStyle& style, const std::string& screen) {
  std::set<std::string> names, keys;
  for (const Series& series : reported.study.series)
    names.insert({series.algorithm, reported.study.definition.robot, reported.study.definition.published});
  names.erase("");
  for (const std::string& name : names) std::ranges::copy(citation_keys_of(name), std::inserter(keys, keys.end()));
  reported.citation_keys.assign(keys.begin(), keys.end());
  reported.references = references[0].text;
  std::optional<ProgressBar> bar(std::in_place, "drawing", "figures");
  show::WrittenReport written = show::write_report(
      reported, folder,
      {.only = arguments.figures,
       .progress = [&](std::int64_t done, std::int64_t all) { bar->show({.done = done, .total = all}); },
       .style = style},
      program_name());
  bar.reset();  // leaves its line to the screen
  for (const std::string& warning : written.warnings) warn(warning);
  const auto is_there = [&](const std::string& name) {
    return std::ranges::any_of(written.files, [&](const std::filesystem::path& file) {
      return file.parent_path() == "figures/source" && is_meant(file.stem(), name);
    });
  };
  for (const std::string& name : arguments.figures)
    if (name != "none" && !is_there(name))
      warn(fmt::format("there is nothing to draw for {}; what it is of: ikbench list figures", name));
  if (arguments.is_json) {
    base::OrderedJson json = show::to_json(reported.answer);
    json["files"] = written.files;
    return show_json(json);
  }
  const std::string page = written.page.string();
  fmt::print("{}", printable(screen.empty() ? show::terminal_report(reported.answer, page)
                                            : fmt::format("{}Report: {}\n", screen, page)));
}

bool write_and_announce(const Store& store, const StoredStudy& study, const std::filesystem::path& folder,
                        const ReportArguments& arguments, const std::optional<judge::StudyResults>& beside) {
  const FigureStyle style =
      apply_style(study.definition.figures, labels_of(study), arguments);  // refuses before the study is read
  judge::StudyResults solved = read_and_export(store, study, folder);
  const bool are_silent = tell_silent(solved, arguments.is_json);
  if (beside) judge::add_imported(solved, *beside);
  judge::JudgedStudy judged = judge::judge(std::move(solved));
  const figures::Look look = figures::look_of(judged, style);
  std::vector<figures::Figure> pictures = figures::of_study(judged, look);
  write_and_print(show::make_report(std::move(judged), std::move(pictures)), folder, arguments, look.style);
  return are_silent;
}

bool show_answer(const Store& store, const StoredStudy& study, const std::optional<judge::StudyResults>& beside) {
  judge::StudyResults solved = read_checked(store, study);
  const bool are_silent = tell_silent(solved, true);
  if (beside) judge::add_imported(solved, *beside);
  show_json(show::to_json(show::make_report(judge::judge(std::move(solved)), {}).answer));
  return are_silent;
}

std::optional<judge::StudyResults> imported_results(const StoredStudy& study, const ReportArguments& arguments) {
  if (arguments.beside.empty()) return {};
  judge::StudyResults theirs;
  if (arguments.beside == judge::archive_name) {
    theirs = judge::read_archive(study.definition.robot);
    const std::string lm = fmt::format("[[solvers]]\nsolver = \"{}\"", judge::time_reference_solver);
    Overrides settings = judge::archive_settings();
    settings.push_back("robot=" + study.definition.robot);
    const StoredStudy archive = to_stored(parse_study(lm, arguments.beside, settings));
    theirs.definition = archive.definition;
    for (results::Series& series : theirs.series)
      if (series.algorithm == judge::time_reference_solver) series.options = archive.series.front().options;
  } else {
    const Store store(arguments.beside, Store::Mode::read);
    const std::vector<StoredStudy> named = store.studies(study.name);
    theirs = read_checked(store, named.empty() ? store.study("") : named.front());
    const std::string began = theirs.sessions.empty() ? "" : theirs.sessions.front().began;
    theirs.imported.origin = "in " + arguments.beside +
                             (began.size() < 7 ? "" : fmt::format(", {}/{}", began.substr(5, 2), began.substr(0, 4)));
  }
  judge::require_same_study(theirs, study);
  return theirs;
}

judge::StudyResults read_checked(const Store& store, const StoredStudy& entry, const SolveVisitor& also) {
  judge::StudyResults study =
      judge::read_study(store, entry, [&, check = stored_solve_check(entry)](const SolveRecord& solve) {
        check(solve);
        if (also) also(solve);
      });
  if (study.solves.empty())
    throw std::invalid_argument(
        fmt::format("no solve of {} in the store is by its solvers as they are now; run the study", entry.name));
  return study;
}

judge::StudyResults read_and_export(const Store& store, const StoredStudy& entry, const std::filesystem::path& folder) {
  judge::StudyResults study;
  const auto pass = [&](const SolveVisitor& take) { study = read_checked(store, entry, take); };
  write_file(folder / "solves.csv", [&](const Write& write) {
    write_csv(pass, write, store.extra_names(entry));
    show::reserve_files(folder, {"solves.csv"});  // now that all solves are read, and before it has its name
  });
  return study;
}

}  // namespace ikbench::cli
