// Random changes of a text: mostly other numbers and blanks, with which it is what it was to a parser; and those of
// somebody who edits it in haste, and worse ones.
#pragma once

#include <cctype>
#include <charconv>

#include "tests/common.hpp"

namespace ikbench {

class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  std::string mutated(std::string text) {
    const bool is_rough = below(4) == 0;
    for (std::size_t changes = 1 + below(is_rough ? 4 : 2); changes > 0; --changes)
      is_rough ? change(text) : touch(text);
    return text;
  }

 private:
  // A number that stands alone becomes another, mostly a near one; or a blank or a line's end is doubled.
  void touch(std::string& text) {
    std::size_t place = 0, length = 0, seen = 1;
    double value = 0;
    for (std::size_t i = 1; i < text.size(); ++i) {
      if (!std::isdigit(static_cast<unsigned char>(text[i])) || !contains(" \t\n=,;[('\"-", {text[i - 1]})) continue;
      double number = 0;
      const char* const end = std::from_chars(text.data() + i, text.data() + text.size(), number).ptr;
      const auto size = static_cast<std::size_t>(end - text.data()) - i;
      const bool stands_alone = end == text.data() + text.size() || contains(" \t\r\n,;])}'\"", {*end});
      if (stands_alone && below(++seen) == 0) place = i, length = size, value = number;
      i += size;
    }
    if (length > 0) {
      const bool is_whole = text.find_first_not_of("0123456789", place) >= place + length;
      const double near = is_whole ? value + double(below(2)) : value * double(1 + below(4)) / 3;
      static const std::array<double, 6> odd{0, 1, 1e9, 1e300, 5e-324, 1e-9};
      text.replace(place, length, fmt::format("{}", below(10) == 0 ? odd[below(odd.size())] : near));
    } else if (const std::size_t blank = text.find_first_of(" \n", below(text.size())); blank != std::string::npos) {
      text.insert(blank, 1, text[blank]);
    }
  }

  std::size_t below(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_); }

  void change(std::string& text) {
    static const std::vector<std::string> pieces = [] {
      std::istringstream words(
          "[ ] { } [[ ]] \" ' \"\"\" = , . # - + nan inf 1e9 true solvers path limits_m slides 0x _ \\ 1979-05-27 \xff "
          "99999999999999999999 {a={b=1}} [[[[1]]]] é 1e308 -Inf NA 5e-324 0.30000000000000004 1e999");
      std::vector<std::string> all{std::istream_iterator<std::string>(words), {}};
      all.insert(all.end(), {"\n", "\r"});
      return all;
    }();
    const std::size_t place = below(text.size() + 1), length = std::min(text.size() - place, below(12));
    switch (below(5)) {
      case 0:
        text.erase(place, length);
        break;
      case 1:
        text.insert(place, pieces[below(pieces.size())]);
        break;
      case 2:  // a piece of the file somewhere else
        text.insert(below(text.size() + 1), text.substr(place, below(80)));
        break;
      case 3:
        if (place < text.size()) text[place] = static_cast<char>(below(256));
        break;
      default:
        text.replace(place, length, pieces[below(pieces.size())]);
    }
  }

  std::mt19937 random_;
};

// Reads texts with random changes: each is read, or refused in one sentence that begins with the place. At least half,
// or `least`, are read: else the changes would test the parser alone.
template <class Read>
void read_mutated(Mutator mutator, const std::string& whole, int times, const std::string& place, Read read,
                  double least = 0.5) {
  int count = 0;
  for (int i = 0; i < times; ++i) {
    const std::string text = mutator.mutated(whole);
    CAPTURE(text);
    try {
      read(text);
      ++count;
    } catch (const std::invalid_argument& refused) {
      const std::string said = refused.what();
      CAPTURE(said);
      REQUIRE(said.starts_with(place));
      REQUIRE_FALSE(contains(said, "\n"));
    }
  }
  INFO(count << " of " << times << " were read");
  CHECK(count >= least * times);
  CHECK(count < times);
}

}  // namespace ikbench
