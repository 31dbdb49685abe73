// Imports solves from a long CSV into a stored study. With all joints of an answer they are verified like any other
// solve; with an error alone they are marked as not verified.
#pragma once

#include <string>
#include <vector>

#include "results/store.hpp"

namespace ikbench::experiments {

struct ImportRequest {
  std::string study;    // must be in the store, with solves
  std::string source;   // the file's name, for messages and for the record
  std::string text;     // the file's content
  std::string digest;   // of the text: an edited file is another series
  std::string label;    // the solver's label if the file has no column `solver`
  std::string command;  // the typed command, for the record
};

struct ImportedSolver {
  std::string label;
  int solves = 0;
  int verified = 0;               // solves with a verified answer
  int without_answer = 0;         // solves with neither answer nor error
  double largest_mistake_cm = 0;  // largest difference between the file's error and the verifier's
  bool is_stored_already = false;
};

struct Imported {
  std::vector<ImportedSolver> solvers;
  std::vector<std::string> unread;  // columns of ours that an import ignores
};

// Each row is a solve. Its columns: run, point, and either answer_rad_1 ... or answer_deg_1 ... (one per joint of the
// arm; metres for a joint that slides) or position_error_cm. solver, orientation_error_deg, evaluations and seconds are
// optional; target_position_m_1 to _3 are compared with the study's. A run must have all its points. Solves start where
// the study says: at the previous answer, or where the others started. A row with neither answer nor error means that
// the solver gave none. The import replaces an earlier import of the same solver. std::invalid_argument names line and
// column.
Imported import_solves(results::Store& store, const ImportRequest& request);

}  // namespace ikbench::experiments
