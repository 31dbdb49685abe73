#include "analysis/show/hard_targets.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

#include "analysis/show/text.hpp"

namespace ikbench::show {

using namespace judge;

namespace {

constexpr std::size_t max_listed = 10'000, max_shown = 10;  // targets, in files and on a page

// Returns the first targets in the order of difficulty: those that the fewest solvers solve come first.
std::vector<std::size_t> hardest(const SolvedTargets& all) {
  std::vector<std::size_t> order(all.targets.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return all.targets[i].solvers; });
  order.resize(std::min(order.size(), max_listed));
  return order;
}

// Returns "; DE and IK-BA together solve the other 18".
std::string others_clause(const HardTargets& hard) {
  const std::size_t solvable = hard.targets - hard.unsolved;
  const std::string others = solvable == 1 ? "the other one" : fmt::format("the other {}", solvable);
  if (hard.alone.size() == 1) return fmt::format("; {} solves {}", hard.alone.front(), others);
  if (hard.alone.size() > max_named) return fmt::format("; {} solvers each solve {}", hard.alone.size(), others);
  if (!hard.alone.empty()) return fmt::format("; {} each solve {}", listed(hard.alone), others);
  const std::string together = listed(hard.together);
  if (hard.solved_together == solvable) return fmt::format("; {} together solve {}", together, others);
  return fmt::format("; {} together solve {} of {}, and no two solve more", together, hard.solved_together, others);
}

}  // namespace

Table targets_table(const SolvedTargets& all) {
  Table table{.name = "targets",
              .caption = "Targets, the hardest first",
              .columns = named_columns({"run", "target", "solvers", "solved by", "fewest evaluations", "fewest by",
                                        "least time", "fastest"}),
              .visible_rows = max_shown};
  if (all.targets.size() < 2) return table;
  table.columns[6].unit = "ms";
  for (const std::size_t i : hardest(all)) {
    const SolvedTarget& target = all.targets[i];
    std::vector<std::string> solvers;
    for (std::size_t solver = 0; solver < all.solvers.size(); ++solver)
      if (all.solves(solver, i)) solvers.push_back(all.solvers[solver]);
    const auto& evaluations = target.fewest_evaluations;
    const auto& seconds = target.least_seconds;
    table.rows.push_back(
        {target.run == 0 ? Cell() : Cell(std::int64_t{target.run}), std::int64_t{target.point},
         static_cast<std::int64_t>(target.solvers), text_cell(fmt::format("{}", fmt::join(solvers, "; "))),
         evaluations ? Cell(evaluations->second) : Cell(), evaluations ? Cell(all.solvers[evaluations->first]) : Cell(),
         seconds ? Cell(1000 * seconds->second) : Cell(), seconds ? Cell(all.solvers[seconds->first]) : Cell()});
  }
  table.notes = {
      fmt::format("Solvers: of {}, how many solve the target{}. Evaluations and time are the least of any solve that "
                  "solved it (not tested).",
                  all.solvers.size(), all.are_repeated ? " in at least one run" : "")};
  if (table.rows.size() < all.targets.size())
    table.notes.push_back(fmt::format("{} easier targets are not listed.", all.targets.size() - table.rows.size()));
  return table;
}

std::string hard_targets_sentence(const HardTargets& hard) {
  if (hard.unsolved > 0)
    return fmt::format("No solver solves {} of the {} targets{}{}.", hard.unsolved, hard.targets,
                       hard.are_repeated ? " in any run" : "", others_clause(hard));
  const std::string first = fmt::format("No solver alone solves all {} targets{}; {} together ", hard.targets,
                                        hard.are_repeated ? ", each in some run" : "", listed(hard.together));
  if (hard.solved_together == hard.targets) return first + "do.";
  return first + fmt::format("solve {}, and no two solve more.", hard.solved_together);
}

nlohmann::ordered_json hard_targets_json(const HardTargets& hard) {
  const bool is_any_alone = !hard.alone.empty();
  return {{"sentence", hard_targets_sentence(hard)},
          {"targets", hard.targets},
          {"unsolved", hard.unsolved},
          {"solvers", is_any_alone ? std::vector{hard.alone.front()} : hard.together},
          {"solved", is_any_alone ? hard.targets - hard.unsolved : hard.solved_together}};
}

}  // namespace ikbench::show
