#include "analysis/judge/data/imported.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

#include "analysis/judge/statistics/descriptives.hpp"
#include "base/units.hpp"
#include "results/merge.hpp"
#include "results/published.hpp"

namespace ikbench::judge {

using namespace results;

std::vector<std::string> archive_settings() {
  const base::CsvTable settings = published::table(archive_name, "settings");
  std::vector<std::string> options;
  for (std::size_t row = 0; row < settings.rows(); ++row)
    options.push_back(fmt::format("{}={}", settings.cell(row, 0), settings.cell(row, 1)));
  return options;
}

StudyResults read_archive(const std::string& robot) {
  constexpr std::string_view arms[]{"franka_panda", "kuka_iiwa14", "ur5e"};
  if (std::ranges::find(arms, robot) == std::end(arms))
    throw std::invalid_argument(fmt::format(
        "--beside {}: the archive has {}, but the study's arm is {}; expected one of these arms. To measure the "
        "libraries on your arm: solvers/programs/install.sh, then solvers/programs/libraries.sh {}",
        archive_name, fmt::join(arms, ", "), robot, robot));
  const base::CsvTable rows = published::table(archive_name, robot);
  const auto statuses = names_of(Status());
  StudyResults study;
  for (std::size_t row = 0; row < rows.rows(); ++row) {
    const auto cell = [&](std::string_view column) { return rows.cell(row, rows.column(column)); };
    const auto number = [&](std::string_view column) {
      return cell(column).empty() ? unknown : rows.number(row, column);
    };
    if (const std::string label(cell("library")); !label.empty()) {
      study.labels.push_back(label);
      study.series.push_back({label, label, std::string(cell("version")), "{}"});
      study.imported.origin = fmt::format("on another machine, {}", cell("month"));
    }
    const auto status = std::ranges::find(statuses, cell("status"));  // none: ok
    study.solves.push_back(
        {.run = static_cast<int>(number("run")),
         .label = static_cast<int>(std::ssize(study.labels) - 1),
         .status = status == statuses.end() ? Status::ok : static_cast<Status>(status - statuses.begin()),
         .counted_by = CountedBy::none,
         .position_error_cm = number("error_um") * 1e-4,
         .orientation_error_deg = number("rotation_urad") * 1e-6 / base::degree,
         .variation_deg = number("motion_deg"),
         .largest_move_deg = unknown,
         .seconds = number("time_us") * 1e-6,
         .second_difference_deg = unknown});
  }
  return study;
}

void require_same_study(const StudyResults& theirs, const StoredStudy& study) {
  const std::string difference = difference_in_solves(theirs.definition.json, study.definition.json);
  if (!difference.empty())
    throw std::invalid_argument(
        fmt::format("--beside: the studies differ in: {}; expected the same targets and limits", difference));
}

void add_imported(StudyResults& study, const StudyResults& theirs) {
  std::string& control = study.definition.plan.control;
  study.imported.is_control_chosen = control.empty();
  if (control.empty()) control = study.labels.front();
  study.imported.origin = theirs.imported.origin;
  for (results::Series series : theirs.series) {
    const Solves solves = theirs.of(series.label);
    const auto same = std::ranges::find_if(study.series, [&](const results::Series& own) {
      return own.algorithm == time_reference_solver && series.algorithm == time_reference_solver &&
             own.options == series.options && !study.imported.has(own.label);
    });
    if (study.imported.local_reference.empty() && same != study.series.end()) {
      study.imported.reference_seconds = describe_values(solve_times(theirs, series.label)).median;
      study.imported.local_reference = same->label;
      continue;
    }
    while (std::ranges::count(study.labels, series.label) > 0) series.label += " (there)";
    study.labels.push_back(series.label);
    study.imported.labels.push_back(series.label);
    study.series.push_back(std::move(series));
    for (SolveSummary solve : solves) {
      if (solve.run > study.definition.runs) continue;
      solve.label = static_cast<int>(std::ssize(study.labels) - 1);
      solve.timing = Timing::process;
      solve.is_self_timed = true;
      solve.was_preempted = false;  // a preemption matters only on the machine of the solve
      study.solves.push_back(solve);
    }
  }
  if (study.imported.labels.empty())
    throw std::invalid_argument("--beside: the other store has no solver that this study lacks");
  if (!theirs.solves.empty() && theirs.solves.front().target != 0) require_same_targets(study);
}

}  // namespace ikbench::judge
