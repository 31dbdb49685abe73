// MO-PSO: velocities, positions, limits, mutation and the archive.
#include "tests/solvers/objectives.hpp"

namespace {

struct Point {
  double error, variation;
  Eigen::VectorXd q;
};

bool dominates(const Point& a, const Point& b) {
  return a.error <= b.error && a.variation <= b.variation && (a.error < b.error || a.variation < b.variation);
}

// The non-dominated of these, compared one by one with all, equal ones once; then the least crowded of them.
std::vector<Point> reference_archive(const std::vector<Point>& all, std::size_t capacity) {
  std::vector<Point> front;
  for (const Point& p : all) {
    const auto beats = [&](const Point& other) { return dominates(other, p); };
    const auto equals = [&](const Point& other) { return other.error == p.error && other.variation == p.variation; };
    if (std::none_of(all.begin(), all.end(), beats) && std::none_of(front.begin(), front.end(), equals)) {
      front.push_back(p);
    }
  }
  if (front.size() <= capacity) return front;
  std::vector<double> crowding(front.size(), 0);
  for (const auto objective : {&Point::error, &Point::variation}) {
    std::vector<std::size_t> order(front.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return front[a].*objective < front[b].*objective; });
    const double range = front[order.back()].*objective - front[order.front()].*objective;
    crowding[order.front()] = crowding[order.back()] = infinity;
    for (std::size_t i = 1; i + 1 < order.size(); ++i) {
      crowding[order[i]] += (front[order[i + 1]].*objective - front[order[i - 1]].*objective) / range;
    }
  }
  std::vector<double> sorted = crowding;
  std::sort(sorted.rbegin(), sorted.rend());
  std::vector<Point> kept;
  for (std::size_t i = 0; i < front.size(); ++i) {
    if (crowding[i] >= sorted[capacity - 1]) kept.push_back(front[i]);
  }
  return kept;
}

std::vector<Point> seen_points(const RecordingObjective& objective, const Eigen::VectorXd& start) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < objective.candidates.size(); ++i) {
    points.push_back({objective.given[i], (objective.candidates[i] - start).norm(), objective.candidates[i]});
  }
  return points;
}

}  // namespace

TEST_CASE("MO-PSO's mutation draws 0 of 17, 9 of 17 and fewer and fewer of 16 particles anew", "[mo_pso]") {
  Task task = planar_task(50);
  task.problem.iterations = 10;
  RecordingObjective objective(task.chain, task.target);
  Random random{Key(1)};
  const Settings at_rest{{"inertia", 0.0}, {"cognitive", 0.0}, {"social", 0.0}};  // only mutation moves a particle
  const auto swarm = solver("multi_objective_swarm").make(at_rest);
  swarm->start(task.problem, objective, random);
  for (std::size_t generation = 1; generation <= 12; ++generation) {
    swarm->step(objective, random);
    std::array<int, 3> redrawn{};
    for (std::size_t i = 0; i < 50; ++i) {
      const bool moved = objective.candidates[50 * generation + i] != objective.candidates[50 * (generation - 1) + i];
      redrawn[i < 17 ? 0 : i < 34 ? 1 : 2] += moved ? 1 : 0;
    }
    const double left = std::max(0.0, 1 - static_cast<double>(generation) / 10);  // g / G; nothing is left after G
    CHECK(redrawn[0] == 0);
    CHECK(redrawn[1] == 9);
    CHECK(redrawn[2] == std::lround(16 * std::pow(left, 5 * 2)));
  }
}

TEST_CASE("MO-PSO's velocity is used whole, kept within 5 % of the range, and turned round at a limit", "[mo_pso]") {
  const Task task = planar_task(2);
  std::vector<double> script;
  for (int i = 0; i < 42; ++i) script.push_back(0.1 + (i * 7) % 41);
  const Settings settings{{"inertia", 0.9}, {"grid", 1.0}, {"mutation", 0.0}};  // one cell: all members weigh the same
  int limited = 0, turned = 0, dominating = 0, tossed = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    RecordingObjective objective(task.chain, script);
    Random random{Key(seed)}, replay{Key(seed)};
    const auto swarm = solver("multi_objective_swarm").make(settings);
    swarm->start(task.problem, objective, random);

    Candidates x = drawn_uniforms(replay, 2, 2), v = Candidates::Zero(2, 2);
    x = (2 * x.array() - 1).matrix();
    std::vector<Point> archive = reference_archive(seen_points(objective, task.problem.start), 50);
    std::vector<Point> own = seen_points(objective, task.problem.start);
    std::size_t turn = 2;
    for (int generation = 1; generation <= 20; ++generation) {
      swarm->step(objective, random);
      const Candidates u1 = drawn_uniforms(replay, 2, 2), u2 = drawn_uniforms(replay, 2, 2);
      const double roulette = drawn_vector(replay, 2)[0];
      const Eigen::VectorXd coin = drawn_vector(replay, 2);
      std::sort(archive.begin(), archive.end(), [](const Point& a, const Point& b) { return a.error < b.error; });
      const Eigen::VectorXd leader =
          archive[static_cast<std::size_t>(roulette * static_cast<double>(archive.size()))].q;
      for (int i = 0; i < 2; ++i, ++turn) {
        Point& personal = own[static_cast<std::size_t>(i)];
        for (int j = 0; j < 2; ++j) {
          v(j, i) = 0.9 * v(j, i) + 2 * u1(j, i) * (personal.q[j] - x(j, i)) + 2 * u2(j, i) * (leader[j] - x(j, i));
          x(j, i) += v(j, i);
          limited += std::abs(v(j, i)) > 0.1 ? 1 : 0;
          v(j, i) = std::clamp(v(j, i), -0.1, 0.1);  // 5 % of [-1, 1]
          if (std::abs(x(j, i)) > 1) {
            x(j, i) = std::copysign(1.0, x(j, i));
            v(j, i) = -v(j, i);
            ++turned;
          }
        }
        REQUIRE((objective.candidates[turn] - x.col(i)).norm() < 1e-13);
        const Point now{script[turn], (x.col(i) - task.problem.start).norm(), x.col(i)};
        archive.push_back(now);
        if (dominates(now, personal)) {
          personal = now;
          ++dominating;
        } else if (!dominates(personal, now) && coin[i] < 0.5) {
          personal = now;
          ++tossed;
        }
      }
      archive = reference_archive(archive, 50);
    }
  }
  for (const int cases : {limited, turned, dominating, tossed}) CHECK(cases > 10);
}

TEST_CASE("MO-PSO's leaders are the non-dominated and least crowded of all it has seen", "[mo_pso]") {
  const Task task = iiwa_task(40);
  // Only the leader moves a particle: x + U (leader - x), so that the log shows each particle's leader.
  const Settings settings{{"inertia", 0.0},  {"cognitive", 0.0}, {"social", 1.0},
                          {"mutation", 0.0}, {"archive", 5.0},   {"leader", "per_particle"}};
  RecordingObjective objective(task.chain, task.target);
  Random random{Key(6)}, replay{Key(6)};
  const auto swarm = solver("multi_objective_swarm").make(settings);
  Problem problem = task.problem;
  problem.iterations = 1;  // no mutation of the last third either
  swarm->start(problem, objective, random);
  drawn_uniforms(replay, 4, 40);
  std::vector<Point> archive;
  std::size_t crowded = 0;
  for (std::size_t generation = 1; generation <= 6; ++generation) {
    std::vector<Point> all = archive;
    const std::vector<Point> seen = seen_points(objective, task.problem.start);
    all.insert(all.end(), seen.end() - 40, seen.end());
    archive = reference_archive(all, 5);
    crowded += archive.size() == 5 ? 1 : 0;
    swarm->step(objective, random);
    drawn_uniforms(replay, 4, 40);
    const Candidates u2 = drawn_uniforms(replay, 4, 40);
    drawn_vector(replay, 40);
    drawn_vector(replay, 40);
    for (std::size_t i = 0; i < 40; ++i) {
      const Eigen::VectorXd& from = objective.candidates[40 * (generation - 1) + i];
      const Eigen::VectorXd& to = objective.candidates[40 * generation + i];
      const bool led = std::any_of(archive.begin(), archive.end(), [&](const Point& member) {
        const Eigen::VectorXd expected = from + u2.col(static_cast<Eigen::Index>(i)).cwiseProduct(member.q - from);
        return (expected - to).norm() < 1e-14;
      });
      REQUIRE(led);
    }
  }
  CHECK(crowded > 0);
}

TEST_CASE("MO-PSO's archive of one has the smallest error: both ends are as little crowded, and the first stays",
          "[mo_pso]") {
  const Task task = iiwa_task(40);
  const Settings settings{{"inertia", 0.0},  {"cognitive", 0.0}, {"social", 1.0},
                          {"mutation", 0.0}, {"archive", 1.0},   {"leader", "per_particle"}};
  RecordingObjective objective(task.chain, task.target);
  Random random{Key(6)}, replay{Key(6)};
  const auto swarm = solver("multi_objective_swarm").make(settings);
  Problem problem = task.problem;
  problem.iterations = 1;
  swarm->start(problem, objective, random);
  const std::vector<Point> seen = seen_points(objective, task.problem.start);
  REQUIRE(reference_archive(seen, 40).size() > 1);
  const Point best = *std::ranges::min_element(seen, {}, &Point::error);
  swarm->step(objective, random);
  drawn_uniforms(replay, 4, 40);  // the first places
  drawn_uniforms(replay, 4, 40);
  const Candidates u2 = drawn_uniforms(replay, 4, 40);
  for (std::size_t i = 0; i < 40; ++i) {
    const Eigen::VectorXd& from = objective.candidates[i];
    const Eigen::VectorXd led = from + u2.col(static_cast<Eigen::Index>(i)).cwiseProduct(best.q - from);
    REQUIRE((led - objective.candidates[40 + i]).norm() < 1e-14);
  }
}

TEST_CASE("MO-PSO's roulette gives each occupied cell 10 / (its members), whoever stands in it", "[mo_pso]") {
  const int particles = 1000;
  const Task task = iiwa_task(particles);
  RecordingObjective objective(task.chain, task.target);
  Random random{Key(6)}, replay{Key(6)};
  Problem problem = task.problem;
  problem.iterations = 1;
  const Settings settings{{"inertia", 0.0},  {"cognitive", 0.0},         {"social", 1.0},
                          {"mutation", 0.0}, {"leader", "per_particle"}, {"grid", 3.0}};
  const auto swarm = solver("multi_objective_swarm").make(settings);
  swarm->start(problem, objective, random);
  const std::vector<Point> archive = reference_archive(seen_points(objective, task.problem.start), 50);
  swarm->step(objective, random);

  Point low = archive.front(), high = low;
  for (const Point& member : archive) {
    low = {std::min(low.error, member.error), std::min(low.variation, member.variation), {}};
    high = {std::max(high.error, member.error), std::max(high.variation, member.variation), {}};
  }
  const auto cell = [&](const Point& member) {
    const auto part = [](double value, double from, double to) {
      return std::min(2, static_cast<int>(3 * (value - from) / (to - from)));
    };
    return std::pair(part(member.error, low.error, high.error), part(member.variation, low.variation, high.variation));
  };
  std::map<std::pair<int, int>, double> members;
  for (const Point& member : archive) ++members[cell(member)];
  double weights = 0;
  for (const auto& [place, count] : members) weights += 10 / count;

  drawn_uniforms(replay, 4, particles);
  drawn_uniforms(replay, 4, particles);
  const Candidates u2 = drawn_uniforms(replay, 4, particles);
  std::vector<double> led(archive.size(), 0);
  for (std::size_t i = 0; i < static_cast<std::size_t>(particles); ++i) {
    const Eigen::VectorXd& from = objective.candidates[i];
    const Eigen::VectorXd& to = objective.candidates[static_cast<std::size_t>(particles) + i];
    for (std::size_t m = 0; m < archive.size(); ++m) {
      const Eigen::VectorXd expected = from + u2.col(static_cast<Eigen::Index>(i)).cwiseProduct(archive[m].q - from);
      if ((expected - to).norm() < 1e-14) ++led[m];
    }
  }
  REQUIRE(members.size() > 2);
  CHECK(members.size() < archive.size());
  for (std::size_t m = 0; m < archive.size(); ++m) {
    const double count = members[cell(archive[m])], p = 10 / count / weights / count;
    CHECK(std::abs(led[m] - particles * p) < 4 * std::sqrt(particles * p * (1 - p)));  // binomial
  }
}

TEST_CASE("MO-PSO's answer is the smallest error it has seen, and its knee gives up error for less variation",
          "[mo_pso]") {
  const Task task = iiwa_task(20);
  const auto answer = [&](const std::string& final_point) {
    RecordingObjective objective(task.chain, task.target);
    const Best best =
        solve_by("multi_objective_swarm", {{"final_point", final_point}}, task.problem, objective, {.iterations = 50})
            .best;
    if (final_point == "smallest_error") CHECK(best.error == std::ranges::min(objective.given));
    return best;
  };
  const Best smallest = answer("smallest_error"), knee = answer("knee");
  CHECK(knee.error > smallest.error);
  CHECK((knee.q - task.problem.start).norm() < (smallest.q - task.problem.start).norm());
}
