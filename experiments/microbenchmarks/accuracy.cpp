// Measures the errors of forward kinematics and of sin_cos against long double.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "experiments/microbenchmarks/harness.hpp"
#include "numerics/functions.hpp"
#include "numerics/units.hpp"

namespace ikbench::microbenchmarks {

using namespace numerics;
using namespace robots;

namespace {

constexpr int candidates = 100'000;

using Exact = std::array<long double, 3>;

// Carries the tool point from the tip to the base; takes the twists as exact quarter turns.
Exact exact_position(const Chain& chain, const ConfigurationRef& q) {
  Exact p{chain.tool().position.x(), chain.tool().position.y(), chain.tool().position.z()};
  for (int j = chain.joints() - 1; j >= 0; --j) {
    const DhLink& link = chain.links()[static_cast<std::size_t>(j)];
    const auto exact = [](long double value) { return std::abs(value) < 1e-15L ? 0 : value; };
    const long double ca = exact(std::cos(static_cast<long double>(link.alpha))),
                      sa = exact(std::sin(static_cast<long double>(link.alpha)));
    const long double angle = static_cast<long double>(q[j]) + static_cast<long double>(link.offset);
    const long double c = std::cos(angle), s = std::sin(angle);
    const long double x = p[0] + link.a, y = ca * p[1] - sa * p[2], z = sa * p[1] + ca * p[2] + link.d;
    p = {c * x - s * y, s * x + c * y, z};
  }
  return p;
}

void kinematics(benchmark::State& state) {
  const Reach reach = flange_reach();
  const Candidates q = drawn_candidates(reach.problem, candidates);
  Eigen::VectorXd errors(candidates);
  long double worst = 0, worst_error = 0;
  for (auto _ : state) {
    reach.chain.position_errors(q, reach.target, errors);
    for (Eigen::Index i = 0; i < q.cols(); ++i) {
      const Exact exact = exact_position(reach.chain, q.col(i));
      const Eigen::Vector3d position = reach.chain.position(q.col(i));
      long double off = 0, distance = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        off += (exact[k] - position[axis]) * (exact[k] - position[axis]);
        distance += (exact[k] - reach.target[axis]) * (exact[k] - reach.target[axis]);
      }
      worst = std::max(worst, std::sqrt(off));
      worst_error = std::max(worst_error, std::abs(std::sqrt(distance) - errors[i]));
    }
  }
  state.counters["position_cm"] = static_cast<double>(worst / centimetre);
  state.counters["position_error_cm"] = static_cast<double>(worst_error / centimetre);
}

long double off_in_ulp(double value, long double exact) {
  const double magnitude = std::max(std::abs(value), std::numeric_limits<double>::min());
  const double next = std::nextafter(magnitude, std::numeric_limits<double>::infinity());
  return std::abs(exact - value) / (next - magnitude);
}

// Draws angles of joints, and those of bats far outside the limits.
void sines(benchmark::State& state) {
  Random random{Key(1)};
  long double worst = 0;
  for (auto _ : state) {
    for (const double range : {4.0, 1000.0}) {
      for (int i = 0; i < 1'000'000; ++i) {
        const double angle = random.uniform(-range, range);
        const auto [sine, cosine] = sin_cos(angle);
        worst = std::max(worst, off_in_ulp(sine, std::sin(static_cast<long double>(angle))));
        worst = std::max(worst, off_in_ulp(cosine, std::cos(static_cast<long double>(angle))));
      }
    }
  }
  state.counters["ulp"] = static_cast<double>(worst);
}

BENCHMARK(kinematics)->Name("accuracy/forward_kinematics")->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(sines)->Name("accuracy/sin_cos")->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace ikbench::microbenchmarks

int main(int argc, char** argv) { return ikbench::microbenchmarks::run(argc, argv); }
