// The solvers' kernels on every instruction set of this machine equal plain loops bit by bit. random.test.cpp has those
// of random streams.
#include "tests/solvers/objectives.hpp"

namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double tiniest = std::numeric_limits<double>::denorm_min();

using Column = std::vector<double>;

// Draws mostly ordinary numbers, sometimes one of the others.
double drawn(Dice& dice) {
  constexpr double others[] = {0.0, -0.0, infinity, -infinity, not_a_number, largest, -largest, tiniest, -tiniest};
  return dice.below(20) == 0 ? others[dice.below(static_cast<int>(std::size(others)))] : dice.between(-7, 7);
}

Column drawn(Dice& dice, std::size_t count) {
  Column numbers(count);
  for (double& number : numbers) number = drawn(dice);
  return numbers;
}

// Compares to the last bit, except NaN: of a sum of two, no compiler promises which it is.
bool same_column(const Column& a, const Column& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
    return std::memcmp(&x, &y, sizeof x) == 0 || (std::isnan(x) && std::isnan(y));
  });
}

// Checks that a kernel only read a column: it is unchanged, and nothing beside it was touched.
bool only_read(Row& row, const Column& numbers) {
  return row.kept_within() && same_bits(row.data(), numbers.data(), numbers.size());
}

// Calls check(kernels, count, page, in place?) for all kinds of rows of candidates.
template <class Check>
void for_each_case(Check check) {
  for (const InstructionSet set : instruction_sets()) {
    for (const std::size_t size : sizes()) {
      for (const Guarded::Page page : {Guarded::Page::after, Guarded::Page::before}) {
        for (const bool in_place : {false, true}) {
          CAPTURE(name_of(set), size, page == Guarded::Page::after, in_place);
          check(solvers::kernels(set), size, page, in_place);
        }
      }
    }
  }
}

}  // namespace

TEST_CASE("every instruction set flies as the plain loop does, also in place, and touches nothing else", "[kernels]") {
  Dice dice;
  for_each_case([&](const solvers::Kernels& kernels, std::size_t size, Guarded::Page page, bool in_place) {
    const double pole = drawn(dice);
    const Column frequency = drawn(dice, size), x = drawn(dice, size), v = drawn(dice, size);
    Column x_next(size), v_next(size);
    for (std::size_t i = 0; i < size; ++i) {
      v_next[i] = v[i] + (x[i] - pole) * frequency[i];
      x_next[i] = x[i] + v_next[i];
    }
    Row frequency_row(frequency, page), x_row(x, page), v_row(v, page);
    Row other_x(Column(size, 1), page), other_v(Column(size, 1), page);
    Row &x_out = in_place ? x_row : other_x, &v_out = in_place ? v_row : other_v;
    kernels.fly({pole, frequency_row.data(), x_row.data(), v_row.data(), x_out.data(), v_out.data(),
                 static_cast<ptrdiff_t>(size)});
    REQUIRE(same_column(x_out.numbers(), x_next));
    REQUIRE(same_column(v_out.numbers(), v_next));
    REQUIRE((x_out.kept_within() && v_out.kept_within()));
    REQUIRE(only_read(frequency_row, frequency));
    if (!in_place) REQUIRE((only_read(x_row, x) && only_read(v_row, v)));
  });
}

TEST_CASE("every instruction set swarms as the plain loop does, also in place, and touches nothing else", "[kernels]") {
  Dice dice;
  for_each_case([&](const solvers::Kernels& kernels, std::size_t size, Guarded::Page page, bool in_place) {
    const double inertia = dice.between(0, 1), cognitive = dice.between(0, 3), social = dice.between(0, 3);
    const double best = drawn(dice);
    const Column x = drawn(dice, size), v = drawn(dice, size), personal = drawn(dice, size);
    const Column u1 = drawn(dice, size), u2 = drawn(dice, size);
    Column x_next(size), v_next(size);
    for (std::size_t i = 0; i < size; ++i) {
      v_next[i] = inertia * v[i] + cognitive * (u1[i] * (personal[i] - x[i])) + social * (u2[i] * (best - x[i]));
      x_next[i] = x[i] + v_next[i];
    }
    Row x_row(x, page), v_row(v, page), personal_row(personal, page), u1_row(u1, page), u2_row(u2, page);
    Row other_x(Column(size, 1), page), other_v(Column(size, 1), page);
    Row &x_out = in_place ? x_row : other_x, &v_out = in_place ? v_row : other_v;
    kernels.swarm({inertia, cognitive, social, best, x_row.data(), v_row.data(), personal_row.data(), u1_row.data(),
                   u2_row.data(), x_out.data(), v_out.data(), static_cast<ptrdiff_t>(size)});
    REQUIRE(same_column(x_out.numbers(), x_next));
    REQUIRE(same_column(v_out.numbers(), v_next));
    REQUIRE((x_out.kept_within() && v_out.kept_within()));
    REQUIRE((only_read(personal_row, personal) && only_read(u1_row, u1) && only_read(u2_row, u2)));
    if (!in_place) REQUIRE((only_read(x_row, x) && only_read(v_row, v)));
  });
}

TEST_CASE("every instruction set scatters as the plain loop does, also in place, and touches nothing else",
          "[kernels]") {
  Dice dice;
  for_each_case([&](const solvers::Kernels& kernels, std::size_t size, Guarded::Page page, bool in_place) {
    const double centre = drawn(dice), step = drawn(dice);
    const Column draws = drawn(dice, size);
    Column q(size);
    for (std::size_t i = 0; i < size; ++i) q[i] = centre + step * draws[i];
    Row draws_row(draws, page), other(Column(size, 1), page);
    Row& out = in_place ? draws_row : other;
    kernels.scatter(centre, step, draws_row.data(), out.data(), static_cast<ptrdiff_t>(size));
    REQUIRE(same_column(out.numbers(), q));
    REQUIRE(out.kept_within());
    if (!in_place) REQUIRE(only_read(draws_row, draws));
  });
}

TEST_CASE("every instruction set clamps as the plain loop does, with every bit, and touches nothing else",
          "[kernels]") {
  struct Limits {
    double lower, upper;
  };
  Dice dice;
  for (const Limits& limits :
       {Limits{-2, 3}, Limits{-2.9670597283903604, 2.9670597283903604}, Limits{1, 1}, Limits{0.0, 0.0},
        Limits{-0.0, 0.0}, Limits{-0.0, -0.0}, Limits{0.0, 5}, Limits{-5, -0.0}, Limits{-infinity, infinity},
        Limits{-infinity, 0}, Limits{0, infinity}, Limits{-largest, largest}}) {
    const double lower = limits.lower, upper = limits.upper;
    // At the limits, next to them, and NaN of any bits.
    const double more[] = {lower,
                           upper,
                           std::nextafter(lower, -infinity),
                           std::nextafter(upper, infinity),
                           std::copysign(not_a_number, -1),
                           std::nan("2023")};
    for_each_case([&](const solvers::Kernels& kernels, std::size_t size, Guarded::Page page, bool) {
      CAPTURE(lower, upper);
      Column q = drawn(dice, size), expected(size);
      for (double& x : q) {
        if (dice.below(4) == 0) x = more[dice.below(static_cast<int>(std::size(more)))];
      }
      for (std::size_t i = 0; i < size; ++i) expected[i] = q[i] < lower ? lower : q[i] > upper ? upper : q[i];
      Row row(q, page);
      kernels.clamp(lower, upper, row.data(), static_cast<ptrdiff_t>(size));
      REQUIRE(same_bits(row.data(), expected.data(), size));  // NaN keeps its bits
      REQUIRE(row.kept_within());
    });
  }
}

TEST_CASE("every instruction set chooses as the plain loop does, and touches nothing else", "[kernels]") {
  Dice dice;
  for_each_case([&](const solvers::Kernels& kernels, std::size_t size, Guarded::Page page, bool in_place) {
    const Column less = drawn(dice, size), yes = drawn(dice, size), no = drawn(dice, size);
    Column than = drawn(dice, size), expected(size);
    if (size > 0) than[size / 2] = less[size / 2];
    for (std::size_t i = 0; i < size; ++i) expected[i] = less[i] < than[i] ? yes[i] : no[i];
    Row less_row(less, page), than_row(than, page), yes_row(yes, page), no_row(no, page), other(Column(size, 1), page);
    Row& out = in_place ? no_row : other;
    kernels.choose(
        {less_row.data(), than_row.data(), yes_row.data(), no_row.data(), out.data(), static_cast<ptrdiff_t>(size)});
    REQUIRE(same_bits(out.data(), expected.data(), size));
    REQUIRE(out.kept_within());
    REQUIRE((only_read(less_row, less) && only_read(than_row, than) && only_read(yes_row, yes)));
  });
}

TEST_CASE("every instruction set turns back and adds squares as the plain loop does", "[kernels]") {
  Dice dice;
  for_each_case([&](const solvers::Kernels& kernels, std::size_t size, Guarded::Page page, bool) {
    const double lower = dice.between(-5, 0), upper = lower + dice.between(0, 5), most = dice.between(0, 5);
    const Column sums = drawn(dice, size);
    Column q = drawn(dice, size), v = drawn(dice, size), sums_after = sums;
    Row q_row(q, page), v_row(v, page), sums_row(sums, page);
    kernels.add_squares(lower, q_row.data(), sums_row.data(), static_cast<ptrdiff_t>(size));
    kernels.turn_back({lower, upper, most, q_row.data(), v_row.data(), static_cast<ptrdiff_t>(size)});
    for (std::size_t i = 0; i < size; ++i) {
      sums_after[i] += (q[i] - lower) * (q[i] - lower);
      v[i] = std::clamp(v[i], -most, most);
      if (q[i] < lower || q[i] > upper) v[i] = -v[i];
      q[i] = std::clamp(q[i], lower, upper);
    }
    REQUIRE((same_column(q_row.numbers(), q) && same_column(v_row.numbers(), v)));
    REQUIRE(same_column(sums_row.numbers(), sums_after));
    REQUIRE((q_row.kept_within() && v_row.kept_within() && sums_row.kept_within()));
  });
}

TEST_CASE("every instruction set chooses three different others, in order from those that are left", "[kernels]") {
  Dice dice;
  for_each_case([&](const solvers::Kernels& kernels, std::size_t size, Guarded::Page page, bool) {
    if (size < 4) return;
    Column rows(3 * size);
    for (double& chance : rows) chance = dice.below(20) == 0 ? 1 - 0x1p-52 : dice.between(0, 1);
    Row row(rows, page);
    kernels.choose_partners(row.data(), static_cast<ptrdiff_t>(size));
    for (std::size_t i = 0; i < size; ++i) {
      Column left(size);
      std::iota(left.begin(), left.end(), 0);
      left.erase(left.begin() + static_cast<ptrdiff_t>(i));
      for (std::size_t at = i; at < 3 * size; at += size) {
        const auto chosen = left.begin() + static_cast<ptrdiff_t>(rows[at] * static_cast<double>(left.size()));
        rows[at] = *chosen;
        left.erase(chosen);
      }
    }
    REQUIRE(row.numbers() == rows);
    REQUIRE(row.kept_within());
  });
}
