// Numbers as text and back, by std::to_chars and std::from_chars, which use no locale.
#include "base/number.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <system_error>

#include "base/names.hpp"

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 200000
#define IKBENCH_READS_BY_STRTOD
#include <locale.h>
#include <stdlib.h>
#ifdef __APPLE__
#include <xlocale.h>
#endif
#endif

namespace ikbench::base {

void append(std::string& text, double value) {
  if (std::isnan(value)) return void(text += "NaN");
  if (!std::isfinite(value)) return void(text += value > 0 ? "Inf" : "-Inf");
  std::array<char, 32> buffer;  // the longest is -2.2250738585072014e-308: 24
  text.append(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr);
}

std::string text_of(double value) {
  std::string text;
  append(text, value);
  return text;
}

std::from_chars_result read_number(const char* begin, const char* end, double& value) {
#ifdef IKBENCH_READS_BY_STRTOD
  static const locale_t none = ::newlocale(LC_ALL_MASK, "C", nullptr);
  const std::string_view all(begin, end);
  std::string text(all.substr(0, all.find_first_not_of("0123456789+-.eEinfatyINFATY")));  // no 0x, no blanks
  char* rest = text.data();
  errno = 0;
  const double read = text.starts_with('+') ? 0 : ::strtod_l(text.c_str(), &rest, none);
  const char* const stop = begin + (rest - text.data());
  if (stop == begin) return {begin, std::errc::invalid_argument};
  if (errno == ERANGE && (read == 0 || std::isinf(read))) return {stop, std::errc::result_out_of_range};
  value = read;
  return {stop, std::errc{}};
#else
  return std::from_chars(begin, end, value);
#endif
}

std::optional<double> number_from(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);  // from_chars accepts no plus
  double value = 0;
  const auto [end, error] = read_number(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

double last_digit(std::string_view number) {
  const std::size_t exponent = std::min(number.find_first_of("eE"), number.size());
  const std::size_t point = std::min(number.find('.'), exponent - 1);
  const double power = exponent < number.size() ? number_from(number.substr(exponent + 1)).value_or(0) : 0;
  const double places = power - static_cast<double>(exponent - 1 - point);
  return number_from("1e" + std::to_string(static_cast<int>(places))).value_or(0);
}

double in_unit(double value, double unit) {
  const double guess = value / unit;
  for (const double x :
       {std::round(guess * 1e9) / 1e9, guess, std::nextafter(guess, 0), std::nextafter(guess, 2 * guess)}) {
    if (x * unit == value) return x;
  }
  return guess;
}

}  // namespace ikbench::base
