// Random numbers, separate for every row of a table, and the format of its shares.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <string_view>

namespace ikbench::error_rates {

// Gives the same numbers on every machine, except for the last bit of a logarithm.
class Random {
 public:
  // Gives other numbers for every simulation of every row, by the row's words (FNV-1a).
  Random(std::string_view row, int simulation) {
    std::uint64_t hash = 14695981039346656037u;
    for (const char c : row) hash = (hash ^ static_cast<std::uint64_t>(c)) * 1099511628211u;
    engine_.seed(hash + static_cast<std::uint64_t>(simulation));
  }

  double uniform() { return (static_cast<double>(engine_() >> 11) + 0.5) * 0x1p-53; }
  double exponential() { return -std::log(uniform()); }
  double normal() {
    const double radius = std::sqrt(2 * exponential());
    return radius * std::cos(2 * std::numbers::pi * uniform());
  }
  double lognormal(double sigma) { return std::exp(sigma * normal() - sigma * sigma / 2); }  // its mean is 1
  double student_3() {
    const double x = normal(), a = normal(), b = normal(), c = normal();
    return x / std::sqrt((a * a + b * b + c * c) / 3);
  }

 private:
  std::mt19937_64 engine_;
};

// "0.051 +- 0.006": a share of the simulations and its standard error.
inline std::string with_error(double share, int simulations) {
  return fmt::format("{:.3f} ± {:.3f}", share, std::sqrt(share * (1 - share) / simulations));
}

}  // namespace ikbench::error_rates
