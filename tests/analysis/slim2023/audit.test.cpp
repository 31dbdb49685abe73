// The audit of Slim et al. 2023, by analysis/slim2023/audit.toml.
#include <algorithm>
#include <set>

#include "analysis/collections.hpp"
#include "analysis/report/claims.hpp"
#include "analysis/report/report.hpp"
#include "tests/analysis/folder.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::report;

namespace {

const std::vector<AuditItem>& audit() {
  static const std::vector<AuditItem> items = analysis::paper("slim2023").audit();
  return items;
}

const AuditItem& item(const std::string& id) {
  const std::vector<AuditItem>& items = audit();
  const auto found = std::ranges::find(items, id, &AuditItem::id);
  REQUIRE(found != items.end());
  return *found;
}

bool has(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

}  // namespace

TEST_CASE("the first lines count what the printed numbers contradict", "[audit]") {
  CHECK(audit_answer(audit()) == "The paper has 4 contradictions and 11 misprints.");
  const AuditItem misprint{.id = "1", .verdict = Verdict::fails, .is_misprint = true};
  CHECK(audit_answer({misprint}) == "The paper has no contradiction and 1 misprint.");
  CHECK(audit_answer({}).empty());
}

TEST_CASE("Tables 4 to 6 follow from Table 3 but for rounding", "[audit][paper]") {
  // R 4.2.2 from the same means and standard deviations, n = 20.
  CHECK(has(item("3.1a").follows, "40.773"));
  CHECK(has(item("3.1b").follows, "388.9"));
  CHECK(has(item("3.1c").follows, "293.93"));
  for (const char* id : {"3.1a", "3.1b", "3.1c"}) CHECK(words_of(item(id)) == "rounding");
  for (const char* id : {"3.1e", "3.1f", "3.1g"}) CHECK(words_of(item(id)) == "consistent");
}

TEST_CASE("equal variances are not supported, and all means are still not the same", "[audit][paper]") {
  // Hand calculations: (0.9069 / 1.7824e-4)^2, (32.8049 / 7.8247)^2, (0.2282 / 0.0229)^2.
  CHECK(has(item("3.2a").follows, "2.59e+07"));
  CHECK(has(item("3.2b").follows, "17.6"));
  CHECK(has(item("3.2c").follows, "99.3"));
  for (const char* id : {"3.2a", "3.2b", "3.2c"}) CHECK(words_of(item(id)) == "not supported");
  // The effect on ANOVA at 0.05: Box's approximation; 0.122, 0.064 and 0.118 of 400000 normal data sets (NumPy).
  CHECK(has(item("3.2a").follows, "level 0.13 instead of 0.05"));
  CHECK(has(item("3.2b").follows, "level 0.065 instead of 0.05"));
  CHECK(has(item("3.2c").follows, "level 0.13 instead of 0.05"));
  // R 4.2.2, oneway.test on samples with these means and standard deviations.
  CHECK(has(item("3.2d").follows, "141.79"));
  CHECK(has(item("3.2e").follows, "740.81"));
  CHECK(has(item("3.2f").follows, "130.66"));
  // docs/paper-notes.md, 3.2: one variance for all hides what each group's own shows
  CHECK(has(item("3.2g").follows, "0.000297 by Games-Howell, 0.0695 by Tukey"));
  CHECK(has(item("3.2h").follows, "1.89e-10 by Games-Howell, 0.5 by Tukey"));
  CHECK(has(item("3.2g").why, "would not show it"));
  CHECK(has(item("3.2i").follows, "0.997"));
  CHECK(has(item("3.2j").follows, "0.00339 by Games-Howell"));
  CHECK(words_of(item("3.2i")) == "not supported");  // variation of IK-BA and MO-PSO
  CHECK(has(item("3.2i").why, "nor that it is not"));
  CHECK(words_of(item("3.2j")) == "consistent");  // PSO is faster than IK-BA
}

TEST_CASE("in Table 7 the row of 20 bats is impossible, and no other", "[audit][paper]") {
  CHECK(words_of(item("3.3c")) == "misprint");
  CHECK(item("3.3c").follows == "the mean exceeds the maximum");
  CHECK(has(item("3.3c").why, "16.5"));  // (80.06 - 47.88) / 2 sqrt(20 / 19)
  for (const char* id : {"3.3a", "3.3b", "3.3d", "3.3e", "3.3f"}) CHECK(words_of(item(id)) == "consistent");
  CHECK(item("3.3e").printed ==
        "12 bats 4.00, 15 bats 4.07, 30 bats 6.03 ms per bat");  // 48.01 / 12, 61.09 / 15, 180.94 / 30
  CHECK(has(item("3.3e").follows, "undecided: Welch p"));
}

TEST_CASE("Table 8's mean is not that of its text, and with one exponent it is", "[audit][paper]") {
  CHECK(words_of(item("3.4a")) == "misprint");
  CHECK(has(item("3.4a").follows, "2.55"));
  CHECK(words_of(item("3.4b")) == "rounding");
  CHECK(has(item("3.4b").where, "9.61e-15 at point 12"));
  CHECK(words_of(item("3.4c")) == "consistent");
  CHECK(has(item("3.4c").printed, "60 angles"));
}

TEST_CASE("Eq. 27 is level, and out of reach from every quarter turn but not from every start", "[audit][paper]") {
  CHECK(words_of(item("3.5a")) == "contradiction");
  CHECK(has(item("3.5a").follows, "90 deg"));
  CHECK(words_of(item("3.5b")) == "not supported");  // the start angle is not printed
  CHECK(has(item("3.5b").follows, "82.10 cm"));      // a Python script of ten lines, both spacings and senses
  CHECK(words_of(item("3.5c")) == "consistent");
  CHECK(has(item("3.5c").follows, "81.76 cm"));
}

TEST_CASE("a contradiction is of two printed things alone", "[audit][paper]") {
  std::set<std::string> contradictions;
  for (const AuditItem& each : audit()) {
    if (words_of(each) == "contradiction") contradictions.insert(each.id);
  }
  // The tool is normal to the floor or level; 50 or 20 agents for the same test; real time met or not; IK-BA or PSO
  // the faster.
  CHECK(contradictions == std::set<std::string>{"3.5a", "3.7a", "3.7b", "3.9b"});
}

TEST_CASE("equations and text that do not go together are found", "[audit][paper]") {
  for (const char* id : {"3.5g", "3.5h", "3.7c"}) CHECK(words_of(item(id)) == "misprint");
  CHECK(item("3.5g").follows == "-cos(theta) sin(alpha)");
  CHECK(item("3.7b").printed == "\"not meeting\" and \"less than 50 ms\"");
  CHECK(item("3.7b").follows == "Table 7: mean 48.01 ms, maximum 67.2 ms");
  CHECK(item("3.7c").printed == "12 15 20");
  CHECK(item("3.7c").follows == "12 15 20 30");
  CHECK(item("3.9b").follows == "IK-BA 0.2439 s, faster: PSO 0.2069 s");
}

TEST_CASE("PSO diverges as printed and converges with the labels permuted", "[audit][paper]") {
  CHECK(words_of(item("3.6c")) == "misprint");
  CHECK(words_of(item("3.6d")) == "consistent");
}

TEST_CASE("every item of the audit says where, what is printed, what follows and why", "[audit]") {
  const std::vector<AuditItem>& items = audit();
  std::set<std::string> ids, groups;
  for (const AuditItem& each : items) {
    CAPTURE(each.id);
    CHECK(ids.insert(each.id).second);
    groups.insert(each.id.substr(0, 3));
    for (const std::string& text : {each.where, each.printed, each.follows, each.why}) CHECK_FALSE(text.empty());
    CHECK(each.why.ends_with('.'));
  }
  // The nine items of docs/paper-notes.md, section 3, and those that are asked of every paper.
  CHECK(groups ==
        std::set<std::string>{"3.1", "3.2", "3.3", "3.4", "3.5", "3.6", "3.7", "3.8", "3.9", "G.1", "G.2", "G.4"});
}

TEST_CASE("the audit's table has a row an item, in three forms", "[audit]") {
  const Table table = audit_table(audit());
  CHECK(table.name == "audit");
  CHECK(table.rows.size() == audit().size());
  const ScratchFolder folder;
  write_table(table, folder.path, "ikbench 1");
  CHECK(files_in(folder.path) == std::set<std::string>{"audit.csv", "audit.md", "audit.tex"});
  CHECK(text_of_file(folder.path / "audit.tex").ends_with("% Made by ikbench 1\n"));
}
