// ikbench reproduce: solves every study of a paper into one store, with the interpretations of what the paper leaves
// open, and writes one report.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <thread>

#include "analysis/figures/of_study.hpp"
#include "analysis/papers/claims.hpp"
#include "analysis/papers/counts.hpp"
#include "analysis/show/phrases.hpp"
#include "analysis/show/publish.hpp"
#include "analysis/show/report.hpp"
#include "analysis/show/text.hpp"
#include "analysis/slim2023/slim2023.hpp"
#include "base/inputs.hpp"
#include "cli/console.hpp"
#include "cli/reporting.hpp"
#include "cli/running.hpp"
#include "experiments/environment.hpp"
#include "experiments/multiverse.hpp"
#include "experiments/study/reader.hpp"
#include "experiments/study/series_key.hpp"
#include "experiments/study/writer.hpp"
#include "results/fingerprint.hpp"
#include "results/published.hpp"
#include "solvers/registry.hpp"

namespace ikbench::cli {

using papers::Paper;

namespace {

constexpr std::string_view slim2023_name = "slim2023";

struct Arguments {
  std::string paper;
  std::int64_t seed = -1;  // -1: as in the paper's studies
  int runs = 0;            // 0: as in the paper
  int seeds = 3;           // of each interpretation; 0: no interpretation is solved
  RunArguments run;
  ReportArguments report;
};

Overrides overridden_runs(const Arguments& arguments) {
  return arguments.runs == 0 ? Overrides() : Overrides{fmt::format("runs={}", arguments.runs)};
}

// Returns the studies that the paper names. If the paper has a table of arms, the paper's first study on each further
// arm follows.
std::vector<Study> studies_of(const Paper& paper, const Arguments& arguments) {
  std::vector<Study> studies;
  const auto add = [&](const std::string& name, Overrides overrides) {
    if (arguments.seed >= 0) overrides.push_back(fmt::format("seed={}", arguments.seed));
    if (std::ranges::count(paper.runs, name) > 0)
      for (const std::string& text : overridden_runs(arguments)) overrides.push_back(text);
    studies.push_back(load_study(name, overrides));
  };
  const std::string& first = paper.studies.front();
  for (const std::string& name : paper.studies) add(name, {});
  for (const auto& [arm, row] : paper.rates.rows)
    if (arm != studies.front().robot) add(first, {fmt::format("name={}-{}", first, arm), "robot=" + arm});
  return studies;
}

// Returns a sentence that says how many studies have the fingerprint that every machine should give, and which studies
// differ. Library solvers are left out, because their bits change with the library.
std::string fingerprints_text(const Store& store, const std::vector<judge::JudgedStudy>& studies,
                              const std::vector<Study>& as_built_in) {
  std::vector<std::string> different;
  std::size_t compared = 0;
  for (std::size_t i = 0; i < studies.size(); ++i) {
    StoredStudy study = studies[i].study;
    const bool is_built_in =
        studies[i].study.definition.runs == as_built_in[i].runs &&
        std::ranges::equal(study.series, series_of(as_built_in[i]), {}, &Series::key, &Series::key);
    const std::string_view reference = is_built_in ? reference_fingerprint(study.name) : "";
    if (reference.empty()) continue;
    ++compared;
    std::erase_if(study.series,
                  [](const Series& series) { return !solvers::solver(series.algorithm).library.empty(); });
    if (fingerprint(store, study).text != reference) different.push_back(study.name);
  }
  if (compared == 0) return "Solves: nothing is published for this seed and number of runs";
  return fmt::format("Solves of {} of {} studies match those published with ikbench, bit for bit{}{}",
                     compared - different.size(), compared,
                     different.empty() ? "" : "; different: ", fmt::join(different, ", "));
}

// Returns the number of solves at once of a multiverse: one per processor, since no times are measured.
int multiverse_jobs(const Arguments& arguments) {
  return std::max(arguments.run.jobs, static_cast<int>(std::max(1u, std::thread::hardware_concurrency())));
}

// Solves all combinations of what a paper leaves open, with progress. After Ctrl-C, prints a message, throws Cancelled
// and keeps nothing, because a claim's share needs all interpretations.
papers::SolvedMultiverse solve_interpretations(const Arguments& arguments, const std::string& study,
                                               const std::vector<Dimension>& varied, int seeds) {
  CancelOnSignal signals;
  const MultiversePlan plan = plan_multiverse(study, varied, seeds, overridden_runs(arguments));
  std::optional<ProgressBar> bar("interpretations");
  const std::vector<SeriesMeans> means =
      solve_multiverse(plan.parts, {.jobs = multiverse_jobs(arguments),
                                    .progress = [&](const Progress& progress) { bar->show(progress); },
                                    .cancelled = &signals.requested()});
  bar.reset();  // clears the line of the bar for the next words
  if (signals.end()) {
    print_message("Stopped. Interpretations are judged together, so none is kept; the same command solves them again.");
    throw Cancelled();
  }
  papers::SolvedMultiverse multiverse{plan, {}};
  for (const SeriesMeans& part : means)
    multiverse.means.push_back({papers::group_of(part.error_cm), papers::group_of(part.variation_deg)});
  return multiverse;
}

papers::JudgedMultiverse judge_interpretations(const Arguments& arguments, const Paper& paper) {
  const std::vector<Dimension> dimensions = read_dimensions(paper.name);
  if (arguments.seeds == 0 || dimensions.empty()) return {};
  return papers::judged(paper, solve_interpretations(arguments, paper.name, dimensions, arguments.seeds),
                        load_study(paper.name).plan);
}

// Returns the counts by seed of each interpretation of the table of means, the paper's own first; empty if the paper
// has no such table.
std::vector<papers::SeedCounts> counts_of(const Arguments& arguments, const papers::Repeated& repeated) {
  constexpr int seeds = 8;
  std::vector<papers::SeedCounts> counts;
  for (const papers::Repeated& reading : repeated.readings()) {
    if (repeated.paper.means.empty()) break;
    counts.push_back(papers::counts_by_seed(repeated.paper,
                                            solve_interpretations(arguments, reading.study().study.name, {}, seeds)));
    counts.back().reading = reading.reading();
  }
  return counts;
}

// Returns the results of external programs that end by the clock: those solved on this machine, otherwise the shipped
// ones. The table's cells are views of `text`, which gets the file.
CsvTable programs_table(const Paper& paper, const std::filesystem::path& folder, std::string& text) {
  const std::filesystem::path solved_here = folder / "programs.csv";
  if (std::error_code none; paper.rates.programs.empty() || !std::filesystem::exists(solved_here, none))
    return published::table(paper.name, paper.rates.programs);
  text = base::text_of_file(solved_here);
  CsvTable programs = parse_csv(text, solved_here.string());
  if (programs.rows() != paper.rates.rows.size())
    throw std::invalid_argument(
        fmt::format("{} has {} rows; expected one for each arm of the paper, {}; remove the "
                    "file, or solve all arms: solvers/programs/{}.sh",
                    solved_here.string(), programs.rows(), paper.rates.rows.size(), paper.name));
  return programs;
}

// Returns the warnings that only the paper's further studies have.
std::vector<std::string> further_warnings(const papers::Repeated& repeated, const show::ReportModel& own) {
  std::vector<std::string> own_texts;
  for (const judge::Warning& warning : own.all_warnings()) own_texts.push_back(warning_text(warning));
  show::NamesByPhrase warnings;
  for (const judge::JudgedStudy& companion : repeated.studies.subspan(1))
    for (const judge::Warning& warning : show::make_report_model(companion).all_warnings())
      if (std::ranges::count(own_texts, warning_text(warning)) == 0)
        warnings.add(warning_text(warning), companion.study.name);
  return warnings.formatted("{1}: {0}.");
}

// Adds the figures and tables that the paper numbers, for each interpretation.
void add_slim2023(show::Report& reported, const papers::Repeated& repeated, const figures::Look& look,
                  const FigureStyle& style) {
  std::vector<figures::Figure> circle_figures;
  if (const judge::JudgedStudy* const dobot = repeated.part("dobot"))
    circle_figures = slim2023::figures_of(*dobot, figures::look_of(dobot->study.series, style));
  reported.extra_sections = slim2023::sections(repeated, circle_figures);
  show::Blocks& further = reported.extra_sections.emplace_back();
  for (const papers::Repeated& reading : repeated.readings()) {
    if (reading.suffix().empty()) continue;
    further.emplace_back(show::Heading{"Figures with " + reading.reading()});
    for (figures::Figure& figure : slim2023::figures_of(reading.study(), look)) {
      figure.name += reading.suffix();
      figure.caption += fmt::format(" With {}.", reading.reading());
      further.emplace_back(std::move(figure));
    }
  }
  // The paper does not compare evaluations. If a solver takes twice as many as another, a warning says so.
  reported.model.remove_metrics(judge::QuantityKind::evaluations);
}

// Returns the figures of the paper's own study. The figures of a table of arms are drawn elsewhere.
std::vector<figures::Figure> own_figures(const judge::JudgedStudy& own, const Paper& paper, const figures::Look& look) {
  if (paper.name == slim2023_name) return slim2023::figures_of(own, look);
  return paper.rates.is_of_arms() ? std::vector<figures::Figure>() : figures::of_study(own, look);
}

// Writes the report of a paper. The first of the studies is the paper's own.
void report(const std::vector<judge::JudgedStudy>& studies, const Paper& paper, const Arguments& arguments,
            const std::filesystem::path& folder, const papers::JudgedMultiverse& readings) {
  const judge::JudgedStudy& own = studies.front();
  const FigureStyle style = apply_style(own.study.definition.figures, labels_of(own.study), arguments.report);
  std::string text;
  const CsvTable programs = programs_table(paper, folder, text);
  const papers::Repeated repeated{.paper = paper, .studies = studies, .programs = &programs};
  const std::vector<papers::JudgedClaim> claims = papers::judged_claims(repeated, readings.in_readings);
  const std::vector<papers::SeedCounts> counts = counts_of(arguments, repeated);
  show::Table means = papers::means_table(repeated, counts.empty() ? papers::SeedCounts() : counts.front());
  if (means.rows.empty()) means = papers::rates_table(repeated);

  const bool is_slim2023 = paper.name == slim2023_name, has_arms = paper.rates.is_of_arms();
  const figures::Look look = is_slim2023 ? figures::look_of(own.study.series, style) : figures::look_of(own, style);
  show::Report reported = show::make_report(own, own_figures(own, paper, look));
  reported.has_own_numbers = is_slim2023 || has_arms;
  reported.extra_warnings = further_warnings(repeated, reported.model);
  if (is_slim2023) add_slim2023(reported, repeated, look, style);
  const std::vector<std::string> sentences =
      is_slim2023 ? slim2023::sentences(claims, counts) : papers::rates_sentences(repeated);
  reported.lead = papers::beginning(paper, sentences, means);
  if (has_arms)
    reported.lead.emplace_back(fmt::format(
        "The rest of this page is only about {}: the arm in motion, which solver is better, and the set-up.",
        paper.rates.rows.at(own.study.definition.robot)));
  if (const auto figure = papers::rates_figure(repeated))
    reported.extra_sections.push_back({show::Heading{"Ours and the paper's"}, *figure});
  for (const auto& [table, words] : paper.rates.tables)
    if (table != paper.rates.tables.begin()->first)
      reported.extra_sections.push_back({show::Heading{"Rates of " + words}, papers::rates_table(repeated, table)});
  reported.claims = papers::claims_section(claims);
  if (!readings.in_readings.empty())
    reported.extra_sections.push_back({show::Heading{"What the paper leaves open"}, readings.table});
  write_and_print(
      reported, folder, arguments.report, look.style,
      fmt::format("{}{}\n", papers::screen(sentences, means, claims),
                  fingerprints_text(Store(store_path(folder), Store::Mode::read), studies, studies_of(paper, {}))));
}

// The counts of a paper's programs, and a sentence that says where they were made.
struct CountsOfPrograms {
  std::map<std::string, papers::CountsByArm> counts;
  std::string origin;
};

// Returns the counts that were made on this machine, otherwise the shipped ones.
CountsOfPrograms counts_of_programs(const Paper& paper, const std::filesystem::path& folder) {
  CountsOfPrograms all{papers::stored_counts(paper), ""};
  std::vector<std::string> shipped, here;
  for (auto& [program, of_arms] : all.counts) {
    const std::filesystem::path made_here = folder / (program + ".csv");
    if (std::error_code none; !std::filesystem::exists(made_here, none)) {
      shipped.push_back(paper.counts.programs.at(program));
      continue;
    }
    const std::string text = base::text_of_file(made_here);
    of_arms = papers::read_counts(parse_csv(text, made_here.string()), made_here.string());
    here.push_back(made_here.string());
  }
  all.origin =
      fmt::format("Solves: {}{}{}{}", shipped.empty() ? "" : "stored with ikbench, by ", fmt::join(shipped, "; "),
                  shipped.empty() || here.empty() ? "" : "; ", fmt::join(here, "; "));
  return all;
}

// Writes the report of a paper whose solves are stored, and prints the screen. Nothing is solved.
void report_counts(const Paper& paper, const Arguments& arguments) {
  const std::filesystem::path folder = output_folder(paper.name, arguments.run.out);
  const CountsOfPrograms of = counts_of_programs(paper, folder);
  const papers::Repeated repeated{.paper = paper, .studies = {}, .counts = of.counts};
  const std::vector<papers::JudgedClaim> claims = papers::judged_claims(repeated);
  const std::vector<std::string> sentences = papers::counts_sentences(repeated);
  const show::Table table = papers::counts_table(repeated);
  base::OrderedJson json{{"headline", sentences.front()}, {"paper", paper.name}, {"arms", show::to_json(table)}};
  show::Blocks beginning = papers::beginning(paper, sentences, table);
  beginning.emplace_back(of.origin + '.');
  const show::Publication publication{
      .title = paper.name, .sections = {beginning, papers::claims_section(claims)}, .json = json};
  const show::WrittenReport written =
      write_with_progress(arguments.report, {}, [&](const figures::RenderOptions& options) {
        return show::publish(publication, folder, options, experiments::program_name());
      });
  json["files"] = written.files;
  if (arguments.report.is_json) return show_json(json);
  fmt::print("{}", printable(fmt::format("{}{}Report: {}\n", papers::screen(sentences, table, claims),
                                         show::wrapped_paragraph(of.origin, "  "), written.page.string())));
}

}  // namespace

void add_reproduce(const Command& command, Invocation& invocation) {
  auto arguments = std::make_shared<Arguments>();
  std::vector<std::string> names;
  for (const Paper& paper : papers::papers()) names.push_back(fmt::format("{} ({})", paper.name, paper.in_short));
  arguments->paper = papers::papers().front().name;
  command.add("PAPER", &arguments->paper, fmt::format("one of: {}", fmt::join(names, ", ")));
  add_run_options(command, arguments->run);
  command.add("--seed", &arguments->seed, "seed of the studies; default: that of each study").whole_number();
  command.add("--runs", &arguments->runs, "runs per solver; default: as in the paper").whole_number({1, 1'000'000});
  command
      .add("--readings", &arguments->seeds,
           "seeds per interpretation of what the paper leaves open; 0: solve no interpretations")
      .whole_number({0, 1000});
  add_report_options(command, arguments->report);
  command.footer(
      "  ikbench reproduce\n"
      "  ikbench reproduce beeson2015             TRAC-IK's table of solve rates\n"
      "  ikbench reproduce haviland2023           six Levenberg-Marquardt rules\n"
      "  ikbench reproduce ssik2026               numbers of answers of ssik and EAIK\n"
      "  ikbench reproduce --seed 2 --out out/seed-2\n"
      "  ikbench reproduce --readings 0 --jobs 2  faster, but times are not comparable");
  command.callback([arguments, &invocation, command] {
    const Paper& paper = papers::paper_named(arguments->paper);
    if (paper.studies.empty()) {
      for (const char* option : {"--seed", "--runs", "--readings"})
        if (command.was_given(option))
          throw std::invalid_argument(
              fmt::format("{}: the solves of {} are stored; leave the option out", option, paper.name));
      return report_counts(paper, *arguments);
    }
    // A mistake in the style shows before hours of solving.
    static_cast<void>(apply_style({}, labels_of(load_study(paper.studies.front())), arguments->report));
    if (command.was_given("--readings") && arguments->seeds > 0 && read_dimensions(paper.name).empty())
      throw std::invalid_argument(
          fmt::format("--readings: {} has no interpretations to solve; leave the option out", paper.name));
    const std::filesystem::path folder = output_folder(paper.studies.front(), arguments->run.out);
    std::vector<judge::JudgedStudy> judged;
    for (const Study& study : studies_of(paper, *arguments)) {
      const StoredStudy stored = to_stored(study);
      run_study(study, stored, folder, {.jobs = arguments->run.jobs, .command = invocation.command});
      const Store store(store_path(folder), Store::Mode::read);
      const bool is_first = judged.empty();
      judged.push_back(judge::judge(is_first ? read_and_export(store, stored, folder) : read_checked(store, stored)));
    }
    report(judged, paper, *arguments, folder, judge_interpretations(*arguments, paper));
  });
}

}  // namespace ikbench::cli
