// The report of a study: its sections of blocks, from which pages and files are made.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/judge/data/study_results.hpp"
#include "analysis/show/block.hpp"
#include "analysis/show/report_model.hpp"

namespace ikbench::show {

// What sections are made of.
struct Report {
  judge::StudyResults study;  // a user's file: its name alone
  ReportModel model;
  std::vector<figures::Figure> figures;
  // Of a paper: instead of the sentence and the table of results; its claims; and sections of its own, each with its
  // heading.
  Blocks lead = {}, claims = {};
  std::vector<Blocks> extra_sections = {};
  bool has_own_numbers = false;                  // the additions have the descriptions and the ANOVA
  std::vector<std::string> extra_warnings = {};  // beside the study's own
  std::vector<std::string> citation_keys = {};   // that its article cites
  std::string_view references = {};              // where they are
};
Report make_report(judge::JudgedStudy judged, std::vector<figures::Figure> figures);

// What was solved and how it was judged, and on which machine; of a user's file only how.
std::vector<Table> setup_tables(const Report& report);
// The blocks of each section, the additions after the pictures; empty ones are left out. The first begins with the
// headline.
std::vector<Blocks> report_sections(const Report& report);

}  // namespace ikbench::show
