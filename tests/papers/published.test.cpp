#include "results/published.hpp"

#include "analysis/judge/statistics/omnibus.hpp"
#include "tests/mistakes.hpp"
#include "tests/papers/studies.hpp"

TEST_CASE("a printed number stands for all that round to its digits, and ours beside it", "[papers]") {
  CHECK(base::last_digit("1.7824e-4") == Approx(1e-8));
  CHECK(base::last_digit("12") == 1);
  CHECK(agrees(34.84, "34.8"));
  CHECK(agrees(2.5, "2"));
  CHECK_FALSE(agrees(34.86, "34.8"));
  CHECK(can_be({0.1, 0.19996}, "0.2"));
  CHECK_FALSE(can_be({0.1, 0.14}, "0.2"));
  CHECK(std::get<show::PublishedNumber>(beside(0.1, "0.2")).printed == "0.2");
  CHECK(std::get<double>(beside(0.1, "")) == 0.1);  // alone
}

TEST_CASE("printed rows have their digits, and the names that a table gives by its columns", "[papers]") {
  const PrintedRows errors = printed_means("slim2023", "table-3", "position_error_cm");
  REQUIRE(errors.size() == 6);
  CHECK(errors[0].solver == "IK-BA");
  CHECK(errors[0].numbers.n == 20);
  CHECK(errors[0].numbers.sd == 1.7824e-4);
  CHECK(errors[0].digits[2] == "1.7824e-4");
  const PrintedRows times = printed_means("slim2023", "table-7", "milliseconds");
  REQUIRE(row_of(times, "30 bats") != nullptr);
  CHECK(row_of(times, "30 bats")->numbers.largest == 448.44);
  CHECK(row_of(times, "13 bats") == nullptr);
}

TEST_CASE("printed means are compared as summaries, and give the printed ANOVA but for rounding", "[papers]") {
  // F of Tables 4 to 6: the means and standard deviations of Table 3 as printed, by R 4.2.2.
  for (const auto& [name, metric, f] : {std::tuple("table-4", "position_error_cm", 40.7736),
                                        {"table-5", "variation_deg", 388.940},
                                        {"table-6", "seconds", 293.939}}) {
    judge::MetricSamples printed{.metric = metric};
    for (const auto& [solver, numbers, digits] : printed_means("slim2023", "table-3", metric))
      printed.groups.push_back(
          {.name = solver, .sample = judge::SummaryStatistics{numbers.n, numbers.mean, numbers.sd}});
    const judge::OmnibusTest test = judge::anova(printed).front();
    CHECK(test.statistic == Approx(f).epsilon(2e-6));
    const base::CsvTable table = results::published::table("slim2023", name);
    CHECK(test.ss_between == Approx(table.number(0, "ss")).epsilon(1e-3));
    CHECK(test.ss_within == Approx(table.number(1, "ss")).epsilon(1e-3));
    CHECK(test.df == table.number(0, "df"));
    CHECK(test.df_within == table.number(1, "df"));
  }
}

TEST_CASE("the range of another study holds 92 % of what such studies have, and widens with fewer runs", "[papers]") {
  constexpr int runs = 20, studies = 100;
  std::mt19937_64 engine(1);
  const auto drawn = [&] {  // log-uniform, as sums of such
    std::vector<double> group;
    for (int run = 0; run < runs; ++run) {
      double log = 0;
      for (int i = 0; i < 4; ++i) log += static_cast<double>(engine() >> 11) * 0x1p-53;
      group.push_back(std::exp(log));
    }
    return group;
  };
  int inside = 0;
  for (int study = 0; study < studies; ++study) {
    const Ranges ranges = *predicted_ranges(drawn(), runs);
    const judge::Descriptives other = judge::describe_values(drawn());
    for (std::size_t s = 0; s < statistics.size(); ++s) {
      const double number = other.*statistics[s].of;
      inside += ranges[s].low <= number && number <= ranges[s].high;
    }
  }
  INFO(inside << " of 500");
  CHECK(inside > 0.90 * 5 * studies);
  CHECK(inside < 0.95 * 5 * studies);
  const std::vector<double> values = drawn();
  const Ranges all = *predicted_ranges(values, runs), of_five = *predicted_ranges(values, 5);
  CHECK(of_five[0].high - of_five[0].low > 1.4 * (all[0].high - all[0].low));
  CHECK(all[3].high > std::ranges::max(values));  // the largest may be larger than any that is known
  CHECK_FALSE(predicted_ranges({1, 2, 3, 4}, 20));
  CHECK_FALSE(predicted_ranges({1, 2, 3, 4, 0}, 20));
}

TEST_CASE("papers are read from their files, and a mistake says where it is", "[papers]") {
  CHECK(papers::papers().front().name == "slim2023");
  CHECK(paper_named("slim2023").claims.size() == 21);
  CHECK(paper_named("beeson2015").means.empty());
  CHECK_FALSE(paper_named("haviland2023").rates.is_of_arms());
  CHECK(contains(complaint<std::invalid_argument>([&] { paper_named("slim2032"); }), "slim2023"));
  const auto read = [](const std::string& claim) { return read_paper("x", "[[claims]]\n" + claim, "x.toml"); };
  const std::string whole = "id = 'a'\nsentence = 'b'\ndecides = 'c'\n";
  CHECK(read(whole).claims.front().id == "a");
  check_mistakes("paper", "x.toml:", read, whole);
}
