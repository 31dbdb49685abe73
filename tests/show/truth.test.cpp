// What sentences, marks and tables may say is a table: every verdict and reason of each pair of two and of three
// solvers, in every order of their numbers, and drawn ones of ten. No sentence says more than its findings.
#include "tests/show/judged.hpp"

using namespace ikbench::judge;

namespace {

using What = std::variant<Tested, Fact, Open>;

Tested tested(Verdict verdict, bool is_small = false) {
  const bool is_better = verdict == Verdict::better, is_worse = verdict == Verdict::worse;
  Tested of{
      .verdict = verdict, .is_small = is_small, .p = is_better || is_worse ? 0.001 : 0.6, .test = "a test", .n = 20};
  of.effect = is_better ? Effect{0.8, 0.1} : is_worse ? Effect{0.1, 0.8} : Effect{0, 0};
  if (verdict == Verdict::undecided || verdict == Verdict::same) of.effect = Effect{0.5, 0.4};
  of.amount = Amount{is_better ? 0.5 : is_worse ? 2.0 : 1.0};
  return of;
}

Tested without_amount(Tested of) {  // its estimate would refute it
  of.amount.reset();
  return of;
}

Tested all_equal() {
  Tested of = tested(Verdict::undecided);
  of.p = 1, of.effect = Effect{0, 0};
  return of;
}

const std::vector<What>& all_kinds() {
  static const std::vector<What> kinds{tested(Verdict::better),
                                       tested(Verdict::better, true),
                                       without_amount(tested(Verdict::better)),
                                       tested(Verdict::worse),
                                       tested(Verdict::same),
                                       tested(Verdict::undecided),
                                       all_equal(),
                                       Fact{Verdict::better, {0.5}},
                                       Fact{Verdict::worse, {2}},
                                       Fact{Verdict::same, {1.01}},
                                       Open{.why = Open::Why::too_few, .n = 3, .needed = 4},
                                       Open{.why = Open::Why::lost},
                                       Open{.why = Open::Why::apart},
                                       Open{.why = Open::Why::few_decide, .n = 20}};
  return kinds;
}

// Solvers A, B, ... with these numbers, and a kind of finding for each pair.
Answer answer_with(const std::vector<double>& numbers, const std::vector<What>& kinds,
                   const std::string& control = "") {
  JudgedMetric judged{.observations = {.metric = "error", .quantity = "error", .unit = "mm"}, .plan = {}};
  judged.plan.control = control;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    judged.observations.groups.push_back(
        {.name = std::string(1, static_cast<char>('A' + i)), .sample = Measured{std::vector<double>(20, numbers[i])}});
    judged.described.push_back(describe(judged.observations.groups.back()));
  }
  std::size_t pair = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    for (std::size_t j = i + 1; j < numbers.size(); ++j) {
      const std::string first(1, static_cast<char>('A' + i)), second(1, static_cast<char>('A' + j));
      if (!control.empty() && first != control && second != control) continue;
      judged.findings.push_back({.first = first, .second = second, .scale = Scale::ratio, .what = kinds[pair++]});
    }
  }
  judged.headline = headline(judged.observations, judged.findings);
  return answer_of({std::move(judged)});
}

// The solvers that a part of a sentence names, and who is said to be what in it.
std::vector<std::string> named_in(const std::string& text) {
  std::vector<std::string> names;
  std::smatch found;
  for (std::string rest = text; std::regex_search(rest, found, std::regex("\\b[A-J]\\b")); rest = found.suffix())
    names.push_back(found.str());
  return names;
}
std::string between(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t begin = text.find(from);
  if (begin == std::string::npos) return "";
  const std::size_t at = begin + from.size();
  return text.substr(at, std::min(text.find_first_of(to, at), text.size()) - at);
}

// What a headline says too much; empty if nothing.
std::string too_much(const Answer& answer) {
  const JudgedMetric& judged = answer.decisive();
  const auto verdict = [&](const std::string& one, const std::string& other) {
    const Finding* const finding = finding_of(judged, one, other);
    if (finding == nullptr) return Verdict::not_tested;
    return finding->first == one ? verdict_of(*finding) : turned(verdict_of(*finding));
  };
  std::vector<std::string> all;
  for (const Group& group : judged.observations.groups) all.push_back(group.name);
  const auto each_pair = [&](const std::vector<std::string>& names, Verdict expected) {
    for (const std::string& one : names) {
      for (const std::string& other : names) {
        if (one < other && verdict(one, other) != expected) return false;
      }
    }
    return names.size() > 1;
  };
  const auto [subject, rest] = headline_of(answer);
  if (subject.starts_with("Against ")) {  // each with the words of its pair
    for (const Finding& finding : judged.findings) {
      const std::string words = verdict_words(finding, judged);
      if (subject.find(words) == std::string::npos) return "against the control: " + words;
    }
    return "";
  }
  const std::string text = subject + rest;
  if (const std::string names = between(text, "Not decided between ", ";."); !names.empty()) {
    if (!each_pair(named_in(names), Verdict::undecided)) return "not decided";
  }
  if (const std::size_t at = subject.find(" are the same within"); at != std::string::npos) {
    if (!each_pair(named_in(subject.substr(0, at)), Verdict::same)) return "the same";
  }
  for (const std::string& name : named_in(between(text, "not decided against ", ":;."))) {
    const std::vector<std::string> firsts = named_in(subject.substr(0, subject.find(" is better than ")));
    for (const std::string& first : named_in(subject.substr(0, subject.find(" are the same within")))) {
      if (firsts.size() == 1 && first != firsts.front()) continue;
      if (first != name && verdict(first, name) != Verdict::undecided) return "not decided against";
    }
  }
  for (const char* const is : {" is best", " are best", " is better than "}) {
    const std::size_t at = subject.find(is);
    if (at == std::string::npos) continue;
    const std::vector<std::string> best = named_in(subject.substr(0, at));
    const std::vector<std::string> others =
        std::string(is) == " is better than " ? named_in(subject.substr(at + std::string(is).size())) : all;
    for (const std::string& one : best) {
      for (const std::string& other : others) {
        if (std::ranges::count(best, other) == 0 && verdict(one, other) != Verdict::better) return "better";
        if (verdict(one, other) == Verdict::worse) return "best, and worse than one";
      }
    }
  }
  const std::vector<std::string> unbeaten = named_in(between(text, "Nobody is shown to beat ", ";."));
  for (const std::string& name : unbeaten) {
    for (const std::string& other : all) {
      if (verdict(name, other) == Verdict::worse) return "nobody beats";
    }
    if (name != unbeaten.front() && verdict(name, unbeaten.front()) == Verdict::not_tested) return "beside the first";
  }
  std::smatch found;
  if (std::regex_search(text, found, std::regex("ot tested against (the others|[A-J])[^:]*: ([^;.]*)"))) {
    const std::vector<std::string> apart = named_in(found.str(2));
    const bool is_of_one = found.str(1).size() == 1;
    for (const std::string& name : apart) {
      if (text.find(" more") != std::string::npos) break;
      for (const std::string& other : is_of_one ? std::vector{found.str(1)} : all) {
        if (std::ranges::count(apart, other) == 0 && verdict(name, other) != Verdict::not_tested) return "not tested";
      }
    }
  } else if (text.starts_with("Not tested") && !each_pair(all, Verdict::not_tested)) {
    return "none is tested";
  }
  for (std::string left = text;
       std::regex_search(left, found, std::regex("([^;:.]*) (?:is|are) worse than ([A-J])\\b"));
       left = found.suffix()) {
    for (const std::string& loser : named_in(found.str(1))) {
      const auto loses = [&](const std::string& other) { return verdict(loser, other) == Verdict::worse; };
      if (std::ranges::none_of(all, loses)) return "worse";
    }
  }
  return "";
}

// What a paragraph of results says wrongly or not at all: pairs with their words, or counts and those of the reference.
std::string wrong_in_results(const Answer& answer) {
  const JudgedMetric& judged = answer.decisive();
  const std::vector<std::string> sentences = results_of(answer);
  if (sentences.front() != headline(answer)) return "no headline";
  const std::string& pairs = sentences[1];
  const std::string reference = reference_of(answer);
  std::map<std::string, int> counts;
  std::map<std::string, std::set<std::string>> of_reference;
  for (const Finding& finding : judged.findings) {
    const Verdict verdict = verdict_of(finding);
    ++counts[is_difference(verdict) ? "decided" : std::string(judge::name_of(verdict))];
    const bool is_first = finding.first == reference;
    if (!is_first && finding.second != reference) continue;
    constexpr std::array words{"is better than", "is worse than", "is the same as", "is not decided against",
                               "is not tested against"};
    of_reference[words[static_cast<std::size_t>(is_first ? verdict : turned(verdict))]].insert(
        is_first ? finding.second : finding.first);
  }
  if (judged.findings.size() <= most_pairs) {
    for (const Finding& finding : judged.findings) {
      const std::string words = verdict_words(finding, judged);
      if (pairs.find(fmt::format("{} against {}: {}", finding.first, finding.second, words)) == std::string::npos)
        return "a pair";
    }
    return "";
  }
  for (const auto& [verdict, count] : counts) {
    if (pairs.find(fmt::format("{} {}", count, verdict)) == std::string::npos) return "counts";
  }
  for (const auto& [words, who] : of_reference) {
    const std::vector<std::string> named = named_in(between(pairs, fmt::format("{} {} ", reference, words), ";."));
    if (std::set<std::string>(named.begin(), named.end()) != who) return words;
  }
  return "";
}

// The same of the table of results and that of pairs.
std::string wrong_in_tables(const Answer& answer) {
  const JudgedMetric& judged = answer.decisive();
  const std::set<std::string> losers = losers_of(judged.findings);
  for (const auto& row : results_table(answer).rows) {
    const auto* const cell = std::get_if<Marked>(&row[1]);
    if (cell == nullptr) return "a number that is known is not shown";
    const std::string& name = std::get<std::string>(row[0]);
    if (judged.plan.control.empty() && (cell->mark == "*") != losers.contains(name)) return "a star";
    const Finding* const pair = finding_of(judged, name, reference_of(answer));
    const bool is_untested = pair && !losers.contains(reference_of(answer)) && verdict_of(*pair) == Verdict::not_tested;
    if (cell->is_best && (losers.contains(name) || is_untested)) return "bold";
  }
  const auto count = [](const Table& table, auto is_so) { return std::ranges::count_if(table.rows, is_so); };
  const auto is_decided = [](const std::vector<Cell>& row) {
    return std::get<Judgement>(row[11]).tone != Tone::neutral;
  };
  const auto decided =
      std::ranges::count_if(judged.findings, [](const Finding& finding) { return is_difference(verdict_of(finding)); });
  if (count(told_pairs(answer), is_decided) != decided) return "a decided pair is not told";
  const nlohmann::ordered_json json = to_json(answer);
  for (const auto& finding : json["findings"]) {
    if (finding.size() != json["findings"][0].size()) return "members of JSON";
    if (finding["p"].is_null() != !finding["reason"].is_null()) return "p or a reason";
  }
  return "";
}

int checked = 0;

void check(const std::vector<double>& numbers, const std::vector<What>& kinds, const std::string& control = "") {
  const Answer answer = answer_with(numbers, kinds, control);
  const std::string said = too_much(answer), shown = wrong_in_tables(answer), told = wrong_in_results(answer);
  ++checked;
  if (said.empty() && shown.empty() && told.empty()) return;
  std::string pairs;
  for (const Finding& finding : answer.decisive().findings)
    pairs += fmt::format("{}{} {}; ", finding.first, finding.second, name_of(verdict_of(finding)));
  CAPTURE(said, shown, told, results_of(answer), headline(answer), pairs, to_text(results_table(answer)));
  FAIL();
}

}  // namespace

TEST_CASE("no sentence says more than its findings, of two and three solvers", "[show]") {
  for (const What& kind : all_kinds()) {
    for (const std::vector<double>& numbers : std::vector<std::vector<double>>{{1, 2}, {2, 1}, {1, 1}}) {
      check(numbers, {kind});
      check(numbers, {kind}, "A");
    }
  }
  for (const What& ab : all_kinds()) {
    for (const What& ac : all_kinds()) {
      check({1, 2, 3}, {ab, ac}, "A");
      for (const What& bc : all_kinds()) {
        for (const std::vector<double>& numbers : std::vector<std::vector<double>>{
                 {1, 2, 3}, {1, 3, 2}, {2, 1, 3}, {3, 1, 2}, {2, 3, 1}, {3, 2, 1}, {1, 1, 1}})
          check(numbers, {ab, ac, bc});
      }
    }
  }
  CHECK(checked > 19'000);
}

TEST_CASE("no sentence says more than its findings, of ten solvers", "[show]") {
  std::mt19937_64 engine(5);
  for (int set = 0; set < 300; ++set) {
    std::vector<double> numbers;
    std::vector<What> kinds;
    const std::size_t most = 1 + engine() % all_kinds().size();  // few kinds agree more often
    for (int i = 0; i < 10; ++i) numbers.push_back(1 + static_cast<double>(engine() % 20));
    for (int i = 0; i < 45; ++i) kinds.push_back(all_kinds()[engine() % most]);
    check(numbers, kinds);
    check(numbers, kinds, "J");
  }
  CHECK(checked >= 600);
}
