// CSVs of users: what is read from them, and what the engine says of it. tests/data/csv has files that were judged
// wrong.
#include "analysis/csv/user_csv.hpp"

#include "tests/judge/studies.hpp"
#include "tests/mistakes.hpp"

using namespace ikbench;
using namespace ikbench::judge;
using csv::Quantities;
using csv::Request;

namespace {

Observations observations(const std::string& text, const Request& request = {}) {
  return csv::read(text, "data.csv", request).observed.front();
}

Seen finding(const std::string& text, const Request& request = {}, const std::string& margin = "") {
  Observations of = observations(text, request);
  const judge::Plan plan = csv::with_margin({}, margin, of);
  return judge::compared(of, plan).front();
}

// With the options that a question offers.
std::string said_of(const std::string& text, const Request& request = {}) {
  return complaint<std::invalid_argument>([&] {
    try {
      csv::read(text, "data.csv", request);
    } catch (const csv::Question& question) {
      std::string said = question.what();
      for (const csv::Options& answer : question.answers) said += fmt::format(" [{}]", fmt::join(answer, " "));
      throw std::invalid_argument(said);
    }
  });
}

const std::string wide = "a,b\n1.1,4.5\n2,5\n3,6.5\n2.5,4\n";

}  // namespace

TEST_CASE("values with a large common offset are told apart by their last digits") {
  std::string text = "solver,v\n";
  for (int i = 0; i < 6; ++i) text += fmt::format("A,{}\nB,{}\n", 10'000'000'000'000 + i, 10'000'000'000'006 + i);
  const Seen found = finding(text);
  CHECK(found.verdict == Verdict::better);
  CHECK(*found.p == Approx(2 / 924.0));  // 2 / C(12, 6)
}

TEST_CASE("values near -5 are the same within 1, on differences") {
  const std::string text = text_in("tests/data/csv/drift.csv");
  const Quantities read = csv::read(text, "drift.csv", {});
  CHECK(read.notes.size() == 2);  // how it was read, and on differences
  CHECK(read.observed.front().scale == Scale::difference);
  const Seen found = finding(text, {}, "1");
  CHECK(found.verdict == Verdict::same);
  CHECK(found.scale == Scale::difference);
  CHECK(std::abs(*found.estimate) < 0.2);
  CHECK(finding(text).verdict == Verdict::undecided);  // a share of negative values is no margin
  CHECK_THROWS_AS(finding(text, {}, "5%"), std::invalid_argument);
}

TEST_CASE("ten times smaller errors on 20 problems of 20 scales are better within blocks") {
  const Request request{.block = {"problem"}};
  const std::string text = text_in("tests/data/csv/ten.csv");
  CHECK(observations(text, request).is_paired);
  const Seen found = finding(text, request);
  CHECK(found.verdict == Verdict::better);
  CHECK(*found.p == Approx(std::exp2(-19)));
  CHECK(*found.estimate == Approx(0.1).epsilon(0.2));
}

TEST_CASE("equal values of a file are tested as copies and as observations") {
  const Quantities read = csv::read(text_in("tests/data/csv/const2.csv"), "const2.csv", {});
  const Observations& observed = read.observed.front();
  CHECK(list_of(observed.groups.front()) == std::vector(20, 0.01));
  CHECK(std::get<judge::Measured>(observed.groups.front().sample).may_repeat);
  const Seen found = judge::compared(observed, {}).front();
  CHECK(found.verdict == Verdict::better);
  CHECK(found.test == "sign test and Mann-Whitney");
}

TEST_CASE("a zero in a third group changes no verdict on the two others") {
  const Seen with = finding(text_in("tests/data/csv/zero.csv"));
  const Seen zero = finding(text_in("tests/data/csv/zero0.csv"));
  CHECK(with.verdict == Verdict::better);
  CHECK(zero.verdict == Verdict::better);
  CHECK(*with.p == *zero.p);
  CHECK(with.scale == Scale::ratio);
  CHECK(zero.scale == Scale::difference);
}

TEST_CASE("rows without a label are left out and counted") {
  const Observations observed = csv::read(text_in("tests/data/csv/stray-label.csv"), "stray.csv", {}).observed.front();
  CHECK(observed.groups.size() == 2);
  REQUIRE(observed.doubts.size() == 1);
  CHECK(observed.doubts.front().count == 4);
  CHECK(observed.doubts.front().of == 12);
}

TEST_CASE("rows of several metrics are refused with the advice --where") {
  const std::string text = text_in("tests/data/csv/mixed-metrics.csv");
  for (const Request& request : {Request{.values = {"value"}}, Request{.values = {"value"}, .where = {"seed=1"}},
                                 Request{.values = {"value"}, .run = "seed"}}) {
    const std::string said = said_of(text, request);
    CHECK(contains(said, "--where metric=error"));
  }
  const Request chosen{.values = {"value"}, .run = "seed", .where = {"metric=error"}};
  CHECK(list_of(observations(text, chosen).groups.front()) == std::vector{0.10, 0.12, 0.11, 0.13});
  CHECK(contains(csv::read(text, "d.csv", chosen).notes.front(), "; only rows with 'metric=error'."));
  CHECK(finding(text, {.values = {"value"}, .run = "seed", .where = {"metric = error"}}).verdict == Verdict::better);
  CHECK(contains(said_of(text, {.where = {"metric=speed"}}), "'metric=error'"));
  // The metric has another name.
  const std::string other = "solver,seed,what,value\nA,1,e,1\nA,1,t,9\nB,1,e,1\nB,1,t,9\n";
  CHECK(contains(said_of(other, {.values = {"value"}, .run = "seed"}), "--where what=e"));
  // Text that never repeats, such as a time of day, tells of nothing.
  CHECK(said_of("solver,seed,at,value\nA,1,x,1\nA,1,y,9\nB,1,z,1\nB,1,w,9\n", {.values = {"value"}, .run = "seed"})
            .empty());
}

TEST_CASE("separators and decimal marks are found, or given") {
  const std::vector<double> a{0.5, 1.25}, b{3, 4};
  for (const std::string text :
       {"s,v\nA,0.5\nA,1.25\nB,3\nB,4\n", "s;v\nA;0,5\nA;1,25\nB;3\nB;4\n", "s\tv\nA\t0,5\nA\t1,25\nB\t3\nB\t4\n",
        "s;v\nA;0.5\nA;1.25\nB;3\nB;4\n", "\"s, or t\";v\nA;0,5\nA;1,25\nB;3\nB;4\n",
        "\xEF\xBB\xBFs;v\r\n\"A\"; 0,5 \r\nA;\"1,25\"\r\nB;3\r\nB;4\r\n;\r\n"}) {
    CAPTURE(text);
    const Observations of = observations(text);
    REQUIRE(of.groups.size() == 2);
    CHECK(of.groups[0].name == "A");
    CHECK(list_of(of.groups[0]) == a);
    CHECK(list_of(of.groups[1]) == b);
  }
  CHECK(contains(said_of("s;v\nA;0,5\nA;1.5\nB;3\nB;4\n", {.values = {"v"}}), "data.csv:3:2"));
  CHECK(list_of(observations("s,v\nA,\"0,5\"\nA,\"1,25\"\nB,3\nB,4\n").groups[0]) == a);
  CHECK(list_of(observations("s,v\nA,1.020\nB,2.040\n").groups[0])[0] == 1.02);
  CHECK(contains(said_of("s;v\nA;0,5\nB;4\n", {.values = {"v"}, .label = {"s"}, .decimal = '.'}), "data.csv:2:2"));
}

TEST_CASE("titles are trimmed, and units belong to quantities") {
  const Observations of = observations(" solver , error [mm] \nA,1\nB,2\n", {.values = {"error [mm]"}});
  CHECK(of.quantity == "error");
  CHECK(of.unit == "mm");
  CHECK(observations("solver,error_cm\nA,1\nB,2\n").unit == "cm");
  CHECK(observations("solver,time (ms)\nA,1\nB,2\n").unit == "ms");
  CHECK(observations("solver,mean_rank\nA,1\nB,2\n").unit.empty());
}

TEST_CASE("a mark of thousands is told from that of decimals, or asked for") {
  const auto read = [](const std::string& cells, char decimal = 0) {
    return list_of(
        observations("s;v;w\nA;" + cells + "\nB;916;7\n", {.values = {"v"}, .decimal = decimal}).groups[0])[0];
  };
  for (const char* cells : {"1.020;7", "1,020;7", "-12.345;7", "1.020;1,020"}) {
    CAPTURE(cells);
    CHECK(contains(said_of("s;v;w\nB;916;7\nA;" + std::string(cells) + "\n", {.values = {"v"}}), "data.csv:3:2"));
  }
  CHECK(contains(said_of("s;w;v;z\nA;1.2;1.020;0,25\nB;1.3;900;0,5\n", {.values = {"v"}}), "data.csv:2:3"));
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
  CHECK(list_of(observations("s;v\nA;1.020\nB;0.5\n").groups[0])[0] == 1.02);  // by another cell
  CHECK(contains(said_of("s;v\nA;1.5\nB;12,34\n", {.values = {"v"}}), "data.csv:3:2"));
  CHECK(contains(said_of("s;v\nA;12,34,567\nB;2\n", {.values = {"v"}}), "data.csv:2:2"));
}

TEST_CASE("which way is better is said, or asked for where it is open") {
  std::string rates = "solver,success_rate\n", outcomes = "solver,collisions\n";
  for (int i = 0; i < 20; ++i) {
    rates += fmt::format("A,0.9{0}\nB,0.4{0}\n", i + 10);
    outcomes += "A,0\nB,1\n";
  }
  CHECK(contains(said_of(outcomes), "[--better collisions=larger] [--better collisions=smaller]"));
  CHECK(finding(rates, {.better = {"smaller"}}).verdict == Verdict::worse);
  CHECK(finding(outcomes, {.better = {"smaller"}}).verdict == Verdict::better);
  CHECK(finding(rates, {.better = {"larger"}}).verdict == Verdict::better);
  CHECK(finding(rates, {.better = {"smaller", "success_rate=larger"}}).verdict == Verdict::better);
  CHECK(finding(outcomes, {.better = {"larger"}}).verdict == Verdict::worse);
  CHECK(observations(outcomes, {.better = {"smaller"}}).scale == Scale::share);
  CHECK(observations("s,a=b\nA,1.5\nB,2\n", {.better = {"a=b=larger"}}).better == Better::larger);
  CHECK(observations(rates).better == Better::smaller);  // as the line below the table says
  CHECK(contains(said_of(rates, {.better = {"rate=larger"}}), "success_rate"));
  CHECK(contains(said_of(rates, {.better = {"bigger"}}), "expected smaller"));
  for (const std::string column : {"", "success_rate="})
    CHECK(contains(said_of(rates, {.better = {column + "smaller", column + "larger"}}), "contradicts"));
}

TEST_CASE("values of 0 are what they are, and differences are compared") {
  std::string blocks = "solver,problem,failures\n", runs = "solver,collisions\nA,5\nB,6\n";
  for (int i = 0; i < 80; ++i) blocks += fmt::format("A,{0},0\nB,{0},2\n", i);
  for (int i = 0; i < 99; ++i) runs += "A,0\nB,5\n";
  const Seen of_blocks = finding(blocks, {.values = {"failures"}, .block = {"problem"}});
  CHECK(of_blocks.verdict == Verdict::better);
  CHECK(*of_blocks.estimate == -2);
  CHECK(*of_blocks.p == Approx(std::exp2(-79)));
  CHECK(*finding(runs).p == Approx(4.09e-44).epsilon(0.01));  // SciPy's Mann-Whitney
  CHECK(*finding(runs).estimate == -5);
  const Seen of_means = judge::compared(observations(runs), {.test = Plan::Test::means}).front();
  CHECK(*of_means.estimate == Approx(-4.96));
  std::string three = "s,p,v\n";
  for (int i = 0; i < 14; ++i) three += fmt::format("A,{0},{1}\nB,{0},{2}\nC,{0},1\n", i, i % 4, i % 5 + 1);
  const std::string other = three + "A,99,1\nB,99,1\nC,99,1\n", tiny = three + "A,99,1\nB,99,1\nC,99,1e-12\n";
  const Request request{.values = {"v"}, .block = {"p"}};
  CHECK(*finding(other, request).p == *finding(tiny, request).p);
}

TEST_CASE("missing values are lost, and such a group is not tested") {
  for (const std::string gap : {"", "NA", "-", "nan", "None", "null", "#N/A"}) {
    CAPTURE(gap);
    const std::string text = "s,v\nA," + gap + "\nA,2\nA,1\nA,3\nA,4\nB,5\nB,6\nB,7\nB,8\n";
    const Observations observed = observations(text);
    CHECK(lost_in(observed.groups.front()) == 1);
    CHECK(observed.doubts.front().kind == DoubtKind::incomplete);
    CHECK(observed.doubts.front().of == 5);
    CHECK(finding(text).why == Why::lost);
  }
  CHECK(contains(said_of("s,v\nA,1e999999\nA,1\nB,2\n", {.values = {"v"}}), "data.csv:2:2"));
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
  const Request rows{.values = {"v"}, .run = "row"}, blocks{.values = {"v"}, .block = {"p"}};
  const Seen paired = finding(with_infinite(0, 3), blocks);
  CHECK(paired.verdict == Verdict::better);
  CHECK(*paired.p == Approx(std::exp2(-9)));
  CHECK(paired.interval->low == 0);  // B may be infinitely worse
  CHECK(paired.interval->high < 1);
  const Seen unpaired = finding(with_infinite(0, 3), rows);
  CHECK(unpaired.interval->low == 0);
  const Seen all = finding(with_infinite(0, 10), rows);
  CHECK(*all.p == Approx(2 / 184756.0));  // 2 / C(20, 10)
  CHECK(!all.estimate);
  CHECK(*all.effect == 1);
  CHECK(is_open(judge::compare(observations(with_infinite(10, 10), rows), {}).front(), Open::Why::no_answer));
  const Seen turned = better_first(finding(with_infinite(10, 2), blocks), "");
  CHECK(turned.first == "B");
  CHECK(turned.verdict == Verdict::better);
  std::string differences = with_infinite(0, 3);  // a value of 0
  differences += "A,0,0\nB,0,1\n";
  CHECK(std::isinf(finding(differences, blocks).interval->low));
  CHECK(finding(with_infinite(2, 2), rows, "5%").verdict == Verdict::undecided);
  std::string near = "s,v\nA,inf\n";  // the rest is within the margin
  for (int i = 0; i < 200; ++i) near += fmt::format("A,1\nB,1.000{}\n", i);
  CHECK(!finding(near, {.run = "row"}).is_within_margin);
  CHECK(!finding(near, {.run = "row"}, "1").is_within_margin);
  const Observations observed = observations(with_infinite(0, 3), rows);
  CHECK(words_of(observed.doubts.front()) == "no answer in 3 of 10 values, counted as largest (B)");
  CHECK(is_open(judge::compare(observed, {.test = Plan::Test::means}).front(), Open::Why::infinite));
  CHECK(std::isinf(describe(observed.groups[1]).mean));
  CHECK(describe(observed.groups[1]).median == 11);
  CHECK(contains(said_of(with_infinite(0, 3), {.values = {"v"}, .run = "row", .better = {"larger"}}), "data.csv:17:3"));
}

TEST_CASE("wide files have a group a column, and tell where one ends early") {
  CHECK(contains(said_of(wide), "(--run row) [--block row]"));
  CHECK(finding(wide, {.run = "row"}).verdict == Verdict::better);
  CHECK(observations(wide, {.block = {"row"}}).is_paired);
  const Observations of = observations("seed,a,b\n1,1.5,4.5\n2,1.2,5\n3,2.1,6\n4,1.7,6\n5,,\n6,,5\n", {.run = "row"});
  REQUIRE(of.groups.size() == 2);
  CHECK(lost_in(of.groups[0]) == 2);
  CHECK(lost_in(of.groups[1]) == 1);
  CHECK(of.doubts.front().count == 3);
  const std::string text = "set,a,b\n2,1.5,4.5\n5,1.2,7\n3,2.1,6\n";
  CHECK(contains(said_of(text, {.values = {"a", "b"}}), "[--block set]"));
  CHECK(csv::read(text, "data.csv", {.block = {"set"}}).observed.front().is_paired);
  CHECK(contains(said_of("a,a\n1,4\n2,5\n", {.values = {"a"}}), "2 columns 'a'"));
}

TEST_CASE("a first column of settings or labels is no group") {
  for (const std::string rows : {"100,1.5,4.2\n7,1.2,6\n30,2.1,5\n",                     // whole
                                 "0.1,1.5,4.2\n0.2,1.2,6\n0.5,2.1,5\n",                  // in order
                                 "0.5,1.5,4.2\n0.1,1.2,6\n0.5,2.1,5\n0.1,1.1,5.5\n"}) {  // repeated
    const bool repeats = contains(rows, "0.1,1.1");
    CHECK(
        contains(said_of("size,a,b\n" + rows), repeats ? "[--label size --value a]" : "[--value a --value b --block "));
    CHECK(observations("size,a,b\n" + rows, {.values = {"size", "a", "b"}, .run = "row"}).groups.size() == 3);
  }
  CHECK(contains(said_of("set,size,a\nx,100,0.5\ny,7,0.4\nz,9,0.45\n", {.block = {"set"}}), "--value size --value a"));
}

std::vector<csv::Options> asked_of(const std::string& text, const Request& request = {}) {
  try {
    csv::read(text, "data.csv", request);
  } catch (const csv::Question& question) {
    for (const csv::Options& answer : question.answers) {
      CAPTURE(fmt::format("{}", fmt::join(answer, " ")));
      CHECK(said_of(text, csv::with(request, answer)).empty());
    }
    return question.answers;
  }
  return {};
}

// A row for each combination, `{}` in turn replaced by what tells it apart, with a value that differs by the last.
std::string crossed(const std::string& header, const std::vector<std::vector<std::string>>& columns, int repeats = 1) {
  std::string text = header + "\n";
  std::vector<std::string> rows{""};
  for (const std::vector<std::string>& column : columns) {
    std::vector<std::string> longer;
    for (const std::string& row : rows) {
      for (const std::string& cell : column) longer.push_back(row + cell + ",");
    }
    rows = longer;
  }
  int i = 0;
  for (const std::string& row : rows) {
    for (int repeat = 0; repeat < repeats; ++repeat, ++i)
      text += fmt::format("{}{:.3f}\n", row, 1 + i * i * 37 % 1009 * 0.013);
  }
  return text;
}

TEST_CASE("what can be read in several ways is asked, and every answer is read") {
  const std::vector<std::string> s{"A", "B", "C"}, p{"x", "y", "z"}, n{"1", "2", "3", "4"}, many{"7", "31", "5", "90"};
  struct {
    std::string text, first;  // what is to be added, as it stands in a shell
    Request request = {};
  } const layouts[] = {
      {crossed("solver,random_seed,point,error", {s, many, n}), "--run random_seed"},
      {crossed("solver,RunId,error", {s, many}, 5), "--run RunId"},
      {crossed("solver,run,error", {s, n}), "--run run"},
      {crossed("solver,problem,error", {s, p}), "--label solver --block problem"},
      {crossed("solver,problem,error", {s, p}, 5), "--label solver --block problem --run row"},
      {crossed("solver,problem,error", {s, p}, 5), "--block problem --run row", {.label = {"solver"}}},
      {crossed("solver,problem,error", {s, p}, 5), "--run row", {.label = {"solver"}, .block = {"problem"}}},
      {crossed("solver,problem,error", {s, n}, 5), "--run problem"},
      {crossed("Algorithm,Problem,MetricName,ExecutionId,MetricValue", {s, {"u", "v"}, p, n}),
       "--label Algorithm --block Problem --block MetricName --run ExecutionId"},
      {crossed("Algorithm,MetricName,ExecutionId,MetricValue", {s, {"HV", "EP"}, n}),
       "--block MetricName --run ExecutionId",
       {.label = {"Algorithm"}}},
      {crossed("algorithm,suite,function,dimension,instance,evaluations", {s, {"bbob"}, n, {"2", "5"}, n}),
       "--run function"},
      {crossed("case,implementation,algorithm,workers,seconds", {n, s, p, {"1"}}),
       "--label implementation --block algorithm --run case",
       {.values = {"seconds"}}},
      {crossed("name,planner,time", {p, s}, 4), "--label name --block planner --run row"},
      {crossed("algorithm_id,evaluations", {{"1", "2"}}, 9), "--label algorithm_id"},
      {"instance,A,B\nx,1.5,4.1\ny,1.2,7\nz,2.1,6\n", "--block instance"},
      {"problem,seed,A,B\nx,4,1.5,4.1\nx,9,1.2,7\ny,4,2.1,6\ny,9,2,6.5\n", "--block problem --block seed"},
      {"set,name,call,time\nx,A,A x,1.5\nx,A,A x,1.6\nx,B,B x,2.5\ny,A,A y,3\ny,A,A y,2\ny,B,B y,5\n",
       "--label name --block set --run row"},
      {"instance,A,B\nx,1.5,4.1\ny,1.2,7\nz,2.1,6\n", "--block instance", {.values = {"A", "B"}}},
      {"solver,time,memory\nA,1.5,4\nA,1.2,7\nB,2.1,6\n", "--value time"},
      {"problem,class,A,B\nx,k,1.5,4\ny,k,1.2,7\nz,l,2.1,6\n", "--label class --value A"},
      {"solver,error,time\nA,.153,20.2\nA,.114,21\nA,.124,2.2\nB,.271,3.2\nB,.217,31.1\nB,.227,34.3\n",
       "--value error --value time"},
      {"solver,run,error\nA,1,.31\nA,2,.27\nA,3,.55\nB,1,.55\nB,2,.31\nB,3,.27\n", "--value error --run run"},
      {"problem,solver,time\nx,A,1\ny,A,2.5\nz,A,2\nx,B,1.5\n", "--label solver --block problem"},
  };
  for (const auto& [text, first, request] : layouts) {
    CAPTURE(text, first);
    const std::vector<csv::Options> answers = asked_of(text, request);
    std::vector<std::string> offered;
    for (const csv::Options& answer : answers) offered.push_back(fmt::format("{}", fmt::join(answer, " ")));
    CAPTURE(offered);
    CHECK(std::ranges::count(offered, first) == 1);
  }
}

// With "*" the first command of a question; else the sentence of a refusal.
std::string first_of(const std::string& text) {
  const std::vector<csv::Options> answers = asked_of(text);
  return answers.empty() ? said_of(text) : fmt::format("* {}", fmt::join(answers.front(), " "));
}

TEST_CASE("the first command compares groups alone, of one metric, at one step") {
  std::string p, n, optimum, mean, sd, gain, two, winner, curve, long_curve = "solver,iteration,best\n", bands;
  for (int i = 0; i < 12; ++i) {
    const double a = 1.2 + i * 37 % 11 * 0.21, b = 1.1 + i * 53 % 13 * 0.17, c = 0.7 + i * 29 % 7 * 0.43;
    const auto best = static_cast<int>(400 + a * 100), at_a = best + i % 3, at_b = best + i % 4 * 2;
    p += fmt::format("i{},{},{},{:.3f}\n", i, a, b, i * i % 17 / 19.0);
    n += fmt::format("i{},{},{},{}\n", i, 20 + i * 7 % 5, a, b);
    optimum += fmt::format("i{},{},{},{}\n", i, best, at_a, at_b);
    mean += fmt::format("i{},{:.3f},{:.3f},{:.3f},{:.3f}\n", i, a, b, c, (a + b + c) / 3);
    sd += fmt::format("i{},{:.3f},{:.3f},{:.3f}\n", i, a, b, std::abs(a - b) / std::numbers::sqrt2);
    gain += fmt::format("i{},{:.3f},{:.3f},{:.1f}\n", i, a, b, 100 * (b - a) / b);
    two += fmt::format("i{},{},{},{},{}\n", i, a, a / (9 + i % 3), b, b / (8 + i % 4));
    winner += fmt::format("i{},{},{},{}\n", i, a, b, a < b ? "A" : "B");
    curve += fmt::format("{},{},{}\n", 10 * i, 5 / (i + 1.0), 6 / (i + 1.1));
    bands += fmt::format("{},{},{},{},{}\n", 5 * i, 9 / (i + 2.0), 0.3 + 0.001 * i, 9 / (i + 1.5), 0.2 + 0.001 * i);
  }
  for (int i = 0; i < 24; ++i)
    long_curve += fmt::format("{},{},{}\n", i < 12 ? "A" : "B", i % 12 * 10, (i < 12 ? 5 : 6) / (i % 12 + 1.0));
  const std::string metrics =
      "algo,problem,metric,seed,value\nA,x,error,1,.002\nA,x,error,2,.003\nA,x,time,1,20\nA,x,time,2,30\n"
      "A,y,error,1,.004\nA,y,error,2,.001\nA,y,time,1,40\nA,y,time,2,25\nB,x,error,1,.005\nB,x,error,2,.006\n"
      "B,x,time,1,28\nB,x,time,2,33\nB,y,error,1,.003\nB,y,error,2,.002\nB,y,time,1,22\nB,y,time,2,31\n";
  const std::string coco = crossed("algorithm,function,dimension,instance,evaluations",
                                   {{"A", "B"}, {"1", "2", "3"}, {"2", "5", "10"}, {"1", "2", "3", "4"}});
  const std::pair<std::string, std::string> tables[] = {
      {"p,A,B,p-value\n" + p, "* --block p --value A --value B"},
      {"p,n,A,B\n" + n, "* --block p --value A --value B"},
      {"p,ours,B,C\na,.4,1.2,1.1\nb,.31,.93,1.4\nc,.52,1.7,1.2\nd,.47,1.5,.95\n", "* --block p"},
      {"p,best known,A,B\n" + optimum, "* --block p --value A --value B"},
      {"p,A,B,C,mean\n" + mean, "* --block p --value A --value B --value C"},
      {"p,A,B,sd of both\n" + sd, "* --block p --value A --value B"},
      {"p,A,B,gain %\n" + gain, "* --block p --value A --value B"},
      {"p,A mean,A sd,B mean,B sd\n" + two, "* --block p --value A mean --value B mean"},
      {"p,A,A_sd,B,B_sd\n" + two, "* --block p --value A --value B"},
      {"p,mean A,sd A,mean B,sd B\n" + two, "* --block p --value mean A --value mean B"},
      {"p,A,B,winner\n" + winner, "* --block p"},
      {"iteration,A,B\n" + curve, "* --value A --value B --where iteration=110 --run row"},
      {"epoch,A_mean,A_sd,B_mean,B_sd\n" + bands, "* --value A_mean --value B_mean --where epoch=55 --run row"},
      {long_curve, "* --where iteration=110"},
      {metrics, "* --label algo --where metric=error --block problem --run seed"},
      {coco, "* --block function --block dimension --run instance"},
      {"solver,s1,s2,s3\nA,1.5,2.5,2\nB,3,1.2,4.1\n", "* --block solver"},
      {crossed("solver,robot,target,restart,ms", {{"A", "B"}, {"u", "v"}, {"1", "2", "3", "4"}, {"0", "1", "2"}}),
       "* --label solver --block robot --block target --run restart"},
      {crossed("date,planner,ms", {{"2026-05-01", "2026-05-04", "2026-05-05"}, {"A", "B"}}, 4),
       "* --label planner --run date"},
      {"solver,n,mean,sd\nA,20,1.5,.2\nB,20,2.5,.3\n", "* --summaries"},
      {"command,mean,stddev,min\nA,1.5,.2,1.1\nB,2.5,.3,2\n", "* --value mean"},
  };
  for (const auto& [text, first] : tables) {
    CAPTURE(text);
    CHECK(first_of(text) == first);
  }
  CHECK(first_of("id,group,score\n1,1,1.5\n2,1,1.2\n3,2,2.1\n4,2,1.9\n") == "* --label group");  // and no other
  CHECK(first_of("step,A,A__MIN,B,B__MIN\n1,1.5,1.5,2.5,2.5\n2,1.2,1.2,2.1,2.1\n3,1.9,1.9,2.2,2.2\n") ==
        "* --value A --value B --block row");
  const std::string statistics =
      "f,stat,A,B\nx,best,1.5,1.7\nx,mean,1.9,2.2\ny,best,2.5,2.1\ny,mean,3.1,2.8\nz,best,1.1,1.3\nz,mean,1.4,1.9\n";
  CHECK(std::ranges::count(asked_of(statistics), csv::Options{"--block", "f", "--where", "stat=best"}) == 1);
  const std::string both = "data,method,n,mean,sd\nx,A,9,1.5,.2\nx,B,9,1.7,.3\ny,A,9,2.5,.2\ny,B,9,2.9,.3\n";
  CHECK(std::ranges::count(asked_of(both), csv::Options{"--summaries", "--label", "method", "--where", "data=x"}) == 1);
  std::string many = "s";  // columns
  for (int column = 0; column < 160; ++column) many += fmt::format(",c{}", column);
  many += ",v\n";
  for (int row = 0; row < 200; ++row) {
    many += fmt::format("S{}", row % 3);
    for (int column = 0; column < 160; ++column)
      many += fmt::format(",t{}", (row * 7919 + column * 104729) % 1009 % 30);
    many += fmt::format(",{}\n", row * 37 % 101 + 0.5);
  }
  CHECK(asked_of(many).size() > 1);
  std::string trials = "sampler,state,value\nA,cut,1.5\nB,cut,2.5\n";
  for (int i = 0; i < 12; ++i)
    trials += fmt::format("{},{},{}\n", "AB"[i / 2 % 2], i % 2 ? "done" : "cut", i * i % 7 + 0.5);
  for (const char* sampler : {"A", "B", "A", "B"}) trials += fmt::format("{},done,3.{}\n", sampler, trials.size() % 10);
  CHECK(contains(said_of(trials), "--where state=done"));
  std::string drawn = "sampler,layers,value\n";  // by each trial, not planned for all
  for (const char layers : std::string("2323232131231321333311"))
    drawn += fmt::format("{},{},{}.5\n", drawn.size() < 115 ? "A" : "B", layers, drawn.size() * 37 % 101);
  CHECK(said_of(drawn, {.values = {"value"}}).empty());
  CHECK(contains(said_of("name,ms\nk/7,101.6062\nk/7,99.5726\nk/7,111.3763\nk/7_mean,104.1850\nj,9.5\nj,8.25\n"),
                 "data.csv:5:1: 'k/7_mean' in column 'name' sums up 'k/7'"));
  CHECK(contains(said_of(tables[16].first), "but of runs and steps, which stand below each other"));
  CHECK(contains(said_of("solver,time,unit\nA,850,ms\nA,1.1,s\nB,990,ms\nB,1.3,s\n"), "'unit' has ms and s"));
}

TEST_CASE("tables of Markdown, org and MySQL, and thousands of the Swiss, are read") {
  for (const std::string text :
       {"| s | v |\n|---|--:|\n| A | 1000.5 |\n| B | 2 |\n", "| s | v |\n|---+---|\n| A | 1000.5 |\n| B | 2 |\n",
        "+---+---+\n| s | v |\n+---+---+\n| A | 1000.5 |\n| B | 2 |\n+---+---+\n", "\"sep=;\"\r\ns;v\nA;1'000.5\nB;2\n",
        "s;v\nA;1\u2019000.5\nB;2\n", "s;v\nA;1\u00a0000,5\nB;2\n", "s;v\nA;1\u2009000,5\nB;2\n",
        "s;v\nA;1.0005D+03\nB;\u22122\n"}) {
    CAPTURE(text);
    CHECK(list_of(observations(text).groups[0]) == std::vector{1000.5});
  }
  CHECK(contains(said_of("s;v\nA;10'00.5\nB;2\n", {.values = {"v"}}), "data.csv:2:2"));
  CHECK(contains(said_of("s,A,B\n2D-1,1.5,2\n3D-2,1.6,2.1\n", {}), "--block s"));  // names, not numbers of Fortran
  for (const std::string text :
       {"\n\n| s | v |\n|---|---|\n| A | **7** |\n\n| B | 2 |\n", "=== ===\ns   v\n=== ===\nA   7\nB   2\n=== ===\n",
        "s v\nA 7\n# the second part\nB 2\n", "sep=;\ns;v, in kg, dry\nA;7\nB;2\n", "s,v\n#1,7\n#2,2\n"})
    CHECK(list_of(observations(text).groups[0]) == std::vector{7.0});
  CHECK(lost_in(observations("A|B\n-|-\n1.5|2\n1.2|3\n", {.run = "row"}).groups[0]) == 1);
  CHECK(contains(said_of("p,A,B\nx,1.5,2\n#y,1.2,3\nz,1,4\n", {.block = {"p"}}), "data.csv:3:1: '#y'"));
  CHECK(contains(said_of("p,A,B\nx,1.5 ± 0.2,2\ny,1.6 ± 0.3,3\n"), "--summaries"));
  for (const char* cell : {"<0.001", "**<0.001**"})
    CHECK(contains(said_of(fmt::format("|p|A|B|\n|---|---|---|\n|x|1.5|{0}|\n|y|1.7|{0}|\n|z|1.8|{0}|\n", cell)),
                   "data.csv:3:4: '<0.001'"));
}

TEST_CASE("columns that do not matter are not asked about") {
  const std::string rows =
      "i,solver,host,version,at,error\n0,A,n1,1.0,10:00:01,1.5\n1,A,n1,1.0,10:00:03,1.2\n2,A,n1,1.0,10:00:04,1.1\n"
      "3,A,n1,1.0,10:00:05,1.6\n4,B,n1,1.1,10:00:06,1.3\n5,B,n1,1.1,10:00:09,1.4\n6,B,n1,1.1,10:00:12,1.8\n"
      "7,B,n1,1.1,10:00:20,1.7\n";
  CHECK(list_of(observations(rows).groups[1]) == std::vector{1.3, 1.4, 1.8, 1.7});
  CHECK(contains(csv::read(rows, "d.csv", {}).notes.front(), "'i' counts rows"));
  CHECK(list_of(observations(rows, {.values = {"i"}}).groups[1]) == std::vector{4.0, 5.0, 6.0, 7.0});
  // Where blocks and runs tell all rows apart, text says how each ended.
  const std::string ended =
      "solver,problem,run,error,end\nA,x,1,1.5,ok\nA,x,2,1.2,late\nA,y,1,2,ok\nA,y,2,2.5,ok\n"
      "B,x,1,1.3,ok\nB,x,2,1.1,ok\nB,y,1,3,late\nB,y,2,2.1,ok\n";
  CHECK(list_of(observations(ended, {.label = {"solver"}, .block = {"problem"}, .run = "run"}).groups[0]) ==
        std::vector{1.35, 2.25});
}

TEST_CASE("a column that was measured is not passed over") {
  for (const char* cell : {"01:12.5", "0 days 00:01:12", "$12.50", "1.25 ± 0.1", "\xE2\x88\x92 3.5", "[0.1, 0.2]"}) {
    CAPTURE(cell);
    std::string rows = "solver;elapsed;steps\n";
    for (int i = 0; i < 4; ++i) rows += fmt::format("{};{}{};{}\n", i < 2 ? "A" : "B", cell, i, 17 - i * i);
    CHECK(contains(said_of(rows), "is no number"));
  }
  CHECK(contains(said_of("case,ours [ms],theirs [us]\na,1.5,2300\nb,2.25,3100\n", {.block = {"case"}}),
                 "different units"));
  CHECK(contains(said_of("case,GA,GA\na,1.5,2.5\nb,2.25,3.5\n", {.block = {"case"}}), "2 columns 'GA'"));
}

TEST_CASE("merged cells are refused with their column") {
  CHECK(contains(said_of("solver,error\nA,1.5\n,1.2\n,1.7\nB,2\n,2.5\n,2.2\n"), "'solver' is empty in 4 of 6 rows"));
  CHECK(contains(said_of("problem,solver,error\nx,A,1.5\n,B,1.2\ny,A,1.7\n,B,2\n",
                         {.label = {"solver"}, .block = {"problem"}, .run = "row"}),
                 "data.csv:3:1: '' in column 'problem' is no name; write merged cells"));
}

TEST_CASE("runs may have numbers of their own, metrics stand below each other, problems be numbers") {
  // A training log: each run ends when it likes.
  CHECK(contains(
      said_of("solver,seed,loss\nA,11,1.5\nA,12,1.7\nA,11,1.2\nA,11,1.1\nA,12,1.4\nB,21,2.5\nB,22,2.1\nB,21,2.2\n"
              "B,22,1.9\n"),
      "[--run seed]"));
  CHECK(contains(
      said_of("algo,problem,metric,value\nA,x,HV,.5\nA,x,IGD,3.5\nA,y,HV,.25\nA,y,IGD,4.5\nB,x,HV,.75\nB,x,IGD,2.5\n"
              "B,y,HV,.625\nB,y,IGD,1.5\n",
              {.label = {"algo"}}),
      "[--where problem=x"));
  CHECK(contains(said_of("sep=;\nsolver;size;time\nA;10;1.5\nA;20;2.5\nA;30;4.5\nB;10;1.25\nB;20;2.125\nB;30;5.5\n"),
                 "[--block size] [--run size]"));
}

TEST_CASE("names are taken as they are, and none looks like another") {
  // An index that pandas left without a name.
  CHECK(contains(said_of(",solver,error\n0,a,1.5\n1,a,2.25\n0,b,3.5\n1,b,4.25\n"), "[--run column 1]"));
  CHECK(observations("so=lver,s,v\na=b,x,1.5\na=b,y,2.5\nc,x,9\n",
                     {.values = {"v"}, .label = {"s"}, .where = {"so=lver=a=b"}})
            .groups.size() == 2);
  const std::string rows = "solver,row,v\na,1,1.5\na,2,2.5\na,1,2\na,2,3\nb,1,3.5\nb,2,3.25\nb,1,4\n";
  CHECK(contains(said_of(rows), "rename it"));
  CHECK(contains(said_of("s,v\n\xe4,1.5\n\xe4,2.5\n\xf6,3.5\n\xf6,4.5\n"), "data.csv:2: letters in another code"));
  CHECK(contains(said_of("s,v\na,1\na\u200b,2\n"), "two groups look alike"));
  CHECK(contains(said_of("s,v\n\"a\nb\",1.5\n\"a\nb\",2.5\na b,3.5\na b,4.5\n"), "two groups look alike"));
}

TEST_CASE("values of a run follow each other, and are no rows of their own") {
  std::mt19937 random(11);
  std::normal_distribution<> normal;
  int asked = 0, asked_of_noise = 0;
  for (int trial = 0; trial < 100; ++trial) {
    std::string runs = "controller,error\n", noise = runs, sorted = runs;
    for (const char* controller : {"A", "B"}) {
      double state = 0;
      for (int i = 0; i < 60; ++i) {
        state = 0.9 * state + normal(random);
        runs += fmt::format("{},{:.4f}\n", controller, std::exp(state));
        noise += fmt::format("{},{:.4f}\n", controller, std::exp(normal(random)));
        sorted += fmt::format("{},{:.4f}\n", controller, i + 0.37);
      }
    }
    asked += contains(said_of(runs), "[--run row]"), asked_of_noise += !said_of(noise).empty();
    CHECK(said_of(sorted).empty());
    CHECK(said_of(runs, {.run = "row"}).empty());
  }
  CHECK(asked == 100);
  CHECK(asked_of_noise == 0);
}

TEST_CASE("a missing value, or a text, is no end of a question") {
  std::string text = "s,t,v\n", cached = "solver,cache,ms\n";
  for (const char* solver : {"a", "b"})
    for (int i = 1; i < 9; ++i) {
      text += fmt::format("{},{},{}\n", solver, i,
                          solver[0] == 'b' && i == 2 ? "NA" : fmt::format("{:.2f}", 1 + i * 5 % 7 * 0.37));
      cached += fmt::format("{},{},{:.2f}\n", solver, i % 4 == 0 ? "cold" : "", 1 + i * 3 % 8 * 0.1);
    }
  CHECK(contains(said_of(text), "[--value v --run t]"));
  CHECK(contains(said_of(cached), "[--run row]"));
}

TEST_CASE("fewer different values than groups may be labels, too") {
  CHECK(contains(said_of("solver,iterations\nA,3\nA,4\nB,4\nB,5\nC,3\nC,5\nD,4\nD,3\n"), "[--label solver]"));
}

TEST_CASE("a run without a number among numbers is none") {
  std::string text = "run,a,b\n";
  for (int i = 1; i < 9; ++i) text += fmt::format("{},{},{}\n", i, 1 + i * 3 % 7 * 0.11, 2 + i * 5 % 7 * 0.13);
  CHECK(said_of(text, {.values = {"a", "b"}, .run = "run"}).empty());
  CHECK(
      contains(said_of(text + "typical,1.3,2.4\n", {.values = {"a", "b"}, .run = "run"}), "data.csv:10:1: 'typical'"));
}

TEST_CASE("True and False are 1 and 0") {
  const std::string text = "id,solver,solved\n0,A,True\n1,A,True\n2,B,FALSE\n3,B,yes\n";
  const Observations of = observations(text, {.better = {"larger"}});
  CHECK(csv::read(text, "d.csv", {.better = {"larger"}}).notes.back() ==
        "All values of solved are 0 or 1: shares are compared.");
  CHECK(of.quantity == "solved");
  CHECK(of.scale == Scale::share);
  CHECK(list_of(of.groups[1]) == std::vector{0.0, 1.0});
  CHECK(contains(said_of(text), "[--better solved=larger]"));
  // They may name the groups.
  CHECK(contains(said_of("s,v\nA,5\nA,no\nA,no\nB,2\nB,3\n"), "data.csv:3:2: 'no'"));
  const std::string pairs = "scene,optimized,time\nx,yes,1\nx,no,2.5\ny,yes,2\ny,no,3\nz,yes,5\nz,no,4\n";
  CHECK(contains(said_of(pairs), "[--label optimized --block scene]"));
  CHECK(observations(pairs, {.label = {"optimized"}, .block = {"scene"}}).groups[1].name == "no");
}

TEST_CASE("last rows with statistics of those above are refused") {
  std::string rows = "problem,A,B\n", whole = "problem,A,B\n", tall = "solver,problem,error\n";
  for (int i = 0; i < 12; ++i) {
    rows += fmt::format("i{},{:.2f},{:.2f}\n", i, 1.1 + 0.01 * i, 1.4 + 0.01 * i);
    whole += fmt::format("i{},{},{}\n", i, 40 + i * i % 7, 60 - i * i % 5);
    tall += fmt::format("A,i{0},{1}\nB,i{0},{2}\n", i, 0.1 + i * i * 0.3, 0.7 + i * 0.21);
  }
  const Request blocks{.values = {"A", "B"}, .block = {"problem"}}, by_solver{.block = {"problem"}};
  for (const char* last :
       {"i12,1.155,1.455\ni13,12,0\n", "i12,13.86,17.46\n", "m,1.155,1.455\nd,0.04,0.04\nw,12,0\nx,1,2\n", "w,12,0\n"})
    CHECK(contains(said_of(rows + last, blocks), "data.csv:14:2"));
  for (const char* other : {"i12,1.155,1.47\n", "i12,13,14\n", "i12,11,1\n"})
    CHECK(said_of(rows + other, blocks).empty());
  CHECK(said_of(rows, blocks).empty());
  CHECK(said_of(whole, blocks).empty());
  CHECK(
      contains(said_of(rows + "rank,1.43,1.91\n", blocks), "data.csv:14:1"));  // of more solvers or runs than there are
  // A sum as a group of its own, of one row.
  std::string named = "solver,error\n";
  for (const char* row : {"a,1.035", "b,1.361", "a,1.002", "b,1.540", "a,0.919", "b,1.357", "a,0.979", "b,1.350"})
    named += fmt::format("{}\n", row);
  for (const char* last : {"x,1.193", "x,1.193\n", "x,9.543", "x,1.540"})
    CHECK(contains(said_of(named + last), "data.csv:10:2"));
  CHECK(contains(said_of("solver,error\nx,1.193" + named.substr(12)), "data.csv:2:2"));
  for (const char* other : {"x,1.201", "x,1.193\nx,1.201", "x,1.193\na,1.001"}) CHECK(said_of(named + other).empty());
  std::string stamps = "s,v\n";  // near each other by their size
  for (int i = 0; i < 20; ++i) stamps += fmt::format("{},{}\n", i < 10 ? "A" : "B", 1.7e9 + i * i * 37 % 101 * 0.971);
  CHECK(said_of(stamps).empty());
  // Small counts and infinite values are data, whatever they add up to.
  CHECK(said_of("judge,A,B\n1,2,5\n2,4,4\n3,2,3\n4,3,1\n5,4,3\n6,3,3.2\n", {.values = {"A", "B"}, .block = {"judge"}})
            .empty());
  CHECK(said_of("p,A,B\n1,1.00,2.00\n2,1.48,2.53\n3,inf,inf\n4,3.10,3.59\n", {.values = {"A", "B"}, .block = {"p"}})
            .empty());
  CHECK(contains(said_of(rows + "m,1.155,1.455\n"), "data.csv:14:2"));  // before it is asked how it is read
  CHECK(said_of(tall, by_solver).empty());
  CHECK(contains(said_of(tall + "A,mean,12.75\nB,mean,1.855\n", by_solver), "data.csv:26:3"));
  // Any statistic, to the digits that it is printed with, of the values that there are.
  const std::string three =
      "p,A,B,C\na,1.31,2.45,NA\nb,0.72,1.16,3.09\nc,2.58,1.97,2.74\nd,0.93,3.62,1.51\ne,1.87,0.84,4.26\n";
  for (const char* last : {"1.48,2.01,2.90", "1.5,2.0,2.9", "1.31,1.97,2.92", "1.3345,1.7629,2.7166", "0.72,0.84,1.51",
                           "2.58,3.62,4.26", "0.75,1.10,1.13", "1.40,1.80,2.80", "3,2,0"}) {
    CAPTURE(last);
    CHECK(contains(said_of(three + "x," + last + "\n", {.block = {"p"}}), "data.csv:7:2"));
  }
  for (const char* last : {"1.51,2.01,2.90", "2,1,3", "2,2,0", "0,0,0", "1.1,1.9,inf"}) {
    CAPTURE(last);
    CHECK(said_of(three + "x," + last + "\n", {.block = {"p"}}).empty());
  }
  CHECK(contains(said_of(tall + "Total,,\n", by_solver), "data.csv:26:1: 'Total'"));
  // First, or of each group or each of its blocks.
  CHECK(contains(said_of("p,A,B\nm,1.48,2.01\na,1.31,2.45\nb,0.72,1.16\nc,2.58,1.97\nd,0.93,3.62\ne,1.87,0.84\n"),
                 "data.csv:2:2"));
  CHECK(contains(said_of("s,v\nA,1.31\nA,0.72\nA,2.58\nA,0.93\nA,1.385\nB,2.45\nB,1.16\nB,1.97\nB,1.86\n"),
                 "data.csv:6:2"));
  std::string each = "p,s,r,v\n";
  for (int i = 0; i < 6; ++i)
    each += fmt::format("x{0},{1},1,{2}\nx{0},{1},2,{3}\nx{0},{1},3,{4}\nx{0},{1},m,{5}\n", i / 2, i % 2, 40 + i * i,
                        61 - i, 70 + 2 * i * i % 11, (171 + i * i - i + 2 * i * i % 11) / 3.0);
  CHECK(contains(said_of(each, {.values = {"v"}, .label = {"s"}, .block = {"p"}, .run = "r"}), "data.csv:5:4"));
  // Whole numbers are often such a statistic by chance, however they are printed, and so is a limit.
  for (const char* data :
       {"p0,8.00,3.00\np1,4.00,3.00\np2,11.00,4.00\np3,1.00,11.00\np4,10.00,7.00\np5,5.00,1.00\np6,8.00,1.00\n"
        "p7,8.00,11.00\np8,7.00,3.00\np9,1.00,1.00\np10,9.00,9.00\np11,10.00,6.00\n",
        "p0,80,140\np1,40,30\np2,100,50\np3,110,40\np4,90,60\np5,120,30\np6,60,90\np7,40,60\n",
        "p0,3.151,4.212\np1,60,18.323\np2,8.452,60\np3,9.161,2.124\np4,60,60\n"})
    CHECK(said_of("p,A,B\n" + std::string(data), {.block = {"p"}}).empty());
  CHECK(said_of("a,b,c\n1,2,3\n2,3,4\n2.5,,\n", {.run = "row"}).empty());  // one group has more
}

TEST_CASE("points of runs are asked about, whatever the runs are called") {
  std::mt19937 random(2023);
  std::normal_distribution<> normal;
  int asked = 0;
  for (int trial = 0; trial < 200; ++trial) {
    std::string text = "solver,random_seed,point,error\n";
    for (const char* solver : {"A", "B"}) {
      for (int seed = 0; seed < 5; ++seed) {
        const double level = normal(random);
        for (int point = 0; point < 8; ++point)
          text += fmt::format("{},{},{},{}\n", solver, seed, point, std::exp(level + 0.01 * normal(random)));
      }
    }
    asked += !asked_of(text, {.values = {"error"}}).empty();
    CHECK(list_of(observations(text, {.values = {"error"}, .run = "random_seed"}).groups[0]).size() == 5);
  }
  CHECK(asked == 200);
}

TEST_CASE("several columns of labels or blocks are joined") {
  const std::string text = "scene,seed,alg,h,time\nx,1,A,1,1\nx,2,A,1,2\ny,1,A,1,3\nx,1,A,2,4\nx,2,A,2,5\ny,1,A,2,6\n";
  const Observations of = observations(text, {.values = {"time"}, .label = {"alg", "h"}, .block = {"scene", "seed"}});
  REQUIRE(of.groups.size() == 2);
  CHECK(of.groups[1].name == "A / 2");
  CHECK(contains(said_of("p,q,v\na / b,c,1\na,b / c,2\n", {.label = {"p", "q"}}), "data.csv:2:1"));
  CHECK(list_of(of.groups[1]) == std::vector{4.0, 5.0, 6.0});
}

TEST_CASE("rows of a run are averaged where asked, else refused") {
  const std::string text = "solver,run,point,e\nA,1,1,1\nA,1,2,3\nA,2,1,2\nA,2,2,6\nB,1,1,9\nB,1,2,9\nB,2,1,7\n";
  CHECK(contains(said_of(text, {.values = {"e"}}), "'run', 'point'"));
  CHECK(contains(said_of(text + "B,2,2,8\n", {.values = {"e"}, .block = {"point"}}), "[--run run]"));
  const Observations observed = csv::read(text, "data.csv", {.values = {"e"}, .run = "run"}).observed.front();
  CHECK(list_of(observed.groups[0]) == std::vector{2.0, 4.0});
  CHECK(lost_in(observed.groups[1]) == 1);  // a row of its second run is missing
  CHECK(observed.doubts.front().kind == DoubtKind::incomplete);
  const Observations blocks = observations(text, {.values = {"e"}, .block = {"point"}, .run = "run"});
  CHECK(list_of(blocks.groups[0]) == std::vector{1.5, 4.5});
  CHECK(lost_in(blocks.groups[1]) == 1);
  CHECK(observations(text, {.values = {"e"}, .block = {"run"}, .run = "run"}).is_paired);
}

TEST_CASE("a row without its run is refused") {
  CHECK(contains(said_of("solver,seed,v\nA,,1.5\nA,,2\nB,1,3\nB,2,4\n", {.values = {"v"}, .run = "seed"}),
                 "data.csv:2:2"));
}

TEST_CASE("a block without a row of a group is lost to it") {
  const Observations observed =
      csv::read("s,p,v\nA,x,1\nA,y,2\nB,x,1\n", "data.csv", {.values = {"v"}, .block = {"p"}}).observed.front();
  CHECK(lost_in(observed.groups[1]) == 1);
  CHECK(observed.doubts.front().who == std::vector<std::string>{"B"});
  CHECK(observed.doubts.front().of == 2);
}

TEST_CASE("values of 0 and 1 are shares, and of several runs a target too") {
  const std::vector<std::string> better{"larger"};
  Observations of = observations("s,v\nA,1\nA,1\nA,0\nB,0\nB,0\nB,1\n", {.better = better});
  CHECK(of.scale == Scale::share);
  CHECK(of.trials == 1);
  CHECK(observations("s,v\nA,1\nA,NA\nA,0\nB,0\nB,0\nB,1\n", {.better = better}).scale == Scale::share);
  CHECK_THROWS_AS(csv::with_margin({}, "0.1", of), std::invalid_argument);
  const Observations several = observations("s,p,r,v\nA,1,1,1\nA,1,2,0\nB,1,1,1\nB,1,2,1\n",
                                            {.values = {"v"}, .block = {"p"}, .run = "r", .better = better});
  CHECK(several.trials == 2);
  CHECK(list_of(several.groups[0]) == std::vector{0.5});
  std::string text = "s,p,r,v\n";
  for (int run = 0; run < 1000; ++run)
    text += fmt::format("A,1,{0},{1}\nB,1,{0},{2}\n", run, run % 3 ? 0 : 1, run > 333 ? 0 : 1);
  const Observations equal = observations(text, {.values = {"v"}, .block = {"p"}, .run = "r", .better = better});
  CHECK(list_of(equal.groups[0]) == list_of(equal.groups[1]));  // in whichever order the runs were solved
}

TEST_CASE("margins are shares or in the unit of the values") {
  Observations of = observations(wide, {.run = "row"});
  CHECK(csv::with_margin({}, "", of).margin == 0.05);
  CHECK(csv::with_margin({}, "10%", of).margin == Approx(0.1));
  const judge::Plan plan = csv::with_margin({}, "0.5", of);
  CHECK(plan.margin == 0);
  CHECK(of.absolute_margin == 0.5);
  for (const char* margin : {"x", "-1", "%", "nan", "inf", "10"})
    CHECK_THROWS_AS(csv::with_margin({}, margin, of), std::invalid_argument);
}

TEST_CASE("printed means are compared by means") {
  const Quantities read =
      csv::read(text_in("results/published/slim2023/table-3.csv"), "table-3.csv", {.are_summaries = true});
  REQUIRE(read.observed.size() == 3);
  const Observations& error = read.observed.front();
  CHECK(error.groups.size() == 6);
  CHECK(std::get<judge::Summary>(error.groups.front().sample).sd == 1.7824e-4);
  const std::vector<Seen> found = judge::compared(error, {});
  CHECK(found.front().test == "Welch's t");
  CHECK(found.front().verdict == Verdict::better);  // IK-BA against BA
  CHECK(*found.front().estimate == Approx(0.0019 - 1.6849));
  CHECK(csv::read("name,n,mean,sd,metric\nA,5,1,1,\u8bef\nA,5,1,1,\u65f6\n", "s.csv", {.are_summaries = true})
            .observed.size() == 2);
  const Quantities usual = csv::read("name,n_runs,avg,std_dev\nA,5,1,2\n", "s.csv", {.are_summaries = true});
  CHECK(std::get<judge::Summary>(usual.observed.front().groups.front().sample).sd == 2);
  CHECK_THROWS_AS(csv::read("name,n,mean,sd\nA,2.5,1,1\n", "s.csv", {.are_summaries = true}), std::invalid_argument);
  CHECK_THROWS_AS(csv::read("name,n,mean,sd\nA,5,1,-1\n", "s.csv", {.are_summaries = true}), std::invalid_argument);
  CHECK_THROWS_AS(csv::read("name,n,mean\nA,5,1\n", "s.csv", {.are_summaries = true}), std::invalid_argument);
  CHECK_THROWS_AS(csv::read("name,n,mean,sd\nA,5,1,1\nA,5,2,1\n", "s.csv", {.are_summaries = true}),
                  std::invalid_argument);
}

TEST_CASE("printed means without a spread decide nothing") {
  const Quantities read =
      csv::read("name,n,mean,sd\nA,20,1,0\nB,20,1.1,0\nC,20,1,0.1\nD,20,2,0.1\n", "s.csv", {.are_summaries = true});
  CHECK(read.observed.front().doubts.size() == 2);
  const std::vector<Seen> found = judge::compared(read.observed.front(), {});
  for (const Seen& each : found)
    CHECK((each.verdict == Verdict::not_tested) == (each.first == "A" || each.first == "B"));
  CHECK(found.back().verdict == Verdict::better);
}

TEST_CASE("mistakes say where and what to do") {
  check_mistakes("csv", "data.csv", [](const std::string& text) {
    if (const std::string said = said_of(text); !said.empty()) throw std::invalid_argument(said);
  });
  CHECK(contains(said_of("s,v\n,1\n", {.label = {"s"}}), "label"));
  CHECK(contains(said_of("s,v\nA,1\nA,x1\n", {.values = {"v"}}), "data.csv:3:2: 'x1' in column 'v'"));
  CHECK(contains(said_of("alg,ok\nA,93%\n", {.values = {"ok"}}), "data.csv:2:2: '93%'"));
  const Quantities two =
      csv::read("s,error_cm,error_deg\nA,5,7\nA,6,8\nB,6,6\nB,9,4\n", "d.csv", {.values = {"error_cm", "error_deg"}});
  CHECK(two.observed[1].quantity == "error_deg");  // a name of its own
  const std::string by_seed = "seed,error\n1,0.5\n1,0.7\n2,0.6\n2,0.9\n";
  CHECK(observations(by_seed, {.label = {"seed"}}).groups.size() == 2);  // a column of groups numbers no runs
  CHECK(csv::read("s,v\nA,1\nB,2\n", "data.csv", {.values = {"v", "v"}}).observed.size() == 1);
  CHECK(contains(said_of("solver,error\nA,1\n", {.values = {"eror"}}), "did you mean \"error\""));
  CHECK(contains(said_of(std::string("s,v\nA\0,1\n", 9)), "NUL"));
  CHECK(contains(said_of("solver,series,error,stop_reason\nA,k,1,ok\n"), "`ikbench report`"));
  std::string many = "s,v\n";
  for (std::size_t i = 0; i <= csv::most_groups; ++i) many += fmt::format("g{},1\n", i);
  CHECK(contains(said_of(many), "100 groups"));
  std::string long_one = "s,v\n";
  for (int i = 0; i <= 10'000'000; ++i) long_one += "A,1\n";
  CHECK(contains(said_of(long_one), "10000000 rows"));
}

TEST_CASE("any label is kept as it is") {
  const Observations of = observations("solver,v\n\"a,\"\"b\"\"\n<c> $d$ \\e\",1\n'=1+1',2\n\xC3\xA9,4\n");
  REQUIRE(of.groups.size() == 3);
  CHECK(of.groups[0].name == "a,\"b\"\n<c> $d$ \\e");
  CHECK(of.groups[2].name == "\xC3\xA9");
}

TEST_CASE("of a million rows a run's are one value") {
  std::string text = "solver;seed;v\n";
  for (int i = 0; i < 1'000'000; ++i) text += fmt::format("{};{};{},5\n", i % 2 ? "A" : "B", i / 20, i % 1000);
  CHECK(list_of(observations(text, {.run = "seed"}).groups.front()).size() == 50'000);
}

TEST_CASE("doubts of a file read as sentences") {
  const Observations observed =
      csv::read("s,p,v\nA,x,1\nA,y,2\nB,x,\n,y,3\n", "d.csv", {.values = {"v"}, .label = {"s"}, .block = {"p"}})
          .observed.front();
  REQUIRE(observed.doubts.size() == 2);
  CHECK(words_of(observed.doubts[0]) ==
        "2 of 2 blocks incomplete: no verdict on B; write inf for no answer, or drop them");
  CHECK(words_of(observed.doubts[1]) == "1 of 4 rows without a label, left out");
}

TEST_CASE("a number whose squares are beyond a double is refused", "[user_csv]") {
  for (const char* number : {"1e80", "-1e80", "1e-80"}) {
    INFO(number);
    CHECK_THROWS_AS(csv::read(fmt::format("solver,error\nA,1\nA,{}\nB,1\nB,2\n", number), "x.csv", {}),
                    std::invalid_argument);
  }
}
