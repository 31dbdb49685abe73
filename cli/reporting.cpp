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
#include "analysis/show/requirements.hpp"
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

// Throws std::invalid_argument for names that no figure of any study has. A name that only other studies have is
// accepted, because the figures of a study are not known before the study is solved.
void refuse_unknown_figures(const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const auto& [name, meaning] : show::figure_list()) known.push_back(name);
  for (const std::string& wanted : names) {
    const auto is_wanted = [&](const std::string& listed) {
      return is_meant(listed, wanted) || is_meant(wanted, listed);
    };
    if (std::ranges::none_of(known, is_wanted)) throw std::invalid_argument(unknown_name("figure", wanted, known));
  }
}

std::vector<std::string> shipped_styles() {
  std::vector<std::string> names;
  for (const EmbeddedFile& style : styles) names.emplace_back(style.stem());
  return names;
}

// Returns the text of the shipped style of this name, otherwise of the file of this name.
std::string style_text(const std::string& name) {
  constexpr std::uintmax_t max_bytes = 100'000;
  if (const EmbeddedFile* const shipped = find_embedded(styles, name)) return std::string(shipped->text);
  if (std::error_code none; !std::filesystem::exists(name, none))
    throw std::invalid_argument(unknown_name("style", name, shipped_styles()) + "; or give the path of a TOML file");
  return text_of_file(name, max_bytes);
}

// Returns the results of the library solvers that are shipped with the program. The archive lacks a definition, so the
// definition of the study is made here.
judge::StudyResults results_of_archive(const std::string& robot) {
  judge::StudyResults results = judge::read_archive(robot);
  const std::string lm = fmt::format("[[solvers]]\nsolver = \"{}\"", judge::time_reference_solver);
  Overrides settings = judge::archive_settings();
  settings.push_back("robot=" + robot);
  const StoredStudy archive = to_stored(parse_study(lm, std::string(judge::archive_name), settings));
  results.definition = archive.definition;
  for (Series& series : results.series)
    if (series.algorithm == judge::time_reference_solver) series.options = archive.series.front().options;
  return results;
}

// Returns the results of the study of this name in another store, or of the first study in that store if no study has
// the name.
judge::StudyResults results_of_store(const std::string& file, const std::string& name) {
  const Store store(file, Store::Mode::read);
  const std::vector<StoredStudy> named = store.studies(name);
  judge::StudyResults results = read_checked(store, named.empty() ? store.study("") : named.front());
  const std::string began = results.sessions.empty() ? "" : results.sessions.front().began;
  const std::string month =
      began.size() < 7 ? "" : fmt::format(", {}/{}", began.substr(5, 2), began.substr(0, 4));  // "2026-11-30 ..."
  results.imported.origin = fmt::format("in {}{}", file, month);
  return results;
}

// Returns the requirements of --require, for these labels of the study.
std::vector<Requirement> requirements_in(const ReportArguments& arguments, const std::vector<std::string>& labels) {
  std::vector<Requirement> requirements;
  for (const std::string& text : arguments.requirements) {
    try {
      requirements.push_back(parse_requirement(text));
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("--require {}", error.what()));
    }
  }
  return for_swept_labels(requirements, labels);
}

}  // namespace

bool print_never_answering(const judge::StudyResults& results, bool is_json) {
  const std::vector<std::string> silent = judge::never_answering(results);
  if (silent.empty()) return false;
  const std::string text =
      fmt::format("{} gave no answer in any solve (crash, timeout or protocol error).", base::listed(silent));
  if (is_json)
    print_message(text);
  else
    fmt::print("{}\n", wrapped(text));
  return true;
}

judge::JudgedStudy judge_with_requirements(judge::StudyResults results, const StoredStudy& study,
                                           const ReportArguments& arguments,
                                           const std::optional<judge::StudyResults>& beside) {
  if (beside) judge::add_imported(results, *beside);
  judge::JudgedStudy judged = judge::judge(std::move(results));
  std::vector<Requirement> requirements = requirements_in(arguments, judged.study.labels);
  if (requirements.empty()) requirements = study.definition.requirements;
  judged.requirements =
      judge::check_requirements(judged, requirements, experiments::own_solvers_of(study), arguments.is_strict);
  return judged;
}

void add_report_options(const Command& command, ReportArguments& arguments, bool is_of_study) {
  if (is_of_study) {
    command.add("--beside", &arguments.beside,
                "add results of the same study: libraries (the archive of libraries), or the path of a store");
    command.add(
        "--require", &arguments.requirements,
        "share that each of your own solvers must show, such as solved=95%, or LABEL.solved=95% for one solver; "
        "repeatable. Exit code 3: one fails; 4 with --strict: one is inconclusive");
    command.add("--strict", &arguments.is_strict, "exit code 4 if a requirement is inconclusive");
  }
  command.add("--figures", &arguments.figures, "draw only these figures: error,solved; none: draw nothing")
      .separated_by_commas();
  command.add("--style", &arguments.styles,
              "style of the figures: ieee, springer, slide, or a TOML file (see ikbench list figures); default: the "
              "study's; repeatable, the last counts");
  add_json_option(command, arguments.is_json);
}

std::string figure_list_text() {
  Rows rows{{"FIGURE", "SHOWS"}};
  for (const auto& [name, meaning] : show::figure_list()) rows.push_back({name, meaning});
  return align_columns(rows) + fmt::format("\nStyles (--style): {}\n", fmt::join(shipped_styles(), ", ")) +
         "\nKeys of [figures] in a study, or in a file for --style\n" + to_toml(FigureStyle()) +
         "\n[words.FIGURE]  # only in a file: x, y and caption are the words of its axes and caption\n";
}

FigureStyle apply_style(FigureStyle style, const std::vector<std::string>& labels, const ReportArguments& arguments) {
  for (const std::string& name : arguments.styles) read_style_text(style_text(name), name, style);
  std::vector<std::string> reworded, texts = labels;
  for (const auto& [figure, words] : style.words) {
    reworded.push_back(figure);
    for (const auto& [axis, text] : words) texts.push_back(text);
  }
  refuse_unknown_figures(reworded);
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

show::WrittenReport write_with_progress(
    const ReportArguments& arguments, const FigureStyle& style,
    const std::function<show::WrittenReport(const figures::RenderOptions& options)>& write) {
  std::optional<ProgressBar> bar(std::in_place, "drawing", "figures");
  show::WrittenReport written =
      write({.only = arguments.figures,
             .progress = [&](std::int64_t done, std::int64_t total) { bar->show({.done = done, .total = total}); },
             .style = style});
  bar.reset();  // clears the line of the bar for the screen
  for (const std::string& warning : written.warnings) warn(warning);
  const auto is_there = [&](const std::string& name) {
    return std::ranges::any_of(written.files, [&](const std::filesystem::path& file) {
      return file.parent_path() == "figures/source" && is_meant(file.stem(), name);
    });
  };
  for (const std::string& name : arguments.figures)
    if (name != "none" && !is_there(name))
      warn(fmt::format("there is nothing to draw for {}; see what it shows: ikbench list figures", name));
  return written;
}

void write_and_print(show::Report report, const std::filesystem::path& folder, const ReportArguments& arguments,
                     const FigureStyle& style, const std::string& screen) {
  std::set<std::string> names, keys;
  for (const Series& series : report.study.series)
    names.insert({series.algorithm, report.study.definition.robot, report.study.definition.published});
  names.erase("");
  for (const std::string& name : names) std::ranges::copy(citation_keys_of(name), std::inserter(keys, keys.end()));
  report.citation_keys.assign(keys.begin(), keys.end());
  report.references = references[0].text;
  const show::WrittenReport written = write_with_progress(arguments, style, [&](const figures::RenderOptions& options) {
    return show::write_report(report, folder, options, program_name());
  });
  if (arguments.is_json) {
    base::OrderedJson json = show::to_json(report.model);
    json["files"] = written.files;
    return show_json(json);
  }
  const std::string page = written.page.string();
  fmt::print("{}", printable(screen.empty() ? show::terminal_report(report.model, page)
                                            : fmt::format("{}Report: {}\n", screen, page)));
}

void refuse_wrong_requirements(const ReportArguments& arguments, const StudySpec& study,
                               const std::vector<std::string>& labels) {
  for (const Requirement& requirement : requirements_in(arguments, labels)) {
    if (!requirement.solver.empty() && std::ranges::count(labels, requirement.solver) == 0)
      throw std::invalid_argument("--require: " + unknown_name("label", requirement.solver, labels));
    if (const std::string lack = lack_of_share(study, requirement.metric); !lack.empty())
      throw std::invalid_argument("--require: " + lack);
  }
}

int write_and_announce(const Store& store, const StoredStudy& study, const std::filesystem::path& folder,
                       const ReportArguments& arguments, const std::optional<judge::StudyResults>& beside) {
  const FigureStyle style =
      apply_style(study.definition.figures, labels_of(study), arguments);  // refuses before the study is read
  refuse_wrong_requirements(arguments, study.definition, labels_of(study));
  judge::StudyResults results = read_and_export(store, study, folder);
  const bool has_silent = print_never_answering(results, arguments.is_json);
  judge::JudgedStudy judged = judge_with_requirements(std::move(results), study, arguments, beside);
  const int code = exit_code(judged.requirements);
  const figures::Look look = figures::look_of(judged, style);
  std::vector<figures::Figure> pictures = figures::of_study(judged, look);
  write_and_print(show::make_report(std::move(judged), std::move(pictures)), folder, arguments, look.style);
  return has_silent ? 3 : code;
}

int show_answer(const Store& store, const StoredStudy& study, const ReportArguments& arguments,
                const std::optional<judge::StudyResults>& beside) {
  judge::StudyResults results = read_checked(store, study);
  const bool has_silent = print_never_answering(results, true);
  judge::JudgedStudy judged = judge_with_requirements(std::move(results), study, arguments, beside);
  const int code = exit_code(judged.requirements);
  show_json(show::to_json(show::make_report(std::move(judged), {}).model));
  return has_silent ? 3 : code;
}

int check_requirements_only(const Store& store, const StoredStudy& study, const ReportArguments& arguments,
                            const std::optional<judge::StudyResults>& beside) {
  judge::StudyResults results = read_checked(store, study);
  const bool has_silent = print_never_answering(results, false);
  judge::JudgedStudy judged = judge_with_requirements(std::move(results), study, arguments, beside);
  const int code = exit_code(judged.requirements);
  for (const std::string& sentence : show::requirement_sentences(show::make_report_model(judged)))
    fmt::print("{}\n", wrapped(printable(sentence)));
  return has_silent ? 3 : code;
}

std::optional<judge::StudyResults> imported_results(const StoredStudy& study, const ReportArguments& arguments) {
  if (arguments.beside.empty()) return {};
  judge::StudyResults imported = arguments.beside == judge::archive_name
                                     ? results_of_archive(study.definition.robot)
                                     : results_of_store(arguments.beside, study.name);
  judge::require_same_study(imported, study);
  return imported;
}

judge::StudyResults read_checked(const Store& store, const StoredStudy& entry, const SolveVisitor& also) {
  judge::StudyResults results =
      judge::read_study(store, entry, [&, check = stored_solve_check(entry)](const SolveRecord& solve) {
        check(solve);
        if (also) also(solve);
      });
  if (results.solves.empty())
    throw std::invalid_argument(fmt::format(
        "the store has no solve of {} by the current versions of its solvers; run the study again", entry.name));
  return results;
}

judge::StudyResults read_and_export(const Store& store, const StoredStudy& entry, const std::filesystem::path& folder) {
  judge::StudyResults results;
  const auto pass = [&](const SolveVisitor& take) { results = read_checked(store, entry, take); };
  write_file(folder / "solves.csv", [&](const Write& write) {
    write_csv(pass, write, store.extra_names(entry));
    show::reserve_files(folder, {"solves.csv"});  // once all solves are read, and before the file gets its name
  });
  return results;
}

}  // namespace ikbench::cli
