// The paragraph of a report on its methods, as sentences that can be pasted into an article: what was solved, how a
// solve began and ended, what was measured and how solvers were compared. The article (article.hpp) and the report
// (report.hpp) call methods_sentences.
#pragma once

#include <string>
#include <vector>

#include "analysis/show/report.hpp"

namespace ikbench::show {

// Returns the sentences on the methods.
std::vector<std::string> methods_sentences(const Report& report);
// Returns the bracket that follows the sentences: machine, compiler and version of a study, otherwise `program`, which
// is the name and version of this program.
std::string methods_bracket(const Report& report, const std::string& program);

}  // namespace ikbench::show
