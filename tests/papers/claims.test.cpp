// The rules, by the claims of both papers on hand-made studies.
#include "tests/papers/studies.hpp"

namespace {

Holds holds(const Repeated& of, std::string_view id) { return claim_of(of, id).holds; }

}  // namespace

TEST_CASE("a study with the printed numbers has the verdicts of the printed numbers", "[papers]") {
  const JudgedStudy study = study_of({});
  const Repeated of = repeated(study);
  for (const char* id :
       {"best_compromise", "most_accurate", "least_variation", "better_than_ba", "least_spread", "solvers_differ"}) {
    INFO(id);
    CHECK(holds(of, id) == Holds::holds);
  }
  CHECK(means_table(of).notes[0].starts_with("~ in the range"));
  CHECK(holds(of, "real_arm") == Holds::not_tested);
  CHECK(holds(of, "circle") == Holds::not_tested);
  CHECK(claim_named(judged_claims(of), "accurate_inside_limits") == nullptr);  // a question needs its study
}

TEST_CASE("a claim fails where one is worse, and is not decided where none is shown to be", "[papers]") {
  const JudgedStudy worse = study_of({}, [](SolveRecord& solve) {
    if (solve.label != "IK-BA") return;
    solve.position_error_cm *= 2000;
    solve.variation_deg *= 4;
  });
  for (const char* id : {"most_accurate", "least_variation", "better_than_ba", "least_spread", "best_compromise"}) {
    INFO(id);
    CHECK(holds(repeated(worse), id) == Holds::fails);
  }

  const JudgedStudy equal = study_of({}, [](SolveRecord& solve) {
    solve.position_error_cm = 1 + 0.1 * solve.run;
    solve.variation_deg = 10 + solve.run;
  });
  for (const char* id : {"most_accurate", "least_variation", "best_compromise", "least_spread", "solvers_differ"}) {
    INFO(id);
    CHECK(holds(repeated(equal), id) == Holds::inconclusive);
  }
}

TEST_CASE("a claim about solvers of one study has the verdicts of its report", "[papers]") {
  for (const int runs : {2, 3, 4, 5, 6, 8, 20}) {
    const JudgedStudy study = study_of({.runs = runs}), limits = study_of({.name = "slim2023-limits", .runs = runs});
    const Repeated of = repeated(study, {&limits});
    for (const Claim& claim : of.paper.claims) {
      const bool is_of_one = claim.study.empty() || claim.study == "limits";
      if (!is_of_one || !claim.rule || claim.rule->name != "better" || claim.of != Of::means) continue;
      const show::Table pairs = show::pairs_table(show::make_report_model(claim.study.empty() ? study : limits));
      const auto verdict = static_cast<std::size_t>(std::ranges::find(pairs.columns, "verdict", &show::Column::name) -
                                                    pairs.columns.begin());
      std::vector<Holds> parts;
      for (const Metric* metric : claim.metrics) {
        Tally tally;
        for (const auto& row : pairs.rows) {
          const auto cell = [&](std::size_t column) {
            const auto* const judged = std::get_if<ikbench::show::VerdictCell>(&row[column]);
            return judged ? judged->text : std::get<std::string>(row[column]);
          };
          const auto is_own = [&](std::size_t column) { return std::ranges::count(claim.solvers, cell(column)) > 0; };
          const std::string& rival = is_own(1) ? cell(2) : cell(1);
          const bool is_asked = claim.against.empty() || std::ranges::count(claim.against, rival) > 0;
          if (cell(0) != metric->name || is_own(1) == is_own(2) || !is_asked) continue;
          const bool is_found = cell(verdict).starts_with("better");  // the first
          tally.add(cell(verdict).starts_with("not tested") ? Verdict::not_tested
                    : !is_found                             ? Verdict::inconclusive
                    : is_own(1)                             ? Verdict::better
                                                            : Verdict::worse);
        }
        if (tally.all() > 0) parts.push_back(holds_of(tally));
      }
      INFO(runs << " runs: " << claim.id);
      if (!parts.empty()) CHECK(holds(of, claim.id) == holds_of(parts));
    }
  }
}

TEST_CASE("an answer that is none decides nothing for its solver", "[papers]") {
  const JudgedStudy lost = study_of({}, [](SolveRecord& solve) {
    if (solve.label == "DE" && solve.run == 1) solve.position_error_cm = unknown;
  });
  CHECK(holds(repeated(lost), "most_accurate") == Holds::inconclusive);
}

TEST_CASE("another solver's numbers come from a companion where the claim says so", "[papers]") {
  const JudgedStudy study = study_of({});
  const JudgedStudy bounds = study_of({.name = "slim2023-bounds"}, [](SolveRecord& solve) {
    if (solve.label == "PSO") solve.position_error_cm = 1e-6 * solve.run;  // and IK-BA is as it was
    if (solve.label == "IK-BA") solve.position_error_cm = 0.01;
  });
  const Repeated of = repeated(study, {&bounds});
  CHECK(holds(of, "accurate_none_clamped") == Holds::fails);
  CHECK(claim_of(of, "accurate_none_clamped").number == "0.00194 cm, PSO 1.05e-05");
  CHECK(holds(of, "accurate_all_clamped") == Holds::holds);
  CHECK(claim_of(of, "accurate_all_clamped").number.starts_with("0.01 cm, K-ABC"));
}

TEST_CASE("what changes no bit has no effect, and what moves joints more has one", "[papers]") {
  const JudgedStudy study = study_of({});
  const auto without = [&](double first, double second) {
    const JudgedStudy companion =
        study_of({.name = "slim2023-elongation", .solvers = {"IK-BA", "without the pull"}}, [&](SolveRecord& solve) {
          const double factor = solve.label == "IK-BA" ? first : second;
          solve.answer_rad = {0.1 * solve.point, 0.001 * solve.run, 0.01 * 'I'};
          if (factor != 1) solve.answer_rad[0] += 0.1;
          solve.variation_deg = factor * as_printed("IK-BA", "variation_deg", solve.run);
        });
    return claim_of(repeated(study, {&companion}), "elongation_control");
  };
  CHECK(without(1, 1).holds == Holds::fails);
  CHECK(without(1, 2).holds == Holds::in_part);
  CHECK(contains(without(1, 2).evidence, "There every answer of IK-BA is the same, bit for bit."));
  CHECK(without(1, 2).number == "88.8 deg, without the pull 178");
  CHECK(without(2, 2).holds == Holds::holds);
  CHECK(without(1, 0.5).holds == Holds::fails);
}

TEST_CASE("no verdict depends on times", "[papers]") {
  const JudgedStudy study = study_of({});
  const JudgedStudy parallel = study_of({}, [](SolveRecord& solve) { solve.timing = results::Timing::parallel; });
  for (const JudgedClaim& each : judged_claims(repeated(study))) {
    INFO(each.id);
    CHECK(holds(repeated(parallel), each.id) == each.holds);
  }
}

TEST_CASE("an error is at rounding level within ten spacings of doubles", "[papers]") {
  const JudgedStudy study = study_of({});
  const auto circle = [&](double error) {
    const JudgedStudy dobot = study_of({.name = "slim2023-dobot", .path = "circle", .solvers = {"IK-BA"}, .runs = 1},
                                       [&](SolveRecord& solve) { solve.position_error_cm = error * solve.point; });
    return claim_of(repeated(study, {&dobot}), "circle").holds;
  };
  CHECK(circle(2e-14) == Holds::holds);    // ten times 2^-52 of 40 cm is 8.9e-14
  CHECK(circle(3e-14) == Holds::in_part);  // the last point is above, the mean is not
  CHECK(circle(1e-12) == Holds::fails);
}

TEST_CASE("a rate is as printed where the two shares do not differ, by the targets of both", "[papers]") {
  const auto share = [](int kdl, const std::string& robot = "abb_irb120", int points = 1000) {
    return study_of({.name = "beeson2015",
                     .paper = "beeson2015",
                     .path = "random",
                     .robot = robot,
                     .solvers = {"KDL", "KDL-RR"},
                     .runs = 1,
                     .points = points,
                     .tolerance_cm = 0.001},
                    [=](SolveRecord& solve) {
                      const int solved = solve.label == "KDL-RR" ? 985 : kdl;
                      solve.status = solve.point <= solved ? results::Status::ok : results::Status::tolerance_missed;
                    });
  };
  const auto text = [](const Repeated& of) { return show::to_text(rates_table(of)); };
  // Printed of 10 000: 39.41 and 98.48 %, of the Panda 61.77 and 92.67 %. By hand, Newcombe's interval of the
  // difference of 43.6 and 39.41 % is 0.01 to 8.45 points, of 43.5 % -0.09 to 8.35.
  const JudgedStudy as_printed = share(435), never = share(436), panda = share(618, "franka_panda_2018");
  CHECK(holds(repeated(as_printed), "rate-KDL") == Holds::holds);
  CHECK(claim_of(repeated(as_printed), "rate-KDL").number == "on 1 of 1 arms");
  CHECK(rates_sentences(repeated(as_printed)) ==
        std::vector<std::string>{
            "We reproduce the rates of README 1.4.6 for KDL on 1 of 1 arms and for KDL-RR on 1 of 1.",
            "We reproduce the rates of README 1.5.1 for KDL on 1 of 1 arms and for KDL-RR on 1 of 1."});
  CHECK(holds(repeated(never), "rate-KDL") == Holds::fails);
  CHECK(holds(repeated(never), "restarts") == Holds::holds);
  CHECK(holds(repeated(never), "trac_ik") == Holds::not_tested);
  const Repeated both = repeated(never, {&panda});
  CHECK(holds(both, "rate-KDL") == Holds::in_part);
  CHECK(rates_sentences(both) ==
        std::vector<std::string>{
            "We reproduce the rates of README 1.4.6 for KDL on 1 of 2 arms and for KDL-RR on 1 of 2.",
            "We reproduce the rates of README 1.5.1 for KDL on 1 of 2 arms and for KDL-RR on 1 of 2.",
            "Not reproduced for KDL: ABB IRB120 43.6 % (paper 39.41).",
            "Not reproduced for KDL-RR: Franka Emika Panda 98.5 % (paper 92.67)."});
  CHECK(contains(text(both), "39.41 x"));
  CHECK(contains(text(both), "61.77 ~"));
  CHECK(contains(text(both), "minus the paper's number: ~ contains 0; x excludes 0.\n"));
  CHECK(rates_figure(both)->name == "printed");
  // What a program did is a table: 9990 of 10 000 where 99.91 % and 0.26 ms are printed.
  const base::CsvTable programs = base::parse_csv(
      "robot,solver,n,solved,mean_ms,program,machine,day\nabb_irb120,TRAC-IK,10000,9990,0.338,its version,it,today\n",
      "programs");
  Repeated with_program = repeated(as_printed);
  with_program.programs = &programs;
  CHECK(holds(with_program, "rate-TRAC-IK") == Holds::holds);
  CHECK(holds(with_program, "trac_ik") == Holds::holds);  // 99.9 % against 98.5
  CHECK(
      rates_sentences(with_program) ==
      std::vector<std::string>{
          "We reproduce the rates of README 1.4.6 for KDL on 1 of 1 arms, for KDL-RR on 1 of 1 and for TRAC-IK on 1 of 1.",
          "We reproduce the rates of README 1.5.1 for KDL on 1 of 1 arms, for KDL-RR on 1 of 1 and for TRAC-IK on 1 of 1.",
          "The mean times of TRAC-IK are 1.3x to 1.3x those of the paper."});
  CHECK(contains(text(with_program), "0.338 ms"));
  CHECK(contains(text(with_program), "TRAC-IK: 10000 poses per arm by its version, it, today."));
  const JudgedStudy few = share(10, "abb_irb120", 30);  // 33.3 % (19 to 51) and 100 % (89 to 100)
  CHECK(holds(repeated(few), "rate-KDL") == Holds::inconclusive);
  CHECK(holds(repeated(few), "rate-KDL-RR") == Holds::inconclusive);
  CHECK(rates_sentences(repeated(few))[0] == "All rates of README 1.4.6 are inconclusive for KDL and KDL-RR.");
  CHECK(contains(text(repeated(few)), "39.41 ?"));
  CHECK(contains(text(repeated(few)), "number: ? is too wide"));
}

TEST_CASE("printed columns of means are compared as they are, and counts to one target", "[papers]") {
  const auto made = [](int nr, double evaluations, int points = 10'000) {
    return study_of({.name = "haviland2023",
                     .paper = "haviland2023",
                     .path = "random",
                     .robot = "ur5",
                     .solvers = {"LM Chan 0.1", "NR"},
                     .runs = 1,
                     .points = points,
                     .tolerance_cm = 0.1},
                    [=](SolveRecord& solve) {
                      const int solved = solve.label == "NR" ? nr : points - points * 961 / 10'000;
                      solve.status = solve.point <= solved ? results::Status::ok : results::Status::tolerance_missed;
                      solve.evaluations = static_cast<std::int64_t>(
                          solve.label == "NR" ? evaluations + (solve.point % 2 == 0 ? 20 : -20) : 9 + solve.point % 2);
                      solve.restarts = 1;
                    });
  };
  // Printed of 10 000: 1110 and 961 not solved, 21.15 and 9.43 iterations. The interval of 21 with an sd of 20 is
  // -0.91 to 0.61; of 9.5 with an sd of 0.5 it is 0.05 to 0.09.
  const JudgedStudy as_printed = made(8889, 21), searches = study_of({.name = "haviland2023-searches",
                                                                      .paper = "haviland2023",
                                                                      .path = "random",
                                                                      .solvers = {"LM Chan 0.1", "NR"},
                                                                      .runs = 1,
                                                                      .points = 10'000,
                                                                      .tolerance_cm = 0.1},
                                                                     [](SolveRecord&solve) { solve.restarts = 1; });
  CHECK(claim_of(repeated(as_printed), "rate-not solved").number == "for 2 of 2 solvers");
  CHECK(holds(repeated(as_printed), "rate-not solved") == Holds::holds);
  CHECK(holds(repeated(as_printed), "rate-iterations") == Holds::in_part);
  CHECK(rates_sentences(repeated(as_printed)) ==
        std::vector<std::string>{
            "We reproduce 3 of 4 numbers of the paper; on the paper's own poses, 2 of 2 solvers miss as "
            "many targets as in the paper, within 2 (1111/1110, 961/961).",
            "Not reproduced: iterations of LM Chan 0.1 9.5 (paper 9.43)."});
  CHECK(holds(repeated(made(8600, 21)), "rate-not solved") == Holds::in_part);
  CHECK(rates_sentences(repeated(made(8, 21, 10))) ==
        std::vector<std::string>{"There are too few targets to say whether we reproduce any number of the paper."});
  const show::Table table = rates_table(repeated(as_printed, {&searches}));
  REQUIRE(table.columns.size() == 5);
  CHECK(std::get<std::string>(table.rows[0][0]) == "NR");  // in the printed order
  CHECK(std::get<show::PublishedNumber>(table.rows[0][1]).ours == 1111);
  CHECK(std::get<show::PublishedNumber>(table.rows[0][4]).ours == 2);
  CHECK(rates_figure(repeated(as_printed))->name == "printed");
}

TEST_CASE("the tally of pairs and of parts", "[papers]") {
  CHECK(holds_of(Tally{.better = 2}) == Holds::holds);
  CHECK(holds_of(Tally{.better = 2, .open = 1}) == Holds::inconclusive);
  CHECK(holds_of(Tally{.better = 2, .worse = 1}) == Holds::fails);
  CHECK(holds_of(Tally{.open = 1, .untested = 1}) == Holds::inconclusive);
  CHECK(holds_of(Tally{.untested = 1}) == Holds::not_tested);
  CHECK(holds_of(Tally{.better = 1, .untested = 1}) == Holds::inconclusive);
  CHECK(holds_of(std::vector{Holds::holds, Holds::fails, Holds::inconclusive}) == Holds::in_part);
  CHECK(holds_of(std::vector{Holds::holds, Holds::inconclusive}) == Holds::inconclusive);
  CHECK(holds_of(std::vector{Holds::inconclusive, Holds::fails}) == Holds::inconclusive);
  CHECK(holds_of(std::vector{Holds::inconclusive, Holds::not_tested}) == Holds::inconclusive);
  CHECK(holds_of(std::vector{Holds::not_tested}) == Holds::not_tested);
}

TEST_CASE("claims are told by verdict, with the whole count of readings", "[papers]") {
  const JudgedStudy study = study_of({});
  const std::vector<JudgedClaim> claims =
      judged_claims(repeated(study), {{"most_accurate", {.hold = 65, .fail = 460, .open = 339}}});
  const show::Blocks blocks = claims_section(claims);
  REQUIRE(blocks.size() == 4);
  const auto& table = std::get<show::Table>(blocks[1]);
  CHECK(table.rows.size() == 14);
  const auto most = std::ranges::find_if(
      table.rows, [](const auto& row) { return std::get<std::string>(row[1]) == "IK-BA is the most accurate"; });
  REQUIRE(most != table.rows.end());
  CHECK(std::get<std::string>((*most)[3]) == "65 hold, 460 fail, 339 inconclusive");
  const auto& verdict = std::get<ikbench::show::VerdictCell>((*most)[0]);
  CHECK(verdict.text == "holds by default");
  CHECK(verdict.tone == ikbench::show::Tone::neutral);
  CHECK(std::get<std::string>(table.rows.back()[3]) == "not counted");
  CHECK(std::get<ikbench::show::VerdictCell>(table.rows.back()[0]).text == "not tested");
  CHECK(contains(show::to_text(means_table(repeated(study))), "0.00194 cm       0.0019 "));
  const std::string text = screen({"A sentence."}, {.caption = "Table"}, claims);
  CHECK(text.find("\nholds by default  ") < text.find("\nnot tested  "));
  CHECK(contains(text, "inconclusive in 864 interpretations"));
  CHECK(contains(text, "(65/460/339)"));
}
