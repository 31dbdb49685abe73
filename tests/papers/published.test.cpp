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

namespace {

constexpr int runs_per_study = 20;

// Returns a random number between 0 and 1, the same on every machine.
double uniform(std::mt19937_64& engine) { return static_cast<double>(engine() >> 11) * 0x1p-53; }

std::vector<double> drawn_runs(std::mt19937_64& engine, double (*drawn_run)(std::mt19937_64&)) {
  std::vector<double> study;
  for (int run = 0; run < runs_per_study; ++run) study.push_back(drawn_run(engine));
  return study;
}

// Returns for each statistic in how many of the studies it lies in the range that another study of the same program
// predicts.
std::array<int, statistics.size()> studies_inside(int studies, double (*drawn_run)(std::mt19937_64&)) {
  std::mt19937_64 engine(1);
  std::array<int, statistics.size()> inside{};
  for (int study = 0; study < studies; ++study) {
    const Ranges ranges = *predicted_ranges(drawn_runs(engine, drawn_run), runs_per_study);
    const judge::Descriptives other = judge::describe_values(drawn_runs(engine, drawn_run));
    for (std::size_t s = 0; s < statistics.size(); ++s) {
      const double number = other.*statistics[s].of;
      inside[s] += ranges[s].low <= number && number <= ranges[s].high;
    }
  }
  return inside;
}

double share_of(const std::array<int, statistics.size()>& inside, int studies) {
  return std::accumulate(inside.begin(), inside.end(), 0.0) / (static_cast<double>(statistics.size()) * studies);
}

// Returns a nearly normal number with mean 0 and standard deviation 1.
double nearly_normal(std::mt19937_64& engine) {
  double sum = 0;
  for (int i = 0; i < 12; ++i) sum += uniform(engine);
  return sum - 6;
}

double normal_run(std::mt19937_64& engine) { return 1 + 0.09 * nearly_normal(engine); }
double lognormal_run(std::mt19937_64& engine) { return std::exp(nearly_normal(engine)); }
double exponential_run(std::mt19937_64& engine) { return 1e-6 - std::log(1 - uniform(engine)); }

// The run of a solver like IK-BA: one in 150 gets stuck, at 10 to 400 times the usual value
// (docs/papers/slim2023-notes.md, 2.4).
double run_that_may_stick(std::mt19937_64& engine) {
  const double usual = normal_run(engine);
  const bool is_stuck = uniform(engine) < 1.0 / 150;
  return is_stuck ? 10 * std::pow(40, uniform(engine)) * usual : usual;
}

}  // namespace

TEST_CASE("the range of another study holds 95 % of what such studies have, and widens with fewer runs", "[papers]") {
  constexpr int studies = 300;
  const double of_normal = share_of(studies_inside(studies, normal_run), studies),
               of_lognormal = share_of(studies_inside(studies, lognormal_run), studies),
               of_exponential = share_of(studies_inside(studies, exponential_run), studies);
  INFO(fmt::format("{} {} {}", of_normal, of_lognormal, of_exponential));
  const double share = (of_normal + of_lognormal + of_exponential) / 3;
  INFO(share);
  CHECK(share > 0.94);
  CHECK(share < 0.97);
  std::mt19937_64 engine(1);
  const std::vector<double> values = drawn_runs(engine, normal_run);
  const Ranges all = *predicted_ranges(values, runs_per_study), of_five = *predicted_ranges(values, 5);
  for (const std::size_t s : {0U, 1U})  // mean and median
    CHECK(of_five[s].high - of_five[s].low > 1.2 * (all[s].high - all[s].low));
  CHECK(all[3].high > std::ranges::max(values));  // the largest may be larger than any that is known
  CHECK_FALSE(predicted_ranges({1, 2, 3, 4}, 20));
  CHECK_FALSE(predicted_ranges({1, 2, 3, 4, 0}, 20));
}

TEST_CASE("the ranges hold fewer studies of a solver of which one run in 150 gets stuck", "[papers]") {
  constexpr int studies = 500;
  const std::array<int, statistics.size()> inside = studies_inside(studies, run_that_may_stick);
  INFO(fmt::format("{} of {}", fmt::join(inside, ", "), studies));
  CHECK(share_of(inside, studies) > 0.87);
  CHECK(share_of(inside, studies) < 0.92);
  // The mean, the standard deviation and the largest are less often inside than the median and the smallest.
  CHECK(std::max({inside[0], inside[2], inside[3]}) < std::min(inside[1], inside[4]));
}

TEST_CASE("a range is wide above a factor of ten", "[papers]") {
  CHECK_FALSE(is_wide({1, 10}));
  CHECK(is_wide({1, 10.1}));
  CHECK(is_wide({0, 1}));
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
