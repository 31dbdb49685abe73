#include "analysis/papers/multiverse.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bitset>
#include <cmath>
#include <iterator>
#include <utility>

#include "analysis/papers/published.hpp"
#include "analysis/papers/rules.hpp"
#include "analysis/show/text.hpp"
#include "base/names.hpp"

namespace ikbench::papers {

using namespace judge;
using results::Choice;
using results::Chosen;
using results::Dimension;

namespace {

using ChosenSolver = SolvedMultiverse::ChosenSolver;
using OfStudy = SolvedMultiverse::OfStudy;
using Names = std::vector<std::string>;

bool contains(const auto& all, const auto& one) { return std::ranges::find(all, one) != all.end(); }

std::size_t place_of(const Names& all, std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(all, name) - all.begin());
}

// If it is that a solver is better in error, variation or their spread.
bool hangs_on_reading(const Claim& claim) {
  return claim.rule != nullptr && claim.rule->name == "better" && claim.metrics.size() == 1 && claim.study.empty() &&
         contains(metrics_of_readings, claim.metrics.front()->column);
}

Verdict verdict_of(const Group& own, const Group& theirs, const Claim& claim, const Plan& plan) {
  const Metric& metric = *claim.metrics.front();
  Observations observed{.metric = std::string(metric.slug),
                        .quantity = std::string(metric.name),
                        .scale = metric.scale,
                        .floor = metric.floor,
                        .rounding = metric.rounding,
                        .groups = {own, theirs}};
  return judge::verdict_of(judge::compare(claim.of == Of::spread ? deviations(observed) : observed, plan).front());
}

// How the claim's solvers, by one choice of the study and of each of them, do against each choice of each rival.
struct Against {
  const Chosen* chosen;
  Holds holds;
};
struct Part {
  Chosen chosen;
  std::vector<std::vector<Against>> rivals;
  double others;  // choices of solvers that the claim is not about
};

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
std::vector<Part> parts_of(const SolvedMultiverse& multiverse, const Claim& claim, const results::Plan& plan) {
  const Names& solvers = multiverse.solvers;
  const std::size_t k = solvers.size(), metric = claim.metrics.front()->column == metrics_of_readings[0] ? 0 : 1;
  std::vector<std::size_t> own, rivals;
  for (const std::string& solver : claim.solvers) own.push_back(place_of(solvers, solver));
  for (const std::string& solver : claim.against.empty() ? solvers : claim.against) {
    if (!contains(claim.solvers, solver)) rivals.push_back(place_of(solvers, solver));
  }
  if (contains(own, k) || contains(rivals, k)) return {};
  // Of each pair alone, by Welch's t, at its part of the significance, as a report judges a pair of these solvers.
  const Plan of_pair{.test = Plan::Test::means,
                     .significance = plan.significance / (static_cast<double>(k * (k - 1)) / 2),
                     .margin = plan.margin};
  std::vector<Part> parts;
  for (const OfStudy& study : multiverse.studies) {
    for (std::size_t seed = 0; seed < study.solvers[0][0].parts.size(); ++seed) {
      const auto verdict = [&](const ChosenSolver& one, const ChosenSolver& other) {
        return verdict_of(multiverse.means[one.parts[seed]][metric], multiverse.means[other.parts[seed]][metric], claim,
                          of_pair);
      };
      OwnChoices chosen;
      for (std::size_t number = 0; !(chosen = combination(study, own, number)).empty(); ++number) {
        Part& part = parts.emplace_back(Part{study.chosen, {}, study.readings()});
        for (const auto& [solver, choice] : chosen) {
          const Chosen& more = study.solvers[solver][choice].chosen;
          part.chosen.insert(part.chosen.end(), more.begin(), more.end());
          part.others /= static_cast<double>(study.solvers[solver].size());
        }
        for (const std::size_t rival : rivals) {
          part.others /= static_cast<double>(study.solvers[rival].size());
          std::vector<Against>& against = part.rivals.emplace_back();
          for (const ChosenSolver& theirs : study.solvers[rival]) {
            Tally tally;
            for (const auto& [solver, choice] : chosen) tally.add(verdict(study.solvers[solver][choice], theirs));
            against.push_back({&theirs.chosen, holds_of(tally)});
          }
        }
      }
    }
  }
  return parts;
}

// Of a part, those that have another answer than this one.
InReadings count(const Part& part, const Choice* without = nullptr) {
  if (without != nullptr && contains(part.chosen, *without)) return {};
  double all = part.others, hold = all, fail_not = all;
  for (const std::vector<Against>& rival : part.rivals) {
    double options = 0, better = 0, worse = 0;
    for (const auto& [chosen, holds] : rival) {
      if (without != nullptr && contains(*chosen, *without)) continue;
      ++options;
      better += holds == Holds::holds;
      worse += holds == Holds::fails;
    }
    all *= options;
    hold *= better;
    fail_not *= options - worse;
  }
  return {hold, all - fail_not, fail_not - hold};
}

InReadings in_readings(const SolvedMultiverse& multiverse, const std::vector<Part>& parts) {
  InReadings of_all;
  for (const Part& part : parts) {
    const InReadings counts = count(part);
    of_all.hold += counts.hold, of_all.fail += counts.fail, of_all.open += counts.open;
  }
  double fewest = of_all.fail;  // without one answer, other than a default
  for (std::size_t d = 0; d < multiverse.dimensions.size(); ++d) {
    for (std::size_t a = 1; a < multiverse.dimensions[d].alternatives.size(); ++a) {
      const Choice answer{d, a};
      double without = 0;
      for (const Part& part : parts) without += count(part, &answer).fail;
      if (without >= fewest) continue;
      fewest = without;
      const results::Alternative& its = multiverse.dimensions[d].alternatives[a];
      of_all.most_fail = fmt::format("{:.0f} with {} ({})", of_all.fail - without, its.set, its.where);
    }
  }
  return of_all;
}

}  // namespace

Group group_of(std::vector<double> runs) {
  const auto lost = static_cast<int>(std::erase_if(runs, [](double value) { return !std::isfinite(value); }));
  if (lost > 0) return {.sample = Untold{.lost = lost, .values = std::move(runs)}};
  return {.sample = Measured{std::move(runs)}};
}

JudgedMultiverse judged(const Paper& paper, const SolvedMultiverse& multiverse, const results::Plan& plan) {
  JudgedMultiverse result{.in_readings = {},
                          .table = {.name = "multiverse",
                                    .caption = "The claims in every reading",
                                    .columns = show::columns_of(
                                        {"claim", "holds", "fails", "not decided", "most failures with one answer"}),
                                    .is_of_study = false}};
  for (const Claim& claim : paper.claims) {
    if (!hangs_on_reading(claim)) continue;
    const std::vector<Part> parts = parts_of(multiverse, claim, plan);
    if (parts.empty()) continue;
    const InReadings& counts = result.in_readings[claim.id] = in_readings(multiverse, parts);
    const auto number = [](double count) { return static_cast<std::int64_t>(count); };
    result.table.rows.push_back({claim.sentence, number(counts.hold), number(counts.fail), number(counts.open),
                                 counts.most_fail.empty() ? "none" : counts.most_fail});
  }
  const std::size_t seeds = multiverse.studies[0].solvers[0][0].parts.size();
  const std::int64_t solvers = std::ssize(multiverse.solvers), pairs = solvers * (solvers - 1) / 2;
  result.table.notes = {
      fmt::format(
          "{:.0f} readings{}. A claim holds where its solvers are better than each rival, and fails where a rival is "
          "better, by Welch's t (spreads: of distances from the median) at {:g} / {} ({} of solvers).",
          static_cast<double>(seeds) * multiverse.readings(),
          seeds > 1 ? fmt::format(": {:.0f}, each with seeds 1 to {}", multiverse.readings(), seeds) : "",
          plan.significance, pairs, base::counted(pairs, "pairs")),
      fmt::format("A reading answers {} of the questions that the paper leaves open. Counts depend on the answers "
                  "listed; they are no probabilities.",
                  multiverse.dimensions.size())};
  return result;
}

namespace {

using TableOfMeans = std::array<PrintedRows, metrics_of_readings.size()>;
constexpr std::size_t numbers_of_row = metrics_of_readings.size() * statistics.size();
using Numbers = std::bitset<numbers_of_row>;  // by metric, then statistic

// One choice of a solver's with one of the study's.
struct Tried {
  Chosen departures = {};
  std::array<Description, metrics_of_readings.size()> ours = {};
  std::vector<Numbers> inside = {};  // by printed row
  std::size_t own = 0, foreign = 0, whose = 0;
  std::size_t study = 0;
  std::int64_t together = 0;  // of all rows, if the others have the study's departures alone
};

Tried tried(const SolvedMultiverse& multiverse, std::size_t study, const ChosenSolver& chosen,
            const TableOfMeans& printed, std::size_t own_row) {
  Tried result{.inside = std::vector<Numbers>(printed[0].size()), .study = study};
  for (const Chosen* const choices : {&multiverse.studies[study].chosen, &chosen.chosen})
    std::ranges::copy_if(*choices, std::back_inserter(result.departures), &Choice::alternative);
  for (std::size_t m = 0; m < printed.size(); ++m) {
    std::vector<double> values;
    for (const std::size_t part : chosen.parts) {
      const Group& group = multiverse.means[part][m];
      values.insert(values.end(), values_of(group).begin(), values_of(group).end());
      if (lost_in(group) > 0) values.push_back(0);  // of which no ranges are
    }
    const auto ranges = predicted_ranges(values, printed[m][own_row].numbers.n);
    if (!ranges) continue;
    result.ours[m] = described(values);
    for (std::size_t i = 0; i < statistics.size() * result.inside.size(); ++i) {
      const std::size_t row = i / statistics.size(), s = i % statistics.size();
      result.inside[row][m * statistics.size() + s] =
          repeats(result.ours[m].*statistics[s].of, (*ranges)[s], printed[m][row].digits[s]);
    }
  }
  for (std::size_t row = 0; row < result.inside.size(); ++row) {
    const std::size_t count = result.inside[row].count();
    if (row == own_row)
      result.own = count;
    else if (count >= result.foreign)
      result.foreign = count, result.whose = row;
  }
  return result;
}

std::vector<std::vector<Tried>> tried_by_row(const SolvedMultiverse& multiverse, const TableOfMeans& printed) {
  std::vector<std::vector<Tried>> by_row(printed[0].size());
  std::vector<std::int64_t> in_study(multiverse.studies.size());
  for (std::size_t row = 0; row < by_row.size(); ++row) {
    const std::size_t solver = place_of(multiverse.solvers, printed[0][row].solver);
    if (solver == multiverse.solvers.size()) continue;
    for (std::size_t study = 0; study < in_study.size(); ++study) {
      std::int64_t usual = -1;
      for (const ChosenSolver& chosen : multiverse.studies[study].solvers[solver]) {
        Tried& one = by_row[row].emplace_back(tried(multiverse, study, chosen, printed, row));
        const auto own = static_cast<std::int64_t>(one.own);
        if (usual < 0) in_study[study] += usual = own;
        one.together = own - usual;
      }
    }
  }
  for (std::vector<Tried>& all : by_row)
    for (Tried& each : all) each.together += in_study[each.study];
  return by_row;
}

// Printed numbers, alone and together, in words; of one alone whose it is, "DE's error", and which, "mean".
struct Target {
  std::string words;
  Numbers numbers;
  std::string whose = {}, which = {};
};
std::vector<Target> targets(const TableOfMeans& printed, std::size_t row, const Tried& usual) {
  std::vector<Target> all;
  const Numbers of_metric((1U << statistics.size()) - 1);
  for (std::size_t m = 0; m < printed.size(); ++m) {
    const Metric& metric = metric_named(metrics_of_readings[m]);
    for (std::size_t s = 0; s < statistics.size(); ++s)
      all.push_back({fmt::format("{}, {} {} {} (here {})", metric.name, statistics[s].column, printed[m][row].digits[s],
                                 metric.unit, show::number_text(usual.ours[m].*statistics[s].of)),
                     Numbers(1U << (m * statistics.size() + s)),
                     fmt::format("{}'s {}", printed[m][row].solver, metric.name), std::string(statistics[s].column)});
    all.push_back({fmt::format("{}, all {}", metric.name, statistics.size()), of_metric << (m * statistics.size())});
  }
  all.push_back({fmt::format("all {}", numbers_of_row), Numbers().set()});
  return all;
}

}  // namespace

Explanation explained(const Paper& paper, const SolvedMultiverse& multiverse) {
  const TableOfMeans printed{printed_means(paper.name, paper.means, metrics_of_readings[0]),
                             printed_means(paper.name, paper.means, metrics_of_readings[1])};
  const std::string own = fmt::format("of its {}", numbers_of_row), foreign = "of another row",
                    together = fmt::format("of all {}", numbers_of_row * printed[0].size());
  Explanation result{
      .numbers = {.name = "explained",
                  .caption = "Printed numbers that are not the default's, and the fewest departures that have them",
                  .columns = show::columns_of(
                      {"solver", "printed", "departures", "sets", "best set", own, foreign, together})},
      .rows = {.name = "rows",
               .caption = "The best reading of each printed row",
               .columns = show::columns_of({"solver", "default", "best", "by", foreign, "by any reading"})},
      .readings = {.name = "readings",
                   .caption = "How many printed numbers each reading has",
                   .columns = show::columns_of({"solver", "departures", "reading", own, foreign, together})}};
  result.numbers.notes = {
      fmt::format(
          "A number is a reading's if it is in the range that holds {:.0f} % of such numbers of new studies, by "
          "all its runs (seeds: {}); fewer than 5 give none.",
          100 * share_in_ranges, multiverse.studies[0].solvers[0][0].parts.size()),
      fmt::format(
          "The best of the sets has most of its solver's numbers; {}: the most of one other solver's; {}: where "
          "the others have its departures for the study.",
          foreign, together)};
  const auto count = [](auto number) { return static_cast<std::int64_t>(number); };
  const auto words_of = [&](const Tried& tried) {
    Names sets;
    for (const auto& [d, a] : tried.departures) sets.push_back(multiverse.dimensions[d].alternatives[a].set);
    return sets.empty() ? "the default" : fmt::format("{}", fmt::join(sets, " and "));
  };
  const auto foreign_of = [&](const Tried& tried) {
    return fmt::format("{} ({})", tried.foreign, printed[0][tried.whose].solver);
  };
  std::vector<std::vector<Tried>> by_row = tried_by_row(multiverse, printed);
  std::map<std::string, std::map<std::string, Names>> by_reading;
  std::map<std::string, Names> by_none;
  for (std::size_t row = 0; row < by_row.size(); ++row) {
    const std::string& name = printed[0][row].solver;
    std::vector<Tried>& all = by_row[row];
    if (all.empty() || all.front().ours[0].n == 0) continue;
    std::ranges::stable_sort(
        all, {}, [](const Tried& each) { return std::pair(each.departures.size(), numbers_of_row - each.own); });
    const Tried& usual = all.front();
    for (const auto& [words, numbers, whose, which] : targets(printed, row, usual)) {
      const auto has = [&](const Tried& each) { return (each.inside[row] & numbers) == numbers; };
      const auto first = std::ranges::find_if(all, has);
      if (has(usual)) continue;
      if (!whose.empty()) (first == all.end() ? by_none : by_reading[words_of(*first)])[whose].push_back(which);
      if (first == all.end()) {
        result.numbers.rows.push_back({name, words, "none tried", {}, {}, {}, {}, {}});
        continue;
      }
      const std::size_t fewest = first->departures.size();
      const auto sets =
          std::ranges::count_if(all, [&](const Tried& each) { return each.departures.size() == fewest && has(each); });
      result.numbers.rows.push_back({name, words, count(fewest), count(sets), words_of(*first), count(first->own),
                                     foreign_of(*first), first->together});
    }
    const Tried &best = *std::ranges::max_element(all, {}, &Tried::own),
                &of_another = *std::ranges::max_element(all, {}, &Tried::foreign);
    result.rows.rows.push_back(
        {name, count(usual.own), count(best.own), words_of(best), foreign_of(best), foreign_of(of_another)});
    for (const Tried& each : all)
      result.readings.rows.push_back(
          {name, count(each.departures.size()), words_of(each), count(each.own), foreign_of(each), each.together});
  }
  Names parts;
  const auto add = [&](const std::string& reading, const std::map<std::string, Names>& numbers) {
    Names all;
    for (const auto& [whose, which] : numbers) all.push_back(whose + ' ' + show::listed(which));
    if (!all.empty()) parts.push_back(fmt::format("{}: {}", reading, show::listed(all, ", and ")));
  };
  for (const auto& [reading, numbers] : by_reading) add(reading, numbers);
  add("none", by_none);
  result.in_short = fmt::format("{}", fmt::join(parts, "; "));
  return result;
}

}  // namespace ikbench::papers
