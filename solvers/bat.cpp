// BA, the bat algorithm: Yang 2010, with the parameters of Slim et al. 2023, Algorithm 1 and Table 1.
// docs/papers/slim2023-notes.md 2.6 argues for this reading.
#include <bit>

#include "numerics/functions.hpp"
#include "solvers/bounds.hpp"
#include "solvers/kernels.hpp"
#include "solvers/registry.hpp"

namespace ikbench::solvers {

using namespace numerics;

namespace {

// Sums non-negative numbers from the first to the last, always to the same bits, without adding all of them again when
// some change. A sum in [2^k, 2^(k + 1)) is a multiple of its last bit. While it stays there, a further number rounds
// to the same amount whatever the sum is, except for ties, which depend on that bit. So a block of numbers adds one
// amount to every even sum, and one to every odd sum.
class OrderedSum {
 public:
  // Starts a sum of `count` unknown numbers.
  void begin(Eigen::Index count) {
    blocks_.assign(static_cast<std::size_t>((count + size - 1) / size), Block());
    first_ = 0;
  }

  void changed(Eigen::Index i) {
    const auto b = static_cast<std::size_t>(i / size);
    blocks_[b].power = 0;
    first_ = std::min(first_, b);
  }

  double of(const Eigen::RowVectorXd& numbers) {
    double sum = blocks_[first_].before;
    for (std::size_t b = first_; b < blocks_.size(); ++b) {
      const auto begin = static_cast<Eigen::Index>(b) * size;
      const Part part = numbers.segment(begin, std::min(size, numbers.size() - begin));
      blocks_[b].before = sum;
      sum = b == first_ ? added(sum, part) : after(blocks_[b], part);  // a block that changed may change again soon
    }
    first_ = blocks_.size() - 1;
    return sum;
  }

 private:
  using Part = Eigen::Ref<const Eigen::RowVectorXd>;
  static constexpr Eigen::Index size = 256;
  struct Block {
    double before = 0;               // sum of all numbers before it
    double power = 0;                // 2^k of the sums for which to_even and to_odd hold; 0: none
    double to_even = 0, to_odd = 0;  // the block's amount
  };

  static double added(double sum, const Part& part) {
    for (const double number : part) sum += number;
    return sum;
  }

  static double after(Block& block, const Part& part) {
    const auto bits = std::bit_cast<std::uint64_t>(block.before);
    constexpr std::uint64_t exponent = 0x7FF0000000000000;
    const auto power = std::bit_cast<double>(bits & exponent);
    if (power == 0) return added(block.before, part);
    if (block.power != power) {
      const auto odd = std::bit_cast<double>((bits & exponent) + 1);
      block.power = power;
      block.to_even = added(power, part) - power;
      block.to_odd = added(odd, part) - odd;
    }
    const double sum = block.before + (bits % 2 == 0 ? block.to_even : block.to_odd);
    return sum < 2 * power ? sum : added(block.before, part);
  }

  std::vector<Block> blocks_;
  std::size_t first_ = 0;  // the first block that may have changed; the last if none has
};

class Bat final : public Searcher {
 public:
  enum class BestOf { accepted, evaluated };
  enum class Acceptance { own, best };
  enum class Loudness { mean, own };
  enum class Flight { candidate, moves };

  struct Options {
    double f_min = 0;
    double f_max = 2;
    double alpha = 0.5;
    double gamma = 0.5;
    double pulse_rate = 0.001;
    double step_factor = 0.1;
    BestOf best_of = BestOf::accepted;
    Acceptance acceptance = Acceptance::own;
    Loudness loudness = Loudness::mean;
    Flight flight = Flight::candidate;
    Bounds bounds = Bounds::clamp;

    void list(OptionList& list) {
      list.number("f_min", f_min, {0, 10}, "smallest frequency, Eq. 5");
      list.number("f_max", f_max, {0, 10}, "largest frequency, Eq. 5");
      list.number("alpha", alpha, {0, 1}, "a bat's loudness is multiplied by this when it accepts, Eq. 9");
      list.number("gamma", gamma, {0, 10}, "growth rate of a bat's pulse rate, Eq. 10");
      list.number("pulse_rate", pulse_rate, {0, 1}, "pulse rate r0, Eq. 10");
      list.number("step_factor", step_factor, {0, 10},
                  "factor of eps A in Eq. 8; 0.1 in Yang's code, not given in the paper");
      list.choice("best_of", best_of, {{"accepted", BestOf::accepted}, {"evaluated", BestOf::evaluated}},
                  "the best may be an accepted candidate only, or any evaluated one");
      list_bounds(list, bounds);
      list.later();
      list.choice("acceptance", acceptance, {{"own", Acceptance::own}, {"best", Acceptance::best}},
                  "if rand < A_i, a bat accepts what is not worse than itself (Yang's code), or what is better than "
                  "X_best (Algorithm 1: \"f(X_new) < f(X_best)\")");
      list.choice("loudness", loudness, {{"mean", Loudness::mean}, {"own", Loudness::own}},
                  "A in Eq. 8 is the mean of all bats (Yang 2010), or the bat's own");
      list.choice("flight", flight, {{"candidate", Flight::candidate}, {"moves", Flight::moves}},
                  "Eq. 7 makes a candidate (Yang's code), or moves the bat whatever comes of it (Algorithm 1)");
    }
  };

  explicit Bat(Options options) : options_(options) {}

  void start(const Problem& problem, Objective& objective, Random& random) override {
    take(problem);
    const int bats = problem.population;
    for (Candidates* each : {&x_, &v_, &x_next_, &v_next_, &candidates_, &epsilon_}) {
      each->resize(problem.joints(), bats);
    }
    for (Eigen::RowVectorXd* each : {&loudness_, &pulse_rate_, &frequency_, &local_, &chance_}) each->resize(bats);
    for (Eigen::VectorXd* each : {&errors_, &found_}) each->resize(bats);
    loudness_sum_.begin(bats);
    iteration_ = 0;

    draw_within_limits(problem, random, x_);
    random.uniforms(loudness_);  // Table 1: A_i random in [0, 1]
    pulse_rate_.setConstant(options_.pulse_rate);
    v_.setZero();
    evaluate_all(objective, x_, errors_);
  }

  void step(Objective& objective, Random& random) override {
    random.uniforms(frequency_);
    random.uniforms(local_);
    random.normals(epsilon_);
    random.uniforms(chance_);
    frequency_ = options_.f_min + (options_.f_max - options_.f_min) * frequency_.array();  // Eq. 5
    ++iteration_;
    if (options_.loudness == Loudness::own)
      epsilon_.array().rowwise() *= loudness_.array();  // only its own bat's falls
    objective.one_by_one(
        candidates_, found_, [&](Eigen::Index first, Eigen::Index count) { fly(first, count); },
        [&](Eigen::Index i) {
          const bool is_good =
              options_.acceptance == Acceptance::own ? found_[i] <= errors_[i] : found_[i] < best_.error;
          const bool accepted = is_good && chance_[i] < loudness_[i];
          if (options_.flight == Flight::moves) x_.col(i) = x_next_.col(i);
          if (accepted) {
            x_.col(i) = candidates_.col(i);
            errors_[i] = found_[i];
            loudness_[i] *= options_.alpha;  // Eq. 9
            loudness_sum_.changed(i);
            pulse_rate_[i] = options_.pulse_rate * (1 - exponential(-options_.gamma * iteration_));  // Eq. 10
          }
          const bool counts = accepted || options_.best_of == BestOf::evaluated;
          return (counts && best_.improve(candidates_.col(i), found_[i])) || accepted;  // the mean loudness fell
        });
    v_.swap(v_next_);
  }

 private:
  void fly(Eigen::Index first, Eigen::Index count) {
    double step = options_.step_factor;
    if (options_.loudness == Loudness::mean)
      step *= loudness_sum_.of(loudness_) / static_cast<double>(loudness_.size());
    for (Eigen::Index j = 0; j < x_.rows(); ++j) {
      // Eq. 6: V <- V + (X - X_best) f;  Eq. 7: X <- X + V
      kernels_.fly({.pole = best_.q[j],
                    .frequency = &frequency_[first],
                    .x = &x_(j, first),
                    .v = &v_(j, first),
                    .x_next = &x_next_(j, first),
                    .v_next = &v_next_(j, first),
                    .count = count});
      kernels_.search_locally({.best = best_.q[j],  // Eq. 8
                               .step = step,
                               .draws = &epsilon_(j, first),
                               .chance = &local_[first],
                               .pulse_rate = &pulse_rate_[first],
                               .flown = &x_next_(j, first),
                               .q = &candidates_(j, first),
                               .count = count});
    }
    keep_inside(options_.bounds, problem_, candidates_.middleCols(first, count));
    if (options_.flight == Flight::moves) keep_inside(options_.bounds, problem_, x_next_.middleCols(first, count));
  }

  Options options_;
  const Kernels& kernels_ = kernels();
  Candidates x_, v_, x_next_, v_next_, candidates_, epsilon_;
  Eigen::RowVectorXd loudness_, pulse_rate_, frequency_, local_, chance_;
  OrderedSum loudness_sum_;
  Eigen::VectorXd errors_, found_;  // errors of the bats; of the candidates
  int iteration_ = 0;
};

}  // namespace

SolverInfo bat() {
  return solver_info<Bat>("bat", "bat algorithm (BA)", "Yang 2010; Slim et al. 2023, Algorithm 1", 1);
}

}  // namespace ikbench::solvers
