// ikbench compare: is a solver worse than its baseline?
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

// "5%".
double margin_from(const std::string& text, const char* option = "--margin") {
  const auto value = text.ends_with('%') ? base::number_from(text.substr(0, text.size() - 1)) : std::nullopt;
  const double share = value ? *value / 100 : -1;
  if (!(share >= 0 && share <= results::margin_percent_range.second / 100))
    throw std::invalid_argument(fmt::format("{} {}; expected a share from 0% to {}%, such as 5%", option, text,
                                            results::margin_percent_range.second));
  return share;
}

struct StudyInStore {
  results::Store store;
  results::StoredStudy entry;

  StudyInStore(const std::string& file, const std::string& name)
      : store(file, results::Store::Mode::read), entry(store.study(name)) {}

  std::vector<std::string> labels() const { return labels_of(entry); }
  bool has(const std::string& label) const { return std::ranges::count(labels(), label) > 0; }
  void refuse_unknown(const std::string& label) const {
    if (!has(label)) throw std::invalid_argument(base::unknown_name("label", label, labels()));
  }
  // Reads all its labels, or one alone.
  StudyResults study(const CompareArguments& arguments, const std::string& label = "") const {
    results::StoredStudy part = entry;
    if (!label.empty()) std::erase_if(part.series, [&](const results::Series& its) { return its.label != label; });
    StudyResults study = read_checked(store, part);
    if (!arguments.margin.empty()) study.definition.plan.margin = margin_from(arguments.margin);
    return study;
  }
};

// The gates of all labels that both stores have, since the p of each pair counts them all: first those that are asked
// for. One of the others that cannot be compared, as it lacks solves, has no pair.
std::vector<RegressionCheck> gates_of(const StudyInStore& a, const StudyInStore& b,
                                      const std::vector<std::string>& asked, const CompareArguments& arguments,
                                      const RegressionOptions& options) {
  std::vector<RegressionCheck> all;
  for (const std::string& label : asked)
    all.push_back(gate(a.study(arguments, label), b.study(arguments, label), options));
  for (const std::string& label : a.labels()) {
    if (!b.has(label) || std::ranges::count(asked, label) > 0) continue;
    try {
      all.push_back(gate(a.study(arguments, label), b.study(arguments, label), options));
    } catch (const LacksSolves&) {
      continue;
    }
  }
  return all;
}

std::vector<RegressionCheck> compare_all(const CompareArguments& arguments) {
  std::vector<RegressionCheck> all;
  RegressionOptions options{.metrics = arguments.metrics};
  if (!arguments.time_margin.empty()) options.time_margin = margin_from(arguments.time_margin, "--time-margin");
  if (!arguments.store.empty()) {
    const StudyInStore both(arguments.store, arguments.study);
    if (arguments.a == arguments.b) throw std::invalid_argument("A and B are the same label; expected two");
    for (const std::string& label : {arguments.a, arguments.b}) both.refuse_unknown(label);
    all.push_back(gate(both.study(arguments), arguments.b, arguments.a, options));
    judge_all(all);
    return all;
  }
  const StudyInStore a(arguments.a, arguments.study), b(arguments.b, arguments.study);
  if (arguments.study.empty() && a.entry.name != b.entry.name)
    throw std::invalid_argument(
        fmt::format("the first study of A is {}, of B {}; expected one name for both: --study NAME if both stores have "
                    "it, else run B's study with the name of A's into a new folder (--out)",
                    a.entry.name, b.entry.name));
  std::vector<std::string> labels = arguments.labels;
  if (labels.empty()) {
    labels = a.labels();
    if (labels.empty()) throw std::invalid_argument(fmt::format("{} has no solvers to compare", arguments.a));
    std::vector<std::string> missing = labels;
    std::erase_if(missing, [&](const std::string& label) { return std::ranges::count(b.labels(), label) > 0; });
    if (!missing.empty())
      throw std::invalid_argument(
          fmt::format("not compared: the candidate lacks {}; run it too, or name with --label those to compare",
                      show::listed(missing)));
  }
  for (const std::string& label : labels) {
    if (std::ranges::count(labels, label) > 1)
      throw std::invalid_argument(fmt::format("the label {} is given twice", label));
    a.refuse_unknown(label);
    b.refuse_unknown(label);
  }
  all = gates_of(a, b, labels, arguments, options);
  judge_all(all);
  all.resize(labels.size());
  return all;
}

std::string not_tested_text(const show::ReportModel& answer, const JudgedMetric& judged) {
  const auto* const open = std::get_if<NotTested>(&judged.comparisons.front().result);
  if (open != nullptr) return show::reason_text(*open, show::observation_noun(answer, judged));
  return fmt::format("neither has {} any {}", judged.samples.quantity, answer.noun);
}

// "mine is worse than PSO: in solved and error. Not decided: joint motion.", "mine against PSO: new: 1 solve without an
// answer."
std::string verdict_of(const RegressionCheck& gate, const show::ReportModel& answer) {
  const std::string& candidate = gate.label.empty() ? gate.candidate : gate.label;
  const std::string& baseline = gate.baseline;
  if (!gate.is_compared)
    return fmt::format("{} is not compared with {}: {}.", candidate, baseline,
                       not_tested_text(answer, gate.judged.metrics[gate.judged.primary]));
  std::vector<std::string> parts;
  const bool is_worse = !gate.worse.empty(), is_open = !gate.inconclusive.empty() || !gate.not_tested.empty(),
             is_within = !gate.worse_below_margin.empty();
  if (is_worse) parts.push_back("in " + show::listed(gate.worse));
  if (!gate.better.empty()) parts.push_back((is_worse ? "better in " : "in ") + show::listed(gate.better));
  if (gate.new_failures > 0)
    parts.push_back(fmt::format("new: {} without an answer", base::counted(gate.new_failures, "solves")));
  std::string text = fmt::format("{} {} {}{}{}.", candidate,
                                 is_worse                ? "is worse than"
                                 : !gate.better.empty()  ? "is better than"
                                 : gate.new_failures > 0 ? "against"
                                 : is_open               ? "is not shown to be worse than"
                                 : is_within             ? "is not worse by more than the margin than"
                                                         : "is not worse than",
                                 baseline, parts.empty() ? "" : ": ", show::listed(parts, ", "));
  if (!gate.worse_below_margin.empty())
    text += fmt::format(" Worse by less than the margin: {}.", show::listed(gate.worse_below_margin));
  if (!gate.inconclusive.empty()) text += fmt::format(" Not decided: {}.", show::listed(gate.inconclusive));
  show::NamesByPhrase untested;  // by why
  for (const JudgedMetric& judged : gate.judged.metrics) {
    const std::string& quantity = judged.samples.quantity;
    if (std::ranges::count(gate.not_tested, quantity) > 0) untested.add(not_tested_text(answer, judged), quantity);
  }
  if (!untested.entries.empty())
    text += fmt::format(" Not tested: {}.", fmt::join(untested.formatted("{1} ({0})"), "; "));
  std::vector<std::string> others;
  if (!gate.also_worse.empty()) others.push_back("worse in " + show::listed(gate.also_worse));
  if (!gate.also_better.empty()) others.push_back("better in " + show::listed(gate.also_better));
  const char* const why = gate.options.metrics.empty() ? "Not in the plan" : "Not asked for";
  if (!others.empty()) text += fmt::format(" {}: {}.", why, fmt::join(others, "; "));
  const std::vector<show::HeadlineQuestion> questions = show::headline_questions(answer);
  const bool is_then_of_times =
      questions.size() > 1 && questions.back().metric->samples.quantity_kind == QuantityKind::time;
  if (gate.label.empty() && !gate.counts_times() && is_then_of_times)
    text += " Times decide nothing here. " + show::tie_breaker_sentence(answer);
  return text;
}

// "Lost: run 57; won: none; the other 199 are the same to the bit."
std::string changed_targets_text(const RegressionCheck& gate) {
  constexpr std::size_t most = 10;
  const std::size_t changed = gate.newly_unsolved.size() + gate.newly_solved.size();
  if (changed == 0) return "";
  const auto names = [](std::vector<std::string> all) {
    if (all.empty()) return std::string("none");
    if (all.size() <= most) return show::listed(all);
    const std::size_t more = all.size() - most;
    all.resize(most);
    return fmt::format("{} and {} more", fmt::join(all, ", "), more);
  };
  const auto rest = gate.judged.metrics.back().descriptives.front().n - static_cast<int>(changed);
  const std::string same = gate.identical_solves == rest
                               ? fmt::format("the other {} are the same to the bit", rest)
                               : fmt::format("the same to the bit: {} of the other {}", gate.identical_solves, rest);
  return fmt::format("{}: {}; won: {}; {}.", gate.label.empty() ? "Lost" : gate.label + " lost",
                     names(gate.newly_unsolved), names(gate.newly_solved), same);
}

// Something may differ.
bool is_told(const RegressionCheck& gate) { return !gate.is_identical || gate.counts_times(); }

// Of all that are the same, bit for bit, in one; empty if none are.
std::string verdict_of_same(const std::vector<RegressionCheck>& all) {
  std::vector<std::string> names;
  int solves = 0;
  for (const RegressionCheck& gate : all) {
    if (!gate.is_identical) continue;
    names.push_back(gate.label.empty() ? show::listed({gate.candidate, gate.baseline}) : gate.label);
    solves += gate.judged.metrics.back().descriptives.front().n;
  }
  if (names.empty()) return "";
  return fmt::format("{}: all solves are the same, bit for bit ({}).", show::listed(names),
                     base::counted(solves, "solves"));
}

show::ReportModel answer_of(const RegressionCheck& gate) {
  show::ReportModel answer = show::answer_of(gate.judged);
  answer.verdict = verdict_of(gate, answer);
  return answer;
}

// What all labels that differ have in common; empty if none does.
std::string gate_note(const std::vector<RegressionCheck>& all) {
  if (std::ranges::none_of(all, is_told)) return "";
  const JudgedStudy& judged = all.front().judged;
  const auto time = std::ranges::find_if(judged.metrics, [](const JudgedMetric& its) {
    return its.samples.quantity_kind == QuantityKind::time && !show::is_success_rate(its);  // which is in time
  });
  const bool do_times_decide = all.front().counts_times();
  const std::string times = !do_times_decide ? "do not count in the exit code"
                            : time == judged.metrics.end()
                                ? "are not known"
                                : fmt::format("decide by a margin of {}", show::margin_text(*time));
  const bool are_of_stores = !all.front().label.empty();
  const std::size_t metrics = names_in_plan(judged.study.definition).size();
  return fmt::format("p is multiplied by the number of pairs tested of {}{}. Times {}{}.",
                     are_of_stores ? "all labels" : "all labels of the store",
                     metrics == 1 ? "" : fmt::format(" and by the {} metrics of the plan", metrics),
                     !are_of_stores || do_times_decide ? "" : "of two sessions are not compared, and ", times);
}

std::string screen_of(const std::vector<RegressionCheck>& all) {
  std::string text;
  for (const RegressionCheck& gate : all) {
    const std::string targets = changed_targets_text(gate);
    text += is_told(gate)
                ? show::terminal_report(answer_of(gate)) + (targets.empty() ? "" : wrapped(targets) + '\n') + '\n'
                : "";
  }
  for (const std::string& last : {gate_note(all), verdict_of_same(all)})
    text += last.empty() ? "" : wrapped(last) + '\n';
  return text;
}

// That of a report, with the rows of all labels.
base::OrderedJson json_of(const std::vector<RegressionCheck>& all, int code) {
  base::OrderedJson json;
  std::vector<std::string> sentences;
  for (const RegressionCheck& gate : all) {
    const std::string& label = gate.label.empty() ? gate.candidate : gate.label;
    const show::ReportModel answer = answer_of(gate);
    base::OrderedJson report = show::to_json(answer);
    report["tests"] = base::OrderedJson::array();  // of all solvers at once: a gate has two
    for (const char* rows : {"groups", "findings"}) {
      for (auto& row : report[rows]) row["label"] = label;
    }
    for (auto& warning : report["doubts"]) warning = label + ": " + warning.get<std::string>();
    if (is_told(gate)) sentences.push_back(answer.verdict);
    report["metric"] = {{label, report["metric"]}};
    for (const auto& [member, value] : report.items()) {
      if (value.is_array() && json.contains(member))
        json[member].insert(json[member].end(), value.begin(), value.end());
      else if (value.is_object() && json.contains(member))
        json[member].update(value);
      else
        json[member] = value;
    }
    json["worse"][label] = gate.worse;
    json["newly_missing"][label] = gate.new_failures;
    json["lost"][label] = gate.newly_unsolved;
    json["won"][label] = gate.newly_solved;
    json["better"][label] = gate.better;
    json["also_worse"][label] = gate.also_worse;
    json["also_better"][label] = gate.also_better;
    json["undecided"][label] = gate.inconclusive;
    json["not_tested"][label] = gate.not_tested;
  }
  if (const std::string same = verdict_of_same(all); !same.empty()) sentences.push_back(same);
  json["headline"] = fmt::format("{}", fmt::join(sentences, " "));
  json["files"] = base::OrderedJson::array();
  json["exit_code"] = code;
  return json;
}

std::string markdown_of(const std::vector<RegressionCheck>& all) {
  std::string text;
  for (const RegressionCheck& gate : all) {
    if (!is_told(gate)) continue;
    const show::ReportModel answer = answer_of(gate);
    std::vector<std::string> sentences{changed_targets_text(gate)};
    for (const Warning& warning : answer.all_warnings()) sentences.push_back(show::warning_sentence(warning));
    std::erase(sentences, "");
    text += fmt::format("**{}**\n\n{}\n{}\n{}\n\n", show::markdown_text(answer.verdict),
                        show::to_markdown(show::results_table(answer)), show::to_markdown(show::pairs_table(answer)),
                        show::markdown_text(fmt::format("{}", fmt::join(sentences, " "))));
  }
  const std::string same = show::markdown_text(verdict_of_same(all));
  std::vector<std::string> last{show::markdown_text(gate_note(all)), same.empty() ? "" : fmt::format("**{}**", same)};
  std::erase(last, "");
  return text + fmt::format("{}\n", fmt::join(last, "\n\n"));
}

}  // namespace

void add_compare(const Command& command, Invocation& invocation) {
  auto arguments = std::make_shared<CompareArguments>();
  command.add("A", &arguments->a, "baseline: a store.sqlite, or with --store a label").required();
  command.add("B", &arguments->b, "candidate: a store.sqlite, or with --store a label").required();
  command.add("--store", &arguments->store, "store in which A and B are labels");
  add_study_option(command, arguments->study);
  command.add("--label", &arguments->labels, "with two stores: this solver alone; repeat for more; default: all of A")
      .excludes("--store");
  command.add("--margin", &arguments->margin,
              "relative difference that matters, such as 10%; default: that of the baseline's plan");
  command.add("--time-margin", &arguments->time_margin,
              "times decide, by this margin; two stores must have been solved in turn (cli/gate.sh with OLD)");
  command
      .add("--metric", &arguments->metrics,
           "only these decide the exit code: solved,evaluations; default: all that the study's plan names")
      .separated_by_commas();
  command.add("--strict", &arguments->is_strict, "exit with 4 if nothing is worse but something is not decided");
  add_out_option(command, arguments->output, "also write the verdict as Markdown to this file");
  add_json_option(command, arguments->is_json);
  command.footer(
      "  ikbench compare before/store.sqlite after/store.sqlite --strict -o verdict.md\n"
      "  ikbench compare IK-BA mine --store out/my/store.sqlite --margin 10%\n\n"
      "The exit code is 3 if something is shown to be worse, and not shown to be so by less than the margin, or if "
      "solves without an answer are new; 1 after a mistake, or else if A and B, or the times that --time-margin asks for, could not be compared; else 4 with "
      "--strict, if something is not decided or not tested; else 0.\n"
      "What the plan of the study names decides: its metric, and its `then`. Times decide nothing without "
      "--time-margin. No option changes a p: of two labels of a store it is that of the report.");
  command.callback([arguments, &invocation] {
    const std::vector<RegressionCheck> all = compare_all(*arguments);
    invocation.exit_code = exit_code(all, arguments->is_strict);
    if (!arguments->output.empty())
      base::write_through(arguments->output, [&](const base::Write& write) { write(markdown_of(all)); });
    if (arguments->is_json) return show_json(json_of(all, invocation.exit_code));
    fmt::print("{}", printable(screen_of(all)));
  });
}

}  // namespace ikbench::cli
