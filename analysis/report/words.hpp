// The sentences of reports, `ikbench stats` and `ikbench compare`, as templates with named arguments (fmt). To improve
// the English, edit this file; inference/doubt.cpp has the words on flawed data.
#pragma once

#include <string_view>

namespace ikbench::report::words {

using Template = std::string_view;

// The answer of an assessment: who is better.
inline constexpr Template decided = "{first} is {better}{by} than {others}";
inline constexpr Template same = "{first} and {others} are the same within {margin}";
inline constexpr Template undecided = "{first} against {others} is undecided";
inline constexpr Template not_judged = "{first} cannot be judged against {others}";
inline constexpr Template nearest = "Against {other}, the best of these: {effect}";
inline constexpr Template is_fact = "a fact of these targets, because all runs are equal";
inline constexpr Template single_values = "nothing can be judged, because no group has more than one observation";
inline constexpr Template all_equal = "all observations are equal, but there are too few to call the groups the same";
inline constexpr Template others_differ = "Other pairs that differ ({count} of {pairs}; the better first): {list}";
inline constexpr Template others_do_not_differ = "No other pair is shown to differ";
inline constexpr Template others_not_judged = "Other pairs that cannot be judged: {count} of {pairs}";
inline constexpr Template another_test =
    "In a new study another test could judge (ikbench run: --set analysis.test={test}; ikbench stats: --test {test})";

// The tests that decided.
inline constexpr Template decided_by = "Decided by: {tests}";
inline constexpr Template corrected = "{test}, corrected for {pairs} pairs";
inline constexpr Template by_sign_of_known = "the sign test against solvers whose runs are all equal";
inline constexpr Template by_fact = "no test between solvers whose runs are all equal, where the difference is a fact";
inline constexpr Template by_order =
    "{test} for groups that do not overlap, where one has a single value or both have too few different ones";
inline constexpr Template by_constants = "{test} for groups of one value each";

// Size of a difference.
inline constexpr Template has_mean = "{name} has the mean {mean}";
inline constexpr Template has_no_mean = "{name} has no mean: {lost} of {n} values not finite";
inline constexpr Template not_by_ranks = "{means}, which ranks do not compare";
inline constexpr Template ahead = "ahead in {share} of {of}";
inline constexpr Template interval = "{what} between {low} and {high}{unit}";
inline constexpr Template runs_for_margin = "it takes {range} {of} to see a difference of {margin}";
inline constexpr Template runs_at_least = "it takes at least {runs:.0f} {of}";

// The leader, in a line.
inline constexpr Template none_tested = "no solver is tested: {values}";
inline constexpr Template exploratory =
    "the study is judged by the quantity above. The {count} below are not corrected for being several.";

// Numbers that contradict the test, and what would change the answer.
inline constexpr Template interval_against = "the interval of the {of} {includes} {none}";
inline constexpr Template favour_other = "{measures} {favour} the other";
inline constexpr Template sound_observations = "observations without the flaw";
inline constexpr Template larger_study = "a larger new study, planned before it is seen ({runs})";
inline constexpr Template more_than_two = "more observations than two";
inline constexpr Template another_measure =
    "another measure, because the mean, the median or ranks favour another group";
inline constexpr Template larger_margin = "a margin above {margin}, because a difference may be smaller";
inline constexpr Template other_conditions = "other targets, arms, budgets or settings";
inline constexpr Template undecided_is_not_equal = "undecided does not mean equal: a difference remains possible";
inline constexpr Template flawed_p = "with flawed observations the p-values are no evidence";
inline constexpr Template only_summaries = "summaries do not show distributions: no ranks, no medians, no normality";
inline constexpr Template only_these_conditions =
    "the results hold for these conditions only, not for other targets, arms, budgets or settings; each quantity is judged "
    "separately";

// The data and the method.
inline constexpr Template data = "{quantity}, {better} is better; {count} {groups} ({names}) with {sizes} each";
inline constexpr Template known_summaries = "; only means, standard deviations and sizes are known.";
inline constexpr Template observation = "One observation is {what}.";
inline constexpr Template logarithms =
    "Tests compare logarithms. So a mean is a geometric mean, and a difference is a ratio.";
inline constexpr Template blocks = "All groups share {count} blocks. A block is {what}.";
inline constexpr Template method = "{test} decides, at {level}{family}; differences below {margin} do not matter.";
inline constexpr Template family_of_control = ", for each group against the control {control}";
inline constexpr Template family_of_all = ", for all {pairs} pairs";
inline constexpr Template correction = "; p-values are corrected by {whose}";
inline constexpr Template share = "{name} {ones} of {n} ({share}, {low:.0f} to {high:.0f} %)";
inline constexpr Template one_group = "There is only one group, so there is nothing to compare.";
inline constexpr Template variances = "; the variance of {most} is {ratio} times that of {least}";
inline constexpr Template assumes_equal_variances = " It assumes equal variances, which are rejected.";
inline constexpr Template normality_unknown = "Summaries do not show whether the values are normal.";
inline constexpr Template normality_untested =
    "Normality cannot be tested: Shapiro-Wilk takes 3 to 5000 values that are not all equal.";
inline constexpr Template not_normal = "Normality is rejected for {names} (Shapiro-Wilk, separately for each group).";
inline constexpr Template normal = "Normality is not rejected for any group{tested} (Shapiro-Wilk).";
inline constexpr Template method_of_shares =
    "every observation is 0 or 1, so shares are compared. {method} Intervals: Wilson's of a share; of a difference "
    "{interval}.";
inline constexpr Template sensitivity =
    "With {n} {of} a t-test finds differences of at least {least} standard deviations{of_differences} with {power} power; "
    "other tests need more.";
inline constexpr Template too_few =
    "no pair can differ by this test. It takes at least {fewest} {of}, and here are {most}.";
inline constexpr Template decades =
    "the single values of {names} span more than two decades (in brackets: nine tenths of them), so the largest few decide "
    "the mean, and a test of means compares the worst cases. Geometric means, A12 and rank tests compare typical values.";
inline constexpr Template described_only =
    "the observations are described, but the groups are not ranked, tested or compared. The note below the table says why.";
inline constexpr Template constants =
    "All values within a group are equal. p comes from {test}. If a quantity is fixed by design, such as a budget of "
    "evaluations, its difference is a fact and needs no test.";

// Notes of the tables of an assessment.
inline constexpr Template ones_interval = "Interval: Wilson's.";
inline constexpr Template intervals_and_quartiles =
    "Intervals: Student's t and studentized bootstrap for the mean, order statistics for the median. Quartiles: "
    "Hyndman-Fan type {type}.";
inline constexpr Template significance =
    "Significance {level}. {test} decides. The plan chooses the test, not the data.";
inline constexpr Template decides = "{test} decides.";
inline constexpr Template decides_all =
    "{test} decides. p: adjusted for {pairs} pairs. Interval of the difference: {interval}, adjusted for {pairs} pairs.";
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
inline constexpr Template limits_first = "First by {measure}: {before}; with enforced limits {after}{test}.";
inline constexpr Template limits_test = " (against {other}: {relation}, {test}, {p})";
inline constexpr Template limits =
    "Both studies have the same targets. recorded: answers outside the joint limits are kept and counted. enforced: they "
    "are refused. Ranks order the means of the solvers that are in both studies; 1 is the smallest.";
inline constexpr Template limits_refused =
    "A refused answer leaves the arm where it was. Its variation of 0 deg should not help a solver, so the ranks in "
    "variation are by mean_accepted_variation_deg, over the answers that are not refused; mean_variation_deg is over all. "
    "The tests of variation compare the runs' means over such answers.";

// The page.
inline constexpr Template legend = "Large: ours. Small: as printed.";
inline constexpr Template legend_of_colours =
    " Green: the printed number is where 95 % of our repetitions are. Yellow: outside, but near. Red: far.";
inline constexpr Template first_rows = "The first {shown} of {all} rows; all of them are in the CSV.";

// `ikbench compare`.
inline constexpr Template regression = "Regression beyond {margin}: {list}. {rest}";
inline constexpr Template no_regression = "No regression beyond {margin}{found}. {rest}";
inline constexpr Template comparisons = "Of {count} comparison{s}: {counts}.";
inline constexpr Template by_less = "{word} by less than {margin}";
inline constexpr Template by_more = "{word} by more than {margin}";
inline constexpr Template perhaps_by_less = "{word}, perhaps by less than {margin}";
inline constexpr Template by_unknown = "{word}, by how much is not known";

}  // namespace ikbench::report::words
