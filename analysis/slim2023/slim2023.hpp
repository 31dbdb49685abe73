// The parts that Slim et al. 2023 adds to a report: figures, Tables 1 to 8 with ours beside the printed numbers, and
// the answer in some sentences. The paper and the results are described in docs/papers/slim2023.md.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/figures/look.hpp"
#include "analysis/judge/judge.hpp"
#include "analysis/papers/repeated.hpp"
#include "analysis/papers/rules.hpp"
#include "analysis/show/block.hpp"

namespace ikbench::slim2023 {

// A metric of the paper: the column here, the paper's name, and the numbers of the paper's ANOVA table, curves and box
// plot.
struct PaperMetric {
  std::string_view column, name;
  int anova, curves, boxes;
};
constexpr std::array<PaperMetric, 3> paper_metrics{{{"position_error_cm", "position error", 4, 6, 10},
                                                    {"variation_deg", "angles variation", 5, 7, 11},
                                                    {"seconds", "computing time", 6, 8, 12}}};

// Returns Table 1, the settings of the paper's study.
show::Table table_1(const judge::StudyResults& study);
// Returns Table 2, the arm of the paper's study.
show::Table table_2(const judge::StudyResults& study);
// Returns the statistics of each solver by error, variation and time, for the paper's study or another interpretation.
show::Table table_3(const papers::Repeated& repeated);
// Returns Tables 4 to 6, the ANOVA of error, variation and time.
std::vector<show::Table> anova_tables(const papers::Repeated& repeated);
// Returns Table 7, the table of random targets; nullopt for other studies.
std::optional<show::Table> table_7(const judge::StudyResults& study);
// Returns Table 8, the table of the circle; nullopt for other studies.
std::optional<show::Table> table_8(const judge::StudyResults& study);

// Returns the answer to three questions: whether the paper's conclusion repeats, how many of the paper's numbers repeat
// by each interpretation (the study's own first), and on what depends whether IK-BA is the most accurate.
std::vector<std::string> sentences(const std::vector<papers::JudgedClaim>& claims,
                                   const std::vector<papers::SeedCounts>& counts);

// Returns the further sections of the report. `figures_of_circle` stand beside Table 8.
std::vector<show::Blocks> sections(const papers::Repeated& repeated,
                                   const std::vector<figures::Figure>& figures_of_circle = {});

// Returns the figures of the paper, with the paper's numbers. For the helix: 5 the path with the arm, 6 to 8 error,
// variation and time by point, 9 the joint angles, 10 to 12 box plots beside the printed numbers. For the circle: 15
// the circle in space, 16 the joint angles, 17 the error by point beside the numbers of Table 8, 18 the mean error by
// iteration. Empty if nothing was solved.
std::vector<figures::Figure> figures_of(const judge::JudgedStudy& judged, const figures::Look& look);

}  // namespace ikbench::slim2023
