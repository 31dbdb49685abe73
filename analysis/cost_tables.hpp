// What it costs to come to the tolerance of a study: how many solves do, expected running time, survival curves and
// their log-rank test (methods and sources: analysis/statistics/{proportion,running_time,survival,log_rank}.hpp).
#pragma once

#include <optional>
#include <vector>

#include "analysis/convergence.hpp"
#include "analysis/figure.hpp"
#include "analysis/statistics/running_time.hpp"
#include "analysis/study.hpp"
#include "analysis/table.hpp"

namespace ikbench {

// A solve that comes to the tolerance has spent its whole cost on it; one that does not is given up at its cost.
std::vector<CensoredCost> censored_costs(const Solves& solves, double tolerance_cm, Cost cost);

// "statistics-cost", in evaluations, and "statistics-cost-seconds" where times are comparable. None where the study has
// no tolerance or no solves.
std::vector<Table> cost_tables(const StudyResults& study);

// "statistics-survival-evaluations": the share of solves that have not come to the tolerance yet (Kaplan and Meier).
// Nothing where there are no tables.
std::optional<Figure> survival_figure(const StudyResults& study);

}  // namespace ikbench
