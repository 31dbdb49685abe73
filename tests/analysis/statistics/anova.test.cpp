#include "analysis/statistics/anova.hpp"

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "tests/analysis/statistics/samples.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;
using samples::plant_growth;

namespace {

// A NIST StRD file: certified F and R^2, and the responses by treatment (header lines give the layout).
struct NistSet {
  double F = 0;
  std::vector<std::vector<double>> groups;
};

NistSet read_nist(const std::string& name) {
  std::ifstream file("tests/data/nist/" + name + ".dat");
  REQUIRE(file);
  NistSet set;
  std::map<int, std::vector<double>> groups;
  std::string line;
  bool data = false;
  while (std::getline(file, line)) {
    std::istringstream words(line);
    std::string word, last;
    if (data) {
      int treatment = 0;
      double response = 0;
      if (words >> treatment >> response) groups[treatment].push_back(response);
      continue;
    }
    while (words >> word) last = word;
    if (line.starts_with("Between ")) set.F = std::stod(last);
    data = line.starts_with("Data:") && set.F > 0;  // the second "Data:" of the file
  }
  for (auto& [treatment, responses] : groups) set.groups.push_back(std::move(responses));
  return set;
}

}  // namespace

TEST_CASE("one-way ANOVA has the certified digits of the NIST reference data sets", "[anova]") {
  const auto [name, digits] = GENERATE(table<std::string, int>({{"SiRstv", 9},
                                                                {"SmLs01", 9},
                                                                {"SmLs02", 9},
                                                                {"SmLs03", 9},
                                                                {"AtmWtAg", 9},
                                                                {"SmLs04", 9},
                                                                {"SmLs05", 9},
                                                                {"SmLs06", 9},
                                                                {"SmLs07", 4},
                                                                {"SmLs08", 4},
                                                                {"SmLs09", 4}}));
  const NistSet set = read_nist(name);
  const AnovaTable table = anova(set.groups);
  CAPTURE(name, table.statistic, set.F);
  const auto correct_digits = [](double value, double certified) {
    return value == certified ? 15.0 : -std::log10(std::abs(value - certified) / certified);
  };
  CHECK(correct_digits(table.statistic, set.F) >= digits);
}

TEST_CASE("the p-value of NIST's SiRstv is that of R", "[anova]") {
  CHECK(anova(read_nist("SiRstv").groups).p == Approx(0.349447493402193).epsilon(1e-12));  // R 4.2.2, aov
}

TEST_CASE("one-way ANOVA of PlantGrowth gives R's table", "[anova]") {
  const AnovaTable table = anova(plant_growth);
  CHECK(table.statistic == Approx(4.846088).epsilon(1e-6));  // R 4.2.2, aov
  CHECK(table.ss_between == Approx(3.76634).epsilon(1e-6));
  CHECK(table.ss_within == Approx(10.49209).epsilon(1e-6));
  CHECK(table.p == Approx(0.01591).epsilon(1e-3));
  CHECK(table.df == 2);
  CHECK(table.df_within == 27);
}

TEST_CASE("ANOVA from summaries equals ANOVA from the samples they summarise", "[anova]") {
  std::vector<GroupSummary> summaries;
  for (const auto& group : plant_growth) {
    const Description d = describe(group);
    summaries.push_back({.mean = d.mean, .std = d.std, .n = d.n});
  }
  CHECK(anova_from_summaries(summaries).statistic == Approx(anova(plant_growth).statistic).epsilon(1e-12));
}

TEST_CASE("the paper's p-values are the upper tails of its printed F", "[anova][paper]") {
  CHECK(f_upper_tail(40.7685, 5, 114) == Approx(7.2225e-24).epsilon(1e-4));   // Table 4
  CHECK(f_upper_tail(388.9396, 5, 114) == Approx(7.1885e-70).epsilon(1e-4));  // Table 5
  CHECK(f_upper_tail(293.9766, 5, 114) == Approx(2.1670e-63).epsilon(1e-4));  // Table 6
}

TEST_CASE("ANOVA by hand: groups 1 2 3 and 2 4 6", "[anova]") {
  // Means 2 and 4, grand mean 3: between 3 + 3 = 6 on 1; within 2 + 8 = 10 on 4; F = 6 / 2.5.
  const AnovaTable table = anova(std::vector<std::vector<double>>{{1, 2, 3}, {2, 4, 6}});
  CHECK(table.ss_between == Approx(6));
  CHECK(table.ss_within == Approx(10));
  CHECK(table.ss_total == Approx(16));
  CHECK(table.df + table.df_within == 5);
  CHECK(table.statistic == Approx(2.4));
}

TEST_CASE("where there is no F the table says why", "[anova]") {
  using Groups = std::vector<std::vector<double>>;
  const double nan = not_defined;
  const auto [groups, reason] = GENERATE_COPY(
      table<Groups, std::string>({{Groups{}, "no group"},
                                  {Groups{{1, 2}}, "one group"},
                                  {Groups{{1}, {2}, {3}}, "single value"},
                                  {Groups{{1, 1}, {2, 2}}, "every group is constant"},
                                  {Groups{{3, 3}, {3, 3}}, "every group is constant"},
                                  {Groups{{1, 2}, {}}, "group 2 has no values"},
                                  {Groups{{1, 2}, {1, nan}}, "group 2 has values that are not finite"},
                                  {Groups{{HUGE_VAL, 2}, {1, 2}}, "group 1 has values that are not finite"},
                                  {Groups{{1e200, -1e200, 1}, {1, 2}}, "too large for double precision"},
                                  {Groups{{1.7e308, -1.7e308}, {1, 2}}, "too large for double precision"},
                                  {Groups{{1e-160, 2e-160}, {3e-160, 5e-160}}, "too small for double precision"},
                                  {Groups{{1e-320, 2e-320}, {3e-320, 5e-320}}, "too small for double precision"}}));
  const AnovaTable table = anova(groups);
  CAPTURE(reason, table.undefined);
  CHECK(ikbench::samples::says(table.undefined, reason));
  CHECK(std::isnan(table.statistic));
  CHECK(std::isnan(table.p));
}

TEST_CASE("a group of one value takes part in the ANOVA and has no spread of its own", "[anova]") {
  // Means 2 and 5 with n 3 and 1, grand mean 2.75: between 3 * 0.5625 + 5.0625 = 6.75 on 1; within 2 on 2.
  const AnovaTable table = anova(std::vector<std::vector<double>>{{1, 2, 3}, {5}});
  CHECK(table.statistic == Approx(6.75));
  const std::vector<GroupSummary> summaries{{.mean = 2, .std = 1, .n = 3}, {.mean = 5, .std = not_defined, .n = 1}};
  CHECK(anova_from_summaries(summaries).statistic == Approx(6.75));
}
