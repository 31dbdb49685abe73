#include "cli/reporting.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <thread>

#include "analysis/figures/of_study.hpp"
#include "analysis/judge/judge.hpp"
#include "analysis/papers/paper.hpp"
#include "base/embedded_file.hpp"
#include "base/inputs.hpp"
#include "base/names.hpp"
#include "base/number.hpp"
#include "cli/console.hpp"
#include "experiments/environment.hpp"
#include "experiments/study_reader.hpp"
#include "experiments/study_writer.hpp"
#include "results/export.hpp"
#include "results/merge.hpp"

namespace ikbench::cli {

using namespace base;
using namespace results;
using namespace experiments;

namespace {

constexpr EmbeddedFile references[]{
#include "references.inc"
};
constexpr EmbeddedFile styles[]{
#include "styles.inc"
};

// Explains why solves that look done are made anew.
void warn_of_left_aside(const StoredStudy& study, const Store& store) {
  const LeftAside aside = left_aside(study, store);
  if (aside.solves == 0) return;
  warn(fmt::format(
      "another version of {} or of shared code made {}; the store keeps them, and this run solves those points again",
      fmt::join(aside.labels, ", "), counted(aside.solves, "solves")));
}

// Warns if somebody else has the store open, so that it is more than one file.
void tell_of_log(const std::vector<std::filesystem::path>& files) {
  if (files.size() < 2) return;
  warn(fmt::format(
      "another program has {0} open, so part of the data is still in {1}; copy both files together, or close "
      "that program and run this command again to merge them",
      files[0].string(), files[1].string()));
}

void warn_of_unreachable(const Study& study) {
  const std::vector<Unreachable> beyond = unreachable(study);
  if (beyond.empty()) return;
  const Unreachable& first = beyond.front();
  warn(fmt::format(
      "{} of a run are out of reach; point {} is {:.2f} cm from the shoulder, and the arm reaches {:.2f} cm",
      counted(std::ssize(beyond), "points"), first.point, first.distance * 100, first.reach * 100));
}

bool is_meant(const std::string& figure, const std::string& name) {
  return figure == name || figure.starts_with(name + "-");
}

// Before anything is solved; a study may lack a figure that others have.
void refuse_unknown_figures(const std::vector<std::string>& names) {
  std::vector<std::string> all;
  for (const auto& [name, meaning] : show::all_figures()) all.push_back(name);
  for (const std::string& name : names) {
    if (std::ranges::none_of(all, [&](const auto& figure) { return is_meant(figure, name) || is_meant(name, figure); }))
      throw std::invalid_argument(unknown_name("figure", name, all));
  }
}

// Leaves the figures of these names or first words: "error" is error-boxes and error-by-point.
void choose_figures(show::Report& reported, const std::vector<std::string>& names) {
  std::set<std::string> lacking(names.begin(), names.end());
  const auto is_left_out = [&](const figures::Figure& figure) {
    std::erase_if(lacking, [&](const std::string& name) { return is_meant(figure.name, name); });
    return std::ranges::none_of(names, [&](const std::string& name) { return is_meant(figure.name, name); });
  };
  std::erase_if(reported.figures, is_left_out);
  for (show::Blocks& blocks : reported.additions) {
    std::erase_if(blocks, [&](const show::Block& block) {
      const auto* const figure = std::get_if<figures::Figure>(&block);
      return figure != nullptr && is_left_out(*figure);
    });
  }
  const auto kinds = show::all_figures();
  for (const std::string& name : lacking) {
    const auto kind = std::ranges::find_if(
        kinds, [&](const auto& each) { return is_meant(each.first, name) || is_meant(name, each.first); });
    warn(fmt::format("there is nothing to draw for {}: it is {}", name, kind->second));
  }
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

bool are_drawn(const std::vector<std::string>& names) { return std::ranges::find(names, "none") == names.end(); }

// The door of these numbers: a run with an answer that is not finite is lost.
judge::Group group_of(const std::vector<double>& runs) {
  std::vector<double> finite = runs;
  const auto lost = static_cast<int>(std::erase_if(finite, [](double value) { return !std::isfinite(value); }));
  if (lost > 0) return {.sample = judge::Untold{.lost = lost, .values = std::move(finite)}};
  return {.sample = judge::Measured{std::move(finite)}};
}

}  // namespace

CLI::Validator number_in(std::pair<double, double> range) {
  const auto mistake = [range](const std::string& text) {
    const auto value = number_from(text);
    return value && *value >= range.first && *value <= range.second
               ? std::string()
               : fmt::format("{} is not a number from {} to {}", text.substr(0, 100), range.first, range.second);
  };
  return {mistake, ""};
}

CLI::Validator whole_number(std::pair<std::int64_t, std::int64_t> range) {
  const auto mistake = [range](const std::string& text) {
    const bool are_digits = !text.empty() && text.size() <= 18 && text.find_first_not_of("0123456789") == text.npos &&
                            (text == "0" || text[0] != '0');
    if (are_digits && std::stoll(text) >= range.first && std::stoll(text) <= range.second) return std::string();
    return fmt::format("{} is not a whole number from {} to {}, without zeros before it", text.substr(0, 100),
                       range.first, range.second);
  };
  return {mistake, range.second < largest_whole ? fmt::format("{} to {}", range.first, range.second) : ""};
}

CLI::Validator not_empty() {
  return {[](const std::string& text) { return text.empty() ? "the name is empty" : ""; }, ""};
}

void add_json_option(CLI::App& command, bool& is_json) {
  command.add_flag("--json", is_json, "print the answer as JSON");
}

void show_json(const base::OrderedJson& json) { fmt::print("{}\n", base::text_of(json, 2)); }

void add_report_options(CLI::App& command, ReportArguments& arguments) {
  command.add_option("--figures", arguments.figures, "draw only these: error,solved; none: draw nothing")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      .add_option("--style", arguments.style,
                  "ieee, springer, slide, or a TOML file of keys of [figures], in place of the study's (list figures)")
      ->check(not_empty());
  add_json_option(command, arguments.is_json);
}

std::string list_of_figures() {
  Rows rows{{"FIGURE", "OF"}};
  for (const auto& [name, meaning] : show::all_figures()) rows.push_back({name, meaning});
  return aligned(rows) + fmt::format("\nStyles (--style): {}\n", fmt::join(shipped_styles(), ", ")) +
         "\nKeys of [figures] in a study, or of a file (--style FILE)\n" + to_toml(FigureStyle());
}

Style styled(Style style, const std::vector<std::string>& labels, const ReportArguments& arguments) {
  const std::string& name = arguments.style;
  if (!name.empty()) read_style_text(style_text(name), name, style.figures, style.tables);
  for (const std::string& label : style.figures.solvers) {
    if (std::ranges::find(labels, label) == labels.end())
      throw std::invalid_argument(fmt::format("solvers of [figures]: {}", unknown_name("solver", label, labels)));
  }
  if (are_drawn(arguments.figures)) {
    refuse_unknown_figures(arguments.figures);
    figures::refuse_missing_font(style.figures, labels);
  }
  return style;
}

Style styled(const StoredStudy& entry, const ReportArguments& arguments) {
  const Definition definition = definition_of(entry.definition);
  return styled({definition.figures, definition.tables}, labels_of(entry), arguments);
}

std::vector<std::string> labels_of(const StoredStudy& stored) {
  std::vector<std::string> labels;
  for (const Series& series : stored.series) labels.push_back(series.label);
  return labels;
}

void add_run_options(CLI::App& command, RunArguments& arguments) {
  command.add_option("--out", arguments.out, "folder for the results; default: out/<study>")->check(not_empty());
  command.add_option("--jobs", arguments.jobs, "number of solves at once; times are compared only with 1")
      ->check(whole_number({1, 1024}))
      ->capture_default_str();
}

void add_study_option(CLI::App& command, std::string& study) {
  command.add_option("--study", study, "name of the study; default: the first in the store");
}

void add_paper_option(CLI::App& command, std::string& paper) {
  std::vector<std::string> names;
  for (const papers::Paper& known : papers::papers())
    names.push_back(fmt::format("{} ({})", known.name, known.in_short));
  paper = papers::papers().front().name;
  command.add_option("PAPER", paper, fmt::format("one of: {}", fmt::join(names, ", ")))->capture_default_str();
}

void check_plan(const Study& study) {
  if (!study.plan.metric.empty()) static_cast<void>(judge::metric_named(study.plan.metric));
}

std::vector<std::string> references_of(std::string_view name) {
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

void announce(show::Report reported, const std::filesystem::path& folder, const ReportArguments& arguments,
              const Style& style, const std::string& screen) {
  if (!arguments.figures.empty() && are_drawn(arguments.figures)) choose_figures(reported, arguments.figures);
  std::set<std::string> names, keys;
  for (const Series& series : reported.study.entry.series)
    names.insert({series.algorithm, reported.study.definition.robot, reported.study.definition.published});
  names.erase("");
  for (const std::string& name : names) std::ranges::copy(references_of(name), std::inserter(keys, keys.end()));
  reported.keys.assign(keys.begin(), keys.end());
  reported.references = references[0].text;
  reported.answer.show = style.tables.show;
  std::optional<ProgressBar> bar(std::in_place, "drawing", "figures");
  show::Written written =
      show::publish(reported, folder,
                    {.render = are_drawn(arguments.figures),
                     .progress = [&](std::int64_t done, std::int64_t all) { bar->show({.done = done, .total = all}); },
                     .style = style.figures},
                    program_name());
  bar.reset();  // leaves its line to the screen
  for (const std::string& warning : written.warnings) warn(warning);
  if (arguments.is_json) {
    base::OrderedJson json = show::to_json(reported.answer);
    json["files"] = written.files;
    return show_json(json);
  }
  const std::string page = written.page.string();
  fmt::print("{}", printable(screen.empty() ? show::screen(reported.answer, page)
                                            : fmt::format("{}Report: {}\n", screen, page)));
}

void write_and_announce(const Store& store, const StoredStudy& study, const std::filesystem::path& folder,
                        const ReportArguments& arguments) {
  const Style style = styled(study, arguments);  // refuses before the study is read
  judge::JudgedStudy judged = judge::judge(exported_study(store, study, folder));
  const figures::Look look = figures::look_of(judged, style.figures);
  std::vector<figures::Figure> pictures = figures::of_study(judged, look);
  announce(show::report_of(std::move(judged), std::move(pictures)), folder, arguments, {look.style, style.tables});
}

judge::StudyResults checked_study(const Store& store, const StoredStudy& entry, const TakeSolve& also) {
  judge::StudyResults study = judge::read_study(store, entry, [&, check = recheck_of(entry)](const SolveRecord& solve) {
    check(solve);
    if (also) also(solve);
  });
  if (study.solves.empty())
    throw std::invalid_argument(
        fmt::format("no solve of {} in the store is by its solvers as they are now; run the study", entry.name));
  return study;
}

judge::StudyResults exported_study(const Store& store, const StoredStudy& entry, const std::filesystem::path& folder) {
  judge::StudyResults study;
  const auto pass = [&](const TakeSolve& take) { study = checked_study(store, entry, take); };
  write_file(folder / "solves.csv", [&](const Write& write) { write_csv(pass, write, store.names_of_extras(entry)); });
  return study;
}

std::string run_study(const Study& study, const StoredStudy& stored, const std::filesystem::path& folder,
                      RunRequest request, Store::Mode mode) {
  if (const auto& arm = study.robot_of_file; arm != nullptr && !arm->tip_link.empty()) {
    say(fmt::format("arm: {}", arm->summary));
    for (const std::string& note : arm->notes) say(note);
  }
  for (const std::string& note : study.notes) say(note);
  warn_of_unreachable(study);
  std::map<std::string, std::vector<std::string>> left_out;  // labels by why
  for (const LeftOut& entry : study.left_out) left_out[entry.why].push_back(entry.label);
  std::string without;
  for (const auto& [why, labels] : left_out)
    without += fmt::format("{}{} ({})", without.empty() ? "" : "; ", fmt::join(labels, ", "), why);
  if (!without.empty()) warn("left out: " + without);
  if (is_debug_build()) {
    warn("this is a debug build; its times are marked and not comparable");
  } else if (request.jobs > static_cast<int>(std::thread::hardware_concurrency())) {
    warn(fmt::format("{} jobs share {}", request.jobs, counted(std::thread::hardware_concurrency(), "processors")));
  }
  // A transaction for each solve would cost more than many a solve; in a shared store each waits for the disk.
  request.patience = std::chrono::milliseconds(mode == Store::Mode::write_shared ? 1000 : 20);
  Store store(store_in(folder), mode);
  for (const StoredStudy& earlier : store.studies()) {
    if (earlier.name != study.name) continue;
    const std::string difference = difference_in_solves(earlier.definition, stored.definition);
    if (!difference.empty())
      warn(
          fmt::format("{} has a different study named {} ({}); its solves stay there, but its {}; use another name or "
                      "--out to keep both",
                      folder.string(), study.name, difference,
                      mode == Store::Mode::write_shared ? "definition is replaced, and merge takes no two of one name"
                                                        : "report is overwritten"));
  }
  warn_of_left_aside(stored, store);
  Progress progress;
  bool is_cancelled = false;
  {
    ProgressBar bar(study.name);
    request.progress = [&](const Progress& now) { bar.show(now); };
    CancelOnSignal signals;
    request.cancelled = &signals.requested();
    progress = run(study, stored, store, request);
    is_cancelled = signals.end();
  }
  for (const std::string& note : progress.notes) warn(note);
  tell_of_log(store.finish());
  const auto may_meddle = [](const SolverEntry& entry) { return entry.program != nullptr; };
  if (std::ranges::any_of(study.solvers, may_meddle)) {  // a program can write where its user can
    const std::int64_t there = Store(store_in(folder), Store::Mode::read).number_of_solves(stored);
    if (there < progress.done)
      throw std::runtime_error(fmt::format(
          "{} has {} of the {} solves: one of the programs or somebody else changed it; run the same command again",
          store_in(folder).string(), there, progress.done));
  }
  if (is_cancelled) {
    say(fmt::format("Stopped: {} of {} solves are kept in {}; run the same command again to continue.", progress.done,
                    progress.total, store_in(folder).string()));
    throw Cancelled();
  }
  return fmt::format("{}{}: {} in {}{}", study.name,
                     request.shard.count == 1 ? "" : fmt::format(", shard {}", request.shard.text()),
                     counted(progress.total, "solves"), store_in(folder).string(),
                     progress.reused == 0 ? "" : fmt::format(" ({} were already stored)", progress.reused));
}

papers::SolvedMultiverse solved_multiverse(const std::string& study, const std::vector<Dimension>& varied,
                                           MultiverseRequest request, int jobs) {
  CancelOnSignal signals;
  request.cancelled = &signals.requested();
  const MultiversePlan plan = plan_multiverse(study, varied, request);
  std::optional<ProgressBar> bar("readings");
  const std::vector<PartMeans> means =
      solve_parts(plan.parts, {.jobs = jobs,
                               .progress = [&](const Progress& progress) { bar->show(progress); },
                               .cancelled = request.cancelled});
  bar.reset();  // leaves its line to the next words
  if (signals.end()) {
    say("Stopped. Readings are judged together, so none is kept; the same command solves them anew.");
    throw Cancelled();
  }
  papers::SolvedMultiverse multiverse{plan, {}};
  for (const PartMeans& part : means)
    multiverse.means.push_back({group_of(part.error_cm), group_of(part.variation_deg)});
  return multiverse;
}

void draw(const figures::Figure& figure, const std::filesystem::path& folder, const figures::RenderOptions& options) {
  for (const std::string& error : figures::write_figures({figure}, folder, options)) warn(error);
}

std::filesystem::path store_in(const std::filesystem::path& folder) { return folder / "store.sqlite"; }

}  // namespace ikbench::cli
