// The report of a study: its sections of blocks, from which pages and files are made.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/judge/data/study_results.hpp"
#include "analysis/show/block.hpp"
#include "analysis/show/report_model.hpp"

namespace ikbench::show {

// A study or a user's file with all that its report shows. `report_sections` makes the sections of it.
struct Report {
  judge::StudyResults study;  // a user's file: its name alone
  ReportModel model;
  std::vector<figures::Figure> figures;
  // The parts of a repeated paper. `lead` replaces the headline and the table of results, and each section has a
  // heading.
  Blocks lead = {}, claims = {};
  std::vector<Blocks> extra_sections = {};
  bool has_own_numbers = false;                  // the additions have the descriptions and the ANOVA
  std::vector<std::string> extra_warnings = {};  // beside the study's own
  std::vector<std::string> citation_keys = {};   // that its article cites
  std::string_view references = {};              // where they are
};
Report make_report(judge::JudgedStudy judged, std::vector<figures::Figure> figures);

// Returns two tables: the study with the rules by which it was judged, and the machine. A user's file has only the
// rules.
std::vector<Table> setup_tables(const Report& report);
// The blocks of each section, the additions after the pictures; empty ones are left out. The first begins with the
// headline.
std::vector<Blocks> report_sections(const Report& report);

}  // namespace ikbench::show
