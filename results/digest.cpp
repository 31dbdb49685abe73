#include "results/digest.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <type_traits>

#include "results/hashed_column.hpp"

namespace ikbench::results {

namespace {

// Each report checks a million solves, so a word costs one multiplication. Words are numbers, not bytes in memory, so
// every machine sees the same.
class Digest {
 public:
  void add(std::uint64_t word) {
    state_ = (state_ ^ word) * 0x9E3779B97F4A7C15;
    state_ ^= state_ >> 32;
  }

  void add(std::string_view text) {
    add(std::uint64_t{text.size()});
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
      word = word << 8 | static_cast<unsigned char>(text[i]);
      if (i % 8 == 7) add(word);
    }
    add(word);
  }

  void add(double number) {
    if (std::isnan(number)) number = std::numeric_limits<double>::quiet_NaN();
    add(std::bit_cast<std::uint64_t>(number));
  }

  std::int64_t value() const {
    Digest last = *this;
    last.add(std::uint64_t{1});
    last.add(std::uint64_t{2});
    constexpr std::uint64_t largest = std::numeric_limits<std::uint32_t>::max();
    return static_cast<std::int64_t>(1 + last.state_ % largest);
  }

 private:
  std::uint64_t state_ = 1;
};

template <class Value>
bool is_as_unknown(const Value& value, const Value& initial) {
  if constexpr (std::is_floating_point_v<Value>)
    return std::isnan(value);
  else
    return value == initial;
}

}  // namespace

std::int64_t digest_of(const SolveRecord& record) {
  static const SolveRecord none;
  Digest digest;
  std::uint64_t column = 0;
  for_each_column([&](std::string_view name, auto member, std::string_view) {
    ++column;
    if (name == "study" || name == "session" || name == "digest" || is_as_unknown(record.*member, none.*member)) return;
    digest.add(column);
    add_column(digest, record.*member);
  });
  return digest.value();
}

std::int64_t digest_of_place(std::string_view study, std::string_view series, std::int64_t run, std::int64_t point) {
  Digest digest;
  for (const std::string_view text : {study, series}) digest.add(text);
  for (const std::int64_t number : {run, point}) digest.add(static_cast<std::uint64_t>(number));
  return digest.value();
}

std::int64_t digest_of(const StudyEntry& study) {
  Digest digest;
  for (const std::string& text : {study.name, study.definition}) digest.add(std::string_view(text));
  for (const Series& series : study.series) {
    for (const std::string& text : {series.key, series.label, series.algorithm, series.options})
      digest.add(std::string_view(text));
  }
  return digest.value();
}

std::int64_t digest_of(const std::map<std::string, std::string>& facts) {
  std::int64_t sum = 0;
  for (const auto& [key, value] : facts) {
    Digest digest;
    digest.add(std::string_view(key));
    digest.add(std::string_view(value));
    sum += digest.value();
  }
  return sum;
}

std::int64_t digest_of(const Session& session) {
  return digest_of(std::map<std::string, std::string>{{"", session.began}}) + digest_of(session.environment);
}

}  // namespace ikbench::results
