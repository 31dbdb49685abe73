// What sentences, marks and tables may say is a table: every verdict and reason of each pair of two and of three
// solvers, in every order of their numbers, and drawn ones of ten. No sentence says more than its findings.
#include "tests/show/judged.hpp"

using namespace ikbench::judge;

namespace {

Comparison tested(Verdict verdict, bool is_small = false) {
  const bool is_better = verdict == Verdict::better, is_worse = verdict == Verdict::worse;
  TestResult of{.verdict = verdict,
                .is_below_margin = is_small,
                .adjusted_p = is_better || is_worse ? 0.001 : 0.6,
                .test = "a test",
                .n = 20};
  of.dominance = is_better ? Dominance{0.8, 0.1} : is_worse ? Dominance{0.1, 0.8} : Dominance{0, 0};
  if (verdict == Verdict::inconclusive || verdict == Verdict::equivalent) of.dominance = Dominance{0.5, 0.4};
  return {.estimate = EffectEstimate{is_better ? 0.5 : is_worse ? 2.0 : 1.0}, .result = of};
}

Comparison without_amount(Comparison of) {  // its estimate would refute it
  of.estimate.reset();
  return of;
}

Comparison all_equal() {
  Comparison of = tested(Verdict::inconclusive);
  auto& result = std::get<TestResult>(of.result);
  result.adjusted_p = 1, result.dominance = Dominance{0, 0};
  return of;
}

Comparison fact(Verdict verdict, double amount) {
  return {.estimate = EffectEstimate{amount}, .result = DeterministicResult{verdict}};
}

const std::vector<Comparison>& all_kinds() {
  static const std::vector<Comparison> kinds{
      tested(Verdict::better),
      tested(Verdict::better, true),
      without_amount(tested(Verdict::better)),
      tested(Verdict::worse),
      tested(Verdict::equivalent),
      tested(Verdict::inconclusive),
      all_equal(),
      fact(Verdict::better, 0.5),
      fact(Verdict::worse, 2),
      fact(Verdict::equivalent, 1.01),
      {.result = NotTested{.reason = NotTestedReason::sample_too_small, .n = 3, .required_n = 4}},
      {.result = NotTested{.reason = NotTestedReason::missing_values}},
      {.result = NotTested{.reason = NotTestedReason::not_comparable}},
      {.result = NotTested{.reason = NotTestedReason::dominated, .n = 20}}};
  return kinds;
}

// Solvers A, B, ... with these numbers, and a kind of finding for each pair.
ReportModel answer_with(const std::vector<double>& numbers, const std::vector<Comparison>& kinds,
                        const std::string& control = "") {
  JudgedMetric judged{.samples = {.metric = "error", .quantity = "error", .unit = "mm"}, .plan = {}};
  judged.plan.control = control;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    judged.samples.groups.push_back(
        {.name = std::string(1, static_cast<char>('A' + i)), .sample = Sample{std::vector<double>(20, numbers[i])}});
    judged.descriptives.push_back(describe(judged.samples.groups.back()));
  }
  std::size_t pair = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    for (std::size_t j = i + 1; j < numbers.size(); ++j) {
      const std::string first(1, static_cast<char>('A' + i)), second(1, static_cast<char>('A' + j));
      if (!control.empty() && first != control && second != control) continue;
      Comparison& comparison = judged.comparisons.emplace_back(kinds[pair++]);
      comparison.first_index = i, comparison.second_index = j;
      comparison.first = first, comparison.second = second, comparison.scale = EffectScale::ratio;
    }
  }
  return make_report_model({std::move(judged)});
}

// A fact that no finding bears out, or who is left out; empty if all is well.
std::string too_much(const ReportModel& model) {
  using What = Statement::StatementKind;
  using Names = std::vector<std::string>;
  const JudgedMetric& judged = model.primary();
  const Names all = model.solvers();
  const std::set<std::string> losers = beaten_solvers(judged.comparisons);
  const auto each = [&](const Names& some, const Names& others, auto is_so) {
    for (const std::string& one : some) {
      for (const std::string& other : others) {
        const Comparison* const comparison = find_comparison(judged, one, other);
        if (one == other) continue;
        const Verdict verdict = comparison == nullptr      ? Verdict::not_tested
                                : comparison->first == one ? verdict_of(*comparison)
                                                           : reversed(verdict_of(*comparison));
        if (!is_so(verdict, comparison)) return false;
      }
    }
    return true;
  };
  const auto are = [](Verdict expected) {
    return [=](Verdict verdict, const Comparison*) { return verdict == expected; };
  };
  const auto are_alike = [](Verdict verdict, const Comparison* comparison) {
    return verdict == Verdict::equivalent || (comparison && all_values_equal(*comparison));
  };
  const auto are_little = [](Verdict, const Comparison* comparison) {
    return std::get<TestResult>(comparison->result).is_below_margin;
  };
  std::multiset<std::string> named;
  for (const auto& [what, who, against, is_little] : model.questions.front().statements) {
    const Names& others = against.empty() ? who : against;
    named.insert(who.begin(), who.end());
    if (what == What::best) named.insert(against.begin(), against.end());
    const bool is_so = what == What::no_comparison ? judged.comparisons.empty()
                       : what == What::best ? each(who, against, are(Verdict::better)) && each(who, who, are_alike)
                       : what == What::equivalent   ? each(who, others, are(Verdict::equivalent))
                       : what == What::inconclusive ? each(who, others, are(Verdict::inconclusive))
                       : what == What::better       ? each(who, against, are(Verdict::better))
                       : what == What::worse        ? each(who, against, are(Verdict::worse))
                       : what == What::not_tested ? each(who, against.empty() ? all : against, are(Verdict::not_tested))
                       : what == What::cyclic
                           ? std::ranges::all_of(who, [&](auto& name) { return losers.contains(name); })
                           : std::ranges::none_of(who, [&](auto& name) { return losers.contains(name); });
    if (!is_so || (is_little && !each(who, against, are_little)))
      return fmt::format("{}: {} against {}", static_cast<int>(what), fmt::join(who, " "), fmt::join(against, " "));
  }
  if (!judged.plan.control.empty() && all.size() > 2 && named.size() + 1 == all.size())
    named.insert(judged.plan.control);
  return named == std::multiset<std::string>(all.begin(), all.end()) ? "" : "who is told";
}

// What a paragraph of results has wrong: a verdict that no pair has, or a pair without its verdict.
std::string wrong_in_results(const ReportModel& model) {
  const JudgedMetric& judged = model.primary();
  const std::vector<std::string> sentences = results_sentences(model);
  if (sentences.size() > max_result_sentences) return "many sentences";
  const std::map<Verdict, const char*> words{{Verdict::better, "better than"},
                                             {Verdict::equivalent, "equivalent to"},
                                             {Verdict::inconclusive, "inconclusive"},
                                             {Verdict::not_tested, " tested"}};
  for (const auto& [verdict, word] : words) {
    const auto has_verdict = [&](const Comparison& comparison) {
      const Verdict found = verdict_of(comparison);
      return found == verdict || (found == Verdict::worse && verdict == Verdict::better);
    };
    const auto has_word = [&](const std::string& sentence) { return contains(sentence, word); };
    const bool is_said = std::ranges::any_of(sentences, has_word);
    if (is_said && std::ranges::none_of(judged.comparisons, has_verdict)) return word;
    if (judged.comparisons.size() > max_pairs) continue;
    for (const Comparison& comparison : judged.comparisons) {
      const auto is_about = [&](const std::string& sentence) {
        const bool has_names = contains(sentence, comparison.first) && contains(sentence, comparison.second);
        return has_word(sentence) && (has_names || contains(sentence, "no pair was tested"));
      };
      const bool are_many = verdict == Verdict::not_tested && judged.comparisons.size() > 4;
      if (has_verdict(comparison) && !are_many && std::ranges::none_of(sentences, is_about))
        return fmt::format("{} {} {}", comparison.first, word, comparison.second);
    }
  }
  return "";
}

// The same of the table of results and that of pairs.
std::string wrong_in_tables(const ReportModel& model) {
  const JudgedMetric& judged = model.primary();
  const std::set<std::string> losers = beaten_solvers(judged.comparisons);
  for (const auto& row : results_table(model).rows) {
    const auto* const cell = std::get_if<ValueCell>(&row[1]);
    if (cell == nullptr) return "a number that is known is not shown";
    const std::string& name = std::get<std::string>(row[0]);
    if (judged.plan.control.empty() && (cell->mark == "*") != losers.contains(name)) return "a star";
  }
  const auto count = [](const Table& table, auto is_so) { return std::ranges::count_if(table.rows, is_so); };
  const auto is_decided = [](const std::vector<Cell>& row) {
    return std::get<VerdictCell>(row[7]).tone != Tone::neutral;
  };
  const auto decided = std::ranges::count_if(
      judged.comparisons, [](const Comparison& comparison) { return is_difference(verdict_of(comparison)); });
  if (count(pairs_table(model), is_decided) != decided) return "a decided pair is not told";
  const nlohmann::ordered_json json = to_json(model);
  for (const auto& comparison : json["comparisons"]) {
    if (comparison.size() != json["comparisons"][0].size()) return "members of JSON";
    if (comparison["p"].is_null() != !comparison["reason"].is_null()) return "p or a reason";
  }
  return "";
}

int checked = 0;

void check(const std::vector<double>& numbers, const std::vector<Comparison>& kinds, const std::string& control = "") {
  const ReportModel model = answer_with(numbers, kinds, control);
  const std::string untrue = too_much(model), wrong_tables = wrong_in_tables(model), wrong = wrong_in_results(model);
  ++checked;
  if (untrue.empty() && wrong_tables.empty() && wrong.empty()) return;
  std::string pairs;
  for (const Comparison& comparison : model.primary().comparisons)
    pairs += fmt::format("{}{} {}; ", comparison.first, comparison.second, name_of(verdict_of(comparison)));
  CAPTURE(untrue, wrong_tables, wrong, results_sentences(model), headline(model), pairs, to_text(results_table(model)));
  FAIL();
}

}  // namespace

TEST_CASE("no sentence says more than its findings, of two and three solvers", "[show]") {
  for (const Comparison& kind : all_kinds()) {
    for (const std::vector<double>& numbers : std::vector<std::vector<double>>{{1, 2}, {2, 1}, {1, 1}}) {
      check(numbers, {kind});
      check(numbers, {kind}, "A");
    }
  }
  for (const Comparison& ab : all_kinds()) {
    for (const Comparison& ac : all_kinds()) {
      check({1, 2, 3}, {ab, ac}, "A");
      for (const Comparison& bc : all_kinds()) {
        // The first is the best, is not, or all are equal.
        for (const std::vector<double>& numbers : std::vector<std::vector<double>>{{1, 2, 3}, {3, 1, 2}, {1, 1, 1}})
          check(numbers, {ab, ac, bc});
      }
    }
  }
  CHECK(checked > 8'000);
}

TEST_CASE("no sentence says more than its findings, of ten solvers", "[show]") {
  std::mt19937_64 engine(5);
  for (int set = 0; set < 300; ++set) {
    std::vector<double> numbers;
    std::vector<Comparison> kinds;
    const std::size_t most = 1 + engine() % all_kinds().size();  // few kinds agree more often
    for (int i = 0; i < 10; ++i) numbers.push_back(1 + static_cast<double>(engine() % 20));
    for (int i = 0; i < 45; ++i) kinds.push_back(all_kinds()[engine() % most]);
    check(numbers, kinds);
    check(numbers, kinds, "J");
  }
  CHECK(checked >= 600);
}
