// Somebody else's solves, from a long CSV, beside those of a study that was run: with all joints of an answer they are
// verified like any other; with an error alone they are told as not verified.
#pragma once

#include <string>
#include <vector>

#include "results/store.hpp"

namespace ikbench::experiments {

struct ImportRequest {
  std::string study;    // that the store has, with solves
  std::string source;   // the file's name, for messages and for the record
  std::string text;     // what is in it
  std::string digest;   // of it: an edited file is another series
  std::string label;    // of the solver where the file has no column `solver`
  std::string command;  // what was typed, for the record
};

struct ImportedSolver {
  std::string label;
  int solves = 0;
  int verified = 0;               // of those, how many have an answer that was verified
  int without_answer = 0;         // and how many have none and no error
  double largest_mistake_cm = 0;  // of errors that stand beside answers, from those that the verifier computes
  bool is_stored_already = false;
};

struct Imported {
  std::vector<ImportedSolver> solvers;
  std::vector<std::string> unread;  // columns that are ours, but not taken from a file
};

// A row is a solve: columns run, point, and answer_rad_1 ... or answer_deg_1 ... (as many as the arm has joints; of one
// that slides, metres) or position_error_cm; solver, orientation_error_deg, evaluations and seconds where they are
// known; target_position_m_1 to _3 are compared with the study's. A run has all its points. Solves start where the
// study says: at the answer before, or where the others started. A row with neither answer nor error is of a solver
// that gave none. A solver that was imported before is replaced. std::invalid_argument names line and column.
Imported import_solves(results::Store& store, const ImportRequest& request);

}  // namespace ikbench::experiments
