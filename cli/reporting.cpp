#include "cli/reporting.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <iterator>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "analysis/inference/analysis_plan.hpp"
#include "analysis/papers.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/report.hpp"
#include "cli/console.hpp"
#include "cli/plan_options.hpp"
#include "experiments/entries_reader.hpp"
#include "experiments/environment.hpp"
#include "experiments/recheck.hpp"
#include "experiments/runner.hpp"
#include "experiments/study_overrides.hpp"
#include "experiments/study_reader.hpp"
#include "experiments/study_writer.hpp"
#include "numerics/names.hpp"
#include "results/same_solves.hpp"

namespace ikbench::cli {

using namespace numerics;
using namespace results;
using namespace experiments;
using namespace inference;
using namespace report;

namespace {

// The study's plan with the options of the command line.
AnalysisPlan plan_for(const StudyEntry& entry, const ReportArguments& arguments) {
  refuse_points(arguments);
  AnalysisPlan plan = plan_of(entry);
  if (!arguments.unit.empty()) plan.unit = arguments.unit == name_of(Unit::run) ? Unit::run : Unit::point;
  if (arguments.quartiles != 0) plan.quartiles = arguments.quartiles;
  if (arguments.significance != 0) plan.significance = arguments.significance;
  if (plan.unit == Unit::point && !arguments.forced) {
    throw std::invalid_argument(fmt::format("the plan of the study {} has unit = \"point\", but {}; or use --unit run",
                                            entry.name, why_points_are_refused));
  }
  return plan;
}

// Explains why solves that look done are made anew.
void warn_of_left_aside(const Study& study, const Store& store) {
  const LeftAside aside = left_aside(study, store);
  if (aside.solves == 0) return;
  warn(fmt::format(
      "{} solves of {} come from another version of the solver or of shared code; they stay in the store, and "
      "this run solves those points again",
      aside.solves, fmt::join(aside.labels, ", ")));
}

// The verdict, the claims or the results, what else is to be said, and where the report is.
std::vector<Part> screen_of(const Report& report, const std::vector<std::string>& remarks,
                            const OutputArguments& output) {
  std::vector<std::string> said = report.verdict.empty() ? report.summary : report.verdict;
  const std::string first = said.empty() ? "" : said.front();
  if (!said.empty()) said.erase(said.begin());
  if (!report.verdict.empty()) {
    std::ranges::copy_if(report.summary, std::back_inserter(said), [&](const std::string& sentence) {
      return std::ranges::find(report.verdict, sentence) == report.verdict.end();
    });
  }
  std::erase_if(said, [&](const std::string& sentence) { return std::ranges::count(report.answers, sentence) > 0; });
  std::vector<Part> parts;
  Part asked;
  for (const std::string& answer : report.answers) asked.items.push_back(wrapped(answer));
  if (report.claims.empty()) {
    constexpr std::size_t of_table = 13, of_sentences = 6;
    if (!first.empty()) {
      parts.push_back({.items = {coloured(wrapped(first), tone_of(report.findings.lead))}});
      asked.items.emplace_back();
    }
    parts.push_back(std::move(asked));
    parts.push_back(table_rows(report.results, output, of_table));
    parts.push_back({.items = {""}});
    parts.push_back(sentences(said, of_sentences));
  } else {
    constexpr std::size_t of_claims = 22;
    constexpr std::array<std::string_view, 4> shown{"here", "printed", "number", "claim"};
    std::vector<Claim> claims = claims_by(Claimant::paper, report.claims);
    const std::size_t of_paper = claims.size();
    std::ranges::move(claims_by(Claimant::us, report.claims), std::back_inserter(claims));
    Tones tones{.column = 0};
    for (const Claim& claim : claims) tones.of_rows.push_back(tone_of(claim.verdict));
    parts.push_back({.items = {wrapped(first)}});
    Part rows = table_rows(with_columns(verdict_table(claims), shown), output, of_claims, tones);
    if (of_paper > 0 && of_paper < rows.items.size()) rows.items[of_paper].insert(0, "our own questions:\n");
    parts.push_back(std::move(rows));
    parts.push_back(std::move(asked));
    parts.push_back(sentences(said));
    if (output.is_verbose) parts.push_back(table_rows(report.results, output, 0));
  }
  if (!remarks.empty()) {
    Part part;
    for (const std::string& remark : remarks) part.items.push_back(wrapped(remark));
    parts.push_back(std::move(part));
  }
  parts.push_back(warnings(report.warnings));
  parts.push_back({.items = {fmt::format("Report: {}", printable(report.page.string()))}});
  return parts;
}

// The claims or the pairs of the quantity that decides; statistics.json has every number of every quantity.
report::Json json_of(const Report& report, WrittenReport wanted) {
  report::Json json{{"study", wanted.study}, {"report", report.page.string()}};
  if (!report.claims.empty()) json["claims"] = rows_json(verdict_table(report.claims));
  json["lead"] = name_of(report.findings.lead);
  json["pairs"] = rows_json(report.findings.pairs);
  json["results"] = rows_json(report.results);
  json["warnings"] = report.warnings;
  if (wanted.tells_of_further) json["further_studies"] = report.further;
  for (auto& [key, value] : wanted.data.items()) json[key] = std::move(value);
  return json;
}

// Warns if somebody else has the store open, so that it is more than one file.
void tell_of_log(const std::vector<std::filesystem::path>& files) {
  if (files.size() < 2) return;
  warn(fmt::format(
      "another program has {0} open, so part of the data is still in {1}; copy both files together, or close "
      "that program and run this command again to merge them",
      files[0].string(), files[1].string()));
}

}  // namespace

void ReportProgress::show(ReportStep step, std::int64_t done, std::int64_t all) {
  constexpr std::array<std::pair<const char*, const char*>, 3> steps{
      {{"reading", "solves"}, {"judging", "quantities"}, {"drawing", "figures"}}};
  const auto& [title, noun] = steps[static_cast<std::size_t>(step)];
  if (step_ != step || done <= 1) bar_.emplace(title, noun);
  step_ = step;
  bar_->show({.done = done, .total = all});
}

CLI::Validator not_empty() {
  return CLI::Validator([](const std::string& text) { return text.empty() ? "the name is empty" : ""; }, "");
}

void add_paper_option(CLI::App& command, std::string& paper, bool (*is_offered)(const Paper& of)) {
  std::vector<std::string> names;
  for (const Paper& each : analysis::papers()) {
    if (is_offered(each)) names.push_back(fmt::format("{} ({})", each.name, each.in_short));
  }
  paper = analysis::papers().front().name;
  command.add_option("PAPER", paper, fmt::format("one of: {}", fmt::join(names, ", ")))->capture_default_str();
}

void add_report_options(CLI::App& command, ReportArguments& arguments) {
  command
      .add_option("--unit", arguments.unit,
                  "what one observation is: run (its mean over the points) or point; default: as in the study")
      ->check(CLI::IsMember(std::vector<std::string>(unit_names.begin(), unit_names.end())));
  command
      .add_option("--quartiles", arguments.quartiles,
                  "Hyndman-Fan type of quartiles in box plots, 5 as in MATLAB; default: as in the study")
      ->check(whole_number({1, 9}));
  add_significance_option(command, arguments.significance)
      ->description("significance level of the tests, also for companion studies; default: as in the study")
      ->default_str("");
  command.add_flag("--force", arguments.forced, "allow points as observations; every table says so");
  command.add_flag("--no-figures", arguments.without_figures,
                   "write tables, but draw no figures; those that are there stay");
  command
      .add_option("--style", arguments.style,
                  "TOML file with the look of figures: the keys of [figures] in a study (width_cm, height_cm, font, "
                  "text_pt, palette, solvers, formats); keys that it lacks are as in the study")
      ->check(not_empty());
  add_output_options(command, arguments.output);
}

FigureStyle styled(FigureStyle style, const ReportArguments& arguments) {
  if (!arguments.style.empty()) read_style_file(arguments.style, style);
  return style;
}

void refuse_reproduction(const std::filesystem::path& folder) {
  if (!std::filesystem::exists(folder / "tables" / "multiverse.csv")) return;
  throw std::invalid_argument(
      fmt::format("'{}' has the report of ikbench reproduce, which this report would replace with less; choose another "
                  "folder (--out), or run ikbench reproduce again",
                  folder.string()));
}

void refuse_points(const ReportArguments& arguments) {
  if (arguments.unit != name_of(Unit::point) || arguments.forced) return;
  throw std::invalid_argument(fmt::format("--unit is {}; expected run: {}", arguments.unit, why_points_are_refused));
}

void add_overrides(CLI::App& command, Overrides& overrides) {
  command
      .add_option("--set", overrides,
                  "change a key of the study: runs=5, path.tool=eq27, ik_bat.bounds=clamp, analysis.significance=0.01")
      ->allow_extra_args(false);
  command
      .add_option_function<std::vector<std::string>>(
          "--sweep",
          [&overrides](const std::vector<std::string>& sweeps) {
            for (const std::string& sweep : sweeps) overrides.push_back(sweep_override(sweep));
          },
          fmt::format("run every combination of such values: population=10,20,50, ik_bat.alpha=0.5,0.9; at most {} "
                      "entries",
                      most_swept))
      ->allow_extra_args(false);
}

void add_run_options(CLI::App& command, RunArguments& arguments) {
  command.add_option("--out", arguments.out, "folder for the results; default: out/<study>")->check(not_empty());
  command
      .add_option("--jobs", arguments.jobs,
                  "number of solves at once; the answers stay the same, but times are comparable only with 1")
      ->check(whole_number({1, 1024}))
      ->capture_default_str();
}

void write_and_announce(const Store& store, WrittenReport wanted) {
  const OutputArguments& output = wanted.arguments.output;
  const StudyEntry entry = store.study(wanted.study);
  const AnalysisPlan plan = plan_for(entry, wanted.arguments);
  ReportProgress progress;
  const Report report = write_report(
      store,
      {.study = wanted.study,
       .folder = wanted.folder,
       .plan = plan,
       .style = styled(figure_style_of(entry), wanted.arguments),
       .figures = {.render = !wanted.arguments.without_figures, .program = program_name()},
       .papers = analysis::papers(),
       .extra_tables = std::move(wanted.tables),
       .extra_figures = std::move(wanted.figures),
       .shares = std::move(wanted.shares),
       .progress = [&](ReportStep step, std::int64_t done, std::int64_t all) { progress.show(step, done, all); }});
  progress.end();
  if (wanted.tells_of_further && !report.further.empty()) {
    wanted.remarks.push_back(
        fmt::format("The store also has {}, which this report is not about: --study NAME reports one of them.",
                    report::listed(report.further)));
  }
  if (output.is_json) {
    for (const std::string& warning : report.warnings) warn(warning);
    show_json(json_of(report, std::move(wanted)));
  } else {
    show_screen(screen_of(report, wanted.remarks, output), output,
                fmt::format(", and {} has it", report.file.string()));
  }
}

Store checked_store(const std::filesystem::path& file) {
  Store store(file, Store::Mode::read);
  store.check_solves([](const StudyEntry& study) {
    SolveCheck check = recheck_of(study);
    if (!check)
      warn(fmt::format("the arm of study {} cannot be read from the store, so its errors are not computed again",
                       printable(study.name)));
    return check;
  });
  return store;
}

void draw(const std::vector<figures::Figure>& figures, const std::filesystem::path& folder,
          figures::RenderOptions options) {
  options.program = program_name();
  for (const figures::FigureOutcome& outcome : figures::write_figures(figures, folder, options)) {
    if (!outcome.error.empty()) warn(fmt::format("{} was not drawn: {}", outcome.name, outcome.error));
  }
}

StudyEntry chosen_study(const Store& store, const std::string& name) {
  if (!name.empty()) return store.study(name);
  std::vector<StudyEntry> studies = store.studies();
  if (studies.empty()) throw std::invalid_argument("the store contains no study");
  return std::move(studies.front());
}

void warn_of_unreachable(const Study& study) {
  const std::vector<Unreachable> found = unreachable(study);
  constexpr std::size_t most = 10;
  for (std::size_t i = 0; i < std::min(found.size(), most); ++i) {
    warn(fmt::format("point {} is out of reach: it is {:.2f} cm from the shoulder, and the arm reaches {:.2f} cm",
                     found[i].point, found[i].distance * 100, found[i].reach * 100));
  }
  if (found.size() > most) warn(fmt::format("{} more points are out of reach", found.size() - most));
}

std::string Solved::words(const std::filesystem::path& store) const {
  return fmt::format("{}: {} solves in {}{}", studies == 1 ? study : fmt::format("{} studies", studies), solves,
                     store.string(), reused == 0 ? "" : fmt::format(" ({} were already stored)", reused));
}

Ended run_study(const Study& study, const std::filesystem::path& folder, RunRequest request, Solved& solved,
                Store::Mode mode) {
  warn_of_unreachable(study);
  for (const LeftOut& left_out : study.left_out) {
    warn(fmt::format("{} is left out: it is {}", left_out.label, left_out.why));
  }
  if (is_debug_build()) {
    warn("this is a debug build; its times are marked and not comparable");
  } else if (request.jobs > static_cast<int>(std::thread::hardware_concurrency())) {
    warn(fmt::format("{} jobs share {} processors", request.jobs, std::thread::hardware_concurrency()));
  }
  constexpr std::chrono::milliseconds patience{20};  // a transaction for each solve would cost more than many a solve
  request.patience = std::max(request.patience, patience);
  Store store(store_in(folder), mode);
  for (const StudyEntry& earlier : store.studies()) {
    if (earlier.name != study.name || earlier.definition == to_json(study)) continue;
    const std::string difference = difference_in_solves(earlier.definition, to_json(study));
    if (difference.empty()) {
      const std::string changes = changes_between(plan_of(earlier), study.analysis);
      if (!changes.empty()) {
        warn(fmt::format("the analysis plan of {} in {} has changed: {}; the report will say so", study.name,
                         folder.string(), changes));
      }
    } else {
      warn(
          fmt::format("{} has a different study named {} ({}); its solves stay there, but its {}; use another name or "
                      "--out to keep both",
                      folder.string(), study.name, difference,
                      mode == Store::Mode::write_shared ? "definition is replaced, and merge takes no two of one name"
                                                        : "report is overwritten"));
    }
  }
  warn_of_left_aside(study, store);
  Progress progress;
  bool is_cancelled = false;
  {
    ProgressBar bar(study.name);
    request.progress = [&](const Progress& now) { bar.show(now); };
    CancelOnSignal signals;
    request.cancelled = &signals.requested();
    progress = run(study, store, request);
    is_cancelled = signals.end();
  }
  for (const std::string& note : progress.notes) warn(note);
  tell_of_log(store.finish());
  if (is_cancelled) {
    say(fmt::format("Stopped: {} of {} solves are kept in {}; run the same command again to continue.", progress.done,
                    progress.total, store_in(folder).string()));
    return Ended::stopped;
  }
  solved.study = study.name + (request.shard.count == 1 ? "" : fmt::format(", shard {}", request.shard.text()));
  ++solved.studies;
  solved.solves += progress.total;
  solved.reused += progress.reused;
  return Ended::complete;
}

Ended run_and_tell(const Study& study, const std::filesystem::path& folder, RunRequest request,
                   const OutputArguments& output, Store::Mode mode) {
  Solved solved;
  const Ended ended = run_study(study, folder, std::move(request), solved, mode);
  if (ended == Ended::stopped || output.is_json) return ended;
  fmt::print("{}\n", wrapped(solved.words(store_in(folder))));
  std::fflush(stdout);  // the next study may take a while
  return ended;
}

Tone tone_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return Tone::good;
    case Verdict::fails:
      return Tone::bad;
    case Verdict::untested:
    case Verdict::incomparable:
      return Tone::plain;
    default:
      return Tone::open;
  }
}

Tone tone_of(Relation relation) {
  switch (relation) {
    case Relation::better:
      return Tone::good;
    case Relation::worse:
      return Tone::bad;
    case Relation::undecided:
      return Tone::open;
    default:
      return Tone::plain;
  }
}

std::filesystem::path store_in(const std::filesystem::path& folder) { return folder / "store.sqlite"; }

}  // namespace ikbench::cli
