// The libraries in a program of your own, by one header: arms, solvers, studies, the store, the report
// (docs/reference/api.md).
#pragma once

#include "analysis/judge/judge.hpp"      // read_study, judge
#include "analysis/show/headline.hpp"    // headline: its sentence
#include "analysis/show/publish.hpp"     // write_report: tables, figures and report.html of a report
#include "analysis/show/report.hpp"      // make_report: what a judged study has to tell
#include "analysis/show/terminal.hpp"    // terminal_report: its screen
#include "experiments/runner.hpp"        // run a study, solve_once
#include "experiments/study/reader.hpp"  // load_study, parse_study
#include "results/store.hpp"             // every solve
#include "robots/robot.hpp"              // robot, load_robot: the chain and its limits
#include "solvers/registry.hpp"          // solver, all_solvers
#include "solvers/solve.hpp"             // one solve without a study
