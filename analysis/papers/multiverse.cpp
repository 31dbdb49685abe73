#include "analysis/papers/multiverse.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bitset>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <map>
#include <random>
#include <utility>

#include "analysis/figures/plots.hpp"
#include "analysis/papers/rules.hpp"

namespace ikbench::papers {

using namespace compare;
using results::Chosen;
using results::Dimension;

namespace {

using ChosenSolver = Multiverse::ChosenSolver;
using OfStudy = Multiverse::OfStudy;
using Names = std::vector<std::string>;
// Which printed numbers: those of error, then those of variation.
using Explained = std::bitset<metrics_of_readings.size() * statistics.size()>;
// By the choice of the study, by solver, by its own choice.
using ExplainedReadings = std::vector<std::vector<std::vector<Explained>>>;
using PrintedMetrics = std::array<PrintedRows, metrics_of_readings.size()>;

std::size_t place_of(const Names& all, std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(all, name) - all.begin());
}

double readings_of(const OfStudy& study) {
  double product = 1;
  for (const std::vector<ChosenSolver>& of_solver : study.solvers) product *= static_cast<double>(of_solver.size());
  return product;
}

// The shares of a claim.

// If it is that a solver is better in error, variation or their spread.
bool hangs_on_reading(const Claim& claim) {
  return claim.rule != nullptr && claim.rule->name == "better" && claim.metrics.size() == 1 && claim.study.empty() &&
         std::ranges::find(metrics_of_readings, claim.metrics.front()->column) != metrics_of_readings.end();
}

struct Counted {
  SharesOfClaim shares;
  std::string sentence;
  std::vector<std::vector<Shares>> alternatives;  // by dimension; of the readings that make the choice
};

// Of each pair alone, by Welch's t, at its part of the significance, as a report judges a pair of these solvers.
Plan plan_of_pairs(const Plan& plan, std::size_t solvers) {
  const auto k = static_cast<double>(solvers);
  return {.test = Plan::Test::means, .significance = plan.significance / (k * (k - 1) / 2), .margin = plan.margin};
}

Verdict verdict_of(const Group& own, const Group& theirs, const Claim& claim, const Plan& plan) {
  const Metric& metric = *claim.metrics.front();
  Observations of{.metric = std::string(metric.slug),
                  .quantity = std::string(metric.name),
                  .scale = metric.scale,
                  .floor = metric.floor,
                  .rounding = metric.rounding,
                  .groups = {own, theirs}};
  return compare::compare(claim.of == Of::spread ? deviations(of) : of, plan).front().verdict;
}

// A choice of a solver: how the claim's solvers do against it.
struct Option {
  const Chosen& chosen;
  Holds holds;
  std::size_t explained;
};
using Options = std::vector<std::vector<Option>>;  // by solver

// Numbers of readings by how many printed numbers they explain; without `by_explained` all are the first.
std::vector<Shares> counted(const Options& options, bool by_explained) {
  std::vector<Shares> counts{{.holds = 1}};
  for (const std::vector<Option>& of_solver : options) {
    std::vector<Shares> next(counts.size() + (by_explained ? Explained().size() : 0));
    for (const Option& each : of_solver) {
      for (std::size_t i = 0; i < counts.size(); ++i) {
        const auto& [holds, fails, undecided] = counts[i];
        next[i + (by_explained ? each.explained : 0)].add(each.holds == Holds::holds ? counts[i]
                                                          : each.holds == Holds::fails
                                                              ? Shares{.fails = counts[i].all()}
                                                              : Shares{.fails = fails, .undecided = holds + undecided});
      }
    }
    counts = std::move(next);
  }
  return counts;
}

// Adds the readings of one choice of the study and of each of the claim's solvers.
void add(Counted& into, const Options& options, const Chosen& of_study, double weight, int near) {
  const Shares all = counted(options, false).front();
  into.shares.all.add(all, weight);
  const std::vector<Shares> by_explained = near > 0 ? counted(options, true) : std::vector<Shares>();
  for (auto i = static_cast<std::size_t>(near); i < by_explained.size(); ++i)
    into.shares.near.add(by_explained[i], weight);
  for (const auto& [dimension, alternative] : of_study) into.alternatives[dimension][alternative].add(all, weight);
  for (std::size_t s = 0; s < options.size(); ++s) {
    std::map<std::pair<std::size_t, std::size_t>, std::vector<Option>> by_choice;
    for (const Option& each : options[s]) {
      for (const auto& [dimension, alternative] : each.chosen) by_choice[{dimension, alternative}].push_back(each);
    }
    for (const auto& [choice, of_solver] : by_choice) {
      Options restricted;
      for (std::size_t i = 0; i < options.size(); ++i) restricted.push_back(i == s ? of_solver : options[i]);
      into.alternatives[choice.first][choice.second].add(counted(restricted, false).front(), weight);
    }
  }
}

// One of the combinations of the choices of these solvers: by solver, its choice; none after the last.
using OwnChoices = std::map<std::size_t, std::size_t>;
OwnChoices combination(const OfStudy& study, const std::vector<std::size_t>& solvers, std::size_t number) {
  OwnChoices chosen;
  for (const std::size_t solver : solvers) {
    chosen[solver] = number % study.solvers[solver].size();
    number /= study.solvers[solver].size();
  }
  return number == 0 ? chosen : OwnChoices();
}

// None if a solver of the claim is missing.
std::optional<Counted> count_claim(const Multiverse& multiverse, const Claim& claim, const results::Plan& plan,
                                   const ExplainedReadings& explained, int near) {
  const Names& solvers = multiverse.solvers;
  const std::size_t k = solvers.size(), seeds = multiverse.studies[0].solvers[0][0].means[0].size();
  const std::size_t metric = claim.metrics.front()->column == metrics_of_readings[0] ? 0 : 1;
  std::vector<std::size_t> own, rivals;
  for (const std::string& solver : claim.solvers) own.push_back(place_of(solvers, solver));
  for (const std::string& solver : claim.against.empty() ? solvers : claim.against) {
    if (std::ranges::find(claim.solvers, solver) == claim.solvers.end()) rivals.push_back(place_of(solvers, solver));
  }
  const auto has = [](const auto& all, std::size_t s) { return std::ranges::find(all, s) != all.end(); };
  if (has(own, k) || has(rivals, k)) return {};
  const Plan of_pair = plan_of_pairs(plan, k);
  Counted result{.shares = {.id = claim.id, .all = {}}, .sentence = claim.sentence, .alternatives = {}};
  for (const Dimension& each : multiverse.dimensions) result.alternatives.emplace_back(each.alternatives.size());
  for (std::size_t g = 0; g < multiverse.studies.size(); ++g) {
    const OfStudy& study = multiverse.studies[g];
    for (std::size_t seed = 0; seed < seeds; ++seed) {
      std::map<std::pair<const ChosenSolver*, const ChosenSolver*>, Verdict> known;
      const auto verdict = [&](const ChosenSolver& one, const ChosenSolver& other) {
        const auto [found, is_new] = known.try_emplace({&one, &other});
        if (is_new) found->second = verdict_of(one.means[metric][seed], other.means[metric][seed], claim, of_pair);
        return found->second;
      };
      OwnChoices chosen;
      for (std::size_t number = 0; !(chosen = combination(study, own, number)).empty(); ++number) {
        Options options(k);
        for (std::size_t s = 0; s < k; ++s) {
          for (std::size_t c = 0; c < study.solvers[s].size(); ++c) {
            if (chosen.contains(s) && chosen.at(s) != c) continue;
            const ChosenSolver& theirs = study.solvers[s][c];
            Tally tally;
            for (const auto& [solver, choice] : chosen) {
              if (has(rivals, s)) tally.add(verdict(study.solvers[solver][choice], theirs));
            }
            options[s].push_back({theirs.chosen, holds_of(tally), explained.empty() ? 0 : explained[g][s][c].count()});
          }
        }
        add(result, options, study.chosen, study.weight / readings_of(study) / static_cast<double>(seeds), near);
      }
    }
  }
  return result;
}

// The largest difference between alternatives in the share that holds.
double difference(const std::vector<Shares>& alternatives) {
  double least = 1, most = 0;
  for (const Shares& each : alternatives) {
    if (each.all() == 0) continue;
    least = std::min(least, each.holds / each.all());
    most = std::max(most, each.holds / each.all());
  }
  return std::max(0.0, most - least);
}

// "who obeys limits: 0 % where no solver is clamped, 28 % where all but IK-BA are"
std::string words_of(const Dimension& dimension, const std::vector<Shares>& alternatives) {
  Names words;
  for (std::size_t a = 0; a < alternatives.size(); ++a) {
    const Shares& each = alternatives[a];
    if (each.all() > 0)
      words.push_back(fmt::format("{} where {}", percent(each.holds / each.all()), dimension.alternatives[a].where));
  }
  return fmt::format("{}: {}", dimension.open, fmt::join(words, ", "));
}

show::Table table_of(const Multiverse& multiverse, const std::vector<Counted>& claims) {
  show::Table table{.name = "multiverse", .caption = "The claims in every reading", .columns = {{"claim"}}};
  for (const std::string near : {"", "near: "}) {
    for (const Holds part : {Holds::holds, Holds::fails, Holds::undecided})
      table.columns.push_back({near + std::string(name_of(part)), "%"});
  }
  table.columns.push_back({"decided most by"});
  double readings = 0;
  for (const OfStudy& study : multiverse.studies) readings += readings_of(study);
  for (const auto& [shares, sentence, alternatives] : claims) {
    auto& row = table.rows.emplace_back(std::vector<show::Cell>{sentence});
    for (const Shares* of : {&shares.all, &shares.near}) {
      for (const double part : {of->holds, of->fails, of->undecided})
        if (row.emplace_back(); of->all() > 0) row.back() = 100 * part / of->all();
    }
    const auto most = std::ranges::max_element(alternatives, {}, difference);
    const bool is_decided = most != alternatives.end() && difference(*most) > 0;
    const auto place = static_cast<std::size_t>(most - alternatives.begin());
    if (row.emplace_back(); is_decided) row.back() = words_of(multiverse.dimensions[place], *most);
  }
  table.notes = {fmt::format(
      "{:.0f} readings, all counted: {} choices for the study, each with every combination of the solvers' own. Each pair "
      "is judged alone, at significance / pairs.",
      readings, multiverse.studies.size())};
  return table;
}

// The printed numbers.

// The runs of all seeds; none if some are lost.
std::vector<double> pooled(const ChosenSolver& own, std::size_t metric) {
  std::vector<double> all;
  for (const Group& seed : own.means[metric]) {
    if (seed.lost > 0) return {};
    all.insert(all.end(), seed.values.begin(), seed.values.end());
  }
  return all;
}

// A number is explained if it lies, but for its rounding, in the range that 95 % of studies with as many runs would
// have.
ExplainedReadings explained_in(const Multiverse& multiverse, const PrintedMetrics& printed) {
  std::map<std::vector<double>, std::optional<Ranges>> known;  // many readings share a series
  ExplainedReadings explained;
  for (const OfStudy& study : multiverse.studies) {
    explained.emplace_back(study.solvers.size());
    for (std::size_t s = 0; s < study.solvers.size(); ++s) {
      for (const ChosenSolver& own : study.solvers[s]) {
        Explained& its = explained.back()[s].emplace_back();
        for (std::size_t m = 0; m < printed.size(); ++m) {
          const PrintedRow* const row = row_of(printed[m], multiverse.solvers[s]);
          if (row == nullptr) continue;
          const auto [found, is_new] = known.try_emplace(pooled(own, m));
          if (is_new) found->second = predicted_ranges(found->first, row->numbers.n);
          for (std::size_t i = 0; i < statistics.size(); ++i) {
            its[m * statistics.size() + i] = found->second && can_be((*found->second)[i], row->digits[i]);
          }
        }
      }
    }
  }
  return explained;
}

// Readings drawn at random by their weights, the same each time; a seed of each. The side is the verdict of the claim
// that the solver is the most accurate, and the interval has the level at which claims judge a pair.
figures::Figure curve(const Multiverse& multiverse, const std::string& solver, const Plan& plan) {
  constexpr std::size_t drawn = 150;
  const std::size_t own = place_of(multiverse.solvers, solver);
  figures::Specifications rows{
      .groups = {}, .all = {}, .below = solver + " is more accurate than all", .above = "a rival is more accurate"};
  const Plan of_pair = plan_of_pairs(plan, multiverse.solvers.size());
  const double z = boost::math::quantile(boost::math::complement(boost::math::normal(), of_pair.significance / 2));
  Claim claim;
  claim.metrics = {&metric_named(metrics_of_readings[0])};
  std::map<std::size_t, std::size_t> groups;  // by dimension
  for (std::size_t d = 0; d < multiverse.dimensions.size(); ++d) {
    const Dimension& dimension = multiverse.dimensions[d];
    if (!dimension.solver.empty() && dimension.solver != solver) continue;
    groups.emplace(d, groups.size());
    rows.groups.emplace_back();
    for (const auto& alternative : dimension.alternatives) rows.groups.back().push_back(alternative.set);
  }
  rows.groups.emplace_back();
  for (const std::string& name : multiverse.solvers) {
    if (name != solver) rows.groups.back().push_back("best rival: " + name);
  }
  std::mt19937_64 engine(1);
  double before = 0;
  auto study = multiverse.studies.begin();
  for (std::size_t i = 0; i < drawn; ++i) {
    while (study + 1 != multiverse.studies.end() && before + study->weight < (static_cast<double>(i) + 0.5) / drawn)
      before += (study++)->weight;
    std::vector<Summary> means;
    std::vector<Group> errors;
    std::vector<std::size_t> choices(groups.size() + 1);
    Chosen chosen = study->chosen;
    for (const std::vector<ChosenSolver>& of_solver : study->solvers) {
      const ChosenSolver& each = of_solver[engine() % of_solver.size()];
      if (means.size() == own) chosen.insert(chosen.end(), each.chosen.begin(), each.chosen.end());
      errors.push_back(each.means[0][i % each.means[0].size()]);
      means.push_back(errors.back().lost > 0 ? Summary() : summarise(errors.back().values));
    }
    Tally tally;
    std::size_t rival = own;
    for (std::size_t s = 0; s < means.size(); ++s) {
      const bool is_smaller = rival == own || means[s].mean < means[rival].mean;
      if (s != own && means[s].mean > 0 && is_smaller) rival = s;
      if (s != own) tally.add(verdict_of(errors[own], errors[s], claim, of_pair));
    }
    if (rival == own || means[own].mean == 0) continue;
    choices.back() = rival < own ? rival : rival - 1;
    for (const auto& [dimension, alternative] : chosen) choices[groups.at(dimension)] = alternative;
    const auto error = [](const Summary& of) { return of.sd / std::sqrt(of.n) / of.mean; };
    const double ratio = means[own].mean / means[rival].mean;
    const double factor = std::exp(z * std::hypot(error(means[own]), error(means[rival])));
    rows.all.push_back({ratio, ratio / factor, ratio * factor, tally.worse > 0 ? 1 : tally.open > 0 ? 0 : -1, choices});
  }
  std::ranges::stable_sort(rows.all, {}, &figures::Specification::estimate);
  return figures::specifications(
      {.name = "multiverse",
       .caption = fmt::format(
           "Mean error of {} by that of its best rival in {} readings drawn by their weights, with "
           "intervals of {:.1f} %. Colours: whether it is more accurate than all, each pair judged at {:g} / "
           "{:g} as in the table, by the difference of means, which may be open where the ratio is far from "
           "1. Below: the choices of each.",
           solver, rows.all.size(), 100 * (1 - of_pair.significance), plan.significance,
           plan.significance / of_pair.significance),
       .quantity = fmt::format("mean error of {} / of its best rival", solver)},
      rows);
}

}  // namespace

JudgedMultiverse judged(const Paper& paper, const Multiverse& multiverse, const results::Plan& plan) {
  PrintedMetrics printed;
  std::size_t numbers = 0;
  int printed_runs = 0;
  for (std::size_t m = 0; m < printed.size() && !paper.means.empty(); ++m) {
    printed[m] = printed_means(paper.name, paper.means, metrics_of_readings[m]);
    for (const PrintedRow& row : printed[m]) {
      if (place_of(multiverse.solvers, row.solver) == multiverse.solvers.size()) continue;
      numbers += statistics.size();
      printed_runs = row.numbers.n;
    }
  }
  const Group& first = multiverse.studies[0].solvers[0][0].means[0].front();
  const int runs = static_cast<int>(first.values.size()) + first.lost;
  const bool can_compare = numbers > 0 && runs == printed_runs;
  const ExplainedReadings explained = can_compare ? explained_in(multiverse, printed) : ExplainedReadings();
  std::vector<Counted> claims;
  JudgedMultiverse result{.claims = {}, .table = {}, .figure = curve(multiverse, paper.solver, plan)};
  for (const Claim& claim : paper.claims) {
    if (!hangs_on_reading(claim)) continue;
    auto counts = count_claim(multiverse, claim, plan, explained, can_compare ? paper.near : 0);
    if (!counts) continue;
    result.claims.push_back(counts->shares);
    claims.push_back(std::move(*counts));
  }
  result.table = table_of(multiverse, claims);
  if (can_compare && !claims.empty())
    result.table.notes.push_back(
        fmt::format("near: readings that explain at least {} of the {} printed numbers, {} of all.", paper.near,
                    numbers, percent(result.claims.front().near.all())));
  if (numbers > 0 && !can_compare)
    result.table.notes.push_back(
        fmt::format("The paper has {} runs, this has {}: not compared with print.", printed_runs, runs));
  return result;
}

}  // namespace ikbench::papers
