#include "analysis/statistics/bayesian_signed_rank.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

#include "tests/analysis/statistics/samples.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;
using namespace ikbench::samples;

namespace {

using Values = std::vector<double>;

constexpr double four_errors = 4 * 0.005;  // of 10000 draws, at the worst probability

SignedRankPosterior posterior(const Values& values, double rope) {
  return bayesian_signed_rank(std::vector<Differences>{{.values = values, .rope = rope}}).front();
}

// Demsar, J. Machine Learning Research 7 (2006) 1, Table 6: AUC of C4.5, C4.5+m, C4.5+cf and C4.5+m+cf.
const std::vector<Values> demsar_errors{
    {.763, .599, .954, .628, .882, .936, .661, .583, .775, 1, .940, .619, .972, .957},
    {.768, .591, .971, .661, .888, .931, .668, .583, .838, 1, .962, .666, .981, .978},
    {.771, .590, .968, .654, .886, .916, .609, .563, .866, 1, .965, .614, .975, .946},
    {.798, .569, .967, .657, .898, .931, .685, .625, .875, 1, .962, .669, .975, .970}};

Values gained(std::size_t from, std::size_t to) {
  Values differences;
  for (std::size_t i = 0; i < demsar_errors[from].size(); ++i)
    differences.push_back(demsar_errors[to][i] - demsar_errors[from][i]);
  return differences;
}

}  // namespace

TEST_CASE("a single difference has the posterior of the beta distribution", "[bayesian_signed_rank]") {
  // Between the region and twice the region, so only its pair with itself is above: w^2 > 1 - w^2 with w from
  // Beta(1, 1/2), whose P(w > x) is (1 - x)^(1/2).
  const SignedRankPosterior found = posterior({3}, 2);
  CHECK(found.above == Approx(std::sqrt(1 - std::sqrt(0.5))).margin(four_errors));
  CHECK(found.below == 0);
  CHECK(found.within + found.above == Approx(1));
}

TEST_CASE("Demsar's classifiers have the posterior of a million draws of NumPy", "[bayesian_signed_rank]") {
  // An independent script: NumPy 1.24's Dirichlet, every pair of differences, region of 0.01.
  struct Expected {
    std::size_t from, to;
    double below, within, above;
  };
  for (const Expected& expected :
       {Expected{0, 1, 0, 0.329415, 0.670585}, Expected{0, 3, 0.000406, 0.032092, 0.967502},
        Expected{0, 2, 0.117550, 0.693544, 0.188906}, Expected{1, 3, 0.002610, 0.726768, 0.270622}}) {
    const SignedRankPosterior found = posterior(gained(expected.from, expected.to), 0.01);
    CAPTURE(expected.from, expected.to);
    CHECK(found.below == Approx(expected.below).margin(four_errors));
    CHECK(found.within == Approx(expected.within).margin(four_errors));
    CHECK(found.above == Approx(expected.above).margin(four_errors));
  }
  CHECK(posterior(gained(0, 3), 0).below == Approx(0.002845).margin(0.0022));  // four binomial errors of that share
}

TEST_CASE("neither the order of the blocks nor the other comparisons change a posterior", "[bayesian_signed_rank]") {
  const Values differences = gained(0, 2), reversed(differences.rbegin(), differences.rend());
  const auto all = bayesian_signed_rank(std::vector<Differences>{
      {.values = gained(0, 1), .rope = 0.3}, {.values = reversed, .rope = 0.01}, {.values = Values(14, NAN)}});
  const SignedRankPosterior alone = posterior(differences, 0.01);
  CHECK(all[1].below == alone.below);
  CHECK(all[1].within == alone.within);
  CHECK(all[0].within == 1);
}

TEST_CASE("many equal differences are above, below or within the region for certain", "[bayesian_signed_rank]") {
  CHECK(posterior(Values(40, 1.0), 0.5).above > 0.999);
  CHECK(posterior(Values(40, -1.0), 0.5).below > 0.999);
  CHECK(posterior(Values(40, 0.4), 0.5).within == 1);
  CHECK(posterior(Values(40, 0.0), 0).within == 1);
}

TEST_CASE("where there is no posterior it says why", "[bayesian_signed_rank]") {
  CHECK(says(posterior({}, 1).undefined, "no differences"));
  CHECK(says(posterior({1, HUGE_VAL}, 1).undefined, "not finite"));
  CHECK(says(posterior({1, 2}, NAN).undefined, "not finite"));
  CHECK(says(posterior(Values(501, 1.0), 1).undefined, "more than 500"));
  CHECK(std::isnan(posterior({1, NAN}, 1).above));
  CHECK(bayesian_signed_rank({}).empty());
  CHECK_THROWS_AS(bayesian_signed_rank(std::vector<Differences>{{.values = {1}}, {.values = {1, 2}}}),
                  std::invalid_argument);
}
