// The sentences of reports, `ikbench stats` and `ikbench compare`, as templates with named arguments (fmt). To improve
// the English, edit this file; inference/doubt.cpp has the words on flawed data.
#pragma once

#include <string_view>

namespace ikbench::report::words {

using Template = std::string_view;

// The answer of an assessment: who is better.
inline constexpr Template decided = "{first} is {better}{by} than {others}";
inline constexpr Template same = "{all} are the same within {margin}";
inline constexpr Template same_as_control = "{others} are each the same as {control} within {margin}";
inline constexpr Template undecided = "{first} against {others} is undecided";
inline constexpr Template not_judged = "{first} cannot be judged against {others}";
inline constexpr Template nearest = "Against {other}, the best of these: {effect}";
inline constexpr Template is_fact = "a fact of these targets, because all runs are equal";
inline constexpr Template same_bits = "equal bit for bit in every solve";
inline constexpr Template single_values = "nothing can be judged, because no group has more than one observation";
inline constexpr Template all_equal = "all observations are equal, but there are too few to call the groups the same";
inline constexpr Template others_differ = "Other pairs that differ ({count} of {pairs}; the better first): {list}";
inline constexpr Template others_do_not_differ = "No other pair is shown to differ{same}";
inline constexpr Template others_are_same = ": {count} of {pairs} are the same within {margin}";
inline constexpr Template others_not_judged = "Other pairs that cannot be judged: {count} of {pairs}";

// The tests that decided.
inline constexpr Template decided_by = "Decided by: {tests}";
inline constexpr Template corrected = "{test}, corrected for {pairs} pairs";
inline constexpr Template by_sign_of_known = "the sign test against solvers whose runs are all equal";
inline constexpr Template by_fact = "no test between solvers whose runs are all equal, where the difference is a fact";
inline constexpr Template by_bits = "no test between solvers that are equal bit for bit";
inline constexpr Template by_order = "{test} where groups do not overlap and the bootstrap has no spread";
inline constexpr Template by_constants = "{test} for groups of one value each";

// Size of a difference.
inline constexpr Template has_mean = "{name} has the mean {mean}";
inline constexpr Template has_no_mean = "{name} has no mean: {lost} of {n} values not finite";
inline constexpr Template not_by_ranks = "{means}, which ranks do not compare";
inline constexpr Template ahead = "ahead in {share} of {of}";
inline constexpr Template interval = "{what} between {low} and {high}{unit}";

// The leader, in a line.
inline constexpr Template none_tested = "no solver is tested: {values}";
inline constexpr Template left_out = "Not compared: {who}.";
inline constexpr Template counts_as = "below {least} counts as {least}";
inline constexpr Template no_answer =
    "{solver} gave no answer in {count} of {solves} solves ({how}): there its error is that of where the arm stood.";
inline constexpr Template exploratory =
    "the verdict is by {judged_by}. Nothing corrects for the {count} other quantit{ies}.";
inline constexpr Template by_quantity = "the quantity above";
inline constexpr Template by_claims = "its claims";

// Numbers that contradict the test, and what would change the answer.
inline constexpr Template interval_against = "the interval of the {of} {includes} {none}";
inline constexpr Template favour_other = "{measures} {favour} the other";
inline constexpr Template sound_observations = "observations without the flaw";
inline constexpr Template more_than_two = "more than two observations of each group that are not all equal";
inline constexpr Template another_measure =
    "another measure, because the mean, the median or ranks favour another group";
inline constexpr Template larger_margin = "a margin above {margin}, because a difference may be smaller";
inline constexpr Template smaller_margin = "a margin below {margin}, because a smaller difference is shown";
inline constexpr Template other_conditions = "other targets, arms, budgets or settings";
inline constexpr Template undecided_is_not_equal = "undecided does not mean equal: a difference remains possible";
inline constexpr Template flawed_p = "with flawed observations the p-values are no evidence";
inline constexpr Template only_summaries = "summaries do not show distributions: no ranks and no medians";
inline constexpr Template only_these_conditions =
    "the results hold for these conditions only, not for other targets, arms, budgets or settings; each quantity is judged "
    "separately";

// The data and the method.
inline constexpr Template data = "{quantity}, {better} is better; {count} {groups} ({names}) with {sizes} each";
inline constexpr Template known_summaries = "; only means, standard deviations and sizes are known.";
inline constexpr Template observation = "One observation is {what}.";
inline constexpr Template logarithms =
    "Tests compare logarithms. So a mean is a geometric mean, and a difference is a ratio.";
inline constexpr Template blocks = "All groups share {count} {blocks}. A block is {what}.";
inline constexpr Template method = "{test} decides, at {level}{family}; differences below {margin} do not matter.";
inline constexpr Template ignores_blocks = " It does not use the blocks.";
inline constexpr Template family_of_control = ", for each group against the control {control}";
inline constexpr Template family_of_all = ", for all {pairs} pairs";
inline constexpr Template correction = "; p-values are corrected by Holm";
inline constexpr Template one_group = "There is only one group, so there is nothing to compare.";
inline constexpr Template method_of_shares =
    "every observation is 0 or 1, so shares are compared. {method} Intervals: Wilson's of a share; of a difference "
    "{interval}.";
inline constexpr Template too_few =
    "no pair can differ by this test. It takes at least {fewest} {of}, and here are {most}.";
inline constexpr Template decades =
    "the single values of {names} span more than two decades (in brackets: nine tenths of them), so the largest few decide "
    "the mean, and a test of means compares the worst cases. Geometric means, A12 and rank tests compare typical values.";
inline constexpr Template described_only =
    "the observations are described, but the groups are not ranked, tested or compared. The note below the table says why.";
inline constexpr Template constants =
    "All values within a group are equal, apart from rounding. p comes from {test}. If a quantity is fixed by design, such as a budget of "
    "evaluations, its difference is a fact and needs no test.";

// Notes of the tables of an assessment.
inline constexpr Template intervals_and_quartiles =
    "Intervals: Student's t and studentized bootstrap for the mean, order statistics for the median. Quartiles: "
    "Hyndman-Fan type {type}.";
inline constexpr Template significance =
    "Significance {level}. {test} decides. The plan chooses the test, not the data.";
inline constexpr Template decides = "{test} decides.";
inline constexpr Template decides_all =
    "{test} decides. p: adjusted for {pairs} pairs. Interval of the difference: {interval}, adjusted for {pairs} pairs.";
inline constexpr Template undecided_in_family =
    " A pair that is undecided among {pairs} pairs may be decided alone, as ikbench compare judges it: see p alone. With a "
    "control there are fewer pairs.";
inline constexpr Template share_of_blocks =
    "Ahead in blocks: the share of blocks in which the first is better; ties count half. Its interval is not adjusted, "
    "and is not defined with ties.";
inline constexpr Template a12 =
    "A12: the probability that an observation of the first is better than one of the second; ties count half. Its "
    "interval is not adjusted.";
inline constexpr Template pairs_with_control = "The table shows the pairs with {name}, the control.";
inline constexpr Template pairs_with_best =
    "The table shows the pairs with {name}, the best; there are too many groups to show all pairs.";
inline constexpr Template flawed = "Flawed: {why}";

// The table of joint limits.
inline constexpr Template limits =
    "Both studies have the same targets. recorded: answers outside the joint limits are kept and counted. enforced: they "
    "are refused. A refused answer leaves the arm where it was. Its variation of 0 deg should not help a solver: "
    "accepted means are over the answers that are not refused.";

// The page.
inline constexpr Template legend = "Large: ours. Small: as printed.";
inline constexpr Template figure_beside = "One figure is not on this page, to keep it small: a link leads to it.";
inline constexpr Template figures_beside =
    "{count} figures are not on this page, to keep it small: a link leads to each.";
inline constexpr Template first_rows = "The first {shown} of {all} rows; all of them are in the CSV.";

// `ikbench compare`.
inline constexpr Template regression = "Regression beyond {margin}: {list}. {rest}";
inline constexpr Template no_regression = "No regression beyond {margin}{found}. {rest}";
inline constexpr Template worse = "{label}: worse beyond {margin} in {list}. {rest}";
inline constexpr Template not_worse = "{label}: no worsening beyond {margin}{found}. {rest}";
inline constexpr Template better_in = "{label}: better in {list}, and no worsening beyond {margin}{found}. {rest}";
inline constexpr Template not_decided = "{label}: undecided in {list}. {rest}";
inline constexpr Template margins = "{margin} (shares: {of_shares})";
inline constexpr Template comparisons = "Of {count} comparison{s}: {counts}.";
inline constexpr Template by_less = "{word} by less than {margin}";
inline constexpr Template by_more = "{word} by more than {margin}";
inline constexpr Template perhaps_by_less = "{word}, perhaps by less than {margin}";
inline constexpr std::string_view the_same_bits = "the same, bit for bit";
inline constexpr Template equal_bits = "equal bit for bit";
inline constexpr Template repeats_itself = "all runs of each are equal: a fact of these targets, without a test";
inline constexpr Template lost = "not finite: {list}";
inline constexpr Template by_itself = "{better} by itself, but not among all of this comparison";
inline constexpr Template independent_runs = "Independent runs, {a} of A and {b} of B: one observation is {what}.";
inline constexpr Template pairs = "{a} pairs of {of}s: one observation is {what}; a pair is {pair}.";
inline constexpr Template by_unknown = "{word}, by how much is not known";
inline constexpr Template families =
    "Judged together here: the metrics of A and B. A report judges each metric over the pairs of {solvers}, so one of the two "
    "may decide what the other leaves undecided.";

// Tables of a study.
inline constexpr Template points =
    "One observation is one point. Points of one run depend on each other, so p-values and standard deviations "
    "are too optimistic.";
inline constexpr Template means_and_medians =
    "One observation is the mean of a run over its points, of times the median; what belongs to a whole run, such as a "
    "path's length, is one observation.";
inline constexpr Template anova_without = "Left out of the ANOVA: {solver} ({lost} of {n} observations not finite).";
inline constexpr Template anova_undefined = "F and p are not defined: {why}.";
inline constexpr Template anova_not_judged = "{why} So our F and p are left out.";
inline constexpr Template solved =
    "Solved is an answer that the verifier finds inside the joint limits and within all tolerances of the study.";
inline constexpr Template trials =
    "The interval counts {trial}s as trials, because solves of one {trial} depend on each other.";
inline constexpr Template wilson = "Interval: Wilson's.";
inline constexpr Template percentiles =
    "p95 and p99: 95 % and 99 % of the solves took no longer. A solve without an answer counts as the longest.";
inline constexpr Template deadline =
    "over deadline: share of solves that took longer than {deadline} ms. solved in time: share with status ok "
    "that did not.";
inline constexpr Template statuses =
    "A solve has the first status that applies: not finite, claimed but wrong, refused, limit violated, "
    "tolerance missed, ok. So ok means finite, as claimed, inside the joint limits and within the tolerance, if "
    "the study has one. A solve without a usable answer leaves the arm where it was and counts with the error that it has "
    "there. observations: what the tests of the position error use, of complete runs or targets. outside limits counts all "
    "answers with a joint outside its limits, whatever their status; worst outside is the largest such violation.";

// Summary, claims.
inline constexpr Template another_task =
    "This study names the paper {paper}, but has another arm or task ({list}): it is not held against the paper.";
inline constexpr Template departs = "This study departs from the built-in study of the paper in: {list}.{judged}";
inline constexpr Template as_measured =
    "The numbers of this table are as measured. The report's answers count an error below the tolerance as the "
    "tolerance, and the cost of a solve without status ok as {penalty} times the "
    "study's limit or, without one, the dearest solve.";
inline constexpr Template inside_limits = "Every answer is inside the joint limits.";
inline constexpr Template outside_limits =
    "{outside} of {answers} answers are outside the joint limits ({list}); the worst joint is outside by {worst}.";
inline constexpr Template times_not_ranked = "Computing times are not ranked or tested: {why} (see the warnings).";
inline constexpr Template no_solves = "This study has no solves yet.";
inline constexpr Template departs_judged = " Only claims that it has the solvers for can be judged.";
inline constexpr Template over_interpretations = "Over all interpretations it {answers}, is undecided in {undecided}.";
inline constexpr Template by_default = "By our default: {verdict}. {evidence}";
inline constexpr Template plan_changed =
    "Set on the command line after the data were collected, not by the study: {changes}.";

// `ikbench compare`: the columns of its table.
inline constexpr Template comparison_columns =
    "The test of the study's plan decides, as in a report of these two solvers. p is that of one metric alone. A "
    "and B differ where it is below the level, which is corrected for all labels and metrics (Holm). low and "
    "high: interval of the ratio that goes with the level: of means, of times the typical ratio. a12: in pairs "
    "the share in which B is better, otherwise the probability that an observation of B is better than one of A.";

// The first lines of a report.
inline constexpr Template no_budget =
    "The study gives no limit of evaluations (stop.evaluations): {least} used {smallest} at the median of a "
    "solve, {most} {largest}.";

}  // namespace ikbench::report::words
