// What a sample of numbers looks like: mean, median, standard deviation, extremes, as in the paper's Table 3.
#pragma once

#include <limits>
#include <span>

namespace ikbench::statistics {

// A quantity that cannot be had from the data given. Table cells show it as "not defined", never as a number.
constexpr double not_defined = std::numeric_limits<double>::quiet_NaN();

// 1 above 0, -1 below it, else 0.
constexpr int sign_of(double value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

// Values that are not finite (a solver that diverged) are never left out. They have no mean and no standard deviation.
// The median and the extremes are those of the whole sample: infinite values have their ranks, and what is not a number
// ranks as worse than every number, infinite.
struct Description {
  int n = 0;           // all values
  int not_finite = 0;  // those among them that are NaN or infinite
  double mean = not_defined;
  double median = not_defined;
  double std = not_defined;  // sample standard deviation, divided by n - 1
  double max = not_defined;
  double min = not_defined;
};

Description describe(std::span<const double> values);

// Of two values or more, all finite, each the same.
constexpr bool is_constant(const Description& of) { return of.n > 1 && of.not_finite == 0 && of.min == of.max; }

// What a paper prints of a group.
struct GroupSummary {
  double mean = not_defined;
  double std = not_defined;  // sample standard deviation; of no account where n is 1
  int n = 0;
};

// NaN where a value is not finite.
GroupSummary summarise(std::span<const double> values);

// Two passes, shifted by the first value, so that many equal leading digits cost nothing.
double mean(std::span<const double> values);
// As describe() has it.
double median(std::span<const double> values);
// Sum of squared deviations from the mean. It vanishes below 1e-308 and overflows above 1e308; the two below do not.
double sum_of_squares(std::span<const double> values);
// Sample standard deviation, divided by n - 1, and the same by sqrt(n), that of the mean; NaN of fewer than two values,
// 0 where it is rounding (rounding.hpp).
double standard_deviation(std::span<const double> values);
double standard_error(std::span<const double> values);

// The power of two at or next below the largest magnitude: what is divided by it keeps every digit, and its squares
// neither overflow nor vanish. 1 where all values are 0 or one is infinite.
double power_of_two_below(std::span<const double> values);

}  // namespace ikbench::statistics
