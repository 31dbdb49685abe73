#include "analysis/show/methods_paragraph.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <set>
#include <utility>

#include "analysis/judge/statistics/closed_tests.hpp"
#include "analysis/show/phrases.hpp"
#include "analysis/show/text.hpp"
#include "base/names.hpp"
#include "base/units.hpp"

namespace ikbench::show {

using namespace judge;
using results::StudyDefinition;

namespace {

std::string list_of(const std::set<std::string>& texts) { return listed({texts.begin(), texts.end()}); }

// The arm and the targets.

std::string arm_text(const StudyDefinition& definition) {
  const std::string name = with_spaces(std::filesystem::path(definition.robot).stem().string());
  if (definition.tip_link.empty()) return name;
  return fmt::format("{} (from link {} to {})", name, definition.base_link, definition.tip_link);
}

std::string targets_phrase(const StudyDefinition& definition) {
  const bool is_one_each = definition.draws_targets && definition.points == 1;
  const int count = is_one_each ? definition.runs : definition.points;
  if (definition.is_grid())
    return fmt::format("{} of a grid ({})", base::counted(count, "targets"), definition.grid_text());
  if (definition.draws_targets) return base::counted(count, "random targets");
  const bool is_curve = definition.path == "helix" || definition.path == "circle";
  return base::counted(count, "targets") + (is_curve ? " on a " + definition.path : "");
}

std::string targets_sentence(const StudyDefinition& definition) {
  const std::string targets = targets_phrase(definition);
  const bool is_one_each = definition.draws_targets && definition.points == 1;
  if (is_one_each || definition.runs == 1) return fmt::format("Each was given the same {}.", targets);
  const std::string runs = base::counted(definition.runs, "runs");
  if (definition.draws_targets)
    return fmt::format("Each made {} of {}, which were drawn anew for each run but were the same for all solvers.",
                       runs, targets);
  return fmt::format("Each made {} of the same {}.", runs, targets);
}

std::string target_sentence(results::Search search) {
  switch (search) {
    case results::Search::wrist:
      return "A target is a position and an orientation; the joints before the spherical wrist were searched for the "
             "position, and the joints of the wrist followed in closed form.";
    case results::Search::all_joints:
      return "A target is a position, for which all joints were searched.";
    case results::Search::pose:
      return "A target is a position and an orientation, for which all joints were searched.";
    case results::Search::axis:
      return "A target is a position and the direction of the tool's z axis, for which all joints were searched.";
    case results::Search::flange:
      return "A target is a position, for which all joints but the last were searched.";
  }
  return "";
}

// The start and the end of a solve.

std::string start_text(const StudyDefinition& definition) {
  switch (definition.start) {
    case results::Start::previous:
      return "the previous answer";
    case results::Start::initial:
      return "the arm's initial configuration";
    case results::Start::middle:
      return "the middle of the joint limits";
    case results::Start::random:
      return "a random configuration that was the same for all solvers";
    case results::Start::near:
      return fmt::format(
          "a configuration within {} deg of one that reaches the target, which was the same for all solvers,",
          number_text(definition.near / base::degree));
  }
  return "";
}

std::string candidates_sentence(results::BoundsPolicy bounds) {
  if (bounds == results::BoundsPolicy::per_solver)
    return "Each solver treated candidates outside the joint limits by its own rule.";
  return "Candidates outside the joint limits were treated by the same rule for all solvers.";
}

std::string end_text(const Report& report) {
  const std::string limits = effort_limits_text(report.study);
  if (!report.study.definition.has_tolerance()) return limits;
  return fmt::format("within the tolerance ({}){}{}", tolerance_text(report.study), limits.empty() ? "" : ", or ",
                     limits);
}

// The measured quantities.

std::string limits_sentence(const StudyDefinition& definition) {
  if (definition.limits == results::LimitPolicy::enforced)
    return "An answer outside the joint limits was refused, and the arm stayed where it was.";
  return definition.has_tolerance() ? "An answer outside the joint limits counted as unsolved."
                                    : "An answer outside the joint limits was kept.";
}

std::string solved_sentence_of(const StudyDefinition& definition) {
  if (!definition.has_tolerance()) return "Errors were recomputed from the answers by forward kinematics.";
  return fmt::format(
      "A target counted as solved if the answer, recomputed by forward kinematics, was within the tolerance{}.",
      definition.check.process.empty() ? "" : " and passed the study's own check");
}

std::string time_sentence(const Report& report) {
  const auto is_time = [](const JudgedMetric& judged) { return judged.samples.quantity_kind == QuantityKind::time; };
  if (std::ranges::none_of(report.model.metrics, is_time)) return "";
  const std::string calls = timed_calls_text(report.study);
  return fmt::format("Times are wall-clock times of single calls{}.", calls.empty() ? "" : fmt::format(" ({})", calls));
}

// Returns the solvers of which at least one solve fulfils a condition, as in sentences; without the imported ones.
std::vector<std::string> solvers_where(const StudyResults& study, const auto& is_such) {
  std::vector<std::string> solvers;
  for (const std::string& solver : study.labels)
    if (!study.imported.has(solver) && std::ranges::any_of(study.of(solver), is_such))
      solvers.push_back(name_in_sentence(solver));
  return solvers;
}

// Returns a sentence for each kind of solver that was not measured as the others were.
std::vector<std::string> exception_sentences(const StudyResults& study) {
  std::vector<std::string> sentences;
  const auto is_elsewhere = [](const SolveSummary& solve) { return solve.timing == results::Timing::elsewhere; };
  const auto is_self_timed = [](const SolveSummary& solve) { return solve.is_self_timed; };
  const auto is_uncounted = [&](const SolveSummary& solve) {
    return !is_elsewhere(solve) && solve.counted_by != results::CountedBy::ikbench;
  };
  if (const auto solvers = solvers_where(study, is_elsewhere); !solvers.empty())
    sentences.push_back(fmt::format(
        "The answers of {} were made elsewhere and read from a file, so that the limits of the study did not stop {}.",
        enumerated(solvers), solvers.size() == 1 ? "it" : "them"));
  if (const auto solvers = solvers_where(study, is_uncounted); !solvers.empty())
    sentences.push_back(fmt::format("The evaluations of {} could not be counted, so that {} stopped by {} own rules.",
                                    enumerated(solvers), solvers.size() == 1 ? "it" : "they",
                                    solvers.size() == 1 ? "its" : "their"));
  if (const auto solvers = solvers_where(study, is_self_timed); !solvers.empty())
    sentences.push_back(fmt::format("The times of {} are self-reported.", enumerated(solvers)));
  std::vector<std::string> imported;
  for (const std::string& solver : study.imported.labels) imported.push_back(name_in_sentence(solver));
  if (!imported.empty())
    sentences.push_back(fmt::format("The solves of {} were made {}, and their times are not compared.",
                                    enumerated(imported), study.imported.origin));
  return sentences;
}

std::string cost_sentence(const ReportModel& model) {
  const auto is_cost = [](const JudgedMetric& judged) { return is_cost_per_success(judged.samples); };
  if (std::ranges::none_of(model.metrics, is_cost)) return "";
  return "A cost per success is the cost of all attempts divided by the number of targets solved.";
}

// The comparisons.

// The tests whose names do not become a phrase by the word "test" behind them.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> phrases_of_tests{
    {{closed_tests_name, closed_tests_name},
     {"Brunner-Munzel and Mann-Whitney", "the larger p of the Brunner-Munzel and Mann-Whitney tests"},
     {"Wilcoxon's signed ranks", "Wilcoxon's signed-rank test"},
     {"paired t", "the paired t test"},
     {"sign test", "the sign test"},
     {"sign test and Mann-Whitney", "the larger p of the sign test and the Mann-Whitney test"}}};

std::string phrase_of_test(std::string_view test) {
  const auto* const found = std::ranges::find(phrases_of_tests, test, [](const auto& pair) { return pair.first; });
  return found == phrases_of_tests.end() ? fmt::format("{} test", test) : std::string(found->second);
}

std::string tests_sentence(const ReportModel& model) {
  NamesByPhrase quantities;
  for (const JudgedMetric& judged : model.metrics) {
    for (const Comparison& comparison : judged.comparisons) {
      const auto* const tested = std::get_if<TestResult>(&comparison.result);
      if (tested != nullptr) quantities.add(phrase_of_test(tested->test), judged.samples.quantity);
    }
  }
  const auto& tests = quantities.entries;
  if (tests.empty()) return "";
  std::vector<std::string> texts;
  for (const auto& [test, names] : tests) texts.push_back(fmt::format("{} ({})", test, listed(names)));
  const std::string& control = model.primary().plan.control;
  std::string subject = model.primary().comparisons.size() == 1 ? "The two were" : "Pairs were";
  if (!control.empty())
    subject = fmt::format("Each of the others was compared with {}, and these pairs were", name_in_sentence(control));
  return fmt::format("{} tested by {}.", subject, tests.size() == 1 ? tests.front().first : enumerated(texts));
}

// Returns the sentences on p and on the intervals, which are corrected alike. Closed tests have no intervals.
std::vector<std::string> correction_sentences(const ReportModel& model) {
  const std::string noun = model.direction.empty() ? "solvers" : "groups";
  const AnalysisPlan& plan = model.primary().plan;
  std::vector<std::string> families;
  if (model.primary().comparisons.size() > 1) {
    families.emplace_back(model.metrics.size() == 1 ? "all pairs" : "all pairs of a metric");
  }
  if (model.named_metrics > 1)
    families.push_back(fmt::format("the {} metrics of the plan", number_word(model.named_metrics)));
  const std::vector<std::string> closed = closed_metrics(model);
  const bool has_intervals = closed.size() < model.metrics.size();
  std::string method = model.named_metrics > 1 || has_intervals ? "Bonferroni" : "closed tests";
  if (method == "Bonferroni" && !closed.empty())
    method += fmt::format("; the pairs {} by closed tests", has_intervals ? "of " + listed(closed) : "of each");
  std::string found = fmt::format("A difference is found if p is below {}", number_text(plan.significance));
  if (!families.empty())
    found += fmt::format("; {} corrected for {} ({})", has_intervals ? "p and intervals are" : "p is", listed(families),
                         method);
  found += '.';
  if (!has_intervals) return {found};
  const std::string brackets =
      fmt::format("Square brackets are {} % confidence intervals", number_text(100 * (1 - plan.significance)));
  // Values that may be negative have no margin by default.
  if (plan.margin <= 0 && model.primary().samples.absolute_margin <= 0) return {found, brackets + '.'};
  const bool has_shares = is_success_rate(model.primary()) && model.metrics.size() > 1;
  const std::string others = has_shares ? fmt::format(" ({} % in other metrics)", number_text(100 * plan.margin)) : "";
  return {found, fmt::format("{}, and two {} are equivalent if the interval of their difference lies within {}{}.",
                             brackets, noun, margin_text(model.primary()), others)};
}

// Returns a sentence on each effect size in the paragraph of results.
std::vector<std::string> effect_size_sentences(const ReportModel& model) {
  std::vector<std::string> sentences;
  const auto add = [&](const std::string& sentence) {
    if (std::ranges::count(sentences, sentence) == 0) sentences.push_back(sentence);
  };
  for (const JudgedMetric& judged : model.metrics) {
    if (!model.is_in_headline(judged)) continue;
    const bool is_paired = judged.samples.is_paired;
    for (const Comparison& comparison : judged.comparisons) {
      const auto* const tested = std::get_if<TestResult>(&comparison.result);
      if (tested == nullptr) continue;
      if (tested->hedges_g)
        add(is_paired ? "The effect size of means is g_av, Hedges' g of paired values."
                      : "The effect size of means is Hedges' g.");
      else if (shows_a12(*tested, judged))
        add(fmt::format("A12 is the share of {} in which the first is better, with equal ones counted half.",
                        is_paired ? model.noun : "pairs of values"));
    }
  }
  return sentences;
}

// Returns the sentence on the settings in which the study differs from the published one; few are named.
std::string departures_sentence(const StudyDefinition& definition) {
  const std::size_t count = definition.departures.size();
  if (count == 0) return "";
  const std::string nouns = count == 1 ? "setting differs" : fmt::format("{} settings differ", number_word(count));
  return as_sentence(fmt::format("{}{} from the published study.", count == 1 ? "one " : "", nouns));
}

std::vector<std::string> study_sentences_of(const Report& report) {
  const StudyDefinition& definition = report.study.definition;
  std::vector<std::string> labels;
  for (const std::string& label : report.study.labels) labels.push_back(name_in_sentence(label));
  std::vector<std::string> sentences{
      fmt::format("The {} on the arm {}.",
                  labels.size() == 1 ? fmt::format("solver {} was measured", labels.front())
                                     : fmt::format("solvers {} were compared", enumerated(labels)),
                  arm_text(definition)),
      targets_sentence(definition),
      target_sentence(definition.search),
      fmt::format("Each solve started from {} and stopped {}.", start_text(definition), end_text(report)),
      candidates_sentence(definition.bounds),
      solved_sentence_of(definition),
      limits_sentence(definition),
      time_sentence(report),
      cost_sentence(report.model)};
  std::ranges::move(exception_sentences(report.study), std::back_inserter(sentences));
  const std::set<std::string> jobs = environment_values(report.study, "jobs");
  if (!jobs.empty() && jobs != std::set<std::string>{"1"}) sentences.emplace_back("Several solves ran at a time.");
  return sentences;
}

// Returns the sentences on a user's file.
std::vector<std::string> file_sentences(const Report& report) {
  const ReportModel& model = report.model;
  std::vector<std::string> quantities, groups, larger;
  std::set<int> sizes;
  for (const JudgedMetric& judged : model.metrics) {
    quantities.push_back(judged.samples.quantity);
    if (judged.samples.better == Better::larger) larger.push_back(judged.samples.quantity);
  }
  for (const Group& group : model.primary().samples.groups) groups.push_back(name_in_sentence(group.name));
  for (const Descriptives& values : model.primary().descriptives) sizes.insert(values.n);
  const bool is_mixed = !larger.empty() && larger.size() < quantities.size();
  std::string direction = larger.empty() ? "smaller values" : "larger values";
  if (is_mixed) direction = fmt::format("larger values of {} and smaller ones of the others", listed(larger));
  const bool is_paired = model.primary().samples.is_paired;
  const std::string least = sizes.size() < 2 ? "" : fmt::format("{} to ", *sizes.begin());
  const std::string at_most = sizes.size() < 2 ? "" : "up to ";
  return {fmt::format("The groups {} of the file {} were compared in {}, where {} are better.", enumerated(groups),
                      report.study.name, listed(quantities), direction),
          is_paired ? fmt::format("The values are paired in {}{} blocks.", at_most, *sizes.rbegin())
                    : fmt::format("Each group has {}{} independent values.", least, *sizes.rbegin())};
}

}  // namespace

std::vector<std::string> methods_sentences(const Report& report) {
  const bool is_of_file = report.study.series.empty();
  std::vector<std::string> sentences = is_of_file ? file_sentences(report) : study_sentences_of(report);
  if (const std::string tests = tests_sentence(report.model); !tests.empty()) {
    sentences.push_back(tests);
    std::ranges::move(correction_sentences(report.model), std::back_inserter(sentences));
    std::ranges::move(effect_size_sentences(report.model), std::back_inserter(sentences));
  }
  if (!is_of_file) {
    sentences.push_back(fmt::format("All random numbers follow from the seed {}.", report.study.definition.seed));
    sentences.push_back(departures_sentence(report.study.definition));
  }
  std::erase(sentences, "");
  return sentences;
}

std::string methods_bracket(const Report& report, const std::string& program) {
  std::vector<std::string> facts;
  for (const char* fact : {"cpu", "os", "compiler"}) facts.push_back(list_of(environment_values(report.study, fact)));
  const std::string version = list_of(environment_values(report.study, "version"));
  const std::string commit = list_of(environment_values(report.study, "commit"));
  if (!version.empty()) facts.push_back("ikbench " + version);
  if (!commit.empty()) facts.push_back("commit " + commit);
  if (report.study.series.empty()) facts.push_back(program.substr(0, program.find(" (")));
  std::erase(facts, "");
  return facts.empty() ? "" : fmt::format("({}.)", fmt::join(facts, ", "));
}

}  // namespace ikbench::show
