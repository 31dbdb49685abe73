// MO-PSO, multi-objective particle swarm optimisation: Coello, Pulido and Lechuga 2004, in the form of
// Martinez-Cagigal's public code, whose labels Table 1 of Slim et al. 2023 uses. The two objectives are the position
// error and the variation, the norm of the joints' move from the start. A continuous joint moves the shorter way
// round. docs/papers/slim2023-notes.md 2.8 argues for this reading.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "numerics/functions.hpp"
#include "solvers/bounds.hpp"
#include "solvers/kernels.hpp"
#include "solvers/registry.hpp"
#include "solvers/roulette.hpp"

namespace ikbench::solvers {

using namespace numerics;
using namespace robots;

namespace {

struct Cost {
  double error = 0;      // [m]
  double variation = 0;  // [rad]

  bool is_no_worse_than(const Cost& other) const {
    return (error <= other.error) & (variation <= other.variation);  // without a branch to predict
  }
};

// The candidates that no other one dominates, ordered by growing error and so by falling variation. In that order
// neighbours along the front are next to each other, and members of one grid cell stand together.
class Front {
 public:
  // Allocates memory for `capacity` members and as many newcomers as the swarm has.
  void start(Eigen::Index joints, Eigen::Index capacity, Eigen::Index swarm, int cells) {
    cells_ = cells;
    capacity_ = static_cast<std::size_t>(capacity);
    members_.clear();
    q_.resize(joints, capacity);
    const auto most = static_cast<std::size_t>(capacity + swarm);
    for (auto* list : {&members_, &newcomers_, &kept_}) list->reserve(most);
    order_.reserve(most);
    free_.resize(capacity_);
    std::iota(free_.begin(), free_.end(), 0);
    roulette_.reserve(capacity_);
  }

  bool empty() const { return members_.empty(); }
  std::size_t size() const { return members_.size(); }
  const Cost& cost(std::size_t m) const { return members_[m].cost; }
  auto q(std::size_t m) const { return q_.col(members_[m].column); }

  void add(const Candidates& swarm, const Eigen::VectorXd& errors, const Eigen::VectorXd& variations) {
    newcomers_.clear();
    for (Eigen::Index i = 0; i < swarm.cols(); ++i) {
      const Cost cost{errors[i], variations[i]};
      if (std::isfinite(cost.error) && !is_behind_front(cost)) newcomers_.push_back({cost, q_.cols() + i});
    }
    if (newcomers_.empty()) return;
    std::sort(newcomers_.begin(), newcomers_.end(), by_error);
    keep_non_dominated();
    if (members_.size() > capacity_) drop_most_crowded();
    take_in(swarm);
    divide();
  }

  // Returns the member that a number in [0, 1) picks.
  std::size_t pick(double chance) const { return roulette_.pick(chance); }

  // Returns the member nearest to the best values of both objectives, each relative to its range over the front.
  std::size_t knee() const {
    const auto distance = [&](std::size_t m) {
      const double e = position(cost(m).error, cost(0).error, cost(size() - 1).error);
      const double v = position(cost(m).variation, cost(size() - 1).variation, cost(0).variation);
      return e * e + v * v;
    };
    std::size_t nearest = 0;
    for (std::size_t m = 1; m < size(); ++m) {
      if (distance(m) < distance(nearest)) nearest = m;
    }
    return nearest;
  }

 private:
  struct Member {
    Cost cost;
    Eigen::Index column;  // of the archive, after these of the swarm, or nowhere
    double crowding = 0;
  };

  // Returns 0 at `low` and 1 at `high`; 0 if both are equal.
  static double position(double value, double low, double high) {
    return high > low ? (value - low) / (high - low) : 0;
  }

  // Fills the roulette: each occupied cell of the grid over the front weighs 10 / (its members), shared among them.
  void divide() {
    roulette_.clear();
    auto next = cell_of(cost(0));
    for (std::size_t first = 0, last = 0; first < size(); first = last) {
      const auto cell = next;
      for (++last; last < size(); ++last) {
        next = cell_of(cost(last));
        if (next != cell) break;
      }
      const auto count = static_cast<double>(last - first);
      const double share = 10 / count / count;
      for (std::size_t m = first; m < last; ++m) roulette_.add(share);
    }
  }

  std::pair<int, int> cell_of(const Cost& cost) const {
    const auto cell = [this](double at) { return std::min(static_cast<int>(at * cells_), cells_ - 1); };
    const Cost &left = members_.front().cost, &right = members_.back().cost;
    return {cell(position(cost.error, left.error, right.error)),
            cell(position(cost.variation, right.variation, left.variation))};
  }

  static constexpr Eigen::Index nowhere = -1;

  static bool by_error(const Member& a, const Member& b) {
    return std::tie(a.cost.error, a.cost.variation, a.column) < std::tie(b.cost.error, b.cost.variation, b.column);
  }

  // Returns true if a member has no larger error and no larger variation. Among members with no larger error the last
  // one varies least.
  bool is_behind_front(const Cost& newcomer) const {
    if (empty() || newcomer.error < cost(0).error) return false;
    std::size_t last = 0;  // bisection without a branch to predict
    for (std::size_t left = size(); left > 1; left -= left / 2) {
      last += cost(last + left / 2).error <= newcomer.error ? left / 2 : 0;
    }
    return cost(last).variation <= newcomer.variation;
  }

  // Keeps members and newcomers that no other one dominates, in one pass in the order of error. A candidate that does
  // not vary less than all before is dominated, or equal to one that stays.
  void keep_non_dominated() {
    kept_.clear();
    auto member = members_.cbegin(), newcomer = newcomers_.cbegin();
    while (member != members_.cend() || newcomer != newcomers_.cend()) {
      const bool old = newcomer == newcomers_.cend() || (member != members_.cend() && by_error(*member, *newcomer));
      const Member& next = old ? *member++ : *newcomer++;
      if (kept_.empty() || next.cost.variation < kept_.back().cost.variation) {
        kept_.push_back(next);
      } else {
        release(next);
      }
    }
    members_.swap(kept_);
  }

  // Drops the members with the smallest crowding distance (Deb et al. 2002), computed once; the ends stay.
  void drop_most_crowded() {
    const std::size_t last = size() - 1;
    const double errors = cost(last).error - cost(0).error;
    const double variations = cost(0).variation - cost(last).variation;
    order_.clear();
    for (std::size_t m = 0; m <= last; ++m) {
      members_[m].crowding = m == 0 || m == last ? std::numeric_limits<double>::infinity()
                                                 : (cost(m + 1).error - cost(m - 1).error) / errors +
                                                       (cost(m - 1).variation - cost(m + 1).variation) / variations;
      order_.push_back(m);
    }
    const auto first_kept = order_.begin() + static_cast<std::ptrdiff_t>(size() - capacity_);
    std::partial_sort(order_.begin(), first_kept, order_.end(), [&](std::size_t a, std::size_t b) {
      return members_[a].crowding < members_[b].crowding || (members_[a].crowding == members_[b].crowding && a > b);
    });
    std::for_each(order_.begin(), first_kept, [&](std::size_t m) {
      release(members_[m]);
      members_[m].column = nowhere;
    });
    std::erase_if(members_, [](const Member& member) { return member.column == nowhere; });
  }

  void release(const Member& member) {
    if (member.column < q_.cols()) free_.push_back(member.column);
  }

  // Copies the newcomers' configurations to free columns.
  void take_in(const Candidates& swarm) {
    for (Member& member : members_) {
      if (member.column < q_.cols()) continue;
      q_.col(free_.back()) = swarm.col(member.column - q_.cols());
      member.column = free_.back();
      free_.pop_back();
    }
  }

  int cells_ = 0;
  std::size_t capacity_ = 0;
  std::vector<Member> members_, newcomers_, kept_;
  std::vector<std::size_t> order_;  // members, the most crowded first
  Roulette roulette_;
  Candidates q_;
  std::vector<Eigen::Index> free_;  // columns of q_
};

class MultiObjectiveSwarm final : public Searcher {
 public:
  enum class Leader { per_generation, per_particle };
  enum class FinalPoint { smallest_error, knee };

  struct Options {
    double inertia = 0.5;
    double cognitive = 2;
    double social = 2;
    int grid = 20;
    int archive = 50;
    double velocity_limit_percent = 5;
    double velocity_limit_rad = 0;
    double mutation = 0.5;
    Leader leader = Leader::per_generation;
    FinalPoint final_point = FinalPoint::smallest_error;

    void list(OptionList& list) {
      list.number("inertia", inertia, {0, 10}, "w, weight of the previous velocity");
      list.number("cognitive", cognitive, {0, 10}, "c1, weight of a particle's own best");
      list.number("social", social, {0, 10}, "c2, weight of the leader");
      list.count("grid", grid, {1, 1000}, "cells of the archive's grid along each objective");
      list.count("archive", archive, {1, 10000}, "size of the archive; not given in the paper");
      list.number("velocity_limit_percent", velocity_limit_percent, {0, 100},
                  "maximum velocity carried into the next generation, in percent of a joint's range");
      list.number("mutation", mutation, {0, 1}, "share of the swarm's second third that is drawn again");
      list.choice("leader", leader,
                  {{"per_generation", Leader::per_generation}, {"per_particle", Leader::per_particle}},
                  "all particles of a generation share one leader from the archive, or each has its own");
      list.choice("final_point", final_point,
                  {{"smallest_error", FinalPoint::smallest_error}, {"knee", FinalPoint::knee}},
                  "the answer is the candidate with the smallest error, or the archive's knee with the smallest error "
                  "so far");
      list.later();
      list.number("velocity_limit_rad", velocity_limit_rad, {0, 100},
                  "maximum velocity in rad instead; 0: in percent. Table 1 prints 5 without a unit");
    }
  };

  explicit MultiObjectiveSwarm(Options options) : options_(options) {}

  void start(const Problem& problem, Objective& objective, Random& random) override {
    take(problem);
    const int particles = problem.population;
    for (Candidates* each : {&x_, &v_, &u1_, &u2_}) each->resize(problem.joints(), particles);
    v_.setZero();
    for (Eigen::VectorXd* each : {&errors_, &variations_, &turned_, &chance_, &coin_}) each->resize(particles);
    order_.resize(static_cast<std::size_t>(particles));
    velocity_limit_.resize(problem.joints());
    for (Eigen::Index j = 0; j < x_.rows(); ++j) {
      const DrawnFrom range(problem, j);
      velocity_limit_[j] = options_.velocity_limit_percent / 100 * (range.upper - range.lower);
      if (options_.velocity_limit_rad > 0) velocity_limit_[j] = options_.velocity_limit_rad;
    }
    archive_.start(problem.joints(), options_.archive, particles, options_.grid);
    generation_ = 0;

    draw_within_limits(problem, random, x_);
    evaluate(objective);
    personal_ = x_;
    personal_errors_ = errors_;
    personal_variations_ = variations_;
  }

  void step(Objective& objective, Random& random) override {
    random.uniforms(u1_);
    random.uniforms(u2_);
    random.uniforms(chance_);
    random.uniforms(coin_);
    ++generation_;
    if (archive_.empty()) return;  // no particle has an error, so none leads
    const Eigen::Index led = options_.leader == Leader::per_generation ? x_.cols() : 1;
    for (Eigen::Index first = 0; first < x_.cols(); first += led) {
      const auto leader = archive_.q(archive_.pick(chance_[first]));
      for (Eigen::Index j = 0; j < x_.rows(); ++j) {
        kernels_.swarm({.inertia = options_.inertia,
                        .cognitive = options_.cognitive,
                        .social = options_.social,
                        .best = leader[j],
                        .x = &x_(j, first),
                        .v = &v_(j, first),
                        .personal = &personal_(j, first),
                        .u1 = &u1_(j, first),
                        .u2 = &u2_(j, first),
                        .x_next = &x_(j, first),
                        .v_next = &v_(j, first),
                        .count = led});
      }
    }
    mutate(random);
    for (Eigen::Index j = 0; j < x_.rows(); ++j) {
      kernels_.turn_back({.lower = problem_.lower[j],
                          .upper = problem_.upper[j],
                          .max_velocity = velocity_limit_[j],
                          .q = &x_(j, 0),
                          .v = &v_(j, 0),
                          .count = x_.cols()});
    }
    evaluate(objective);
    for (Eigen::Index i = 0; i < x_.cols(); ++i) chance_[i] = chance_to_replace(i);
    const auto replace = [&](const double* by, double* own) {
      kernels_.choose({coin_.data(), chance_.data(), by, own, own, x_.cols()});
    };
    for (Eigen::Index j = 0; j < x_.rows(); ++j) replace(&x_(j, 0), &personal_(j, 0));
    replace(errors_.data(), personal_errors_.data());
    replace(variations_.data(), personal_variations_.data());
  }

 private:
  void evaluate(Objective& objective) {
    objective.errors(x_, errors_);
    variations_.setZero();
    for (Eigen::Index j = 0; j < x_.rows(); ++j) {
      if (is_endless(problem_.lower[j], problem_.upper[j])) {
        turned_ =
            (x_.row(j).array() - problem_.start[j]).unaryExpr([](double q) { return std::remainder(q, whole_turn); });
        kernels_.add_squares(0, turned_.data(), variations_.data(), x_.cols());
      } else {
        kernels_.add_squares(problem_.start[j], &x_(j, 0), variations_.data(), x_.cols());
      }
    }
    variations_ = variations_.cwiseSqrt();
    archive_.add(x_, errors_, variations_);
    if (archive_.empty()) return;
    // The front's first member has the smallest error ever: nothing dominates it, and crowding spares it.
    const std::size_t answer = options_.final_point == FinalPoint::knee ? archive_.knee() : 0;
    best_.improve(archive_.q(answer), archive_.cost(answer).error);
  }

  // Mutates the swarm in thirds (50: 17, 17, 16): the first stays, some of the second are drawn again, and fewer and
  // fewer of the third.
  void mutate(Random& random) {
    const auto swarm = static_cast<int>(x_.cols());
    const int first = (swarm + 2) / 3, second = (swarm + 1) / 3, third = swarm / 3;
    const double left = std::max(0.0, 1 - generation_ / static_cast<double>(std::max(1, problem_.iterations)));
    redraw(first, second, options_.mutation, random);
    redraw(first + second, third, power(left, 5 * problem_.joints()), random);
  }

  // Draws a share of the particles from, ..., from + count - 1 again, each once at most.
  void redraw(int from, int count, double share, Random& random) {
    for (int k = 0; k < count; ++k) order_[static_cast<std::size_t>(k)] = from + k;
    const auto redrawn = static_cast<int>(std::lround(share * count));
    for (int k = 0; k < redrawn; ++k) {
      std::swap(order_[static_cast<std::size_t>(k)], order_[static_cast<std::size_t>(k + random.index(count - k))]);
      const int i = order_[static_cast<std::size_t>(k)];
      draw_one_within_limits(problem_, random, x_.col(i));
    }
  }

  // Returns the chance that a particle's own best gives way to a candidate: 1 if the candidate dominates, 0 if it is
  // dominated, otherwise a half.
  double chance_to_replace(Eigen::Index i) const {
    const Cost now{errors_[i], variations_[i]}, own{personal_errors_[i], personal_variations_[i]};
    if (!std::isfinite(now.error)) return 0;
    return 0.5 * (1 + now.is_no_worse_than(own) - own.is_no_worse_than(now));
  }

  Options options_;
  const Kernels& kernels_ = kernels();
  Candidates x_, v_, personal_, u1_, u2_;
  Eigen::VectorXd errors_, variations_, personal_errors_, personal_variations_;
  Eigen::VectorXd turned_;  // moves of a continuous joint
  Eigen::VectorXd chance_, coin_;
  Configuration velocity_limit_;
  std::vector<int> order_;
  Front archive_;
  int generation_ = 0;
};

}  // namespace

SolverInfo multi_objective_swarm() {
  return solver_info<MultiObjectiveSwarm>("multi_objective_swarm",
                                          "multi-objective particle swarm (MO-PSO): position error and variation",
                                          "Coello, Pulido and Lechuga 2004; Martinez-Cagigal's MOPSO", 1);
}

}  // namespace ikbench::solvers
