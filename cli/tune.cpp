// ikbench tune: chooses settings of a solver by successive halving, then judges them on solves that tuning never saw.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>

#include "analysis/inference/estimand.hpp"
#include "analysis/inference/make_study.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/plan_options.hpp"
#include "cli/reporting.hpp"
#include "experiments/halving.hpp"
#include "experiments/study_overrides.hpp"
#include "experiments/study_reader.hpp"
#include "experiments/study_writer.hpp"
#include "numerics/names.hpp"
#include "results/files.hpp"

namespace ikbench::cli {

using namespace results;
using namespace experiments;
using namespace inference;

namespace {

namespace fs = std::filesystem;

struct TuneArguments {
  std::string study, solver, metric;
  Overrides overrides = {};
  std::vector<std::string> sweeps = {};
  std::int64_t budget = 0;
  RunArguments run = {};
  ReportArguments report = {};
};

constexpr std::string_view mark_of_file = "# Written by ikbench tune";

// The override of a --sweep, whose setting is the solver's.
std::string sweep_of_solver(const std::string& sweep, const std::string& solver) {
  const std::string key = sweep.substr(0, sweep.find('=')), owner = key.substr(0, std::min(key.rfind('.'), key.size()));
  if (key.find('.') == std::string::npos) return sweep_override(fmt::format("{}.{}", solver, sweep));
  if (owner == solver) return sweep_override(sweep);
  throw std::invalid_argument(fmt::format("--sweep {}: expected a setting of {}, the solver to tune", key, solver));
}

// The combinations of the swept settings of the solver.
std::vector<SolverEntry> candidates_of(const TuneArguments& arguments) {
  Overrides overrides = arguments.overrides;
  overrides.insert(overrides.end(),
                   {"figures={}", "analysis.control=\"\""});  // no candidate has the label that they name
  for (const std::string& sweep : arguments.sweeps) overrides.push_back(sweep_of_solver(sweep, arguments.solver));
  std::vector<SolverEntry> candidates = load_study(arguments.study, overrides).solvers;
  std::erase_if(candidates, [&](const SolverEntry& entry) { return entry.family != arguments.solver; });
  if (candidates.size() > 1) return candidates;
  throw std::invalid_argument(fmt::format(
      "{} has {} combination of settings to choose from; expected several, such as --sweep population=10,20,50, or a list "
      "of values in its entry",
      arguments.solver, candidates.size() == 1 ? "one" : "no"));
}

// The entry that tuning has to beat: the study's own, of a swept one without the swept settings.
SolverEntry default_of(const Study& study, const std::string& solver) {
  std::vector<std::string> known;
  for (const SolverEntry& entry : study.solvers) {
    if (entry.label == solver) return entry;
    known.push_back(entry.family.empty() ? entry.label : entry.family);
    if (entry.family != solver) continue;
    SolverEntry own = entry;
    own.label = std::exchange(own.family, "");
    for (const auto& [setting, value] : std::exchange(own.swept, {})) {
      own.options.erase(setting);
      if (setting == "population") own.population = 0;
    }
    return own;
  }
  known.erase(std::unique(known.begin(), known.end()), known.end());
  throw std::invalid_argument("--solver: " + numerics::unknown_name("label of the study", solver, known));
}

// Decides between candidates: the quantity that decides the study, or the average of a metric.
struct Criterion {
  Metric metric = Metric::position_error_cm;
  std::optional<Estimand> estimand = {};  // none: as the study decides

  Quantity quantity(const StudyResults& study) const {
    return quantity_of(study, metric, estimand.value_or(primary_estimand(study)));
  }
};

Criterion criterion_of(const std::string& name) {
  if (name.empty()) return {};
  const Metric metric = metric_named(name);
  return {.metric = metric, .estimand = average_estimand(metric)};
}

// The study beside which `ikbench tune` writes another: files that it names are found from there.
fs::path file_beside(const std::string& study) {
  const bool is_file = fs::is_regular_file(study);
  return is_file ? fs::path(study).parent_path() / (fs::path(study).stem().string() + "-tuned.toml")
                 : fs::path(study + "-tuned.toml");
}

void refuse_foreign(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(fs::symlink_status(file, error))) return;
  if (!fs::is_regular_file(file, error)) {  // a pipe would wait for a writer
    throw std::invalid_argument(
        fmt::format("'{}' is no regular file; move it away, because the tuned study goes there", file.string()));
  }
  const std::optional<std::string> text = read_file(file);
  if (text && text->starts_with(mark_of_file)) return;
  throw std::invalid_argument(
      fmt::format("'{}' is there and not written by ikbench tune; move it away, because the tuned study goes there",
                  file.string()));
}

// Text for people; with --json nothing but the data is printed.
void tell(const OutputArguments& output, std::string_view text) {
  if (output.is_json) return;
  fmt::print("{}\n", wrapped(text));
  std::fflush(stdout);  // the next round may take a while
}

// The training of all rounds.
class Training {
 public:
  Training(const Study& study, std::vector<SolverEntry> candidates, std::size_t rounds, Criterion criterion,
           const OutputArguments& output)
      : study_(study), rounds_(rounds), criterion_(criterion), output_(output), left_(std::move(candidates)) {
    study_.published.clear();
    study_.figures.solvers.clear();
    study_.analysis.control.clear();
    study_.seed = study.seed == static_cast<std::uint64_t>(no_limit) ? study.seed - 1 : study.seed + 1;
    if (criterion.metric != Metric::seconds) study_.repeats = 1;
    tuning_.candidates = static_cast<int>(left_.size());
    tuning_.seed = study_.seed;
  }

  // Solves the round of that number, from 1, and keeps the better half.
  Ended round(int number, int runs, const fs::path& folder, const RunRequest& request) {
    Study round = study_;
    round.name = fmt::format("{}-round-{}", study_.name, number);
    round.solvers = left_;
    round.runs = runs;
    if (Solved solved; run_study(round, folder, request, solved) == Ended::stopped) return Ended::stopped;
    const Store store(store_in(folder), Store::Mode::read);
    const StudyEntry entry = store.study(round.name);
    StudyMaker maker(entry, static_cast<std::size_t>(store.solves_of(entry.series)));
    store.each_of_study(entry, [&](const SolveRecord& solve) {
      maker.add(solve);
      if (solve.run > tuning_.runs * (number > 1 ? 1 : 0)) count(solve);
    });
    tuning_.rounds = number;
    tuning_.runs = runs;
    halve(maker.finish(store.sessions()));
    return Ended::complete;
  }

  const SolverEntry& best() const { return left_.front(); }
  const Tuning& tuning() const { return tuning_; }

 private:
  void count(const SolveRecord& solve) {
    ++tuning_.solves;
    tuning_.evaluations += solve.evaluations;
    if (std::isfinite(solve.cpu_seconds)) tuning_.cpu_seconds += solve.cpu_seconds;
  }

  void halve(const StudyResults& results) {
    const Quantity quantity = criterion_.quantity(results);
    tuning_.by = shortened(quantity.described.quantity, 100);
    const double sign = quantity.described.better == Better::smaller ? 1 : -1;
    std::vector<Standing> standings;
    const std::vector<Sample> values = samples(results, quantity.value),
                              evaluations = samples(results, Metric::evaluations);
    for (std::size_t i = 0; i < left_.size(); ++i)
      standings.push_back({sign * statistics::mean(values[i].values), statistics::mean(evaluations[i].values)});
    const std::size_t candidates = left_.size();
    std::vector<SolverEntry> kept;
    const std::vector<std::size_t> places = better_half(standings);
    for (const std::size_t place : places) kept.push_back(left_[place]);
    left_ = std::move(kept);
    const double value = sign * standings[places.front()].value;
    const ValueScale scale = quantity.described.scale;
    tell(output_,
         fmt::format("Round {} of {}: {} candidates, {} run{} each; best so far: {}, mean {} {}", tuning_.rounds,
                     rounds_, candidates, tuning_.runs, tuning_.runs == 1 ? "" : "s", left_.front().label, tuning_.by,
                     scale == ValueScale::share
                         ? percent(value)
                         : rounded_number(scale == ValueScale::log10 ? std::pow(10, value) : value, 4)));
  }

  Study study_;
  std::size_t rounds_;
  Criterion criterion_;
  OutputArguments output_;
  std::vector<SolverEntry> left_;
  Tuning tuning_ = {};
};

// The study with the default and the tuned entry.
Study tuned_study(Study study, SolverEntry own, SolverEntry tuned, const Tuning& tuning) {
  tuned.label = own.label + " tuned";
  tuned.family.clear();
  tuned.swept.clear();
  tuned.tuned = tuning;
  study.name += "-tuned";
  study.title = fmt::format("{}: {} and its tuned settings", study.title.empty() ? study.name : study.title, own.label);
  study.published.clear();
  study.analysis.control.clear();
  study.figures.solvers.clear();
  study.solvers = {std::move(own), std::move(tuned)};
  study.left_out.clear();
  return study;
}

// Reads the tuned study back before hours are spent: a name may be too long by what is added to it.
void check_is_readable(const Study& tuned, const fs::path& file) {
  try {
    static_cast<void>(parse_study(to_toml(tuned), file.string()));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("the tuned study could not be read: {}", error.what()));
  }
}

std::string settings_words(const SolverEntry& candidate) {
  std::string words;
  for (const auto& [setting, value] : candidate.swept)
    words += fmt::format("{}{} = {}", words.empty() ? "" : ", ", setting, value);
  return words;
}

Ended tune(const TuneArguments& arguments, const std::string& command) {
  const Criterion criterion = criterion_of(arguments.metric);
  refuse_collection(arguments.study, "ikbench tune");
  const Study study = load_study(arguments.study, arguments.overrides);
  const SolverEntry own = default_of(study, arguments.solver);
  const std::vector<SolverEntry> candidates = candidates_of(arguments);
  const std::int64_t points = study.path->points();
  const std::vector<HalvingRound> rounds = halving_rounds(candidates.size(), points, arguments.budget);
  if (rounds.empty()) {
    throw std::invalid_argument(fmt::format("--budget {}: {} candidates take at least {} solves", arguments.budget,
                                            candidates.size(), least_solves(candidates.size(), points)));
  }
  const fs::path file = file_beside(arguments.study);
  refuse_foreign(file);
  const fs::path folder =
      arguments.run.out.empty() ? default_folder(study.name + "-tuned") : fs::path(arguments.run.out);
  refuse_reproduction(folder);
  static_cast<void>(styled({}, arguments.report));
  const RunRequest request{.jobs = arguments.run.jobs, .command = command};
  const OutputArguments& output = arguments.report.output;
  Training training(study, candidates, rounds.size(), criterion, output);
  check_is_readable(tuned_study(study, own, own, training.tuning()), file);
  const std::string training_words =
      fmt::format("{} candidates, {} round{}, {} solves of training with seed {}", candidates.size(), rounds.size(),
                  rounds.size() == 1 ? "" : "s", solves_of(rounds, points), training.tuning().seed);
  tell(output, training_words);
  for (std::size_t i = 0; i < rounds.size(); ++i) {
    if (training.round(static_cast<int>(i) + 1, rounds[i].runs, folder / "training", request) == Ended::stopped)
      return Ended::stopped;
  }
  const std::string chosen = settings_words(training.best());
  if (effective_options(study, training.best()) == effective_options(study, own) &&
      effective_population(study, training.best()) == effective_population(study, own)) {
    const std::string found =
        fmt::format("The search found nothing better than the settings that {} has: {}", own.label, chosen);
    if (output.is_json)
      show_json({{"study", study.name}, {"chosen", chosen}, {"tuned_study", nullptr}, {"found", found}});
    tell(output, found);
    return Ended::complete;
  }
  const std::string text = to_toml(tuned_study(study, own, training.best(), training.tuning()));
  write_through(file, fmt::format("{}: the study with the settings that it chose.\n{}", mark_of_file, text));
  const Study tuned = load_study(file.string());
  Solved solved;
  if (run_study(tuned, folder, request, solved) == Ended::stopped) return Ended::stopped;
  const Store store(store_in(folder), Store::Mode::read);
  check_is_stored(tuned, store);
  write_and_announce(
      store, {.study = tuned.name,
              .folder = folder,
              .arguments = arguments.report,
              .answers = {fmt::format("Chosen from {}: {}. {} has them.", training_words, chosen, file.string())},
              .remarks = {solved.words(store_in(folder))},
              .data = {{"chosen", chosen}, {"tuned_study", file.string()}}});
  return Ended::complete;
}

}  // namespace

void add_tune(CLI::App& app, Invocation& invocation) {
  auto arguments = std::make_shared<TuneArguments>();
  CLI::App* command =
      app.add_subcommand("tune", "Choose settings of a solver, then judge them on solves that tuning never saw");
  command
      ->add_option("STUDY", arguments->study, "name of a built-in study (ikbench list studies) or path of a TOML file")
      ->required();
  command->add_option("--solver", arguments->solver, "label of the solver to tune")->required();
  command
      ->add_option("--sweep", arguments->sweeps,
                   "values of a setting of the solver: population=10,20,50, alpha=0.5,0.9; repeat for more settings: "
                   "every combination is a candidate")
      ->allow_extra_args(false);
  command->add_option("--budget", arguments->budget, "largest number of solves of the training")
      ->required()
      ->check(whole_number({1, 100'000'000}));
  command->add_option("--metric", arguments->metric,
                      "what decides between candidates, of ikbench list metrics; default: what decides the study, its "
                      "position error or with a tolerance the share of solved targets. Equal candidates: fewer "
                      "evaluations");
  command->add_option("--set", arguments->overrides, "change a key of the study, as ikbench run does")
      ->allow_extra_args(false);
  add_run_options(*command, arguments->run);
  add_report_options(*command, arguments->report);
  command->footer(
      "Examples:\n"
      "  ikbench tune my.toml --solver mine --sweep population=10,20,50 --sweep alpha=0.5,0.9,0.97 --budget 2000\n"
      "  ikbench tune slim2023 --solver IK-BA --sweep alpha=0.5,0.9 --budget 400 --metric evaluations\n\n"
      "Successive halving: all candidates have few runs, the better half goes on with twice as many, until one is left. The\n"
      "training has the seed of the study plus 1 and a store of its own, OUT/training. Then my-tuned.toml is written beside\n"
      "my.toml: the study with `mine` and `mine tuned`. It is solved with the study's own seed and reported in OUT. The report\n"
      "says what the training cost, and whether the targets are those of the training. A second call goes on where the first\n"
      "was stopped.");
  command->callback([arguments, &invocation] {
    refuse_points(arguments->report);
    if (tune(*arguments, invocation.command) == Ended::stopped) invocation.exit_code = cancelled_exit_code();
  });
}

}  // namespace ikbench::cli
