#include "numerics/polynomial.hpp"

#include <algorithm>
#include <random>
#include <vector>

#include "tests/catch.hpp"

using namespace ikbench::numerics;

namespace {

// `product` times (x - r) for each root r.
Polynomial with_roots(const std::vector<double>& roots, Polynomial product) {
  for (const double root : roots) {
    const Eigen::Index size = product.size();
    Polynomial next = Polynomial::Zero(size + 1);
    next.tail(size) = product;
    next.head(size) -= root * product;
    product = next;
  }
  return product;
}

const Polynomial one = Polynomial::Ones(1);

}  // namespace

TEST_CASE("the roots of a product of factors x - r are its r", "[polynomial]") {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> anywhere(-3, 3);
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<double> wanted(static_cast<std::size_t>(1 + trial % 4));
    for (double& root : wanted) root = anywhere(engine);
    std::ranges::sort(wanted);
    double gap = 1;
    for (std::size_t i = 1; i < wanted.size(); ++i) gap = std::min(gap, wanted[i] - wanted[i - 1]);
    if (gap < 1e-2) continue;
    const Roots roots = real_roots(with_roots(wanted, Polynomial::Constant(1, anywhere(engine))));
    REQUIRE(roots.size() == static_cast<Eigen::Index>(wanted.size()));
    for (Eigen::Index i = 0; i < roots.size(); ++i) {
      REQUIRE(roots[i] == Approx(wanted[static_cast<std::size_t>(i)]).margin(1e-9));
    }
  }
}

TEST_CASE("complex roots are left out", "[polynomial]") {
  const Polynomial none = (Polynomial(3) << 2, 2, 1).finished();  // (x + 1)^2 + 1
  CHECK(real_roots(none).size() == 0);
  const Roots roots = real_roots(with_roots({-0.5, 2}, none));
  REQUIRE(roots.size() == 2);
  CHECK(roots[0] == Approx(-0.5));
  CHECK(roots[1] == Approx(2));
}

TEST_CASE("a multiple root is found once, as exactly as rounding lets it", "[polynomial]") {
  for (const std::vector<double>& wanted :
       {std::vector<double>{1, 1}, {-2, 1, 1}, {1, 1, 1}, {-2, -2, 1, 1}, {0, 0, 0, 0}}) {
    const Roots roots = real_roots(with_roots(wanted, one));
    for (const double root : wanted) {
      CHECK(std::ranges::count_if(roots, [&](double found) { return std::abs(found - root) < 2e-5; }) == 1);
    }
  }
}

TEST_CASE("numbers that are not finite give no root and no end of search", "[polynomial]") {
  Polynomial bad = Polynomial::Constant(5, std::numeric_limits<double>::quiet_NaN());
  CHECK(real_roots(bad).size() <= 4);
  bad.setConstant(std::numeric_limits<double>::infinity());
  CHECK(real_roots(bad).size() <= 4);
}
