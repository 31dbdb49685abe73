#include "analysis/inference/together.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/design.hpp"
#include "analysis/inference/estimand.hpp"
#include "analysis/inference/text.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

// The groups of one name, one of each study; empty if a study lacks it.
std::vector<const Group*> groups_named(const std::vector<OfStudy>& all, const std::string& name) {
  std::vector<const Group*> groups;
  for (const OfStudy& of : all) groups.push_back(group_named(of.observations.groups, name));
  if (std::ranges::find(groups, nullptr) != groups.end()) groups.clear();
  return groups;
}

// The number of runs that every study has of the group; copies of a run are as many runs as they are.
std::size_t common_runs_of(const std::vector<const Group*>& groups) {
  std::size_t runs = std::numeric_limits<std::size_t>::max();
  for (const Group* group : groups) {
    if (group->copies == 0 || group->values.empty()) runs = std::min(runs, group->values.size());
  }
  return runs;
}

// The means over the studies. If all runs are copies in every study, so is their mean.
void add_means_of_runs(Group& result, const std::vector<const Group*>& groups) {
  std::size_t runs = common_runs_of(groups);
  if (runs == std::numeric_limits<std::size_t>::max()) {
    runs = 1;
    result.copies = (*std::ranges::min_element(groups, {}, &Group::copies))->copies;
  }
  for (std::size_t run = 0; run < runs; ++run) {
    std::vector<double> values;
    for (const Group* group : groups) values.push_back(group->values[group->copies > 0 ? 0 : run]);
    result.values.push_back(mean(values));
  }
}

// Notes that all studies have stand once; the others name their study.
std::vector<std::string> notes_of(const std::vector<OfStudy>& all, std::vector<std::string> Observations::*notes) {
  std::vector<std::string> result;
  for (const OfStudy& of : all) {
    for (const std::string& note : of.observations.*notes) {
      const bool is_of_all = std::ranges::all_of(
          all, [&](const OfStudy& other) { return std::ranges::count(other.observations.*notes, note) > 0; });
      std::string own_note = is_of_all ? note : fmt::format("{}: {}", of.study, note);
      if (std::ranges::count(result, own_note) == 0) result.push_back(std::move(own_note));
    }
  }
  return result;
}

template <class Of>
bool is_same_in_all(const std::vector<OfStudy>& all, Of Observations::*member) {
  return std::ranges::all_of(
      all, [&](const OfStudy& of) { return of.observations.*member == all.front().observations.*member; });
}

void describe_runs(Observations& result, const std::vector<OfStudy>& all) {
  result.replicate = fmt::format("the mean over {} studies of a run", all.size());
  std::vector<std::string> shorter;
  for (const Group& group : result.groups) {
    const auto groups = groups_named(all, group.name);
    const std::size_t common = common_runs_of(groups);
    const bool has_more =
        std::ranges::any_of(groups, [&](const Group* of) { return of->copies == 0 && of->values.size() > common; });
    if (has_more) shorter.push_back(fmt::format("{} ({} runs)", one_line(group.name), common));
  }
  if (!shorter.empty()) {
    result.notes.push_back(
        fmt::format("Only runs that every study has count, the first of each: {}.", fmt::join(shorter, ", ")));
  }
}

void describe_seeds(Observations& result, const std::vector<OfStudy>& all) {
  for (const OfStudy& of : all) result.blocks.push_back(of.study);
  result.replicate = "the mean over the runs of a seed";
  result.block = "a seed of the study, the same for all solvers";
  result.block_noun = "seeds";
}

void describe_blocks(Observations& result, const std::vector<OfStudy>& all) {
  std::vector<std::string> counts;
  for (const OfStudy& of : all) {
    for (const std::string& block : of.observations.blocks)
      result.blocks.push_back(fmt::format("{}: {}", of.study, block));
    counts.push_back(fmt::format("{} of {}", of.observations.blocks.size(), of.study));
  }
  if (!is_same_in_all(all, &Observations::block_noun)) result.block_noun = "problems";
  result.block = "a problem of one of the studies, the same for all solvers";
  if (!is_same_in_all(all, &Observations::replicate)) result.replicate = "a solver's value of a problem";
  result.notes.push_back(
      fmt::format("The {} of all studies count alike: {}.", result.block_noun, fmt::join(counts, ", ")));
}

}  // namespace

Observations together(std::vector<OfStudy> all, bool are_seeds) {
  Observations result = all.front().observations;
  const bool have_blocks = !result.blocks.empty();
  result.groups.clear();
  result.blocks.clear();
  result.counting = notes_of(all, &Observations::counting);
  result.notes = notes_of(all, &Observations::notes);
  result.flaws.clear();
  std::vector<std::string> lacking;
  for (const OfStudy& of : all) {
    Doubts flaws = of.observations.flaws;
    for (Doubt& flaw : flaws) flaw.studies.push_back(of.study);
    result.flaws = result.flaws + flaws;
    for (const Group& own : of.observations.groups) {
      if (group_named(result.groups, own.name) != nullptr || std::ranges::count(lacking, own.name) > 0) continue;
      const std::vector<const Group*> groups = groups_named(all, own.name);
      if (groups.empty()) {
        lacking.push_back(own.name);
        continue;
      }
      Group group{.name = own.name, .style = own.style};
      const auto widest = std::ranges::max_element(
          groups, {}, [](const Group* each) { return std::isnan(each->decades) ? -1 : each->decades; });
      group.decades = (*widest)->decades;
      if (!are_seeds && !have_blocks) {
        add_means_of_runs(group, groups);
      } else {
        for (const Group* each : groups) {
          if (are_seeds)
            group.values.push_back(mean(each->values));
          else
            std::ranges::copy(each->values, std::back_inserter(group.values));
        }
      }
      result.groups.push_back(std::move(group));
    }
  }
  // Groups have the same bits if they have them in every study.
  mark_same_bits(result.groups, [&](const Group& one, const Group& other) {
    return std::ranges::all_of(all, [&](const OfStudy& of) {
      const std::size_t bits = group_named(of.observations.groups, one.name)->bits;
      return bits > 0 && bits == group_named(of.observations.groups, other.name)->bits;
    });
  });
  if (are_seeds)
    describe_seeds(result, all);
  else if (have_blocks)
    describe_blocks(result, all);
  else
    describe_runs(result, all);
  if (!lacking.empty()) {
    result.notes.push_back(fmt::format("Left out, because not every study has them: {}.",
                                       one_line(fmt::format("{}", fmt::join(lacking, ", ")))));
  }
  return result;
}

Observations together(const JudgedStudies& studies, Metric metric, Estimand estimand, bool are_seeds) {
  std::vector<OfStudy> all;
  for (const JudgedStudy& study : studies) all.push_back({study.name, observations(study, metric, estimand)});
  const auto has_blocks = [](const OfStudy& of) { return !of.observations.blocks.empty(); };
  if (are_seeds || !std::ranges::all_of(all, has_blocks)) {
    all.clear();
    for (const JudgedStudy& study : studies) all.push_back({study.name, observations_of_runs(study, metric, estimand)});
  }
  const bool is_one_quantity = is_same_in_all(all, &Observations::quantity);
  Observations result = together(std::move(all), are_seeds);
  if (!is_one_quantity) {
    result.quantity = estimand == Estimand::reliability
                          ? "share of solves within each study's distance"
                          : (estimand == Estimand::typical ? "typical " : "") + quantity(metric);
  }
  result.name = "together-" + result.name;
  return result;
}

std::vector<Judged> judged_together(const JudgedStudies& studies) {
  const JudgedStudy& first = studies.front();
  std::vector<Judged> judged;
  for (const Metric metric : shown_metrics(first)) {
    const bool is_in_all = std::ranges::all_of(studies, [&](const JudgedStudy& study) {
      return is_comparable(study, metric) && std::ranges::count(shown_metrics(study), metric) > 0;
    });
    if (!is_in_all) continue;
    for (const Estimand estimand : estimands_of(first, metric)) {
      const bool all_have = std::ranges::all_of(studies, [&](const JudgedStudy& study) {
        return std::ranges::count(estimands_of(study, metric), estimand) > 0;
      });
      if (all_have) judged.push_back({metric, estimand});
    }
  }
  // The deciding estimand is that of all studies if they have one.
  const Estimand decides = primary_estimand(first);
  const bool is_of_all =
      std::ranges::all_of(studies, [&](const JudgedStudy& study) { return primary_estimand(study) == decides; });
  const Estimand wanted = is_of_all ? decides : first.plan.estimands.front();
  std::stable_partition(judged.begin(), judged.end(), [&](const Judged& each) {
    return each.metric == Metric::position_error_cm && each.estimand == wanted;
  });
  return judged;
}

}  // namespace ikbench::inference
