// ikbench compare: says whether a solver is worse than a baseline.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>

#include "analysis/judge/regression.hpp"
#include "analysis/show/headline.hpp"
#include "analysis/show/phrases.hpp"
#include "analysis/show/result_tables.hpp"
#include "analysis/show/terminal.hpp"
#include "analysis/show/text.hpp"
#include "base/files.hpp"
#include "base/json.hpp"
#include "base/names.hpp"
#include "base/number.hpp"
#include "cli/console.hpp"
#include "cli/reporting.hpp"

namespace ikbench::cli {

using namespace judge;

namespace {

struct CompareArguments {
  std::string a, b, store, study, margin, time_margin, output;
  std::vector<std::string> labels, metrics;
  bool is_strict = false, is_json = false;
};

// Reads a share from text such as "5%". Throws std::invalid_argument if the share is out of range.
double margin_from(const std::string& text, const char* option = "--margin") {
  const auto value = text.ends_with('%') ? base::number_from(text.substr(0, text.size() - 1)) : std::nullopt;
  const double share = value ? *value / 100 : -1;
  if (!(share >= 0 && share <= results::margin_percent_range.second / 100))
    throw std::invalid_argument(fmt::format("{} {}; expected a share from 0% to {}%, such as 5%", option, text,
                                            results::margin_percent_range.second));
  return share;
}

// A store and one of its studies.
struct StudyInStore {
  results::Store store;
  results::StoredStudy entry;

  // Throws std::invalid_argument for a grid of targets.
  StudyInStore(const std::string& file, const std::string& name)
      : store(file, results::Store::Mode::read), entry(store.study(name)) {
    if (entry.definition.is_grid())
      throw std::invalid_argument(fmt::format("{}: {}; `{}` draws its map", entry.name, results::grid_is_no_sample,
                                              shell_command("ikbench", {"report", file})));
  }

  std::vector<std::string> labels() const { return labels_of(entry); }
  bool has(const std::string& label) const { return std::ranges::count(labels(), label) > 0; }
  void refuse_unknown(const std::string& label) const {
    if (!has(label)) throw std::invalid_argument(base::unknown_name("label", label, labels()));
  }
  // Reads and checks the study's solves: those of one label, or of all labels if `label` is empty.
  StudyResults results_of(const CompareArguments& arguments, const std::string& label = "") const {
    results::StoredStudy part = entry;
    if (!label.empty())
      std::erase_if(part.series, [&](const results::Series& series) { return series.label != label; });
    StudyResults results = read_checked(store, part);
    if (!arguments.margin.empty()) results.definition.plan.margin = margin_from(arguments.margin);
    return results;
  }
};

// Makes the checks of all labels that both stores have, since the p of each pair counts all labels. The checks of the
// requested labels come first. A label that is not requested and lacks solves has no check.
std::vector<RegressionCheck> checks_by_label(const StudyInStore& a, const StudyInStore& b,
                                             const std::vector<std::string>& requested,
                                             const CompareArguments& arguments, const RegressionOptions& options) {
  std::vector<RegressionCheck> checks;
  for (const std::string& label : requested)
    checks.push_back(check_regression(a.results_of(arguments, label), b.results_of(arguments, label), options));
  for (const std::string& label : a.labels()) {
    if (!b.has(label) || std::ranges::count(requested, label) > 0) continue;
    try {
      checks.push_back(check_regression(a.results_of(arguments, label), b.results_of(arguments, label), options));
    } catch (const LacksSolves&) {
      continue;
    }
  }
  return checks;
}

// Returns the labels of --label, or all labels of the baseline. Throws std::invalid_argument if the candidate lacks a
// label.
std::vector<std::string> requested_labels(const StudyInStore& a, const StudyInStore& b,
                                          const CompareArguments& arguments) {
  std::vector<std::string> labels = arguments.labels;
  if (labels.empty()) {
    labels = a.labels();
    if (labels.empty()) throw std::invalid_argument(fmt::format("{} has no solver to compare", arguments.a));
    std::vector<std::string> missing = labels;
    std::erase_if(missing, [&](const std::string& label) { return std::ranges::count(b.labels(), label) > 0; });
    if (!missing.empty())
      throw std::invalid_argument(fmt::format(
          "the candidate lacks {}; run it too, or choose the solvers to compare with --label", show::listed(missing)));
  }
  for (const std::string& label : labels) {
    if (std::ranges::count(labels, label) > 1)
      throw std::invalid_argument(fmt::format("the label {} is given twice", label));
    a.refuse_unknown(label);
    b.refuse_unknown(label);
  }
  return labels;
}

std::vector<RegressionCheck> compare_all(const CompareArguments& arguments) {
  std::vector<RegressionCheck> checks;
  RegressionOptions options{.metrics = arguments.metrics};
  if (!arguments.time_margin.empty()) options.time_margin = margin_from(arguments.time_margin, "--time-margin");
  if (!arguments.store.empty()) {
    const StudyInStore both(arguments.store, arguments.study);
    if (arguments.a == arguments.b) throw std::invalid_argument("A and B are the same label; expected two");
    for (const std::string& label : {arguments.a, arguments.b}) both.refuse_unknown(label);
    checks.push_back(check_regression(both.results_of(arguments), arguments.b, arguments.a, options));
    judge_all(checks);
    return checks;
  }
  const StudyInStore a(arguments.a, arguments.study), b(arguments.b, arguments.study);
  if (arguments.study.empty() && a.entry.name != b.entry.name)
    throw std::invalid_argument(fmt::format(
        "the first study of A is {}, that of B is {}; expected one name: if both stores have it, add --study "
        "NAME; otherwise run B's study under A's name, with --out NEW",
        a.entry.name, b.entry.name));
  const std::vector<std::string> labels = requested_labels(a, b, arguments);
  checks = checks_by_label(a, b, labels, arguments, options);
  judge_all(checks);
  checks.resize(labels.size());
  return checks;
}

std::string not_tested_text(const show::ReportModel& answer, const JudgedMetric& judged) {
  const auto* const not_tested = std::get_if<NotTested>(&judged.comparisons.front().result);
  if (not_tested != nullptr) return show::reason_in_metric(*not_tested, judged, show::observation_noun(answer, judged));
  if (show::is_success_rate(judged)) return "neither solved any target";
  return fmt::format("neither has a value of {}", judged.samples.quantity);
}

// The kinds of outcomes of a check, on which its sentence depends.
enum OutcomeFlag : unsigned {
  worse = 1,
  better = 2,
  failures = 4,
  inconclusive = 8,
  untested = 16,
  within_margin = 32
};

// A sentence for the checks that have all of `flags`.
struct SentenceCase {
  unsigned flags;
  const char* sentence;
};

// The first case that fits a check makes its sentence.
constexpr SentenceCase sentence_cases[]{
    {worse | better | inconclusive,
     "{candidate} is worse than {baseline} in {worse}, but better in {better}; {unclear} inconclusive."},
    {worse | better, "{candidate} is worse than {baseline} in {worse}, but better in {better}."},
    {worse | inconclusive, "{candidate} is worse than {baseline} in {worse}; {unclear} inconclusive."},
    {worse, "{candidate} is worse than {baseline} in {worse}."},
    {better | inconclusive, "{candidate} is better than {baseline} in {better}; {unclear} inconclusive."},
    {better, "{candidate} is better than {baseline} in {better}."},
    {failures | inconclusive, "{candidate} has {failures}, compared with {baseline}; {unclear} inconclusive."},
    {failures, "{candidate} has {failures}, compared with {baseline}."},
    {inconclusive, "{candidate} is not shown to be worse than {baseline} in {any} (inconclusive)."},
    {untested, "{candidate} is not shown to be worse than {baseline}."},
    {within_margin, "{candidate} is not worse than {baseline} by more than the margin."},
    {0, "{candidate} is not worse than {baseline}."}};

unsigned flags_of(const RegressionCheck& check) {
  unsigned found = 0;
  if (check.new_failures > 0) found = failures;
  for (const auto& [outcome, flag] : {std::pair(RegressionOutcome::worse, worse),
                                      {RegressionOutcome::better, better},
                                      {RegressionOutcome::inconclusive, inconclusive},
                                      {RegressionOutcome::not_tested, untested},
                                      {RegressionOutcome::worse_below_margin, within_margin}})
    if (check.has(outcome)) found |= flag;
  return found;
}

// Returns how a sentence names the baseline: by its label, or "the baseline" if it is another store.
std::string baseline_name(const RegressionCheck& check) {
  return check.label.empty() ? check.baseline : "the " + check.baseline;
}

// The beginnings of quantities that are plurals.
constexpr std::string_view plural_quantities[]{"targets ", "evaluations", "iterations", "searches"};

// Returns "joint motion is" or "error and joint motion are".
std::string with_verb(const std::vector<std::string>& quantities) {
  const std::string all = show::listed(quantities);
  const bool is_plural = std::ranges::any_of(plural_quantities, [&](auto each) { return all.starts_with(each); });
  return all + (quantities.size() > 1 || is_plural ? " are" : " is");
}

// Returns "mine is worse than PSO in targets solved and error; joint motion is inconclusive."
std::string relation_sentence(const RegressionCheck& check, const std::string& candidate) {
  const unsigned found = flags_of(check);
  const auto fits = [&](const SentenceCase& each) { return (each.flags & ~found) == 0; };
  const SentenceCase& chosen = *std::ranges::find_if(sentence_cases, fits);
  const std::string failed = base::counted(check.new_failures, "new failures") + " (no answer)";
  const std::vector<std::string> unclear = check.quantities(RegressionOutcome::inconclusive);
  std::string text = fmt::format(
      fmt::runtime(chosen.sentence), fmt::arg("candidate", candidate), fmt::arg("baseline", baseline_name(check)),
      fmt::arg("worse", show::listed(check.quantities(RegressionOutcome::worse))),
      fmt::arg("better", show::listed(check.quantities(RegressionOutcome::better))), fmt::arg("failures", failed),
      fmt::arg("unclear", with_verb(unclear)), fmt::arg("any", show::listed(unclear, " or ")));
  if ((found & failures) != 0 && (chosen.flags & failures) == 0) text += fmt::format(" It also has {}.", failed);
  return text;
}

// Returns the sentences of one check: "mine is worse than PSO in error. Not tested: time (2 runs)."
std::string verdict_text(const RegressionCheck& check, const show::ReportModel& answer) {
  const std::string& candidate = check.label.empty() ? check.candidate : check.label;
  if (!check.is_compared)
    return fmt::format("{} is not compared with {}: {}.", candidate, baseline_name(check),
                       not_tested_text(answer, check.judged.metrics[check.judged.primary]));
  std::string text = relation_sentence(check, candidate);
  if (check.has(RegressionOutcome::worse_below_margin))
    text += fmt::format(" Worse by less than the margin: {}.",
                        show::listed(check.quantities(RegressionOutcome::worse_below_margin)));
  const std::vector<std::string> not_tested = check.quantities(RegressionOutcome::not_tested);
  show::NamesByPhrase untested;  // quantities by the reason
  for (const JudgedMetric& judged : check.judged.metrics) {
    const std::string& quantity = judged.samples.quantity;
    if (std::ranges::count(not_tested, quantity) > 0) untested.add(not_tested_text(answer, judged), quantity);
  }
  if (!untested.entries.empty())
    text += fmt::format(" Not tested: {}.", fmt::join(untested.formatted("{1} ({0})"), "; "));
  std::vector<std::string> others;
  const std::vector<std::string> also_worse = check.quantities(RegressionOutcome::worse, false);
  const std::vector<std::string> also_better = check.quantities(RegressionOutcome::better, false);
  if (!also_worse.empty()) others.push_back("worse in " + show::listed(also_worse));
  if (!also_better.empty()) others.push_back("better in " + show::listed(also_better));
  const char* const why = check.options.metrics.empty() ? "not in the plan" : "not in --metric";
  if (!others.empty()) text += fmt::format(" Not counted ({}): {}.", why, fmt::join(others, "; "));
  const JudgedMetric& last_asked = answer.metrics[answer.questions.back().metric];
  const bool is_time_tie_breaker =
      answer.questions.size() > 1 && last_asked.samples.quantity_kind == QuantityKind::time;
  if (check.label.empty() && !check.counts_times() && is_time_tie_breaker)
    text += " Times are not counted here. " + show::tie_breaker_sentence(answer);
  return text;
}

// Returns "Newly unsolved: run 57; newly solved: none; the other 199 solves are identical."; empty if no target
// changed.
std::string changed_targets_text(const RegressionCheck& check) {
  constexpr std::size_t max_names = 10;
  const std::size_t changed = check.newly_unsolved.size() + check.newly_solved.size();
  if (changed == 0) return "";
  const auto names_text = [](std::vector<std::string> targets) {
    if (targets.empty()) return std::string("none");
    if (targets.size() <= max_names) return show::listed(targets);
    const std::size_t more = targets.size() - max_names;
    targets.resize(max_names);
    return fmt::format("{} and {} more", fmt::join(targets, ", "), more);
  };
  const auto rest = check.judged.metrics.back().descriptives.front().n - static_cast<int>(changed);
  std::string same = check.identical_solves == rest
                         ? fmt::format("the other {} solves are identical", rest)
                         : fmt::format("identical: {} of the other {} solves", check.identical_solves, rest);
  if (rest == 0) same = "no other solves";
  return fmt::format("Newly unsolved{}: {}; newly solved: {}; {}.", check.label.empty() ? "" : " by " + check.label,
                     names_text(check.newly_unsolved), names_text(check.newly_solved), same);
}

// Returns whether something may differ: identical solves differ at most in their times.
bool may_differ(const RegressionCheck& check) { return !check.is_identical || check.counts_times(); }

// Returns one sentence on all labels whose solves are identical; empty if there are none.
std::string identical_text(const std::vector<RegressionCheck>& checks) {
  std::vector<std::string> names;
  int solves = 0;
  for (const RegressionCheck& check : checks) {
    if (!check.is_identical) continue;
    names.push_back(check.label.empty() ? show::listed({check.candidate, check.baseline}) : check.label);
    solves += check.judged.metrics.back().descriptives.front().n;
  }
  if (names.empty()) return "";
  return fmt::format("{}: all {} are identical, bit for bit.", show::listed(names), base::counted(solves, "solves"));
}

show::ReportModel make_report_model(const RegressionCheck& check) {
  show::ReportModel answer = show::make_report_model(check.judged);
  answer.verdict = verdict_text(check, answer);
  return answer;
}

// Returns a sentence on what times of this check decide.
std::string times_sentence(const RegressionCheck& check) {
  if (!check.counts_times() && check.label.empty()) return "Times do not affect the exit code.";
  if (!check.counts_times())
    return "Times are from different sessions: they are not compared and do not affect the exit code.";
  const auto time = std::ranges::find_if(check.judged.metrics, [](const JudgedMetric& judged) {
    const bool is_share = show::is_success_rate(judged);  // of targets solved in time
    return judged.samples.quantity_kind == QuantityKind::time && !is_share;
  });
  if (time == check.judged.metrics.end()) return "Times are not known.";
  return fmt::format("Times decide, with a margin of {}.", show::margin_text(*time));
}

// Returns a note on p and times that holds for all labels; empty if no label may differ.
std::string common_note(const std::vector<RegressionCheck>& checks) {
  if (std::ranges::none_of(checks, may_differ)) return "";
  const RegressionCheck& first = checks.front();
  const bool are_of_stores = !first.label.empty();
  const std::size_t metrics = names_in_plan(first.judged.study.definition).size();
  return fmt::format(
      "p is multiplied by the number of tested pairs of all labels{}{}. {}", are_of_stores ? "" : " of the store",
      metrics == 1 ? "" : fmt::format(" and by the {} metrics of the plan", metrics), times_sentence(first));
}

std::string screen_text(const std::vector<RegressionCheck>& checks) {
  std::string text;
  for (const RegressionCheck& check : checks) {
    if (!may_differ(check)) continue;
    const std::string targets = changed_targets_text(check);
    text += show::terminal_report(make_report_model(check));
    if (!targets.empty()) text += wrapped(targets) + '\n';
    text += '\n';
  }
  for (const std::string& note : {common_note(checks), identical_text(checks)})
    text += note.empty() ? "" : wrapped(note) + '\n';
  return text;
}

// Returns the JSON of a report, with the rows of all labels.
base::OrderedJson make_json(const std::vector<RegressionCheck>& checks, int code) {
  base::OrderedJson json;
  std::vector<std::string> sentences;
  for (const RegressionCheck& check : checks) {
    const std::string& label = check.label.empty() ? check.candidate : check.label;
    const show::ReportModel answer = make_report_model(check);
    base::OrderedJson report = show::to_json(answer);
    report["tests"] = base::OrderedJson::array();  // no omnibus test, because a check has two solvers
    for (const char* rows : {"groups", "comparisons"}) {
      for (auto& row : report[rows]) row["label"] = label;
    }
    for (auto& warning : report["warnings"]) warning = label + ": " + warning.get<std::string>();
    if (may_differ(check)) sentences.push_back(answer.verdict);
    report["metric"] = {{label, report["metric"]}};
    for (const auto& [member, value] : report.items()) {
      if (value.is_array() && json.contains(member))
        json[member].insert(json[member].end(), value.begin(), value.end());
      else if (value.is_object() && json.contains(member))
        json[member].update(value);
      else
        json[member] = value;
    }
    json["worse"][label] = check.quantities(RegressionOutcome::worse);
    json["new_failures"][label] = check.new_failures;
    json["newly_unsolved"][label] = check.newly_unsolved;
    json["newly_solved"][label] = check.newly_solved;
    json["better"][label] = check.quantities(RegressionOutcome::better);
    json["also_worse"][label] = check.quantities(RegressionOutcome::worse, false);
    json["also_better"][label] = check.quantities(RegressionOutcome::better, false);
    json["inconclusive"][label] = check.quantities(RegressionOutcome::inconclusive);
    json["not_tested"][label] = check.quantities(RegressionOutcome::not_tested);
  }
  if (const std::string same = identical_text(checks); !same.empty()) sentences.push_back(same);
  json["headline"] = fmt::format("{}", fmt::join(sentences, " "));
  json["files"] = base::OrderedJson::array();
  json["exit_code"] = code;
  return json;
}

std::string make_markdown(const std::vector<RegressionCheck>& checks) {
  std::string text;
  for (const RegressionCheck& check : checks) {
    if (!may_differ(check)) continue;
    const show::ReportModel answer = make_report_model(check);
    std::vector<std::string> sentences{changed_targets_text(check)};
    for (const Warning& warning : answer.all_warnings()) sentences.push_back(show::warning_sentence(warning));
    std::erase(sentences, "");
    text += fmt::format("**{}**\n\n{}\n{}\n{}\n\n", show::markdown_text(answer.verdict),
                        show::to_markdown(show::results_table(answer)), show::to_markdown(show::pairs_table(answer)),
                        show::markdown_text(fmt::format("{}", fmt::join(sentences, " "))));
  }
  const std::string same = show::markdown_text(identical_text(checks));
  std::vector<std::string> notes{show::markdown_text(common_note(checks)),
                                 same.empty() ? "" : fmt::format("**{}**", same)};
  std::erase(notes, "");
  return text + fmt::format("{}\n", fmt::join(notes, "\n\n"));
}

}  // namespace

void add_compare(const Command& command, Invocation& invocation) {
  auto arguments = std::make_shared<CompareArguments>();
  command.add("A", &arguments->a, "baseline: path of a store.sqlite, or a label of --store").required();
  command.add("B", &arguments->b, "candidate: path of a store.sqlite, or a label of --store").required();
  command.add("--store", &arguments->store, "the one store in which A and B are labels");
  add_study_option(command, arguments->study);
  command
      .add("--label", &arguments->labels,
           "with two stores: compare only this solver; repeatable; default: all solvers of A")
      .excludes("--store");
  command.add("--margin", &arguments->margin,
              "smallest relative difference that matters, such as 10%; default: that of the baseline's plan");
  command.add(
      "--time-margin", &arguments->time_margin,
      "let times decide, too, with this margin; two stores must have been solved in alternating rounds (cli/gate.sh "
      "with OLD)");
  command
      .add("--metric", &arguments->metrics,
           "only these metrics decide the exit code: solved,evaluations; default: all metrics of the study's plan")
      .separated_by_commas();
  command.add("--strict", &arguments->is_strict,
              "exit with code 4 if nothing is worse, but something is inconclusive or not tested");
  add_out_option(command, arguments->output, "also write the verdict as Markdown to this file");
  add_json_option(command, arguments->is_json);
  command.footer(
      "  ikbench compare before/store.sqlite after/store.sqlite --strict -o verdict.md\n"
      "  ikbench compare IK-BA mine --store out/my/store.sqlite --margin 10%\n\n"
      "Exit codes, first match wins:\n"
      "  3  something is worse and not shown to be within the margin, or there are new failures (no answer)\n"
      "  1  the command has a mistake, or A and B, or the times of --time-margin, could not be compared\n"
      "  4  --strict is given, and something is inconclusive or not tested\n"
      "  0  otherwise\n\n"
      "The metrics in the plan of the study decide: its metric and its tie-breakers. Times decide only with "
      "--time-margin. No option changes a p: for two labels of one store it is the p of the report.");
  command.callback([arguments, &invocation] {
    const std::vector<RegressionCheck> checks = compare_all(*arguments);
    invocation.exit_code = exit_code(checks, arguments->is_strict);
    if (!arguments->output.empty())
      base::write_through(arguments->output, [&](const base::Write& write) { write(make_markdown(checks)); });
    if (arguments->is_json) return show_json(make_json(checks, invocation.exit_code));
    fmt::print("{}", printable(screen_text(checks)));
  });
}

}  // namespace ikbench::cli
