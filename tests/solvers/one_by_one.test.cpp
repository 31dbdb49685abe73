// Solvers that look ahead in batches equal, bit for bit, the loops of their pseudo-code, which draw, evaluate and
// decide one candidate after another.

#include "base/number.hpp"
#include "tests/solvers/objectives.hpp"

namespace {

constexpr int iterations = 30, candidates_a_step = 21;
constexpr std::uint64_t keys = 21;  // of each task and settings

using Vector = std::vector<double>;

// A loop's own state: candidate i is q[i], in plain vectors.
struct Loop {
  Loop(const Task& task, Objective& through, std::uint64_t key, const Settings& with)
      : problem(task.problem),
        joints(static_cast<std::size_t>(problem.joints())),
        objective(through),
        random{Key(key)},
        settings(with),
        clamps(is("bounds", "clamp")) {
    best.q = problem.start;
  }

  const Problem& problem;
  const std::size_t joints;
  Objective& objective;
  Random random;
  const Settings& settings;
  const bool clamps;
  std::vector<Vector> x;
  Vector errors;
  Best best;

  double number(const char* name) const { return std::get<double>(settings.at(name)); }
  bool is(const char* name, const char* value) const { return text_of(settings.at(name)) == value; }
  double start(std::size_t j) const { return problem.start[static_cast<Eigen::Index>(j)]; }
  double lower(std::size_t j) const { return problem.lower[static_cast<Eigen::Index>(j)]; }
  double upper(std::size_t j) const { return problem.upper[static_cast<Eigen::Index>(j)]; }
  double best_q(std::size_t j) const { return best.q[static_cast<Eigen::Index>(j)]; }

  Vector uniforms(std::size_t count) {
    Eigen::VectorXd drawn(static_cast<Eigen::Index>(count));
    random.uniforms(drawn);
    return {drawn.begin(), drawn.end()};
  }
  // Draws, joint by joint, numbers for candidate i and joint j in [i][j].
  std::vector<Vector> each(std::size_t count, void (*draw)(Random&, Candidates&)) {
    Candidates drawn(static_cast<Eigen::Index>(joints), static_cast<Eigen::Index>(count));
    draw(random, drawn);
    std::vector<Vector> of(count, Vector(joints));
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < joints; ++j) {
        of[i][j] = drawn(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(i));
      }
    }
    return of;
  }
  std::vector<Vector> each_uniform(std::size_t count) {
    return each(count, [](Random& from, Candidates& out) { from.uniforms(out); });
  }

  std::vector<Vector> each_normal(std::size_t count) {
    return each(count, [](Random& from, Candidates& out) { from.normals(out); });
  }

  void clamp(Vector& q) const {
    for (std::size_t j = 0; j < joints; ++j) q[j] = std::min(std::max(q[j], lower(j)), upper(j));
  }
  double error(const Vector& q) {
    return objective.error(Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<Eigen::Index>(q.size())));
  }
  void keep_if_best(const Vector& q, double error) {
    best.improve(Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<Eigen::Index>(q.size())), error);
  }
  std::size_t place_of_least() const {
    return static_cast<std::size_t>(std::ranges::min_element(errors) - errors.begin());
  }
  void draw_first(std::size_t count) {
    x = each_uniform(count);
    for (Vector& q : x) {
      for (std::size_t j = 0; j < joints; ++j) q[j] = lower(j) + (upper(j) - lower(j)) * q[j];
    }
    errors.resize(count);
  }
  void evaluate_first() {
    for (std::size_t i = 0; i < x.size(); ++i) {
      errors[i] = error(x[i]);
      keep_if_best(x[i], errors[i]);
    }
  }
};

// Slim et al. 2023, Algorithm 2.
void ik_bat(Loop& loop) {
  const std::size_t bats = candidates_a_step;
  const double step_factor = loop.number("step_factor");
  const bool is_greedy = loop.is("acceptance", "greedy"), by_loudness = loop.is("acceptance", "loudness");
  const double spread = loop.number("spread_deg") * degree;
  if (spread > 0) {
    loop.x = loop.each_normal(bats);
    for (Vector& q : loop.x) {
      for (std::size_t j = 0; j < loop.joints; ++j) q[j] = loop.start(j) + spread * q[j];
    }
  } else {
    loop.draw_first(bats);
  }
  loop.errors.resize(bats);
  for (std::size_t j = 0; j < loop.joints && loop.is("seeded", "yes"); ++j) loop.x[0][j] = loop.start(j);
  for (Vector& q : loop.x) {
    if (loop.clamps) loop.clamp(q);
  }
  loop.evaluate_first();
  double A = loop.number("loudness");
  const double r0 = loop.number("pulse_rate"), first = loop.number("first_iteration");
  for (int t = 0; t < iterations; ++t) {
    loop.uniforms(bats);  // the frequencies, which change no evaluation
    const std::vector<Vector> epsilon =
        loop.is("epsilon", "normal") ? loop.each_normal(bats)
        : loop.is("epsilon", "truncated")
            ? loop.each(bats, [](Random& from, Candidates& out) { from.truncated_normals(out); })
            : loop.each(bats, [](Random& from, Candidates& out) {
                from.uniforms(out);
                for (double& number : out.reshaped()) number = 2 * number - 1;
              });
    const Vector chance = loop.uniforms(bats);
    A *= loop.number("alpha");  // Eq. 9
    const double grown = 1 - exponential(-loop.number("gamma") * (first + t));
    const double r = loop.is("pulse", "rising") ? r0 * grown : r0;  // Eq. 10
    for (std::size_t i = 0; i < bats; ++i) {
      Vector q(loop.joints);
      for (std::size_t j = 0; j < loop.joints; ++j) {  // Eq. 14
        q[j] = (r * loop.best_q(j) + (1 - r) * loop.start(j)) + (step_factor * A) * epsilon[i][j];
      }
      if (loop.clamps) loop.clamp(q);
      const double error = loop.error(q);
      const bool accepts = is_greedy || (by_loudness ? chance[i] < A : chance[i] > A);
      if (accepts) loop.keep_if_best(q, error);
    }
  }
}

// Slim et al. 2023, Algorithm 1.
void bat(Loop& loop) {
  const auto bats = static_cast<std::size_t>(loop.problem.population);
  const double f_min = loop.number("f_min"), f_max = loop.number("f_max"), step_factor = loop.number("step_factor");
  const double alpha = loop.number("alpha"), gamma = loop.number("gamma"), pulse_rate = loop.number("pulse_rate");
  const bool keeps_all = loop.is("best_of", "evaluated"), moves = loop.is("flight", "moves");
  const bool has_own = loop.is("loudness", "own"), is_for_best = loop.is("acceptance", "best");
  loop.draw_first(bats);
  Vector A = loop.uniforms(bats), r(bats, pulse_rate);
  std::vector<Vector> v(bats, Vector(loop.joints, 0));
  loop.evaluate_first();
  for (int t = 1; t <= iterations; ++t) {
    const Vector beta = loop.uniforms(bats), local = loop.uniforms(bats);
    const std::vector<Vector> epsilon = loop.each_normal(bats);
    const Vector chance = loop.uniforms(bats);
    for (std::size_t i = 0; i < bats; ++i) {
      double sum = 0;
      for (const double loudness : A) sum += loudness;
      const double mean = sum / static_cast<double>(bats);
      const double f = f_min + (f_max - f_min) * beta[i];  // Eq. 5
      Vector q(loop.joints), flown(loop.joints);
      for (std::size_t j = 0; j < loop.joints; ++j) {
        v[i][j] = v[i][j] + (loop.x[i][j] - loop.best_q(j)) * f;  // Eq. 6
        flown[j] = loop.x[i][j] + v[i][j];                        // Eq. 7
        const double step = has_own ? step_factor * (epsilon[i][j] * A[i]) : (step_factor * mean) * epsilon[i][j];
        q[j] = local[i] > r[i] ? loop.best_q(j) + step : flown[j];  // Eq. 8
      }
      for (Vector* each : {&q, &flown}) {
        if (loop.clamps) loop.clamp(*each);
      }
      const double error = loop.error(q);
      const bool accepted = (is_for_best ? error < loop.best.error : error <= loop.errors[i]) && chance[i] < A[i];
      if (moves) loop.x[i] = flown;
      if (accepted) {
        loop.x[i] = q;
        loop.errors[i] = error;
        A[i] *= alpha;                                      // Eq. 9
        r[i] = pulse_rate * (1 - exponential(-gamma * t));  // Eq. 10
      }
      if (accepted || keeps_all) loop.keep_if_best(q, error);
    }
  }
}

// Kennedy and Eberhart 1995 with inertia; each particle sees the swarm's best at once.
void particle_swarm(Loop& loop) {
  const std::size_t particles = candidates_a_step;
  const double damping = loop.number("damping"), limit = loop.number("velocity_limit");
  double inertia = loop.number("inertia"), cognitive = loop.number("cognitive"), social = loop.number("social");
  if (loop.is("coefficients", "as_printed")) {  // by Table 1's labels
    std::swap(inertia, social);
    std::swap(inertia, cognitive);
  }
  if (loop.is("coefficients", "exchanged")) std::swap(cognitive, social);
  const bool is_at_once = loop.is("best_update", "at_once");
  const auto draw = [&] {
    if (loop.is("random", "per_joint")) return loop.each_uniform(particles);
    std::vector<Vector> same;
    for (const double number : loop.uniforms(particles)) same.emplace_back(loop.joints, number);
    return same;
  };
  loop.draw_first(particles);
  loop.evaluate_first();
  std::vector<Vector> v(particles, Vector(loop.joints, 0)), personal = loop.x;
  for (int t = 0; t < iterations; ++t) {
    const std::vector<Vector> u1 = draw(), u2 = draw();
    const std::vector<Vector> fresh = loop.is("bounds", "resample") ? loop.each_uniform(particles) : u1;
    Best next = loop.best;
    for (std::size_t i = 0; i < particles; ++i) {
      Vector& x = loop.x[i];
      for (std::size_t j = 0; j < loop.joints; ++j) {
        v[i][j] = inertia * v[i][j] + cognitive * (u1[i][j] * (personal[i][j] - x[j])) +
                  social * (u2[i][j] * (loop.best_q(j) - x[j]));
        const double most = limit * (loop.upper(j) - loop.lower(j));
        if (limit > 0) v[i][j] = std::clamp(v[i][j], -most, most);
        x[j] += v[i][j];
        if (loop.is("bounds", "resample") && !(x[j] >= loop.lower(j) && x[j] <= loop.upper(j)))
          x[j] = loop.lower(j) + (loop.upper(j) - loop.lower(j)) * fresh[i][j];
      }
      if (loop.clamps) loop.clamp(x);
      const double error = loop.error(x);
      if (error < loop.errors[i]) {
        personal[i] = x;
        loop.errors[i] = error;
      }
      next.improve(Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size())), error);
      if (is_at_once) loop.best = next;
    }
    loop.best = next;
    inertia *= damping;
  }
}

// rand/1/bin; a better trial takes its place at once, or when all have been tried (Storn and Price 1997).
void differential_evolution(Loop& loop) {
  const std::size_t candidates = candidates_a_step;
  const double crosses_below = loop.number("crossover"), weight = loop.number("weight");
  const bool at_once = loop.is("replacement", "at_once");
  loop.draw_first(candidates);
  loop.evaluate_first();
  for (int t = 0; t < iterations; ++t) {
    Candidates chance(3, candidates_a_step);
    loop.random.uniforms(chance);
    const std::vector<Vector> crossover = loop.each_uniform(candidates);
    const Vector forced = loop.uniforms(candidates);
    std::vector<Vector> weights(candidates, Vector(loop.joints, weight));
    if (loop.is("weight_drawn", "per_joint")) weights = loop.each_uniform(candidates);
    if (loop.is("weight_drawn", "per_trial")) {
      const Vector drawn = loop.uniforms(candidates);
      for (std::size_t i = 0; i < candidates; ++i) weights[i].assign(loop.joints, drawn[i]);
    }
    for (Vector& of_one : weights) {
      for (double& F : of_one) F = loop.is("weight_drawn", "never") ? F : 0.2 + (0.8 - 0.2) * F;
    }
    const std::vector<Vector> generation = loop.x, &from = at_once ? loop.x : generation;
    for (std::size_t i = 0; i < candidates; ++i) {
      // Three of the others, in order, each from those that are left.
      std::vector<std::size_t> left;
      for (std::size_t k = 0; k < candidates; ++k) {
        if (k != i) left.push_back(k);
      }
      std::array<std::size_t, 3> partner{};
      for (std::size_t k = 0; k < 3; ++k) {
        const double share = chance(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i));
        const auto which = left.begin() + static_cast<int>(share * static_cast<double>(left.size()));
        partner[k] = *which;
        left.erase(which);
      }
      const auto& [a, b, c] = partner;
      Vector q(loop.joints);
      for (std::size_t j = 0; j < loop.joints; ++j) {
        const bool mutates = crossover[i][j] < crosses_below ||
                             static_cast<std::size_t>(forced[i] * static_cast<double>(loop.joints)) == j;
        q[j] = mutates ? from[a][j] + weights[i][j] * (from[b][j] - from[c][j]) : from[i][j];
      }
      if (loop.clamps) loop.clamp(q);
      const double error = loop.error(q);
      if (!(error < loop.errors[i])) continue;
      loop.x[i] = q;
      loop.errors[i] = error;
      loop.keep_if_best(q, error);
    }
  }
}

// Karaboga 2005, and El-Sherbiny, Elhosseini and Haikal 2018 with the best source as everyone's neighbour.
void k_artificial_bee_colony(Loop& loop) {
  const std::size_t sources = loop.is("colony", "full") ? candidates_a_step : candidates_a_step / 2;
  loop.draw_first(sources);
  loop.evaluate_first();
  std::vector<int> failures(sources, 0);
  const auto set_limit = static_cast<int>(loop.number("limit"));
  const bool takes_random = loop.is("neighbour", "random"), best_takes_random = loop.is("best_neighbour", "random");
  const double unit = loop.is("fitness_unit", "cm") ? centimetre : 1;
  const int limit = set_limit > 0 ? set_limit : (candidates_a_step + static_cast<int>(loop.joints)) / 2;
  for (int t = 0; t < iterations; ++t) {
    for (const bool onlookers : {false, true}) {
      const Vector joint = loop.uniforms(sources), phi = loop.uniforms(sources);
      const Vector neighbour = takes_random || best_takes_random ? loop.uniforms(sources) : Vector(sources, 0);
      const Vector roulette = onlookers ? loop.uniforms(sources) : Vector(sources, 0);
      Vector shares;  // sums, from before the first onlooker flies
      for (const double error : loop.errors) {
        shares.push_back((shares.empty() ? 0 : shares.back()) + 1 / (1 + error / unit));
      }
      for (std::size_t bee = 0; bee < sources; ++bee) {
        std::size_t i = bee;
        if (onlookers) {
          for (i = 0; i + 1 < sources && shares[i] <= roulette[bee] * shares.back();) ++i;
        }
        const std::size_t best_source = loop.place_of_least();
        std::size_t k = best_source;
        if (takes_random || (i == best_source && best_takes_random)) {
          k = static_cast<std::size_t>(neighbour[bee] * static_cast<double>(sources - 1));
          if (k >= i) ++k;
        }
        const auto j = static_cast<std::size_t>(joint[bee] * static_cast<double>(loop.joints));
        Vector q = loop.x[i];
        const bool is_from_origin = k == i && loop.is("best_neighbour", "origin");
        q[j] += (2 * phi[bee] - 1) * (is_from_origin ? q[j] : q[j] - loop.x[k][j]);
        if (loop.clamps) loop.clamp(q);
        const double error = loop.error(q);
        if (error < loop.errors[i]) {
          loop.x[i] = q;
          loop.errors[i] = error;
          failures[i] = 0;
          loop.keep_if_best(q, error);
        } else {
          ++failures[i];
        }
      }
    }
    const std::size_t best_source = loop.place_of_least();
    for (std::size_t i = 0; i < sources; ++i) {
      if (failures[i] <= limit || (i == best_source && loop.is("best_source", "spared"))) continue;
      for (std::size_t j = 0; j < loop.joints; ++j) loop.x[i][j] = loop.random.uniform(loop.lower(j), loop.upper(j));
      loop.errors[i] = loop.error(loop.x[i]);
      failures[i] = 0;
      loop.keep_if_best(loop.x[i], loop.errors[i]);
    }
  }
}

// The iiwa's four joints to its wrist, or all seven to the flange; each key has a target of its own, within reach or
// just outside.
Task task_of(int joints, std::uint64_t key) {
  Task task = iiwa_task(candidates_a_step);
  const Robot iiwa = robot("kuka_iiwa14");
  if (joints == 7) {
    task.chain = iiwa.chain;
    task.problem.start = Eigen::VectorXd::Constant(7, 0.2);
    task.problem.lower = iiwa.limits.lower;
    task.problem.upper = iiwa.limits.upper;
  }
  Random random{Key(key).with("target")};
  for (double& coordinate : task.target) coordinate = random.uniform(-0.6, 0.6);
  return task;
}

// With each of its lines in tests/data/variants.txt.
void check_against(const std::string& name, void (*run)(Loop&)) {
  const SolverInfo info = solver(name);
  int found = 0;
  std::istringstream variants(text_in("tests/data/variants.txt"));
  for (std::string line; std::getline(variants, line);) {
    std::istringstream words(line);
    Settings variant;
    std::string word;
    if (!(words >> word) || word != name) continue;
    ++found;
    while (words >> word) {
      const std::string key = word.substr(0, word.find('=')), value = word.substr(key.size() + 1);
      variant[key] = number_from(value) ? Setting(*number_from(value)) : Setting(value);
    }
    const auto registered = info.make(variant);
    const Settings settings = info.options(variant);
    for (const int joints : {4, 7}) {
      for (std::uint64_t key = 0; key < keys; ++key) {
        CAPTURE(line, joints, key);
        const Task task = task_of(joints, key);
        Objective ahead(task.chain, task.target), by_itself(task.chain, task.target);
        Random random{Key(key)};
        const Solution solution = solve(*registered, task.problem, ahead, random, {.iterations = iterations});
        Loop loop(task, by_itself, key, settings);
        run(loop);
        REQUIRE(solution.best.q == loop.best.q);
        REQUIRE(solution.best.error == loop.best.error);
        REQUIRE(solution.evaluations == by_itself.evaluations());
        REQUIRE(random.uniform() == loop.random.uniform());  // both have drawn equally many
      }
    }
  }
  CHECK(found >= 4);
}

}  // namespace

TEST_CASE("IK-BA, BA, PSO, DE and K-ABC are their pseudo-code bit for bit, one candidate after another",
          "[one_by_one]") {
  check_against("ik_bat", ik_bat);
  check_against("bat", bat);
  check_against("particle_swarm", particle_swarm);
  check_against("differential_evolution", differential_evolution);
  check_against("k_artificial_bee_colony", k_artificial_bee_colony);
}

TEST_CASE("BA of many bats is its pseudo-code bit for bit: the mean loudness is added up in order",
          "[one_by_one][bat]") {
  const SolverInfo info = solver("bat");
  for (const int bats : {256, 257, 513}) {
    for (const double alpha : {0.0, 0.5, 0.99}) {
      CAPTURE(bats, alpha);
      const Settings variant{{"alpha", alpha}, {"step_factor", 1.0}, {"pulse_rate", 0.5}};
      const Settings settings = info.options(variant);
      Task task = task_of(4, 1);
      task.problem.population = bats;
      RecordingObjective in_blocks(task.chain, task.target), by_itself(task.chain, task.target);
      Random random{Key(1)};
      solve(*info.make(variant), task.problem, in_blocks, random, {.iterations = iterations});
      Loop loop(task, by_itself, 1, settings);
      bat(loop);
      REQUIRE(in_blocks.candidates == by_itself.candidates);
    }
  }
}
