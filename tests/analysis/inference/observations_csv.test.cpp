#include "analysis/inference/observations_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "results/export.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"
#include "tests/results/samples.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::statistics;
using namespace ikbench::inference;
using Values = std::vector<double>;
using Texts = std::vector<std::string>;

namespace {

// The words on what is missing.
std::string missing(const std::string& what) {
  return "Values are missing: " + what +
         ". A group that failed there looks better than it is: write Inf for a failure (-Inf if larger is better).";
}

const CsvRequest by_solver{.value = "error", .group = "solver"};
const CsvRequest wide{.is_wide = true};

Observations read(std::string_view text, const CsvRequest& request = by_solver) {
  return read_observations(text, "a/folder/file.csv", request);
}

std::string refusal(std::string_view text, const CsvRequest& request = by_solver) {
  try {
    read(text, request);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "not refused";
}

std::string summary_refusal(std::string_view text) {
  try {
    read_summaries(text, "file.csv");
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "not refused";
}

bool says(const std::string& text, const Texts& words) {
  UNSCOPED_INFO(text);
  return std::ranges::all_of(words, [&](const std::string& word) { return text.find(word) != std::string::npos; });
}

Texts names_of(const Observations& observations) {
  Texts names;
  for (const Group& group : observations.groups) names.push_back(group.name);
  return names;
}

}  // namespace

TEST_CASE("pandas' to_csv with its index column is one observation a row", "[csv]") {
  const Observations seen = read(",solver,error\n0,IK-BA,0.1\n1,BA,0.2\n2,IK-BA,0.3\n");
  CHECK(names_of(seen) == Texts{"IK-BA", "BA"});
  CHECK(seen.groups[0].values == Values{0.1, 0.3});
  CHECK(seen.groups[1].values == Values{0.2});
  CHECK(seen.replicate == "a row of file.csv");
  CHECK(seen.quantity == "error");
  CHECK(seen.blocks.empty());
  CHECK(seen.notes.empty());
  CHECK(seen.flaws.empty());
}

TEST_CASE("R's write.csv with quoted texts and row names reads the same", "[csv]") {
  const Observations seen = read("\"\",\"solver\",\"error\"\n\"1\",\"IK-BA\",1e-05\n\"2\",\"BA\",NA\n\"3\",\"BA\",2\n");
  CHECK(seen.groups[0].values == Values{1e-5});
  CHECK(seen.groups[1].values == Values{2});
  CHECK(words_of(seen.flaws) == missing("1 of 2 values of BA"));
}

TEST_CASE("a spreadsheet's byte-order mark, CRLF and empty rows below the table mean nothing", "[csv]") {
  const Observations seen = read("\xEF\xBB\xBFsolver,error\r\nA,1\r\nA,2\r\n,\r\n,\r\n");
  CHECK(names_of(seen) == Texts{"A"});
  CHECK(seen.groups[0].values == Values{1, 2});
  CHECK(seen.notes.empty());
}

TEST_CASE("every spelling of a missing value is left out and counted by group, infinities are values", "[csv]") {
  const Observations seen = read(
      "solver,error\nA,\nA,NA\nA,NaN\nA,nan\nA,null\nA,<NA>\nA,None\nA,N/A\nA,-nan\nA,1\nB,Inf\nB,inf\nB,2\nC, NA \n");
  CHECK(seen.groups[0].values == Values{1});
  CHECK(seen.groups[1].values == Values{HUGE_VAL, HUGE_VAL, 2});
  CHECK(seen.groups[2].values.empty());  // a group that has nothing is still there
  CHECK(words_of(seen.flaws) == missing("9 of 10 values of A, 1 of 1 of C"));
  CHECK(seen.notes == Texts{"B: 2 of 3 observations are not finite and worse than any number; differences of means are "
                            "those of finite observations."});
}

TEST_CASE("an infinity that would beat every number is refused, because it can only be a failure", "[csv]") {
  CHECK(refusal("solver,error\nA,1\nB,-inf\nB,2\n") ==
        "a/folder/file.csv: row 2 below the header: -Inf, but smaller values are better; expected a finite number, or "
        "Inf for a failure");
  const CsvRequest larger{.value = "share", .group = "solver", .better = Better::larger};
  CHECK(says(refusal("solver,share\nA,1\nB,Inf\n", larger), {"row 2", "Inf, but larger values are better"}));
  CHECK(read("solver,share\nA,1\nB,-Inf\n", larger).groups[1].values == Values{-HUGE_VAL});
}

TEST_CASE("a number of another language is refused", "[csv]") {
  CHECK(
      refusal("solver,error\nA,1\nB,\"1,5\"\n") ==
      "a/folder/file.csv: row 2 below the header, column 'error': '1,5', expected a number with a decimal point, of at "
      "most 1.7e308, or NA if it is missing");
  CHECK(says(refusal("solver,error\nA,3 cm\n"), {"row 1 below the header, column 'error': '3 cm', expected a"}));
  CHECK(says(refusal("solver,error\nA,1e999\n"), {"'1e999', expected a number"}));
}

TEST_CASE("semicolons and tabs between the columns are refused, in quotes they are text", "[csv]") {
  CHECK(refusal("solver;error\nA;1,5\n") ==
        "a/folder/file.csv:1: no commas between the columns; expected them (and a point, not a comma, in a number)");
  CHECK(says(refusal("solver\terror\nA\t1\n"), {":1: no commas between the columns"}));
  CHECK(says(refusal(std::string_view("\xFF\xFEs\0", 4)), {"a NUL byte; expected text in UTF-8"}));
  CHECK(read("\"solver\",\"error; squared\"\nA,1\n", {.value = "error; squared", .group = "solver"}).name ==
        "error-squared");
  CHECK(read("\"a;b\"\n1\n", wide).groups[0].name == "a;b");
}

TEST_CASE("what is not in the file is refused with what is", "[csv]") {
  CHECK(says(refusal("solver,err\nA,1\n"), {"no column 'error'; expected one of: solver, err"}));
  CHECK(says(refusal("method,error\nA,1\n", {.value = "error"}), {"--group", "method, error"}));
  CHECK(says(refusal("solver,error\nA,1\n", {.group = "solver"}), {"--value", "solver, error"}));
  CHECK(says(refusal("solver,error\n"), {"no rows below the header"}));
  CHECK(says(refusal("solver,error\nA,NA\n"), {"all values are missing"}));
  CHECK(says(refusal(""), {"the file is empty"}));
  CHECK(names_of(read("Algorithm,error\nA,1\n", {.value = "error"})) == Texts{"A"});  // found without being named
}

TEST_CASE("names with commas, quotes, line ends and of any script are kept", "[csv]") {
  const Observations seen = read("solver,error\n\"a,b\",1\n\"say \"\"hi\"\"\",2\n\"two\nlines\",3\nΔ 蝙蝠,4\n,5\n");
  CHECK(names_of(seen) == Texts{"a,b", "say \"hi\"", "two\nlines", "Δ 蝙蝠", "(empty)"});
}

TEST_CASE("rows that share a run are not replicates", "[csv]") {
  const std::string text = "solver,run,point,error\nA,1,1,1\nA,1,2,3\nA,2,1,5\nA,2,2,7\nB,1,1,2\nB,1,2,4\n";
  CHECK(refusal(text) ==
        "a/folder/file.csv: 2 rows share run 1 of A, and are not replicates; average rows that depend on each other, "
        "such as points of a path, with --run run; compare problems that were solved separately within blocks with "
        "--block COLUMN --run run; or use --force");

  const Observations means = read(text, {.value = "error", .group = "solver", .run = "run"});
  CHECK(means.groups[0].values == Values{2, 6});
  CHECK(means.groups[1].values == Values{3});
  CHECK(means.replicate == "the mean of a run over its 2 rows of file.csv");
  CHECK(words_of(means.flaws) == missing("1 of 2 runs of B"));

  CsvRequest forced = by_solver;
  forced.takes_any_rows = true;
  CHECK(read(text, forced).groups[0].values == Values{1, 3, 5, 7});
  CHECK(says(words_of(read(text, forced).flaws), {"2 rows share run 1 of A", "anyway"}));
}

TEST_CASE("the solves that the program exports are refused as replicates and averaged by run", "[csv]") {
  const std::vector<SolveRecord> solves = synthetic::solves({.solvers = {"IK-BA", "BA"}, .runs = 3, .points = 5});
  const std::string text = exported("csv", solves);
  const CsvRequest errors{.value = "position_error_cm", .group = "solver"};
  CHECK(says(refusal(text, errors), {"5 rows share run 1 of IK-BA, and are not replicates"}));
  CsvRequest by_run = errors;
  by_run.run = "run";
  CHECK(read(text, by_run).groups[1].values.size() == 3);
}

TEST_CASE("columns that number repetitions are known by their names", "[csv]") {
  for (const char* title : {"Run", "seed", "trial_id", "Repetition", "rep", "repeat", "REPLICATE", "run number"}) {
    CAPTURE(title);
    CHECK(says(refusal(fmt::format("solver,{},error\nA,1,1\nA,1,2\n", title)), {"2 rows share"}));
    CHECK(refusal(fmt::format("solver,{},error\nA,1,1\nA,2,2\nB,1,3\n", title)) == "not refused");
    CHECK(refusal(fmt::format("solver,{},error\nA,,1\nA,,2\n", title)) == "not refused");  // not known
  }
  for (const char* title : {"fold", "running time", "trials", "id", "problem"}) {
    CAPTURE(title);
    CHECK(refusal(fmt::format("solver,{},error\nA,1,1\nA,1,2\n", title)) == "not refused");
  }
}

TEST_CASE("a run with a missing row has no mean and is left out", "[csv]") {
  const Observations seen = read("solver,run,error\nA,1,1\nA,1,NA\nA,2,2\nA,2,4\nA,3,Inf\nA,3,1\n",
                                 {.value = "error", .group = "solver", .run = "run"});
  CHECK(seen.groups[0].values == Values{3, HUGE_VAL});
  CHECK(seen.notes.back().starts_with("A: 1 of 2 observations is not finite and worse than any number"));
  CHECK(words_of(seen.flaws) == missing("1 of 3 runs of A"));
  CHECK(says(refusal("solver,run,error\nA,,1\nA,2,1\n", {.value = "error", .group = "solver", .run = "run"}),
             {"row 1 below the header, column 'run': '', expected a name or a number"}));
}

TEST_CASE("a run that lacks a row which others have has no mean, whether the row is there without a value or not",
          "[csv]") {
  const CsvRequest by_run{.value = "error", .group = "solver", .run = "run"};
  for (const char* failed : {"", "B,1,NA\n"}) {
    CAPTURE(failed);
    const Observations seen =
        read(std::string("solver,run,error\nA,1,1\nA,1,9\nA,2,2\nA,2,8\nB,1,1\nB,2,4\nB,2,6\n") + failed, by_run);
    CHECK(seen.groups[0].values == Values{5, 5});
    CHECK(seen.groups[1].values == Values{5});  // not 1, which is the easier row alone
    CHECK(seen.replicate == "the mean of a run over its 2 rows of file.csv");
    CHECK(words_of(seen.flaws) == missing("1 of 2 runs of B"));
  }
  CHECK(says(refusal("solver,run,error\nA,1,1\nA,1,NA\nB,1,1\n", by_run), {"no run has a value in each of its rows"}));
  CsvRequest forced = by_run;
  forced.takes_any_rows = true;
  const Observations seen = read("solver,run,error\nA,1,1\nA,1,9\nB,1,1\n", forced);
  CHECK(seen.groups[1].values == Values{1});
  CHECK(seen.replicate == "the mean of a run over its 1 to 2 rows of file.csv");
  CHECK(says(words_of(seen.flaws), {"Fewer values than the fullest have 1 of 1 runs of B"}));
}

TEST_CASE("a run that is absent as a whole counts as one that the group lacks", "[csv]") {
  // Runs of two rows; of A 1 to 20, of B what `of_b` says.
  const auto text_with = [](const std::vector<int>& of_b) {
    std::string text = "solver,run,error\n";
    for (int run = 1; run <= 20; ++run) text += fmt::format("A,{0},{0}\nA,{0},{0}\n", run);
    for (const int run : of_b) text += fmt::format("B,{0},{0}\nB,{0},{0}\n", run);
    return text;
  };
  const auto flaw = [](const std::string& text) {
    return words_of(read(text, {.value = "error", .group = "solver", .run = "run"}).flaws);
  };
  std::vector<int> runs;
  for (int run = 1; run <= 15; ++run) runs.push_back(run);
  CHECK(flaw(text_with(runs)) == missing("5 of 20 runs of B"));
  CHECK(flaw(text_with({7})) == missing("19 of 20 runs of B"));
  runs.push_back(21);  // which A lacks
  CHECK(flaw(text_with(runs)) == missing("1 of 21 runs of A, 5 of 21 of B"));
  CHECK(flaw(text_with({21, 22, 23})).empty());  // seeds of its own

  CsvRequest forced{.value = "error", .group = "solver", .run = "run", .takes_any_rows = true};
  CHECK(words_of(read(text_with({1, 2}), forced).flaws) == missing("18 of 20 runs of B"));
}

TEST_CASE("a row that is absent counts as missing where a column numbers the runs", "[csv]") {
  const Observations seen = read("solver,seed,error\nA,1,1\nA,2,2\nA,3,3\nB,1,1\nB,3,2\n");
  CHECK(seen.groups[1].values == Values{1, 2});
  CHECK(words_of(seen.flaws) == missing("1 of 3 values of B"));
  CHECK(read("solver,seed,error\nA,1,1\nA,2,2\nA,3,3\nB,4,1\nB,5,2\n").flaws.empty());
  // Two pairs of groups with runs of their own, and a second column that numbers the rows.
  const std::string pairs = "A,1,1\nA,2,2\nB,1,3\nB,2,2\nC,3,1\nC,4,2\nD,3,3\n";
  CHECK(read("solver,seed,error\n" + pairs + "D,4,2\n").flaws.empty());
  CHECK(words_of(read("solver,seed,error\n" + pairs).flaws) == missing("1 of 2 values of D"));
  CHECK(words_of(read("solver,seed,trial,error\nA,1,1,1\nA,2,2,2\nB,1,3,2\n").flaws) == missing("1 of 2 values of B"));
}

TEST_CASE("a row that is there twice is refused", "[csv]") {
  std::string text = "solver,run,error\n";
  for (const char* solver : {"A", "B"}) {
    for (int run = 1; run <= 10; ++run) text += fmt::format("{0},{1},1\n{0},{1},2\n{0},{1},3\n", solver, run);
  }
  CsvRequest request{.value = "error", .group = "solver", .run = "run"};
  CHECK(read(text, request).flaws.empty());
  CHECK(refusal(text + "A,1,6\n", request) ==
        "a/folder/file.csv: only 1 of 20 runs have 4 rows; a row may be duplicated, or rows may be missing; --force "
        "averages them as they are");
  request.takes_any_rows = true;
  const Observations seen = read(text + "A,1,6\n", request);
  CHECK(seen.groups[0].values == Values{3, 2, 2, 2, 2, 2, 2, 2, 2, 2});
  CHECK(words_of(seen.flaws) ==
        "Fewer values than the fullest have 9 of 10 runs of A, 10 of 10 of B. Their means are taken as they are.");
}

TEST_CASE("a missing value without blocks is a flaw, because a group that failed there looks better", "[csv]") {
  CHECK(words_of(read("solver,error\nA,1\nA,NA\nB,2\n").flaws) == missing("1 of 2 values of A"));
  CHECK(read("solver,error\nA,1\nA,Inf\nB,2\n").flaws.empty());  // written as a failure, which ranks last
}

TEST_CASE("the mean of huge values does not overflow", "[csv]") {
  const Observations seen = read("solver,run,error\nA,1,1e308\nA,1,1.5e308\nA,2,1e308\nA,2,-1e308\n",
                                 {.value = "error", .group = "solver", .run = "run"});
  CHECK(seen.groups[0].values[0] == Approx(1.25e308));
  CHECK(seen.groups[0].values[1] == 0);
}

TEST_CASE("rows of one block alone are refused", "[csv]") {
  CHECK(refusal("solver,problem,error\nA,p,1\nA,p,2\nB,p,1\n",
                {.value = "error", .group = "solver", .block = "problem"}) ==
        "a/folder/file.csv: all rows are in one block, 'p', within which nothing can be judged; leave out --block");
}

TEST_CASE("blocks are aligned over the groups, incomplete ones left out and counted", "[csv]") {
  const CsvRequest request{.value = "error", .group = "solver", .block = "problem"};
  const Observations seen =
      read("problem,solver,error\np1,A,1\np1,B,2\np2,B,4\np2,A,3\np3,A,5\np4,A,NA\np4,B,6\n", request);
  CHECK(seen.blocks == Texts{"p1", "p2"});
  CHECK(seen.groups[0].values == Values{1, 3});
  CHECK(seen.groups[1].values == Values{2, 4});
  CHECK(seen.block == "a value of 'problem' in file.csv");
  CHECK(words_of(seen.flaws) == missing("1 of 4 blocks of A, 1 of 4 of B; these blocks are left out for all groups"));
  CHECK(says(refusal("problem,solver,error\np1,A,1\np2,B,1\n", request), {"no block has a value for every group"}));
  CHECK(says(refusal("problem,solver,error\n,A,1\n", request), {"column 'problem': '', expected a name"}));
}

TEST_CASE("runs of a block are averaged where the runs are named", "[csv]") {
  const std::string text =
      "problem,solver,run,error\np,A,1,1\np,A,2,3\np,B,1,10\np,B,2,20\nq,A,1,5\nq,A,2,NA\nq,B,1,2\nq,B,2,4\n";
  CsvRequest request{.value = "error", .group = "solver", .block = "problem"};
  CHECK(refusal(text, request) ==
        "a/folder/file.csv: 2 rows of 'A' in block 'p'; expected one; average rows and runs with --run COLUMN, or all "
        "rows with --force");
  request.run = "run";
  const Observations seen = read(text, request);
  CHECK(seen.blocks == Texts{"p"});
  CHECK(seen.groups[0].values == Values{2});
  CHECK(seen.groups[1].values == Values{15});
  CHECK(seen.replicate == "the mean over the 2 runs of a block in file.csv");
}

TEST_CASE("a group with fewer runs than another in a block has no value there", "[csv]") {
  // B crashes in the worst run of p: not told, its mean there would be 1, and A's 34.
  const CsvRequest request{.value = "error", .group = "solver", .block = "problem", .run = "seed"};
  const std::string text =
      "solver,problem,seed,error\nA,p,1,1\nA,p,2,1\nA,p,3,100\nB,p,1,1\nB,p,2,1\n"
      "A,q,1,2\nA,q,2,4\nB,q,1,6\nB,q,2,8\nA,r,1,3\nA,r,2,3\nA,r,3,3\nB,r,1,4\nB,r,2,4\nB,r,3,4\n";
  for (const char* failed : {"", "B,p,3,\n", "B,p,3,NaN\n"}) {
    CAPTURE(failed);
    const Observations seen = read(text + failed, request);
    CHECK(seen.blocks == Texts{"q", "r"});  // all groups have two runs of q
    CHECK(seen.groups[0].values == Values{3, 3});
    CHECK(seen.groups[1].values == Values{7, 4});
    CHECK(seen.replicate == "the mean over the 2 to 3 runs of a block in file.csv");
    CHECK(words_of(seen.flaws) == missing("1 of 3 blocks of B; these blocks are left out for all groups"));
  }
  CHECK(read(text + "B,p,3,Inf\n", request).groups[1].values == Values{HUGE_VAL, 7, 4});
  CHECK(read(text + "B,p,3,Inf\n", request).flaws.empty());

  CsvRequest forced = request;
  forced.takes_any_rows = true;
  const Observations seen = read(text, forced);
  CHECK(seen.groups[1].values == Values{1, 7, 4});
  CHECK(words_of(seen.flaws) ==
        "Fewer values than the fullest have 1 of 3 blocks of B. Their means are taken as they are.");
}

TEST_CASE("a group that has fewer runs in every block is refused with the way to insist", "[csv]") {
  const std::string text = "solver,problem,seed,error\nA,p,1,1\nA,p,2,1\nB,p,1,1\nA,q,1,1\nA,q,2,1\nB,q,1,1\n";
  CHECK(refusal(text, {.value = "error", .group = "solver", .block = "problem", .run = "seed"}) ==
        "a/folder/file.csv: no block has a value for every group; --force averages the values that exist");
}

TEST_CASE("a run that is the block gives one mean a run and group", "[csv]") {
  const Observations seen = read("solver,run,error\nA,1,1\nA,1,3\nA,2,5\nA,2,7\nB,1,0\nB,1,0\nB,2,1\nB,2,1\n",
                                 {.value = "error", .group = "solver", .block = "run", .run = "run"});
  CHECK(seen.blocks == Texts{"1", "2"});
  CHECK(seen.groups[0].values == Values{2, 6});
  CHECK(seen.groups[1].values == Values{0, 1});
}

TEST_CASE("a wide column without a title is a group like the others", "[csv]") {
  const Observations seen = read("A,,C\n1,100,3\n2,200,4\n3,300,5\n", {.is_wide = true});
  REQUIRE(seen.groups.size() == 3);
  CHECK(seen.groups[1].values == std::vector<double>{100, 200, 300});
}

TEST_CASE("wide columns are groups, of unequal size where cells are empty", "[csv]") {
  const Observations seen = read(",A,B\n0,1,2\n1,3,\n2,5,\n", wide);
  CHECK(names_of(seen) == Texts{"A", "B"});
  CHECK(seen.groups[0].values == Values{1, 3, 5});
  CHECK(seen.groups[1].values == Values{2});
  CHECK(seen.blocks.empty());
  CHECK(words_of(seen.flaws) == missing("2 of 3 values of B"));
}

TEST_CASE("rows of the wide layout are blocks where that is asked", "[csv]") {
  const Observations rows = read("A,B\n1,2\n3,\n5,6\n", {.is_wide = true, .rows_are_blocks = true});
  CHECK(rows.blocks == Texts{"1", "3"});
  CHECK(rows.groups[1].values == Values{2, 6});
  const Observations named = read("problem,A,B\nx,1,2\ny,3,4\n", {.is_wide = true, .block = "problem"});
  CHECK(named.blocks == Texts{"x", "y"});
  CHECK(names_of(named) == Texts{"A", "B"});
}

TEST_CASE("a wide column that is no group is refused or known", "[csv]") {
  CHECK(says(refusal("problem,A\nx,1\n", wide), {"row 1 below the header, column 'problem': 'x', expected"}));
  CHECK(says(refusal("A,A\n1,2\n", wide), {"two columns 'A'"}));
  CHECK(says(refusal("run,A\n1,2\n1,3\n", wide), {"2 rows share run 1 of A"}));
  CHECK(says(refusal("A\n1\n", {.is_wide = true, .group = "A"}), {"--group 'A'"}));
  const Observations seen = read("run,A\n1,2\n2,3\n", wide);
  CHECK(names_of(seen) == Texts{"A"});
  CHECK(seen.notes == Texts{"Column 'run' numbers the repetitions and is not a group."});
}

TEST_CASE("200 groups are read, more than 1000 refused", "[csv]") {
  const auto text_with = [](int groups) {
    std::string text = "solver,error\n";
    for (int i = 0; i < groups; ++i) text += fmt::format("s{},1\n", i);
    return text;
  };
  CHECK(read(text_with(200)).groups.size() == 200);
  CHECK(read(text_with(1000)).groups.size() == 1000);
  CHECK(says(refusal(text_with(1001)), {"more than 1000 groups, the last 's1000'"}));
}

TEST_CASE("a file that is no text, and a name that is none, are refused by what is wrong with them", "[csv]") {
  using namespace std::string_literals;
  CHECK(says(refusal("solver,error\nA,1\0\n"s), {"file.csv:2: a NUL byte"}));
  CHECK(says(refusal("A\0,error\nA,1\n"s), {"file.csv:1: a NUL byte"}));
  const std::string endless(3'000'000, 'x');
  CHECK(says(refusal("solver,error\n" + endless + ",1\n"), {"has 3000000 bytes; expected a name"}));
  CHECK(says(refusal(endless + ",b\n1,2\n", wide), {"3000000 bytes; expected a name"}));
  CHECK(says(summary_refusal("name,mean,sd,n\n" + endless + ",1,1,2\n"), {"3000000 bytes"}));
  for (const std::string& message : {refusal(endless + ",b\n1,2\n"), refusal(endless + ",solver,error\n1,A,x\n"),
                                     refusal("solver,error\n" + endless + ",1\n")}) {
    CHECK(message.size() < 1000);
  }
  CHECK(read("solver,error\n" + std::string(1000, 'x') + ",1\n").groups.front().name.size() == 1000);
}

TEST_CASE("messages that list columns name those without a name", "[csv]") {
  CHECK(says(refusal(",solver,err\n0,A,1\n"), {"no column 'error'; expected one of: (empty), solver, err"}));
}

TEST_CASE("a name for files and anchors is made of any column's name", "[csv]") {
  const auto name = [](const std::string& column) {
    return read("solver,\"" + column + "\"\nA,1\n", {.value = column, .group = "solver"}).name;
  };
  CHECK(name("Position error [cm]") == "position-error-cm");
  CHECK(name("../../etc") == "etc");
  CHECK(name("誤差") == "value");
}

TEST_CASE("published summaries are read under their usual names", "[csv]") {
  const Observations seen =
      read_summaries("Solver,Mean,STD,count,median\nIK-BA,1.5,0.5,20,1\nBA,2,,1,2\n", "file.csv").front();
  REQUIRE(seen.groups.size() == 2);
  CHECK(seen.groups[0].name == "IK-BA");
  CHECK(seen.groups[0].summary->mean == 1.5);
  CHECK(seen.groups[0].summary->std == 0.5);
  CHECK(seen.groups[0].summary->n == 20);
  CHECK(std::isnan(seen.groups[1].summary->std));  // one value has no spread
}

TEST_CASE("more observations in all than can be counted are refused", "[csv]") {
  CHECK(says(summary_refusal("name,mean,sd,n\nA,1,1,2147483647\nB,1,1,2147483647\n"), {"2147483647 in all groups"}));
}

TEST_CASE("summaries that cannot be are refused", "[csv]") {
  CHECK(says(summary_refusal("name,mean,n\nA,1,2\n"), {"no column sd or std or stddev"}));
  CHECK(says(summary_refusal("name,mean,sd,n\nA,1,-1,2\n"), {"'-1', expected a standard deviation"}));
  CHECK(says(summary_refusal("name,mean,sd,n\nA,1,,2\n"), {"'', expected a standard deviation"}));
  CHECK(says(summary_refusal("name,mean,sd,n\nA,1,1,2.5\n"), {"'2.5', expected the number of observations"}));
  CHECK(says(summary_refusal("name,mean,sd,n\nA,1,1,0\n"), {"'0', expected the number of observations"}));
  CHECK(says(summary_refusal("name,mean,sd,n\nA,1,1,1e12\n"), {"expected the number of observations"}));
  CHECK(says(summary_refusal("name,mean,sd,n\nA,Inf,1,2\n"), {"'Inf', expected a finite number"}));
  CHECK(says(summary_refusal("name,mean,sd,n\nA,1,1,2\nA,1,1,2\n"), {"'A', given twice"}));
  CHECK(says(summary_refusal("name,mean,sd,n\n"), {"no rows below the header"}));
}

TEST_CASE("rows of a group that are equal to the bit are one observation", "[csv]") {
  const auto sizes = [](const std::string& rows) {
    const Observations found = read_observations("group,e\n" + rows, "f.csv", {.value = "e"});
    std::vector<std::size_t> result;
    for (const Group& group : found.groups) result.push_back(group.values.size());
    result.push_back(found.notes.size());
    return result;
  };
  using Sizes = std::vector<std::size_t>;
  CHECK(sizes("A,0.25\nA,0.25\nA,0.25\nB,0.5\nB,0.5\n") == Sizes{1, 1, 1});
  CHECK(sizes("A,0.25\nA,0.25\nB,0.5\nB,0.75\n") == Sizes{1, 2, 1});
  CHECK(sizes("A,0.25\nA,0.5\nB,0.5\nB,0.75\n") == Sizes{2, 2, 0});
  CHECK(sizes("A,137\nA,137\nB,245\nB,245\n") == Sizes{1, 1, 1});
  CHECK(sizes("A,100\nA,100\nB,98\nB,97\n") == Sizes{2, 2, 0});  // counts may be equal by chance
  CHECK(sizes("A,1\nA,1\nB,0\nB,0\n") == Sizes{2, 2, 0});        // outcomes
  const Observations found =
      read_observations("group,e,seed\nA,0.25,1\nA,0.5,1\nA,0.25,2\nA,0.5,2\nB,1,1\nB,2,1\nB,1,2\nB,4,2\n", "f.csv",
                        {.value = "e", .run = "seed"});
  CHECK(found.groups[0].values == std::vector<double>{0.375});
  CHECK(found.groups[1].values == std::vector<double>{1.5, 2.5});
  CHECK(found.notes.back().starts_with("Equal runs are one observation: all runs of A (2) have the same value"));
}

TEST_CASE("typical values of a CSV are geometric means of its positive values", "[csv]") {
  const std::string csv = "solver,run,error\nA,1,1\nA,1,100\nA,2,10\nA,2,10\nB,1,2\nB,1,2\nB,2,2\nB,2,3\n";
  CsvRequest request{.value = "error", .run = "run", .scale = ValueScale::log10};
  const Observations found = read_observations(csv, "a.csv", request);
  CHECK(found.name == "typical-error");
  CHECK(found.quantity == "typical error");
  CHECK(found.groups[0].values == std::vector<double>{1, 1});  // log10 of 10
  CHECK_THROWS_WITH(read_observations("solver,run,error\nA,1,1\nA,2,0\n", "a.csv", request),
                    "a.csv: row 2 below the header: 0 has no logarithm; expected positive values for typical ones");
}

TEST_CASE("the order of rows in a run does not make copies differ", "[csv]") {
  CsvRequest request = by_solver;
  request.run = "run";
  const std::string rows = "a,1,.1\na,1,.1\na,1,.2\nb,0,.5\nb,0,.4\nb,0,.3\nb,1,.5\nb,1,.4\nb,1,.4\n";
  for (const char* first : {"a,0,.1\na,0,.1\na,0,.2\n", "a,0,.2\na,0,.1\na,0,.1\n"})
    CHECK(read("solver,run,error\n" + (first + rows), request).groups.at(0).values.size() == 1);
}

TEST_CASE("the order of rows does not decide the order of blocks", "[csv]") {
  CsvRequest request = by_solver;
  request.block = "target";
  for (const char* rows : {"a,x,1\na,y,2\nb,x,3\nb,y,4\n", "b,y,4\na,y,2\na,x,1\nb,x,3\n"}) {
    const Observations found = read("solver,target,error\n" + std::string(rows), request);
    CHECK(found.blocks == std::vector<std::string>{"x", "y"});
    for (const Group& group : found.groups) CHECK(group.values == (group.name == "a" ? Values{1, 2} : Values{3, 4}));
  }
}

TEST_CASE("spaces around a group's name are not part of it", "[csv]") {
  const Observations found = read("solver,error\na,1\n a,2\na ,3\nb,4\n");
  CHECK(found.groups.size() == 2);
  CHECK(found.groups.at(0).values == Values{1, 2, 3});
}
