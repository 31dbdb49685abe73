#include "results/fingerprint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <tuple>
#include <type_traits>

#include "base/sha256.hpp"

namespace ikbench::results {

namespace {

struct Reference {
  std::string_view study;
  std::string_view fingerprint;
};

constexpr Reference references[] = {
#include "results/reference.inc"
};

// Two hashes of 64 bits, which mix the same words differently. Words are numbers, not bytes in memory, so every machine
// computes the same.
class Hash {
 public:
  void add(std::uint64_t word) {
    first_ = mixed(first_ ^ word);
    second_ = mixed(second_ + std::rotl(word, 32) * 0xD6E8FEB86659FD93);
  }

  void add(std::string_view text) {
    add(std::uint64_t{text.size()});
    for (const char character : text) add(std::uint64_t{static_cast<unsigned char>(character)});
  }

  void add(double number) {
    if (std::isnan(number)) number = std::numeric_limits<double>::quiet_NaN();
    add(std::bit_cast<std::uint64_t>(number));
  }

  std::string text() const { return fmt::format("{:016x}{:016x}", first_, second_); }

 private:
  // Returns a well mixed word: the function is splitmix64 (Steele, Lea and Flood 2014).
  static std::uint64_t mixed(std::uint64_t word) {
    word += 0x9E3779B97F4A7C15;
    word = (word ^ (word >> 30)) * 0xBF58476D1CE4E5B9;
    word = (word ^ (word >> 27)) * 0x94D049BB133111EB;
    return word ^ (word >> 31);
  }

  std::uint64_t first_ = 1, second_ = 2;
};

// Adds a value. Outside of lists -0.0 counts as 0.0, because a store cannot tell the two apart.
template <class Value>
void add_column(Hash& hash, const Value& value) {
  if constexpr (std::is_enum_v<Value>) {
    hash.add(name_of(value));
  } else if constexpr (std::is_integral_v<Value>) {
    hash.add(static_cast<std::uint64_t>(value));
  } else if constexpr (std::is_floating_point_v<Value>) {
    hash.add(value == 0 ? 0.0 : value);
  } else if constexpr (std::is_same_v<Value, std::vector<double>>) {
    hash.add(std::uint64_t{value.size()});
    for (const double number : value) hash.add(number);
  } else {
    hash.add(std::string_view(value));
  }
}

void add_record(Hash& hash, SolveRecord& record) {
  record.series = configuration_part(record.series);
  for_each_column_of_fingerprint([&](std::string_view, auto member) { add_column(hash, record.*member); });
}

}  // namespace

std::string fingerprint(std::vector<SolveRecord> records) {
  const auto place = [](const SolveRecord& record) {
    return std::tie(record.label, record.series, record.run, record.point);
  };
  std::sort(records.begin(), records.end(), [&](const auto& a, const auto& b) { return place(a) < place(b); });
  Hash hash;
  for (SolveRecord& record : records) add_record(hash, record);
  return hash.text();
}

Fingerprint fingerprint(const Store& store, StoredStudy study) {
  std::ranges::sort(study.series, {}, [](const Series& series) { return std::tie(series.label, series.key); });
  Hash hash;
  std::int64_t solves = 0;
  store.for_each_in_study(study, [&](SolveRecord& record) {
    add_record(hash, record);
    ++solves;
  });
  return {hash.text(), solves};
}

std::string fingerprint_line(const Store& store, const StoredStudy& study) {
  const Fingerprint found = fingerprint(store, study);
  const auto runs = study.definition.runs, points = study.definition.points;
  const auto solvers = std::ssize(study.series);
  return fmt::format("{}: {} of {} solves (runs x targets x solvers: {} x {} x {}), fingerprint {}", study.name,
                     found.solves, solvers * runs * points, runs, points, solvers, found.text);
}

std::string seal_of(const Store& store) {
  base::Sha256 digest;
  store.each_value(seal_fact, [&](std::string_view bytes) { digest.add(bytes); });
  return digest.text();
}

std::string_view reference_fingerprint(std::string_view study) {
  const auto* const found = std::ranges::find(references, study, &Reference::study);
  return found == std::end(references) ? std::string_view() : found->fingerprint;
}

}  // namespace ikbench::results
