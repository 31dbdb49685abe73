// Describes a sample: mean, median, standard deviation, extremes, as in the paper's Table 3.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace ikbench::statistics {

// Says why a number is not defined; empty if it is. In the reason of a group "{}" stands for the group.
struct Reason : std::string {
  Reason() = default;
  Reason(std::string words) : std::string(std::move(words)) {}
  Reason(const char* words) : std::string(words) {}
  Reason(std::size_t of_group, std::string words) : std::string(std::move(words)), group(of_group) {}

  std::optional<std::size_t> group = std::nullopt;  // in the given order, from 0
};

// The words with the name of the group.
inline std::string named(const Reason& reason, std::string_view group) {
  return reason.group ? fmt::format(fmt::runtime(std::string_view(reason)), group) : std::string(reason);
}

// A quantity that the data do not give. Table cells show it as "not defined", never as a number.
constexpr double not_defined = std::numeric_limits<double>::quiet_NaN();

// 1 above 0, -1 below it, else 0.
constexpr int sign_of(double value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

// A number with its interval. What the data do not give is not defined.
struct Estimate {
  double value = not_defined;
  double low = not_defined;
  double high = not_defined;
};

// The result of a test. Its statistic is F, H, t, ... as the test's header says.
struct Test {
  double statistic = not_defined;
  double df = not_defined;
  double df_within = not_defined;  // second degrees of freedom, if the statistic has two
  double p = not_defined;          // two-sided, or the upper tail
  int direction = 0;               // for two samples: 1 if the first is the larger, -1 if the second is
  Reason undefined = {};           // why there is no p; empty if there is one
};

// Says why so few groups cannot be compared; empty for two or more.
std::string too_few_groups(std::size_t groups);

bool all_finite(std::span<const double> values);

// Values that are not finite (a solver that diverged) are never left out. They have no mean and no standard deviation.
// The median and the extremes are those of the whole sample: infinite values have their ranks, and NaN ranks as worse
// than every number, as infinity.
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

// True for two values or more, all finite and equal.
constexpr bool is_constant(const Description& of) { return of.n > 1 && of.not_finite == 0 && of.min == of.max; }

// A group as papers print it.
struct GroupSummary {
  double mean = not_defined;
  double std = not_defined;  // sample standard deviation; ignored if n is 1
  int n = 0;
};

// NaN if a value is not finite.
GroupSummary summarise(std::span<const double> values);

// Makes two passes, shifted by the first value, so that many equal leading digits cost nothing.
double mean(std::span<const double> values);
// The median of describe().
double median(std::span<const double> values);
// Sum of squared deviations from the mean. It vanishes below 1e-308 and overflows above 1e308; the two below do not.
double sum_of_squares(std::span<const double> values);
// Sample standard deviation, divided by n - 1, and that of the mean, divided by sqrt(n), too; NaN for fewer than two
// values, 0 if it is rounding (rounding.hpp).
double standard_deviation(std::span<const double> values);
double standard_error(std::span<const double> values);

// The power of two at or next below the largest magnitude. Values divided by it keep every digit, and their squares
// neither overflow nor vanish. 1 if all values are 0 or one is infinite.
double power_of_two_below(std::span<const double> values);

}  // namespace ikbench::statistics
