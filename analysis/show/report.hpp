// The report of a study as sections of blocks, from which pages and files are made (page.hpp, publish.hpp). Commands
// call make_report; a repeated paper then adds parts of its own (papers/claims.hpp). The sections are documented in
// docs/reference/report.md.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/judge/data/study_results.hpp"
#include "analysis/show/block.hpp"
#include "analysis/show/report_model.hpp"

namespace ikbench::show {

// A study or a user's file, with all that the report shows. `report_sections` makes the sections.
struct Report {
  judge::StudyResults study;  // only the name for a user's file
  ReportModel model;
  std::vector<figures::Figure> figures;
  // The parts of a repeated paper. If `lead` is not empty, `lead` replaces the headline and the table of results. Each
  // further section begins with a heading.
  Blocks lead = {}, claims = {};
  std::vector<Blocks> extra_sections = {};
  bool has_own_numbers = false;                  // `extra_sections` have the descriptives and the ANOVA
  std::vector<std::string> extra_warnings = {};  // beside the warnings of the study
  std::vector<std::string> citation_keys = {};   // what the article cites; empty: no references.bib
  std::string_view references = {};              // the text of references.bib
};
// Returns the report of a judged study with these figures.
Report make_report(judge::JudgedStudy judged, std::vector<figures::Figure> figures);

// Returns two tables: the study with the rules of the judgement, and the machine. For a user's file the first table has
// only the rules.
std::vector<Table> setup_tables(const Report& report);
// Returns the blocks of each section. The first section begins with the headline or with `lead`. The sections of a
// repeated paper stand behind the pictures. Empty sections are left out.
std::vector<Blocks> report_sections(const Report& report);

}  // namespace ikbench::show
