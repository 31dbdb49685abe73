#include "results/published.hpp"
#include "tests/papers/studies.hpp"

namespace {

Repeated as_stored() {
  const Paper& paper = paper_named("ssik2026");
  return {.paper = paper, .studies = {}, .counts = stored_counts(paper)};
}

}  // namespace

TEST_CASE("stored counts give the printed ranges but on five arms", "[papers]") {
  const Repeated of = as_stored();
  CHECK(claim_of(of, "ssik").holds == Holds::in_part);
  CHECK(claim_of(of, "ssik").number == "13 of 16 arms");
  CHECK(claim_of(of, "EAIK").number == "7 of 9 arms");
  CHECK(claim_of(of, "EAIK-file").holds == Holds::holds);
  CHECK(claim_of(of, "EAIK-file").number == "8 of 8 arms");
  CHECK(contains(claim_of(of, "EAIK-file").evidence, "82 of 200 on UR3e"));
  CHECK(claim_of(of, "ssik-older").number == "3 of 3 arms");
  const std::vector<std::string> sentences = counts_sentences(of);
  REQUIRE(sentences.size() == 4);
  CHECK(sentences[0] == "13 of 16 rows of ssik and 7 of 9 of EAIK are the published ones.");
  CHECK(sentences[1].starts_with("ssik differs on PiPER, Gen3 and xArm7: "));
  CHECK(sentences[2].starts_with("EAIK differs on UR3e and UR5e: "));
  const show::Table table = counts_table(of);
  REQUIRE(table.rows.size() == 16);
  const auto cells = [&](std::size_t row) {
    std::vector<std::string> texts;
    for (const show::Cell& cell : table.rows[row])
      texts.push_back(std::holds_alternative<std::string>(cell) ? std::get<std::string>(cell) : "-");
    return texts;
  };
  CHECK(cells(1) == std::vector<std::string>{"UR3e", "6", "2-8", "2-8", "2-8", "2-6", "not EAIK"});
  CHECK(cells(5) == std::vector<std::string>{"JACO 2", "6", "2-12", "2-12", "refuses", "refuses", "yes"});
  CHECK(cells(9) == std::vector<std::string>{"iiwa14", "7 (samples)", "128", "128", "-", "-", "yes"});
}

TEST_CASE("counts of other solves are judged, and an unknown difference has no reason", "[papers]") {
  Repeated of = as_stored();
  of.counts["ssik"]["UR5"][7] = 16;
  CHECK(claim_of(of, "ssik").number == "12 of 16 arms");
  CHECK(contains(counts_sentences(of)[1] + counts_sentences(of)[2], "ssik differs on UR5: no reason is known."));
  of.counts["EAIK"]["xArm6"] = {0, 4};  // answers where the paper has a refusal
  CHECK(claim_of(of, "EAIK").number == "6 of 9 arms");
  of.counts["EAIK"]["xArm6"] = {0, 0};  // no answer is no refusal
  CHECK(claim_of(of, "EAIK").number == "6 of 9 arms");
  of.counts["ssik"] = {{"UR5", {8, 2}}};
  CHECK(claim_of(of, "ssik").holds == Holds::holds);
  CHECK(claim_of(of, "ssik").number == "1 of 1 arms");
  of.counts["ssik"].clear();
  CHECK(claim_of(of, "ssik").holds == Holds::not_tested);
}

TEST_CASE("a table of counts has a whole number per pose, or none", "[papers]") {
  const auto read = [](const std::string& text) { return read_counts(base::parse_csv(text, "x.csv"), "x.csv"); };
  CHECK(read("pose,UR5,Z1\n1,2,\n2,0,\n") == CountsByArm{{"UR5", {2, 0}}, {"Z1", {}}});
  for (const char* cell : {"-1", "2.5", "nan", "1e9", "two"}) {
    const std::string said =
        complaint<std::invalid_argument>([&] { read(fmt::format("pose,UR5\n1,8\n2,{}\n", cell)); });
    CHECK(said == fmt::format("x.csv:3: UR5 is \"{}\"; expected a number of answers from 0 to 10000", cell));
  }
  CHECK(complaint<std::invalid_argument>([&] { read("pose,UR5\n1,8\n2,\n"); }) ==
        "x.csv: UR5 has 1 number for 2 poses; expected one per pose, or none");
}

TEST_CASE("the joints of the poses are stored, within the paper's ranges", "[papers]") {
  for (const int joints : {6, 7}) {
    const base::CsvTable table = results::published::table("ssik2026", fmt::format("joints-{}", joints));
    REQUIRE(table.rows() == 200);
    for (std::size_t row = 0; row < table.rows(); ++row) {
      for (int joint = 1; joint <= joints; ++joint) {
        const double angle = table.number(row, fmt::format("q{}", joint));
        CHECK(angle >= (joints == 7 && joint == 4 ? 0.3 : -0.5));
        CHECK(angle <= (joints == 7 && joint == 4 ? 0.7 : 0.5));
      }
    }
  }
}
