// CSVs of users: what is read from them, and what the engine says of it. tests/data/csv has files that were judged
// wrong.
#include "analysis/csv/user_csv.hpp"

#include "analysis/judge/statistics/omnibus.hpp"
#include "tests/judge/studies.hpp"
#include "tests/mistakes.hpp"

using csv::Quantities;
using csv::Request;

namespace {

Request smaller(Request request) {
  if (request.better.empty()) request.better = {"smaller"};
  return request;
}

MetricSamples samples_of(const std::string& text, const Request& request = {}) {
  return csv::read(text, "data.csv", smaller(request)).samples.front();
}

FlatComparison comparison_of(const std::string& text, const Request& request = {}, const std::string& margin = "") {
  MetricSamples of = samples_of(text, request);
  const judge::AnalysisPlan plan = csv::with_margin({}, margin, of);
  return judge::compared(of, plan).front();
}

// With the options that a question leaves open, and with its answers.
std::string said_exactly(const std::string& text, const Request& request = {}) {
  return complaint<std::invalid_argument>([&] {
    try {
      csv::read(text, "data.csv", request);
    } catch (const csv::MissingOption& question) {
      std::string said = fmt::format("{} [{}]", question.what(), fmt::join(question.options, " "));
      for (const auto& answer : question.answers) said += fmt::format(" [{}]", fmt::join(answer, " "));
      throw std::invalid_argument(said);
    }
  });
}
std::string statements_of(const std::string& text, const Request& request = {}) {
  return said_exactly(text, smaller(request));
}

const std::string wide = "a,b\n1.1,4.5\n2,5\n3,6.5\n2.5,4\n";
const std::string as_columns = "[] [--label columns --run row] [--label columns --block row]";

// The request with further options, as the command takes them.
Request with_options(Request request, const std::vector<std::string>& options) {
  for (std::size_t i = 0; i + 1 < options.size(); i += 2) {
    const std::string &option = options[i], &value = options[i + 1];
    if (option == "--run")
      request.run = value;
    else if (option == "--decimal")
      request.decimal = value.front();
    else if (option == "--missing")
      request.missing = value;
    else if (option == "--better")
      request.better.push_back(value);
    else if (option == "--label")
      request.label.push_back(value);
    else if (option == "--block")
      request.block.push_back(value);
    else
      request.values.push_back(value);
  }
  return request;
}

// Reads the text with each answer to what is asked, until nothing is; returns how many ways it was read.
int follow(const std::string& text, const Request& request, int depth = 0) {
  CAPTURE(depth, text, request.label, request.values, request.block, request.run);
  REQUIRE(depth < 4);
  try {
    csv::read(text, "data.csv", request);
    return 1;
  } catch (const csv::MissingOption& question) {
    CAPTURE(question.what());
    int ways = 0;
    for (const auto& answer : question.answers) ways += follow(text, with_options(request, answer), depth + 1);
    const bool is_open = !question.options.empty();  // a part of what is asked for
    CHECK((ways > 0 || is_open));
    return ways;
  }
}

}  // namespace

TEST_CASE("values near -5 are the same within 1, on differences") {
  const std::string text = text_in("tests/data/csv/drift.csv");
  CHECK(csv::read(text, "drift.csv", smaller({})).notes.size() == 2);  // how it was read, and on differences
  CHECK(comparison_of(text, {}, "1").verdict == Verdict::equivalent);
  CHECK(comparison_of(text).verdict == Verdict::inconclusive);  // a share of negative values is no margin
  CHECK_THROWS_AS(comparison_of(text, {}, "5%"), std::invalid_argument);
}

TEST_CASE("a zero in a third group changes no verdict on the two others") {
  const FlatComparison with = comparison_of(text_in("tests/data/csv/zero.csv"));
  const FlatComparison zero = comparison_of(text_in("tests/data/csv/zero0.csv"));
  CHECK(with.verdict == Verdict::better);
  CHECK(zero.verdict == Verdict::better);
  CHECK(*with.p == *zero.p);
  CHECK(with.scale == EffectScale::ratio);
  CHECK(zero.scale == EffectScale::difference);
}

TEST_CASE("rows without a label are left out and counted") {
  const MetricSamples samples = samples_of(text_in("tests/data/csv/stray-label.csv"));
  CHECK(samples.groups.size() == 2);
  REQUIRE(samples.warnings.size() == 1);
  CHECK(samples.warnings.front().count == 4);
  CHECK(samples.warnings.front().total == 12);
}

TEST_CASE("rows of several metrics are asked about, and --where takes one") {
  const std::string text = text_in("tests/data/csv/mixed-metrics.csv");
  CHECK(contains(statements_of(text), "[] [--label solver --value value] [--label metric --value value]"));
  CHECK(contains(statements_of(text, {.values = {"value"}, .label = {"solver"}}), "[] [--block seed --block metric]"));
  const Request chosen{.values = {"value"}, .label = {"solver"}, .run = "seed", .where = {"metric=error"}};
  CHECK(list_of(samples_of(text, chosen).groups.front()) == std::vector{0.10, 0.12, 0.11, 0.13});
  const std::string read = csv::read(text, "d.csv", smaller(chosen)).notes.front();
  CHECK(contains(read, "; only rows with 'metric=error'."));
  CHECK(read.starts_with("2 labels (solver), "));  // a title may be no noun
  // A column that --where fixed is named.
  CHECK(comparison_of("solver,metric,value\nA,e,1\nA,e,2\nA,t,9\nB,e,3\nB,e,4\nB,t,9\n", {.where = {"metric = e"}})
            .first == "A");
  CHECK(contains(statements_of(text, {.where = {"metric=speed"}}), "'metric=error'"));
  // A mean is of one metric: of a text that nobody named its rows have one.
  CHECK(contains(statements_of(text, {.values = {"value"}, .label = {"solver"}, .run = "seed"}),
                 "in column 'metric' is not"));
  CHECK(contains(statements_of("s,p,metric,v\nA,x,e,1\nA,x,t,2\nB,x,e,3\nB,x,t,4\n",
                               {.values = {"v"}, .label = {"s"}, .block = {"p"}, .run = "row"}),
                 "data.csv:3:3: 't' in column 'metric' is not 'e'"));
}

TEST_CASE("a text that nobody named may differ between labels, blocks and runs, and is told") {
  for (const std::string text : {"s,p,t,n,v\nA,x,one,1,1\nA,x,one,2,2\nB,x,one,1,3\nB,x,one,2,4\n",
                                 "s,p,t,n,v\nA,x,one,1,1\nA,x,one,2,2\nB,x,two,1,3\nB,x,two,2,4\n",
                                 "s,p,t,n,v\nA,x,one,1,1\nA,y,two,2,2\nB,x,one,1,3\nB,y,two,2,4\n"}) {
    const Request request{.values = {"v"}, .label = {"s"}, .block = {"p"}, .run = "n"};
    CHECK(contains(csv::read(text, "d.csv", smaller(request)).notes[0], "not used: 't'"));
  }
  CHECK(list_of(samples_of("s,t,n,v\nA,one,1,1\nA,two,2,2\nB,one,1,3\nB,two,2,4\n",
                           {.values = {"v"}, .label = {"s"}, .run = "n"})
                    .groups[0])
            .size() == 2);
}

TEST_CASE("a question counts no blank as a value") {
  try {
    csv::read("s,note,v\nA,,1\nA,x,2\nB,,3\nB,,4\n", "d.csv", {});
    FAIL("no question");
  } catch (const csv::MissingOption& question) {
    CHECK(question.columns[1][2] == "1 different");
  }
}

TEST_CASE("separators and decimal marks are found, or given") {
  const std::vector<double> a{0.5, 1.25}, b{3, 4};
  for (const std::string text :
       {"s,v\nA,0.5\nA,1.25\nB,3\nB,4\n", "s;v\nA;0,5\nA;1,25\nB;3\nB;4\n", "s\tv\nA\t0,5\nA\t1,25\nB\t3\nB\t4\n",
        "s;v\nA;0.5\nA;1.25\nB;3\nB;4\n", "\"s, or t\";v\nA;0,5\nA;1,25\nB;3\nB;4\n",
        "\xEF\xBB\xBFs;v\r\n\"A\"; 0,5 \r\nA;\"1,25\"\r\nB;3\r\nB;4\r\n;\r\n"}) {
    CAPTURE(text);
    const MetricSamples of = samples_of(text);
    REQUIRE(of.groups.size() == 2);
    CHECK(of.groups[0].name == "A");
    CHECK(list_of(of.groups[0]) == a);
    CHECK(list_of(of.groups[1]) == b);
  }
  CHECK(list_of(samples_of("s,v\nA,\"0,5\"\nA,\"1,25\"\nB,3\nB,4\n").groups[0]) == a);
  CHECK(list_of(samples_of("s,v\nA,1.020\nB,2.040\n").groups[0])[0] == 1.02);
}

TEST_CASE("titles are trimmed, and units belong to quantities") {
  const MetricSamples of = samples_of(" solver , error [mm] \nA,1\nB,2\n", {.values = {"error [mm]"}});
  CHECK(of.quantity == "error");
  CHECK(of.unit == "mm");
  CHECK(samples_of("solver,error_cm\nA,1\nB,2\n").unit == "cm");
  CHECK(samples_of("solver,time (ms)\nA,1\nB,2\n").unit == "ms");
}

TEST_CASE("a mark of thousands is told from that of decimals, or asked for") {
  const auto read = [](const std::string& cells, char decimal = 0) {
    return list_of(samples_of("s;v;w\nA;" + cells + "\nB;916;7\n",
                              {.values = {"v"}, .label = {"s"}, .run = "row", .decimal = decimal})
                       .groups[0])[0];
  };
  CHECK(read("1.020;7", ',') == 1020);
  CHECK(read("1.020;7", '.') == 1.02);
  CHECK(read("1.020;0,5") == 1020);  // by another column
  CHECK(read("1,020;0,5") == 1.02);
  CHECK(read("1,020;0.5") == 1020);
  CHECK(read("1.020,5;7") == 1020.5);
  CHECK(read("1,234,567;7") == 1234567);
  CHECK(read("0.123;7") == 0.123);
  CHECK(read("1020.123;7") == 1020.123);
  CHECK(read("1,5e3;7") == 1500);
  CHECK(list_of(samples_of("s;v\nA;1.020\nB;0.5\n").groups[0])[0] == 1.02);  // by another cell
}

TEST_CASE("which way is better is asked for, whatever a column is called") {
  std::string rates = "solver,success_rate\n", outcomes = "solver,collisions\n", both = "solver,error,score\n";
  for (int i = 0; i < 20; ++i) {
    rates += fmt::format("A,0.9{0}\nB,0.4{0}\n", i + 10);
    outcomes += "A,0\nB,1\n";
    both += fmt::format("A,{0},{0}\nB,5{0},5{0}\n", i + 10);
  }
  const std::string accuracy = text_in("tests/data/csv/accuracy.csv");
  for (const std::string& text : {rates, outcomes, accuracy, std::string("solver,time [ms]\nA,1\nA,2\nB,3\n")})
    CHECK(contains(said_exactly(text), "--better smaller or --better larger"));
  CHECK(comparison_of(accuracy, {.better = {"larger"}}).verdict == Verdict::better);  // A
  CHECK(comparison_of(accuracy, {.better = {"smaller"}}).verdict == Verdict::worse);
  CHECK(contains(said_exactly("name,n,mean,sd\nA,5,1,1\nB,5,2,1\n", {.are_summaries = true}), "--better larger"));
  const Request of_both{.values = {"error", "score"}};
  CHECK(contains(said_exactly(both, of_both), "--better error=larger"));
  Request half = of_both;
  half.better = {"error=smaller"};
  CHECK(contains(said_exactly(both, half), "[--better score=smaller] [--better score=larger]"));
  CHECK(follow(both, of_both) == 2);
  half.better.emplace_back("score=larger");
  CHECK(csv::read(both, "data.csv", half).samples[1].better == Better::larger);
  CHECK(comparison_of(outcomes, {.better = {"smaller"}}).verdict == Verdict::better);
  CHECK(comparison_of(rates, {.better = {"smaller", "success_rate=larger"}}).verdict == Verdict::better);
  CHECK(comparison_of(outcomes, {.better = {"larger"}}).verdict == Verdict::worse);
  CHECK(effect_scale(samples_of(outcomes, {.better = {"smaller"}})) == EffectScale::share);
  CHECK(samples_of("s,a=b\nA,1.5\nB,2\n", {.better = {"a=b=larger"}}).better == Better::larger);
  CHECK(contains(statements_of(rates, {.better = {"rate=larger"}}), "success_rate"));
  CHECK(contains(statements_of(rates, {.better = {"bigger"}}), "expected smaller"));
  for (const std::string column : {"", "success_rate="})
    CHECK(contains(statements_of(rates, {.better = {column + "smaller", column + "larger"}}), "contradicts"));
}

TEST_CASE("values of 0 are what they are, and differences are compared") {
  std::string blocks = "solver,problem,failures\n", runs = "solver,collisions\nA,5\nB,6\n";
  for (int i = 0; i < 80; ++i) blocks += fmt::format("A,{0},0\nB,{0},2\n", i);
  for (int i = 0; i < 99; ++i) runs += "A,0\nB,5\n";
  const FlatComparison of_blocks = comparison_of(blocks, {.values = {"failures"}, .block = {"problem"}});
  CHECK(of_blocks.verdict == Verdict::better);
  CHECK(*of_blocks.estimate == -2);
  CHECK(*of_blocks.p == Approx(std::exp2(-79)));
  CHECK(*comparison_of(runs).p == Approx(4.09e-44).epsilon(0.01));  // SciPy's Mann-Whitney
  CHECK(*comparison_of(runs).estimate == -5);
}

const Request dropped{.missing = "drop"}, worst{.missing = "worst"};

TEST_CASE("what missing values count as is asked, with an answer that runs") {
  for (const std::string gap : {"", "NA", "-", "nan", "None", "null", "#N/A"}) {
    CAPTURE(gap);
    const std::string text = "s,v\nA," + gap + "\nA,2\nA,1\nA,3\nA,4\nB,5\nB,6\nB,7\nB,8\n";
    CHECK(contains(statements_of(text), "1 of 9 rows have no value (A 1)"));
    const auto answers = [&](bool are_means) {
      try {
        csv::read(text, "data.csv", smaller({.are_means = are_means}));
      } catch (const csv::MissingOption& question) {
        return question.answers;
      }
      return std::vector<std::vector<std::string>>();
    };
    CHECK(answers(false) == std::vector<std::vector<std::string>>{{"--missing", "drop"}, {"--missing", "worst"}});
    CHECK(answers(true) == std::vector<std::vector<std::string>>{{"--missing", "drop"}});
    const MetricSamples without = samples_of(text, dropped), with = samples_of(text, worst);
    CHECK(list_of(without.groups.front()) == std::vector{2.0, 1.0, 3.0, 4.0});
    CHECK(std::isinf(list_of(with.groups.front()).front()));
    CHECK(without.warnings.front().kind == WarningKind::incomplete);
    CHECK(without.warnings.front().total == 9);
    CHECK(comparison_of(text, dropped).verdict == Verdict::better);
  }
}

TEST_CASE("rows that are unrelated are compared without those that have no value") {
  std::string text = "s,v\nA,NA\n", complete = "s,v\n";
  for (int i = 1; i <= 11; ++i)
    for (std::string* const each : {&text, &complete}) *each += fmt::format("A,{}\nB,{}\n", i, 20 + i);
  CHECK(*comparison_of(text, dropped).p == *comparison_of(complete).p);
  const FlatComparison as_worst = comparison_of(text, worst);
  CHECK(as_worst.verdict == Verdict::better);
  CHECK(*as_worst.p > *comparison_of(complete).p);
  Request larger = worst;
  larger.better = {"larger"};
  MetricSamples of_larger = csv::read(text, "data.csv", larger).samples.front();
  CHECK(std::isinf(list_of(of_larger.groups.front()).front()));
  CHECK(list_of(of_larger.groups.front()).front() < 0);
  const FlatComparison turned = judge::compared(of_larger, {}).front();
  CHECK(turned.verdict == Verdict::worse);
  larger.better = {"smaller"};
  CHECK(*turned.p < *as_worst.p);  // no answer is worse than any, here as there
  CHECK(describe(of_larger.groups.front()).mean < 0);
  const std::string shares = "s,v\nA,1\nA,NA\nA,1\nB,0\nB,0\nB,1\n";
  for (const auto& [better, value] : {std::pair{"larger", 0.0}, {"smaller", 1.0}}) {
    Request request = worst;
    request.better = {better};
    const MetricSamples of = csv::read(shares, "data.csv", request).samples.front();
    CHECK(effect_scale(of) == EffectScale::share);
    CHECK(list_of(of.groups.front())[1] == value);
  }
}

TEST_CASE("pairs are compared on the blocks that both have") {
  std::string text = "s,p,v\n";
  for (int p = 0; p < 12; ++p)
    for (const char group : {'A', 'B', 'C'})
      if (!(group == 'B' && p < 2) && !(group == 'C' && p > 9))
        text += fmt::format("{},{},{}\n", group, p, 1 + p + (group - 'A') * 0.5 + 0.01 * ((3 * p + group) % 5));
  const Request blocks{.block = {"p"}, .missing = "drop"};
  CHECK(contains(statements_of(text, {.block = {"p"}}), "4 of 36 rows have no value (C 2, B 2)"));
  const MetricSamples of = samples_of(text, blocks);
  const std::vector<FlatComparison> pairs = judge::compared(of, {});
  REQUIRE(pairs.size() == 3);
  CHECK(pairs[0].n == 10);
  CHECK(pairs[1].n == 10);
  CHECK(pairs[2].n == 8);
  for (const FlatComparison& pair : pairs) CHECK(pair.p.has_value());
  const auto complete = [&](char one, char other) {  // the blocks that both have
    std::string both = "s,p,v\n";
    for (int p = 2; p < 10; ++p)
      for (const char group : {one, other})
        both += fmt::format("{},{},{}\n", group, p, 1 + p + (group - 'A') * 0.5 + 0.01 * ((3 * p + group) % 5));
    return comparison_of(both, {.block = {"p"}});
  };
  CHECK(*pairs[2].p == Approx(3 * *complete('C', 'B').p));
  const auto [tests, without] = omnibus_tests(of);  // of the eight blocks that all have
  REQUIRE(!tests.empty());
  CHECK(tests.front().df_within == 14);
  const MetricSamples none = samples_of(text, {.block = {"p"}, .missing = "worst"});
  CHECK(list_of(none.groups[1]).size() == 12);
  CHECK(none.groups[1].name == "C");
  CHECK(std::isinf(list_of(none.groups[1]).back()));
  CHECK(std::isinf(list_of(none.groups[2]).front()));
}

TEST_CASE("leaving rows out favours who lacks more of them, which is said") {
  const auto kinds = [](int missing) {
    std::string text = "s,v\n";
    for (int i = 0; i < 20; ++i)
      text += fmt::format("A,{}\nB,{}\n", i < missing ? "NA" : fmt::to_string(i + 1), 2 * i + 1);
    const std::vector<judge::Warning> warnings = samples_of(text, dropped).warnings;
    return std::ranges::count(warnings, WarningKind::favoured_by_drop, &judge::Warning::kind);
  };
  CHECK(kinds(1) == 0);
  CHECK(kinds(2) == 0);  // a tenth
  CHECK(kinds(3) == 1);
}

TEST_CASE("one number for each label is no measurement, unless somebody says so") {
  std::string text = "s,view,v\n", one_varies = text;
  for (int i = 0; i < 8; ++i) {
    text += fmt::format("A,{0},700\nB,{0},400\n", i);
    one_varies += fmt::format("A,{0},{1}\nB,{0},400\n", i, 700 + i);
  }
  const Request unsaid{.values = {"v"}, .label = {"s"}};
  Request rows = unsaid, views = unsaid;
  rows.run = "row";
  views.block = {"view"};
  const auto unrelated = [](std::string rest) {  // two columns alone say nothing of rows
    std::string two = "s,v\n";
    for (std::istringstream lines(rest.substr(rest.find('\n') + 1)); std::getline(lines, rest);)
      two += rest.substr(0, 2) + rest.substr(rest.rfind(',') + 1) + '\n';
    return two;
  };
  MetricSamples of = samples_of(unrelated(text));
  CHECK(is_not_tested(judge::compare_pairs(of, {}).front(), NotTestedReason::copies));
  CHECK(comparison_of(unrelated(one_varies)).verdict == Verdict::worse);
  CHECK(comparison_of(text, rows).verdict == Verdict::worse);
  CHECK(comparison_of(text, views).verdict == Verdict::worse);
  CHECK(samples_of(text, views).warnings.front().kind == WarningKind::may_be_one_measurement);
  CHECK(samples_of(one_varies, views).warnings.empty());
  const MetricSamples shares = samples_of("s,v\nA,1\nA,1\nA,1\nB,0\nB,0\nB,0\n");
  CHECK_FALSE(is_not_tested(judge::compare_pairs(shares, {}).front(), NotTestedReason::copies));
}

// A against B, the last values of a group being infinite.
std::string with_infinite(int in_a, int in_b) {
  std::string text = "s,p,v\n";
  for (int i = 1; i <= 10; ++i)
    text += fmt::format("A,{0},{1}\nB,{0},{2}\n", i, i > 10 - in_a ? "inf" : fmt::to_string(i),
                        i > 10 - in_b ? "Inf" : fmt::to_string(2 * i));
  return text;
}

TEST_CASE("infinite values are no answer, larger than any, in tests of ranks") {
  const Request rows{.values = {"v"}, .label = {"s"}, .run = "row"}, blocks{.values = {"v"}, .block = {"p"}};
  const FlatComparison paired = comparison_of(with_infinite(0, 3), blocks);
  CHECK(paired.verdict == Verdict::better);
  CHECK(*paired.p == Approx(std::exp2(-9)));
  CHECK(paired.interval->low == 0);  // B may be infinitely worse
  CHECK(paired.interval->high < 1);
  const FlatComparison unpaired = comparison_of(with_infinite(0, 3), rows);
  CHECK(unpaired.interval->low == 0);
  const FlatComparison all = comparison_of(with_infinite(0, 10), rows);
  CHECK(*all.p == Approx(2 / 184756.0));  // 2 / C(20, 10)
  CHECK(!all.estimate);
  CHECK(*all.effect == 1);
  CHECK(is_not_tested(judge::compare_pairs(samples_of(with_infinite(10, 10), rows), {}).front(),
                      NotTestedReason::no_answer));
  const FlatComparison turned = better_first(comparison_of(with_infinite(10, 2), blocks), "");
  CHECK(turned.first == "B");
  CHECK(turned.verdict == Verdict::better);
  std::string differences = with_infinite(0, 3);  // a value of 0
  differences += "A,0,0\nB,0,1\n";
  CHECK(std::isinf(comparison_of(differences, blocks).interval->low));
  CHECK(comparison_of(with_infinite(2, 2), rows, "5%").verdict == Verdict::inconclusive);
  const MetricSamples samples = samples_of(with_infinite(0, 3), rows);
  CHECK(warning_text(samples.warnings.front()) == "3 of 20 values are infinite, which means no answer (B)");
  CHECK(is_not_tested(judge::compare_pairs(samples, {.test = AnalysisPlan::Test::means}).front(),
                      NotTestedReason::infinite_values));
  CHECK(std::isinf(describe(samples.groups[1]).mean));
  CHECK(describe(samples.groups[1]).median == 11);
  CHECK(contains(
      statements_of(with_infinite(0, 3), {.values = {"v"}, .label = {"s"}, .run = "row", .better = {"larger"}}),
      "data.csv:17:3"));
}

TEST_CASE("one layout is read without names: a column of texts and one of numbers") {
  for (const char* text : {"s,v\nA,1\nA,2\nB,4\n", "v,s\n1,A\n2,A\n4,B\n"}) {
    const MetricSamples of = samples_of(text);
    CHECK(of.quantity == "v");
    CHECK(list_of(of.groups[0]) == std::vector{1.0, 2.0});
  }
  // What is left beside named columns has one reading, too.
  CHECK(samples_of("p,s,v\nx,A,1\nx,B,2\n", {.block = {"p"}}).groups[0].name == "A");
  CHECK(samples_of("id,v\n1,1.5\n1,1.7\n2,2.5\n", {.label = {"id"}}).groups.size() == 2);
}

TEST_CASE("where a column stays unnamed it is asked what a row is") {
  const std::string text = "solver,seed,error\nA,1,1.5\nA,2,1.7\nB,1,2.5\nB,2,2.7\n";
  CHECK(contains(statements_of(text, {.label = {"solver"}, .better = {"larger"}}),
                 "[] [--value error --block seed] [--value error --run row]"));
  CHECK(contains(statements_of(text, {.values = {"error"}, .label = {"solver"}}), "[] [--block seed] [--run row]"));
  for (const char* run : {"row", "seed"})
    CHECK(list_of(samples_of(text, {.values = {"error"}, .label = {"solver"}, .run = run}).groups[0]).size() == 2);
  CHECK(samples_of(text, {.values = {"error"}, .label = {"solver"}, .block = {"seed"}}).is_paired);
  CHECK(contains(statements_of(wide, {.label = {"columns"}}), "[] [--run row] [--block row]"));  // rows may be problems
}

TEST_CASE("a question fills in what has one answer, and each of its answers can be read") {
  CHECK(contains(statements_of(wide), as_columns));
  CHECK(contains(said_exactly(wide), "[--label columns --run row --better smaller]"));
  const std::string of_two = "solver,seed,error\nA,1,1.5\nA,2,1.7\nB,1,2.5\nB,2,2.7\n";
  CHECK(contains(statements_of(of_two),
                 "[] [--label solver --value error --block seed] [--label solver --value error --run "));
  // Each patient had one treatment, so no treatments are compared within patients.
  std::string patients = "treatment,patient,visit,pressure\n", nested;
  for (int i = 0; i < 36; ++i)
    patients += fmt::format("{},p{},{},{}.5\n", i % 4 < 2 ? "A" : "B", i % 4, i / 4, 100 + i * i % 17);
  nested = statements_of(patients, {.label = {"treatment"}});
  CHECK(contains(nested, "[--value pressure --run patient]"));
  CHECK_FALSE(contains(nested, "--block patient"));
  CHECK(contains(statements_of("problem,A,B\nx,1.5,2\ny,2,3.5\nz,2,2.5\n"), "[--label columns --block problem]"));
  CHECK(contains(statements_of("scene,A,B\nx,1.5,2\nx,2,3.5\nz,2,2.5\n"),
                 "[] [--label scene --value A] [--label scene --value B]"));
  CHECK(
      contains(statements_of("id,v\n1,1.5\n1,1.7\n2,2.5\n2,4\n"), "[] [--label id --value v] [--label columns --run "));
  for (const std::string& text :
       {wide, of_two, patients, text_in("tests/data/csv/two-factors.csv"), text_in("tests/data/csv/mixed-metrics.csv"),
        text_in("tests/data/csv/versions.csv"), text_in("tests/data/csv/unequal-columns.csv"),
        std::string("s,p,v\nA,x,1\nA,y,2\nB,x,3\nB,y,\n"), std::string("s,note,v,w\nA,x,1,2\nA,x,1.5,2.5\nB,x,3,4\n"),
        std::string("plot,row,gen,yield\n1,1,A,5\n2,1,B,6\n3,2,A,5.5\n4,2,B,6.5\n"), std::string("a,b\n1.5,2\n1,3\n"),
        std::string("A,B\n0,1\n0,1\n1,0\n1,1\n")}) {
    for (const Request& request : {Request{}, Request{.better = {"larger"}}, Request{.label = {"columns"}}})
      if (request.label.empty() || !contains(statements_of(text, request), "there is only one")) follow(text, request);
  }
  CHECK(follow(wide, smaller({})) == 2);
}

TEST_CASE("a column that numbers the rows is never asked for, unless it is the only one of numbers") {
  for (const int first : {0, 1}) {
    std::string with = ",solver,error\n", columns = "\"\",a,b\n";
    for (int i = 0; i < 6; ++i) {
      with += fmt::format("{},{},{}.5\n", first + i, i % 2 ? "A" : "B", i * i);
      columns += fmt::format("\"{}\",{}.5,{}\n", first + i, i, 5 * i % 7);
    }
    const Quantities read = csv::read(with, "d.csv", smaller({}));
    CHECK(read.samples.front().quantity == "error");
    CHECK(contains(read.notes.front(), "not used: 'column 1'"));
    CHECK(contains(statements_of(columns), as_columns));
    CHECK(samples_of(columns, {.label = {"columns"}, .run = "row"}).groups.size() == 2);
    CHECK(samples_of(columns, {.label = {"columns"}, .block = {"column 1"}}).is_paired);
    // Rows that --where takes away leave it what it is.
    CHECK(csv::read(with, "d.csv", smaller({.values = {"error"}, .where = {"error=0.5"}})).samples[0].groups.size() ==
          1);
  }
  CHECK(list_of(samples_of("s,v\nA,1\nA,2\nB,3\nB,4\n").groups[0]) == std::vector{1.0, 2.0});
  CHECK(contains(statements_of("v,w,s\n0,0,A\n1,2,A\n2,1,A\n4,5,B\n"),
                 "[] [--label s --value v] [--label s --value w]"));  // 4 is no 3
  CHECK(contains(statements_of("n,v\n1,4\n2,6\n3,5\n", {.label = {"columns"}, .run = "row"}), "'n' numbers the rows"));
  CHECK(samples_of("n,v\n1,4\n2,6\n3,5\n", {.values = {"n", "v"}, .label = {"columns"}, .run = "row"}).groups.size() ==
        2);
}

TEST_CASE("rows in which Google Benchmark sums up others are left out, and told") {
  std::string text = "name,iterations,real_time,cpu_time,time_unit,label,error_occurred\n";
  for (const std::string name : {"BM_x", "BM_y_mean"}) {
    for (int i = 0; i < 4; ++i) text += fmt::format("\"{0}\",{1},{1}.5,2.5,ns,,\n", name, 1000 + i);
    for (const char* of : {"mean", "stddev", "p99"}) text += fmt::format("\"{}_{}\",4,7.5,2.5,ns,,\n", name, of);
  }
  text += "\"BM_BigO\",,8.5,8.5,(1),,\n\"BM_once\",5,8.5,8.5,ns,,\n";
  const Request times{.values = {"real_time"}, .label = {"name"}, .run = "row"};
  const Quantities read = csv::read(text, "d.csv", smaller(times));
  REQUIRE(read.samples[0].groups.size() == 3);
  CHECK(read.samples[0].groups[1].name == "BM_y_mean");  // repeated, so it is no aggregate
  CHECK(list_of(read.samples[0].groups[0]).size() == 4);
  CHECK(contains(fmt::format("{}", fmt::join(read.notes, " ")),
                 "Rows that summarise other rows are left out: BM_x_mean, "));
  Request asked = times;
  asked.where = {"name=BM_x_mean"};
  CHECK(list_of(samples_of(text, asked).groups[0]) == std::vector{7.5});
  CHECK(
      contains(statements_of(text + "\"BM_once\",5,8.5,8.5,us,,\n", times), "'us' in column 'time_unit' is not 'ns'"));
  // Other tables have labels as they like.
  CHECK(samples_of("name,v\nA,1\nA,2\nA_mean,1.5\nB,3\n").groups.size() == 3);
}

TEST_CASE("`row` is the file's column where it has one") {
  const std::string text = "plot,row,gen,yield\n7,1,A,5\n2,1,B,6\n3,2,A,5.5\n4,2,B,6.5\n";
  const MetricSamples of = samples_of(text, {.values = {"yield"}, .label = {"gen"}, .block = {"row"}});
  CHECK(of.is_paired);
  CHECK(list_of(of.groups[0]) == std::vector{5.0, 5.5});
  CHECK(contains(statements_of(text, {.values = {"yield"}, .label = {"gen"}}), "[--block row]"));
}

TEST_CASE("a question describes the columns, of many those that may be labels and values") {
  std::string text = "host,solver,seed,error\n", header = "remark", row = "x";
  for (int i = 0; i < 6; ++i) text += fmt::format("n1,{},{},{}.5\n", i % 2 ? "A" : "B", 2 * i, i * i);
  const auto page_of = [](const std::string& of) {
    try {
      csv::read(of, "data.csv", {});
    } catch (const csv::MissingOption& question) {
      return question.columns;
    }
    return std::vector<std::vector<std::string>>();
  };
  const std::vector<std::vector<std::string>> page = page_of(text);
  REQUIRE(page.size() == 4);
  CHECK(page[0] == std::vector<std::string>{"  host", "text", "1 different", "n1"});
  CHECK(page[2] == std::vector<std::string>{"  seed", "whole number", "6 different", "0"});
  CHECK(page[3] == std::vector<std::string>{"  error", "number", "6 different", "0.5"});
  for (int i = 0; i < 40; ++i) header += fmt::format(",c{}", i), row += ",same";
  const std::string many = header + ",who,error\n" + row + ",A,1.5\n" + row + ",A,2.5\n" + row + ",B,3.5\n";
  REQUIRE(page_of(many).size() == 15);
  CHECK(page_of(many)[0][0] == "  who");
  CHECK(page_of(many)[1][0] == "  error");
  CHECK(page_of(many).back() == std::vector<std::string>{"  and 29 more"});
}

TEST_CASE("wide files have a group a column, which may end early where rows are unrelated") {
  const Request rows{.label = {"columns"}, .run = "row"}, blocks{.label = {"columns"}, .block = {"row"}};
  CHECK(comparison_of(wide, rows).verdict == Verdict::better);
  CHECK(samples_of(wide, blocks).is_paired);
  const std::string gaps = "seed,a,b\n1,1.5,4.5\n2,,5\n3,2.1,6\n4,1.7,6\n5,,\n6,,5\n";
  Request of_two = rows;
  of_two.values = {"a", "b"};
  of_two.missing = "drop";
  const MetricSamples of = samples_of(gaps, of_two);
  REQUIRE(of.groups.size() == 2);
  CHECK(of.warnings.front().count == 2);  // not the two at the end of the first
  CHECK(of.warnings.front().total == 10);
  const FlatComparison unequal = comparison_of(text_in("tests/data/csv/unequal-columns.csv"), rows);
  CHECK(unequal.p.has_value());
  CHECK(list_of(samples_of(text_in("tests/data/csv/unequal-columns.csv"), rows).groups[1]).size() == 15);
  CHECK(contains(statements_of(text_in("tests/data/csv/unequal-columns.csv"), blocks), "--missing drop"));
  const MetricSamples of_sets =
      samples_of("set,a,b\n2,1.5,4.5\n5,1.2,7\n3,2.1,6\n", {.label = {"columns"}, .block = {"set"}});
  CHECK(of_sets.is_paired);
  CHECK(of_sets.groups.size() == 2);
}

TEST_CASE("of too few blocks it is said which column makes more") {
  const std::string text = text_in("tests/data/csv/two-factors.csv");
  const std::vector<std::string> notes =
      csv::read(text, "d.csv", smaller({.label = {"solver"}, .block = {"robot"}, .run = "seed"})).notes;
  CHECK(contains(fmt::format("{}", fmt::join(notes, " ")), "add --block seed: that makes 24 blocks"));
  CHECK(contains(fmt::format("{}", fmt::join(notes, " ")), "leave --block out and add --run row"));
  CHECK(comparison_of(text, {.block = {"robot", "seed"}}).verdict != Verdict::not_tested);
  CHECK(samples_of(text, {.label = {"solver", "robot"}, .run = "seed"}).groups.size() == 4);
}

TEST_CASE("tables of Markdown, org and MySQL, and thousands of the Swiss, are read") {
  for (const std::string text :
       {"| s | v |\n|---|--:|\n| A | 1000.5 |\n| B | 2 |\n", "| s | v |\n|---+---|\n| A | 1000.5 |\n| B | 2 |\n",
        "+---+---+\n| s | v |\n+---+---+\n| A | 1000.5 |\n| B | 2 |\n+---+---+\n", "\"sep=;\"\r\ns;v\nA;1'000.5\nB;2\n",
        "s;v\nA;1\u2019000.5\nB;2\n", "s;v\nA;1\u00a0000,5\nB;2\n", "s;v\nA;1\u2009000,5\nB;2\n",
        "s;v\nA;1.0005D+03\nB;\u22122\n"}) {
    CAPTURE(text);
    CHECK(list_of(samples_of(text).groups[0]) == std::vector{1000.5});
  }
  for (const std::string text :
       {"\n\n| s | v |\n|---|---|\n| A | **7** |\n\n| B | 2 |\n", "=== ===\ns   v\n=== ===\nA   7\nB   2\n=== ===\n",
        "s v\nA 7\n# the second part\nB 2\n", "sep=;\ns;v, in kg, dry\nA;7\nB;2\n", "s,v\n#1,7\n#2,2\n"})
    CHECK(list_of(samples_of(text).groups[0]) == std::vector{7.0});
  CHECK(contains(statements_of("A|B\n-|-\n1.5|2\n1.2|3\n", {.label = {"columns"}, .run = "row"}),
                 "2 of 6 rows have no value"));
}

TEST_CASE("names are taken as they are, and none looks like another") {
  CHECK(samples_of("solver,v\n\"a,\"\"b\"\"\n<c> $d$ \\e\",1\n'=1+1',2\n").groups[0].name == "a,\"b\"\n<c> $d$ \\e");
  // An index that pandas left without a name.
  CHECK(samples_of(",solver,error\n0,a,1.5\n1,a,2.25\n0,b,3.5\n1,b,4.25\n", {.block = {"column 1"}}).is_paired);
  CHECK(samples_of("so=lver,s,v\na=b,x,1.5\na=b,y,2.5\nc,x,9\n", {.where = {"so=lver=a=b"}}).groups.size() == 2);
  CHECK(contains(statements_of("s,v\n\xe4,1.5\n\xe4,2.5\n\xf6,3.5\n\xf6,4.5\n"),
                 "data.csv:2: letters in another encoding"));
  CHECK(contains(statements_of("s,v\na,1\na\u200b,2\n"), "two groups look alike"));
  CHECK(contains(statements_of("s,v\n\"a\nb\",1.5\n\"a\nb\",2.5\na b,3.5\na b,4.5\n"), "two groups look alike"));
}

TEST_CASE("True and False are 1 and 0") {
  const std::string text = "solver,solved\nA,True\nA,True\nB,FALSE\nB,yes\n";
  const MetricSamples of = samples_of(text, {.better = {"larger"}});
  CHECK(csv::read(text, "d.csv", smaller({})).notes.back() == "All values of solved are 0 or 1: shares are compared.");
  CHECK(of.quantity == "solved");
  CHECK(effect_scale(of) == EffectScale::share);
  CHECK(list_of(of.groups[1]) == std::vector{0.0, 1.0});
  // They may name the groups.
  const std::string pairs = "scene,optimized,time\nx,yes,1\nx,no,2.5\ny,yes,2\ny,no,3\nz,yes,5\nz,no,4\n";
  CHECK(samples_of(pairs, {.label = {"optimized"}, .block = {"scene"}}).groups[1].name == "no");
}

TEST_CASE("a value counts although it is the sum or the mean of those above it") {
  const Request columns{.label = {"columns"}, .run = "row"};
  // Each solver fails once: the sum of its other values is infinite, too.
  const std::string failures = "A,B\n1.1,2.1\ninf,1.9\n0.9,inf\n1.3,2.3\n1.2,2.2\n1.05,2.05\n0.95,1.95\n";
  for (const Request& request : {columns, Request{.label = {"columns"}, .block = {"row"}}}) {
    const MetricSamples samples = samples_of(failures, request);
    CHECK(list_of(samples.groups[0]).back() == 0.95);
    CHECK(list_of(samples.groups[1]).back() == 1.95);
    CHECK(comparison_of(failures, request).p.has_value());
  }
  CHECK(*comparison_of(failures, columns).p == Approx(0.032410375));  // Brunner and Munzel's, by hand
  // The mean of the others is nearer to each value than its ninth digit.
  for (const auto& [offset, spread] : {std::pair{1e9, 0.01}, {1.0, 1e-10}}) {
    std::string near = "A,B\n";
    for (const int i : {1, 5, 3, 9, 4, 7, 2}) near += fmt::format("{},{}\n", offset + i * spread, offset - i * spread);
    CHECK(comparison_of(near, columns).first == "A");
  }
  // So do rows of totals, which --where leaves out.
  const std::string totals = "s,kind,v\nA,value,1.5\nA,value,2\nA,total,3.5\nB,value,4\nB,value,5.5\nB,total,9.5\n";
  CHECK(list_of(samples_of(totals, {.values = {"v"}, .label = {"s"}, .run = "row"}).groups[0]).size() == 3);
  CHECK(list_of(samples_of(totals, {.where = {"kind=value"}}).groups[1]) == std::vector{4.0, 5.5});
}

TEST_CASE("several columns of labels or blocks are joined") {
  const std::string text = "scene,seed,alg,h,time\nx,1,A,1,1\nx,2,A,1,2\ny,1,A,1,3\nx,1,A,2,4\nx,2,A,2,5\ny,1,A,2,6\n";
  const MetricSamples of = samples_of(text, {.values = {"time"}, .label = {"alg", "h"}, .block = {"scene", "seed"}});
  REQUIRE(of.groups.size() == 2);
  CHECK(of.groups[1].name == "A / 2");
  CHECK(list_of(of.groups[1]) == std::vector{4.0, 5.0, 6.0});
}

TEST_CASE("rows of a run are averaged where asked, else refused") {
  const std::string text = "solver,run,point,e\nA,1,1,1\nA,1,2,3\nA,2,1,2\nA,2,2,6\nB,1,1,9\nB,1,2,9\nB,2,1,7\n";
  const MetricSamples samples = samples_of(text, {.values = {"e"}, .label = {"solver"}, .run = "run"});
  CHECK(list_of(samples.groups[0]) == std::vector{2.0, 4.0});
  CHECK(list_of(samples.groups[1]) == std::vector{9.0, 7.0});  // its second run has one row
  CHECK(list_of(samples_of("s,p,v\nA,x,1\nA,x,2\nB,x,3\nB,x,4\n", {.block = {"p"}, .run = "row"}).groups[0]) ==
        std::vector{1.5});
  // Of B's second run a point is missing.
  CHECK(contains(statements_of(text, {.block = {"point"}, .run = "run"}), "1 of 8 rows have no value (B 1)"));
  const MetricSamples blocks = samples_of(text, {.block = {"point"}, .run = "run", .missing = "drop"});
  CHECK(list_of(blocks.groups[0]) == std::vector{1.5, 4.5});
  CHECK(list_of(blocks.groups[1]) == std::vector{8.0, 9.0});
  CHECK(blocks.warnings.front().kind == WarningKind::incomplete);
  const Request runs{.values = {"e"}, .label = {"solver"}, .block = {"run"}, .run = "run", .missing = "drop"};
  CHECK(samples_of(text, runs).is_paired);
}

TEST_CASE("a run counts by its mean, however many rows it has") {
  const Request of_runs{.values = {"e"}, .label = {"s"}, .run = "run"};
  std::string equal = "s,run,step,e\n", longer = equal;
  for (int run = 0; run < 6; ++run)
    for (int step = 0; step < 3; ++step)
      for (std::string* const text : {&equal, &longer})
        *text += fmt::format("A,{0},{1},{2}\nB,{0},{1},{3}\n", run, step, run + step, 10 + run + step);
  longer += "B,5,3,16\nA,4,3,5\nA,4,4,5\n";  // a run's mean, again
  CHECK(missing_in(samples_of(longer, of_runs).groups[0]) == 0);
  CHECK(samples_of(longer, of_runs).warnings.empty());
  CHECK(list_of(samples_of(longer, of_runs).groups[1]) == list_of(samples_of(equal, of_runs).groups[1]));
  CHECK(*comparison_of(longer, of_runs).p == *comparison_of(equal, of_runs).p);
  CHECK(contains(csv::read(equal, "d.csv", smaller(of_runs)).notes[0], ", means of 3 rows"));
  CHECK(contains(csv::read(longer, "d.csv", smaller(of_runs)).notes[0], ", means of 3 to 5 rows"));
  Request lacking = of_runs;
  lacking.missing = "drop";
  const std::string gap = longer + "B,0,3,NA\n";
  CHECK(list_of(samples_of(gap, lacking).groups[1]) == list_of(samples_of(longer, of_runs).groups[1]));
  CHECK(samples_of(gap, lacking).warnings.front().count == 1);
  lacking.missing = "worst";
  CHECK(std::isinf(list_of(samples_of(gap, lacking).groups[1]).front()));
}

TEST_CASE("values of 0 and 1 are shares, and of several runs a target too") {
  const std::vector<std::string> better{"larger"};
  MetricSamples of = samples_of("s,v\nA,1\nA,1\nA,0\nB,0\nB,0\nB,1\n", {.better = better});
  CHECK(effect_scale(of) == EffectScale::share);
  CHECK(trials_per_value(of) == 1);
  CHECK(effect_scale(samples_of("s,v\nA,1\nA,NA\nA,0\nB,0\nB,0\nB,1\n", {.better = better, .missing = "drop"})) ==
        EffectScale::share);
  CHECK_THROWS_AS(csv::with_margin({}, "0.1", of), std::invalid_argument);
  const MetricSamples several = samples_of("s,p,r,v\nA,1,1,1\nA,1,2,0\nB,1,1,1\nB,1,2,1\n",
                                           {.values = {"v"}, .block = {"p"}, .run = "r", .better = better});
  CHECK(trials_per_value(several) == 2);
  CHECK(list_of(several.groups[0]) == std::vector{0.5});
  std::string text = "s,p,r,v\n";
  for (int run = 0; run < 1000; ++run)
    text += fmt::format("A,1,{0},{1}\nB,1,{0},{2}\n", run, run % 3 ? 0 : 1, run > 333 ? 0 : 1);
  const MetricSamples equal = samples_of(text, {.values = {"v"}, .block = {"p"}, .run = "r", .better = better});
  CHECK(list_of(equal.groups[0]) == list_of(equal.groups[1]));  // in whichever order the runs were solved
}

TEST_CASE("margins are shares or in the unit of the values") {
  MetricSamples of = samples_of(wide, {.label = {"columns"}, .run = "row"});
  CHECK(csv::with_margin({}, "", of).margin == 0.05);
  CHECK(csv::with_margin({}, "10%", of).margin == Approx(0.1));
  const judge::AnalysisPlan plan = csv::with_margin({}, "0.5", of);
  CHECK(plan.margin == 0);
  CHECK(of.absolute_margin == 0.5);
  for (const char* margin : {"x", "-1", "%", "nan", "inf", "10"})
    CHECK_THROWS_AS(csv::with_margin({}, margin, of), std::invalid_argument);
}

TEST_CASE("printed means are compared by means") {
  const Request summaries = smaller({.are_summaries = true});
  const Quantities read = csv::read(text_in("results/published/slim2023/table-3.csv"), "table-3.csv", summaries);
  REQUIRE(read.samples.size() == 3);
  const MetricSamples& error = read.samples.front();
  CHECK(error.groups.size() == 6);
  CHECK(std::get<judge::SummaryStatistics>(error.groups.front().sample).sd == 1.7824e-4);
  const std::vector<FlatComparison> found = judge::compared(error, {});
  CHECK(found.front().test == "Welch's t");
  CHECK(found.front().verdict == Verdict::better);  // IK-BA against BA
  CHECK(*found.front().estimate == Approx(0.0019 - 1.6849));
  CHECK(csv::read("name,n,mean,sd,metric\nA,5,1,1,\u8bef\nA,5,1,1,\u65f6\n", "s.csv", smaller({.are_summaries = true}))
            .samples.size() == 2);
  const Quantities usual = csv::read("name,n_runs,avg,std_dev\nA,5,1,2\n", "s.csv", smaller({.are_summaries = true}));
  CHECK(std::get<judge::SummaryStatistics>(usual.samples.front().groups.front().sample).sd == 2);
  // pytest-benchmark counts rounds, of texts it has another column, and hyperfine counts nothing.
  const Quantities rounds = csv::read(
      "name,min,mean,stddev,outliers,ops,rounds\na,1,1.5,.1,1;2,9,20\nb,2,2.5,.1,0;1,9,30\n", "s.csv", summaries);
  CHECK(std::get<judge::SummaryStatistics>(rounds.samples.front().groups.back().sample).n == 30);
  const std::string of_hyperfine =
      "command,mean,stddev,median,user,system,min,max\na,1,.1,1,1,1,1,1\nb,2,.1,2,2,2,2,2\n";
  CHECK(contains(statements_of(of_hyperfine, summaries), "[--n N]"));
  Request with_n = summaries;
  with_n.n = 10;
  const MetricSamples ten = csv::read(of_hyperfine, "s.csv", with_n).samples.front();
  CHECK(std::get<judge::SummaryStatistics>(ten.groups.back().sample).n == 10);
  CHECK(contains(statements_of("name,n,mean,sd\nA,5,1,1\nB,5,2,1\n", with_n), "leave --n out"));
  // Who does not say --summaries is told, also where the labels are named.
  CHECK(contains(statements_of(of_hyperfine), "[--summaries --n N]"));
  const std::string of_three = "solver,best,average,std_dev,n_runs\nA,1,1.2,.1,20\nB,1,1.4,.1,20\nC,1,1.5,.1,20\n";
  CHECK(contains(statements_of(of_three), "[] [--summaries]"));
  CHECK(contains(statements_of(of_three, {.values = {"average"}, .label = {"solver"}, .run = "row"}),
                 "[] [--summaries]"));
  CHECK(csv::read(of_three, "s.csv",
                  smaller({.values = {"average"}, .label = {"solver"}, .run = "row", .are_summaries = true}))
            .samples.front()
            .groups.size() == 3);
  for (const char* text : {"name,n,mean,sd\nA,2.5,1,1\n", "name,n,mean,sd\nA,5,1,-1\n", "name,n,mean\nA,5,1\n",
                           "name,n,mean,sd\nA,5,1,1\nA,5,2,1\n"})
    CHECK_THROWS_AS(csv::read(text, "s.csv", summaries), std::invalid_argument);
}

TEST_CASE("printed means without a spread decide nothing") {
  const Quantities read = csv::read("name,n,mean,sd\nA,20,1,0\nB,20,1.1,0\nC,20,1,0.1\nD,20,2,0.1\n", "s.csv",
                                    smaller({.are_summaries = true}));
  CHECK(read.samples.front().warnings.size() == 2);
  const std::vector<FlatComparison> found = judge::compared(read.samples.front(), {});
  for (const FlatComparison& each : found)
    CHECK((each.verdict == Verdict::not_tested) == (each.first == "A" || each.first == "B"));
  CHECK(found.back().verdict == Verdict::better);
}

TEST_CASE("mistakes say where and what to do") {
  check_mistakes("csv", "data.csv", [](std::string text) {
    std::vector<std::string> options;  // before the text
    for (std::string option, value; text.starts_with("--");
         text.erase(0, text.find_first_of(" \n", text.find(' ') + 1) + 1)) {
      std::istringstream(text) >> option >> value;
      options.insert(options.end(), {option, value});
    }
    const Request request = with_options({}, options);
    if (const std::string said = statements_of(text, request); !said.empty()) throw std::invalid_argument(said);
  });
  const Quantities two = csv::read("s,error_cm,error_deg\nA,5,7\nA,6,8\nB,6,6\nB,9,4\n", "d.csv",
                                   smaller({.values = {"error_cm", "error_deg"}}));
  CHECK(two.samples[1].quantity == "error_deg");  // a name of its own
  CHECK(csv::read("s,v\nA,1\nB,2\n", "data.csv", smaller({.values = {"v", "v"}})).samples.size() == 1);
  CHECK(contains(statements_of(std::string("s,v\nA\0,1\n", 9)), "NUL"));
  std::string many = "s,v\n";
  for (int i = 0; i <= 100; ++i) many += fmt::format("g{0},1\ng{0},2\n", i);
  CHECK(contains(statements_of(many), "100 groups"));
  std::string long_one = "s,v\n";
  for (int i = 0; i <= 10'000'000; ++i) long_one += "A,1\n";
  CHECK(contains(statements_of(long_one), "10000000 rows"));
}

TEST_CASE("of a million rows a run's are one value") {
  std::string text = "solver;seed;v\n";
  for (int i = 0; i < 1'000'000; ++i) text += fmt::format("{};{};{},5\n", i % 2 ? "A" : "B", i / 20, i % 1000);
  CHECK(list_of(samples_of(text, {.run = "seed"}).groups.front()).size() == 50'000);
}

TEST_CASE("a wrong direction is refused before any other question", "[csv]") {
  CHECK_THROWS_WITH(csv::read("a,b\n1,2\n3,4\n", "wide.csv", {.better = {"bigger"}}),
                    ContainsSubstring("expected smaller, larger"));
}
