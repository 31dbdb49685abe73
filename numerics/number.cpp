// Numbers as text and back, by std::to_chars and std::from_chars, which know no locale.
#include "numerics/number.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

#include "numerics/names.hpp"

namespace ikbench::numerics {

void append(std::string& text, double value) {
  std::array<char, 32> buffer;  // the longest is -2.2250738585072014e-308: 24
  text.append(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr);
}

std::string text_of(double value) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value > 0 ? "Inf" : "-Inf";
  std::string text;
  append(text, value);
  return text;
}

std::optional<double> number_from(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);  // from_chars takes no plus
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

double in_unit(double value, double unit) {
  const double guess = value / unit;
  for (const double x :
       {std::round(guess * 1e9) / 1e9, guess, std::nextafter(guess, 0), std::nextafter(guess, 2 * guess)}) {
    if (x * unit == value) return x;
  }
  return guess;
}

}  // namespace ikbench::numerics
