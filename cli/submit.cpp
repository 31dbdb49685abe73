// ikbench submit: submits a study as a job array of Slurm, and a job that merges and reports after all its tasks.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <stdexcept>

#include "analysis/figures/process.hpp"
#include "analysis/inference/text.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/plan_options.hpp"
#include "cli/reporting.hpp"
#include "cli/shards.hpp"
#include "experiments/study_reader.hpp"
#include "results/files.hpp"

namespace ikbench::cli {

using namespace results;
using namespace experiments;

namespace {

namespace fs = std::filesystem;

struct SubmitArguments {
  std::string study;
  Overrides overrides;
  RunArguments run;
  int tasks = 0;
  std::string sbatch;
  bool is_dry = false;
  OutputArguments output = {};
};

// A job script. Names from the user stand in it as quoted words, or on one line of a comment.
struct Script {
  std::string name, text;
};

std::string this_program() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return error ? "ikbench" : program.string();
}

// The path as one word of a shell's line.
std::string shell_word(const fs::path& path) { return shell_command("", {path.string()}).substr(1); }

// The script's lines that set its working folder and the folder of results.
std::string places(const fs::path& folder) {
  return fmt::format("folder={}\ncd {} || exit 2\n", shell_word(folder), shell_word(fs::current_path()));
}

Script solve_script(const SubmitArguments& arguments, const fs::path& folder, const std::string& typed) {
  std::vector<std::string> words{"run", arguments.study};
  for (const std::string& setting : arguments.overrides) words.insert(words.end(), {"--set", setting});
  words.insert(words.end(), {"--jobs", std::to_string(arguments.run.jobs)});
  return {"solve.sbatch", fmt::format(R"(#!/usr/bin/env bash
# Task I solves shard I of {tasks} into shards/I-of-{tasks}; what is stored there is not solved again. A task that fails is
# queued again, three times at most.
# Written by: {typed}
#SBATCH --job-name=ikbench
#SBATCH --array=1-{tasks}
#SBATCH --output=log/%a.txt
#SBATCH --open-mode=append
#SBATCH --requeue
#SBATCH --cpus-per-task={jobs}
{places}shard=$SLURM_ARRAY_TASK_ID
{run} --shard "$shard/{tasks}" --out "$folder/shards/$shard-of-{tasks}"
code=$?
# 1 is a mistake in the request, which stays one.
if [ $code -gt 1 ] && [ "${{SLURM_RESTART_COUNT:-0}}" -lt 3 ]; then
  scontrol requeue "${{SLURM_ARRAY_JOB_ID}}_$shard"
fi
exit $code
)",
                                      fmt::arg("tasks", arguments.tasks), fmt::arg("typed", typed),
                                      fmt::arg("jobs", arguments.run.jobs), fmt::arg("places", places(folder)),
                                      fmt::arg("run", shell_command(this_program(), words)))};
}

Script merge_script(const Study& study, const fs::path& folder, const std::string& typed) {
  return {"merge.sbatch",
          fmt::format(R"(#!/usr/bin/env bash
# Merges the shards, names what is missing of them, and writes the report where nothing is.
# Written by: {}
#SBATCH --job-name=ikbench-merge
#SBATCH --output=log/merge.txt
#SBATCH --requeue
{}ikbench={}
"$ikbench" merge "$folder" "$folder/shards" || exit
"$ikbench" report "$folder/store.sqlite" --study{}
)",
                      typed, places(folder), shell_word(this_program()), shell_command("", {study.name}))};
}

// Splits a text into words at blanks.
std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t from = text.find_first_not_of(' '); from != std::string::npos;) {
    const std::size_t to = std::min(text.find(' ', from), text.size());
    words.push_back(text.substr(from, to - from));
    from = text.find_first_not_of(' ', to);
  }
  return words;
}

// Submits a job; returns the number that sbatch gave it.
std::string submitted(const std::vector<std::string>& words, const fs::path& folder) {
  const figures::ProcessResult result = figures::run_process(words, folder);
  std::string last = result.output;
  while (!last.empty() && last.back() == '\n') last.pop_back();
  last.erase(0, last.rfind('\n') + 1);  // after its warnings
  last = last.substr(0, last.find(';'));
  if (result.succeeded && !last.empty() && last.find_first_not_of("0123456789") == std::string::npos) return last;
  std::string said = result.output;
  while (!said.empty() && said.back() == '\n') said.pop_back();
  for (std::size_t end = said.find('\n'); end != std::string::npos; end = said.find('\n', end))
    said.replace(end, 1, "; ");
  throw std::runtime_error(fmt::format(
      "{} failed: {}; the job scripts stay in '{}'; docs/cluster.md shows other ways to run shards",
      shell_command(words[0], {words.begin() + 1, words.end()}), inference::one_line(said), folder.string()));
}

void show(const fs::path& folder, const Script& script, const std::vector<std::string>& submission) {
  fmt::print("==> {}\n{}==> in its folder: {}\n\n", printable((folder / script.name).string()), printable(script.text),
             printable(shell_command(submission[0], {submission.begin() + 1, submission.end()})));
}

report::Json json_of(const fs::path& folder, const Script& script, const std::vector<std::string>& submission) {
  return {{"file", (folder / script.name).string()}, {"text", script.text}, {"submission", submission}};
}

void submit(const SubmitArguments& arguments, const std::string& command) {
  refuse_collection(arguments.study, "ikbench submit");
  const Study study = load_study(arguments.study, arguments.overrides);
  refuse_empty_shards(study, fmt::format("--tasks {}", arguments.tasks), arguments.tasks);
  const fs::path folder =
      fs::absolute(arguments.run.out.empty() ? default_folder(study.name) : fs::path(arguments.run.out))
          .lexically_normal();
  const std::string typed = inference::one_line(command);
  const Script solve = solve_script(arguments, folder, typed), merge = merge_script(study, folder, typed);
  std::vector<std::string> words{"sbatch", "--parsable"};
  for (std::string& word : split(arguments.sbatch)) words.push_back(std::move(word));
  std::string array = "ARRAY";  // stands for the array's job number
  const auto merge_words = [&] {
    std::vector<std::string> all = words;
    all.insert(all.end(), {"--dependency=afterany:" + array, merge.name});
    return all;
  };
  std::vector<std::string> solve_words = words;
  solve_words.push_back(solve.name);
  report::Json json{{"study", study.name}, {"folder", folder.string()}, {"tasks", arguments.tasks}};
  if (arguments.is_dry && arguments.output.is_json) {
    json["scripts"] = {json_of(folder, solve, solve_words), json_of(folder, merge, merge_words())};
    return show_json(json);
  }
  if (arguments.is_dry) {
    show(folder, solve, solve_words);
    return show(folder, merge, merge_words());
  }
  fs::create_directories(folder / "log");
  for (const Script* script : {&solve, &merge}) write_file(folder / script->name, script->text);
  array = submitted(solve_words, folder);
  const std::string last = submitted(merge_words(), folder);
  if (arguments.output.is_json) {
    json["array_job"] = array;
    json["merge_job"] = last;
    return show_json(json);
  }
  fmt::print("{}: job {} has {} tasks, then job {} merges and reports\n", printable(study.name), array, arguments.tasks,
             last);
  fmt::print("Watch:  {}   and   squeue --me\nOutput: {}\nAgain, where tasks failed: the same command\n",
             printable(shell_command("ikbench", {"status", folder.string()})), printable((folder / "log").string()));
}

}  // namespace

void add_submit(CLI::App& app, Invocation& invocation) {
  auto arguments = std::make_shared<SubmitArguments>();
  CLI::App* command = app.add_subcommand("submit", "Solve a study as a job array of Slurm, then merge and report");
  command
      ->add_option("STUDY", arguments->study, "name of a built-in study (ikbench list studies) or path of a TOML file")
      ->required();
  add_overrides(*command, arguments->overrides);
  command->add_option("--tasks", arguments->tasks, "number of tasks, each of which solves one shard")
      ->required()
      ->check(whole_number({1, most_shards}));
  add_run_options(*command, arguments->run);
  command->add_option("--sbatch", arguments->sbatch,
                      "further arguments of sbatch, separated by blanks: \"--partition=long --time=02:00:00\"");
  command->add_flag("--dry-run", arguments->is_dry, "show the job scripts and how they are submitted, and do nothing");
  add_json_option(*command, arguments->output);
  command->footer(
      "Examples:\n"
      "  ikbench submit slim2023 --tasks 20 --dry-run\n"
      "  ikbench submit my.toml --tasks 100 --out out/big --sbatch \"--partition=long --time=02:00:00\"\n\n"
      "The folder must be one that all machines see. docs/cluster.md shows the same without this command.");
  command->callback([arguments, &invocation] { submit(*arguments, invocation.command); });
}

}  // namespace ikbench::cli
