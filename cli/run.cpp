// ikbench run: runs a study, built-in or from a file.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <set>
#include <stdexcept>

#include "analysis/judge/data/imported.hpp"
#include "analysis/judge/data/sampling.hpp"
#include "base/files.hpp"
#include "base/names.hpp"
#include "cli/console.hpp"
#include "cli/file_kind.hpp"
#include "cli/reporting.hpp"
#include "cli/running.hpp"
#include "cli/studies.hpp"
#include "experiments/runner.hpp"
#include "experiments/study/reader.hpp"
#include "experiments/study/writer.hpp"
#include "experiments/targets.hpp"

namespace ikbench::cli {

namespace {

constexpr const char* study_of_any_arm = "any-arm";

struct StudyToRun {
  std::string study, study_of_store, robot, shard;
  robots::UrdfChoice urdf;
  double limit = 0;  // [s]
  std::vector<std::string> set, sweep, only;
  RunArguments run;
  ReportArguments report;
  bool without_report = false, starts_programs = false;
};

// Returns the changes of the study in the order in which they apply: --set overrides all earlier changes, and only
// links and sweeps come later. `swept` are those of a sweep over keys of the study.
Overrides overrides_of(const StudyToRun& arguments, const Overrides& swept) {
  Overrides overrides;
  if (arguments.report.beside == judge::archive_name)
    for (const std::string& setting : judge::archive_settings()) overrides.push_back("--beside " + setting);
  if (const double limit = arguments.limit; limit > 0)
    for (const std::string& key :
         {fmt::format("analysis.deadline_ms={}", 1000 * limit), std::string("stop.iterations=1000000"),
          std::string("stop.evaluations=0"), fmt::format("stop.seconds={}", limit)})
      overrides.push_back("--limit " + key);
  if (!arguments.robot.empty()) overrides.push_back("--robot robot=" + arguments.robot);
  overrides.insert(overrides.end(), arguments.set.begin(), arguments.set.end());
  for (const auto& [key, link] : {std::pair{"base", arguments.urdf.base}, {"tip", arguments.urdf.tip}})
    if (!link.empty()) overrides.push_back(fmt::format("--{0} urdf.{0}={1}", key, link));
  std::set<std::string> keys;
  for (const std::string& text : arguments.sweep) {
    if (!keys.insert(text.substr(0, text.find('='))).second)
      throw std::invalid_argument(
          fmt::format("--sweep {}: this key is swept twice; give all of its values in one --sweep", text));
    if (!experiments::is_sweep_of_study(text)) overrides.push_back(sweep_override(text));
  }
  overrides.insert(overrides.end(), swept.begin(), swept.end());
  return overrides;
}

// Reads the study of a store, to be solved again into another store. Throws std::invalid_argument if the study would
// start programs without --start-programs, or if other solvers made the solves.
Study study_of_store(const StudyToRun& arguments, const Overrides& swept) {
  const std::string& file = arguments.study;
  if (arguments.run.out.empty())
    throw std::invalid_argument(fmt::format(
        "{0} is a store; to solve its study again into a new folder: ikbench run {0} --out NEW; to show its results: "
        "ikbench report {0}",
        file));
  const Store store(file, Store::Mode::read);
  const StoredStudy stored = store.study(arguments.study_of_store);
  std::vector<std::string> commands;
  for (const std::vector<std::string>& process : experiments::programs_of(stored))
    if (!process.empty()) commands.push_back(shell_command(process[0], {process.begin() + 1, process.end()}));
  if (!commands.empty() && !arguments.starts_programs)
    throw std::invalid_argument(
        fmt::format("{0} would start programs with your rights: {1}; to allow it: {2}", file, fmt::join(commands, "; "),
                    shell_command("ikbench", {"run", file, "--out", arguments.run.out, "--start-programs"})));
  const Overrides overrides = overrides_of(arguments, swept);
  Study study = load_study(store, stored, overrides);
  const auto is_same = [](const Series& made, const Series& read) {
    return made.label == read.label && made.algorithm == read.algorithm && made.options == read.options;
  };
  std::vector<Series> series = stored.series;
  std::erase_if(series, [&](const Series& each) {
    return std::ranges::count(study.awaited, each.label, &experiments::AwaitedSolver::label) > 0;
  });
  if (overrides.empty() && !std::ranges::equal(series, to_stored(study).series, is_same))
    throw std::invalid_argument(fmt::format(
        "{}: its study names other solvers or options than those that made its solves, so it was changed since then",
        file));
  return study;
}

// Says why a grid has no requirement, with a command that asks for the share on random targets of the same arm.
[[noreturn]] void refuse_requirement_of_grid(const Study& study, const results::Requirement& wanted) {
  std::vector<std::string> arguments{"run", "--robot", study.robot};
  if (!study.urdf.base.empty()) arguments.insert(arguments.end(), {"--base", study.urdf.base});
  if (!study.urdf.tip.empty()) arguments.insert(arguments.end(), {"--tip", study.urdf.tip});
  const results::Requirement of_all{.metric = "solved",
                                    .share = wanted.share};  // other targets may lack the label and a deadline
  arguments.insert(arguments.end(), {"--require", of_all.text()});
  throw std::invalid_argument(fmt::format("--require: {}; `{}` asks for it on random targets",
                                          results::grid_is_no_sample, shell_command("ikbench", arguments)));
}

// Returns the study, or with `swept` a study of a sweep over keys of the study.
Study study_of(const StudyToRun& arguments, const experiments::SweptStudy& swept = {}) {
  refuse_as_arm(arguments.robot);
  const bool is_of_any_arm = arguments.study.empty();
  const bool sweeps_arms =
      std::ranges::any_of(arguments.sweep, [](const std::string& text) { return text.starts_with("robot="); });
  if (sweeps_arms && !arguments.robot.empty())
    throw std::invalid_argument("--robot names one arm, and --sweep robot=... several; leave one of them out");
  if (is_of_any_arm && arguments.robot.empty() && !sweeps_arms)
    throw std::invalid_argument(
        "no study; expected ikbench run STUDY, or ikbench run --robot ARM (see ikbench list studies, ikbench list robots)");
  const std::string name = is_of_any_arm ? study_of_any_arm : arguments.study;
  if (!arguments.study_of_store.empty() && !is_store(name))
    throw std::invalid_argument(fmt::format("--study is only for a store, but {} is not a store; leave it out", name));
  Study study = is_store(name) ? study_of_store(arguments, swept.overrides)
                               : load_study(name, overrides_of(arguments, swept.overrides));
  // A built-in study on another arm gets another name, so that the usual folder keeps only solves of the usual arm.
  if (!arguments.robot.empty() && study.name == name)
    study.name = (is_of_any_arm ? "" : study.name + '-') + robot_of(study).name;
  if (!arguments.only.empty()) select_solvers(study, arguments.only);
  if (arguments.report.beside == judge::archive_name) {
    // The archive's study, with these solvers and the solver whose times are the unit of imported times.
    study.name += fmt::format("-{}", judge::archive_name);
    const auto is_time_reference = [](const SolverEntry& entry) {
      return entry.solver == judge::time_reference_solver && entry.options.empty();
    };
    if (std::ranges::none_of(study.solvers, is_time_reference))
      study.solvers.push_back({.label = "ikbench's LM", .solver = std::string(judge::time_reference_solver)});
  }
  // A mistake in style, requirements or plan shows before hours of solving.
  static_cast<void>(apply_style({study.figures}, labels_of(study), arguments.report));
  refuse_wrong_requirements(arguments.report, study, labels_in_file(study));
  if (study.path->grid() != nullptr && !arguments.report.requirements.empty())
    refuse_requirement_of_grid(study, parse_requirement(arguments.report.requirements.front()));
  const std::vector<judge::Metric> metrics = judge::metrics_of(study);
  if (!study.plan.metric.empty()) static_cast<void>(judge::metric_named(study.plan.metric, metrics));
  return study;
}

// Writes the targets of a study that waits for answers made elsewhere, and prints how to go on.
void write_awaited_targets(const Study& study, const std::filesystem::path& folder, const std::string& command) {
  if (study.awaited.empty()) return;
  const std::filesystem::path file = folder / "targets.csv";
  write_file(file, [&](const base::Write& write) { experiments::write_targets(study, write); });
  for (const experiments::AwaitedSolver& awaited : study.awaited)
    print_message(fmt::format("{}. Its targets are in {}; write its answers into {}, then:",
                              awaited.reason.empty()
                                  ? awaited.label + " has no answers yet"
                                  : fmt::format("{} answered other targets ({})", awaited.label, awaited.reason),
                              file.string(), awaited.file));
  print_command(command);
}

// Judges what was solved: writes the report, or prints JSON or the checks of requirements. Returns the exit code.
int judge_run(const Store& store, const StoredStudy& stored, const std::filesystem::path& folder,
              const StudyToRun& arguments, const std::optional<judge::StudyResults>& beside) {
  const ReportArguments& report = arguments.report;
  if (!arguments.without_report) return write_and_announce(store, stored, folder, report, beside);
  if (report.is_json) return show_answer(store, stored, report, beside);
  const bool is_required = !report.requirements.empty() || !stored.definition.requirements.empty();
  return is_required ? check_requirements_only(store, stored, report, beside) : 0;
}

// Refuses options of a report for a part of a study, which is not judged.
void refuse_to_judge_part(const StudyToRun& arguments) {
  if (!arguments.shard.empty() && (!arguments.report.requirements.empty() || arguments.report.is_strict))
    throw std::invalid_argument(
        "--shard: a part is not judged; leave out --require and --strict, and give them to ikbench report after the merge");
}

// Returns the part of the study that --shard names, or the whole.
Shard shard_of(const StudyToRun& arguments, const Study& study) {
  const Shard shard = arguments.shard.empty() ? Shard{} : parse_shard(arguments.shard);
  if (const std::int64_t parts = work_unit_count(study); shard.count > parts)  // some shards would be empty
    throw std::invalid_argument(fmt::format("--shard {}: {} has only {}; expected at most that many shards",
                                            shard.text(), study.name,
                                            base::counted(parts, study.is_chained() ? "runs" : "targets")));
  return shard;
}

// Returns the folder of the results of a study or a sweep with this name.
std::filesystem::path folder_of(const StudyToRun& arguments, const std::string& name) {
  const std::filesystem::path folder = output_folder(name, arguments.run.out);
  if (!arguments.run.out.empty() || arguments.shard.empty()) return folder;
  const Shard shard = parse_shard(arguments.shard);
  return folder / "shards" / fmt::format("{}-of-{}", shard.index, shard.count);
}

// Solves a study, or a part of it, and prints how many solves are stored if nothing else is printed.
void solve(const StudyToRun& arguments, const Study& study, const StoredStudy& stored,
           const std::filesystem::path& folder, const std::string& command) {
  const bool is_part = !arguments.shard.empty();
  const std::string solved = run_study(
      study, stored, folder, {.jobs = arguments.run.jobs, .command = command, .shard = shard_of(arguments, study)},
      is_part ? Store::Mode::write_shared : Store::Mode::write);
  if ((arguments.without_report || is_part) && !arguments.report.is_json) fmt::print("{}\n", wrapped(solved));
}

void run_and_report(const StudyToRun& arguments, Invocation& invocation) {
  const Study study = study_of(arguments);
  refuse_to_judge_part(arguments);
  static_cast<void>(shard_of(arguments, study));
  const std::filesystem::path folder = folder_of(arguments, study.name);
  write_awaited_targets(study, folder, invocation.command);
  if (!study.awaited.empty()) invocation.exit_code = 5;
  if (study.solvers.empty()) return;
  const StoredStudy stored = to_stored(study);
  const auto beside = imported_results(stored, arguments.report);  // refuses before hours of solving
  solve(arguments, study, stored, folder, invocation.command);
  if (!arguments.shard.empty()) return;
  const Store store(store_path(folder), Store::Mode::read);
  const int judged_code = judge_run(store, stored, folder, arguments, beside);
  if (study.awaited.empty()) invocation.exit_code = judged_code;
}

// Returns the studies of a sweep over keys of the study.
std::vector<Study> studies_of_sweep(const StudyToRun& arguments, const std::vector<std::string>& sweeps) {
  std::vector<Study> studies;
  for (experiments::SweptStudy& swept : experiments::swept_studies(sweeps)) {
    Study& study = studies.emplace_back(study_of(arguments, swept));
    if (!study.awaited.empty())
      throw std::invalid_argument(
          fmt::format("--sweep: {0} has no answers to the targets of each value; leave {0} out by --only",
                      study.awaited.front().label));
    study.sweep = std::move(swept.place);
    study.sweep.name = study.name + "-by";
    for (const auto& [key, value] : study.sweep.values) {
      study.name += fmt::format(" {}={}", key, value);
      study.sweep.name += '-' + key;
    }
    static_cast<void>(shard_of(arguments, study));
  }
  return studies;
}

// Solves the studies of a sweep over keys of the study, one after another, and reports them side by side.
void run_and_report_sweep(const StudyToRun& arguments, const std::vector<std::string>& sweeps, Invocation& invocation) {
  refuse_to_judge_part(arguments);
  if (!arguments.report.beside.empty())
    throw std::invalid_argument(
        "--beside is for one study, but a sweep over keys of the study makes several; leave one out");
  const std::vector<Study> studies = studies_of_sweep(arguments, sweeps);
  std::vector<StoredStudy> all_stored;
  for (const Study& study : studies) all_stored.push_back(to_stored(study));
  const std::filesystem::path folder = folder_of(arguments, studies.front().sweep.name);
  const bool is_part = !arguments.shard.empty();
  Store(store_path(folder), is_part ? Store::Mode::write_shared : Store::Mode::write).save_sweep(all_stored);
  for (std::size_t i = 0; i < studies.size(); ++i)
    solve(arguments, studies[i], all_stored[i], folder, invocation.command);
  if (is_part) return;
  const Store store(store_path(folder), Store::Mode::read);
  invocation.exit_code =
      report_studies(cli::studies_of_sweep(store, all_stored), folder, arguments.report, !arguments.without_report);
}

}  // namespace

void add_run(const Command& command, Invocation& invocation) {
  auto arguments = std::make_shared<StudyToRun>();
  command.add(
      "STUDY", &arguments->study,
      fmt::format("a built-in study (ikbench list studies), a TOML file, or a store, whose study is solved again; "
                  "default with --robot: {}",
                  study_of_any_arm));
  command.add("--robot", &arguments->robot, "arm to use: my_arm.urdf, my_arm.toml, ur5e");
  add_study_option(command, arguments->study_of_store,
                   "if STUDY is a store: name of the study to run again; default: the first in the store");
  add_link_options(command, arguments->urdf.base, arguments->urdf.tip);
  command
      .add("--limit", &arguments->limit,
           "time limit per solve, such as 1ms, in place of all other limits; shows what is solved within it")
      .time();
  command.add("--set", &arguments->set, "change a key of the study: runs=5, path.tool=eq27, ik_bat.bounds=clamp");
  command.add(
      "--sweep", &arguments->sweep,
      "solve every combination of values, of options of solvers (population=10,20,50, ik_bat.alpha=0.5,0.9) and "
      "of keys of the study (robot=ur5e,my_arm.urdf, near_deg=1,10, study.population=20,50); each value of a "
      "key is a column of the table");
  command.add("--only", &arguments->only, "solve and report only these labels: A,B; for a sweep, also its base label");
  add_run_options(command, arguments->run);
  add_report_options(command, arguments->report, true);
  command.add("--no-report", &arguments->without_report, "solve without writing a report");
  command.add("--start-programs", &arguments->starts_programs, "allow the study of a store to start its programs");
  command.add("--shard", &arguments->shard,
              "I/N: solve only part I of N, without a report; default of --out: out/<study>/shards/I-of-N");
  command.footer(
      "  ikbench run --robot my_arm.urdf --limit 1ms\n"
      "  ikbench run my.toml\n"
      "  ikbench run slim2023 --set seed=2 --out out/seed-2\n"
      "  ikbench run my.toml --beside libraries\n"
      "  ikbench run slim2023 --set IK-BA.bounds=clamp --set runs=5 --out out/clamped\n"
      "  ikbench run my.toml --sweep population=10,20,50 --sweep IK-BA.alpha=0.5,0.9,0.97\n"
      "  ikbench run my.toml --sweep robot=ur5e,franka_panda,my_arm.urdf\n"
      "  ikbench run theirs.sqlite --out here     solves its study again\n"
      "  ikbench run slim2023 --shard 3/12        one of twelve parts, then:\n"
      "  ikbench merge out/slim2023 out/slim2023/shards\n\n"
      "--shard shares out runs, or targets if no solve starts from the previous answer (start = \"previous\").\n"
      "The same command again solves only what is missing. If the source of a solver changed, all its solves are repeated. "
      "If a study waits for answers made elsewhere, targets.csv in the folder has its targets; the exit code is then 5.");
  command.callback([arguments, &invocation] {
    if (arguments->robot.empty() && is_arm(arguments->study)) std::swap(arguments->robot, arguments->study);
    std::vector<std::string> of_study;
    std::ranges::copy_if(arguments->sweep, std::back_inserter(of_study), experiments::is_sweep_of_study);
    if (of_study.empty()) return run_and_report(*arguments, invocation);
    run_and_report_sweep(*arguments, of_study, invocation);
  });
}

}  // namespace ikbench::cli
