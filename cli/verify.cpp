// ikbench verify: whether a store has what its solvers did.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "base/names.hpp"
#include "cli/console.hpp"
#include "cli/reporting.hpp"
#include "experiments/stored_checks.hpp"
#include "results/fingerprint.hpp"
#include "results/merge.hpp"

namespace ikbench::cli {

namespace {

struct VerifyArguments {
  std::string store, study, seal;
  std::int64_t solves = 100;
};

// Throws unless a fact that an archive was given still holds, and names it by `what`. Returns whether there is such a
// fact.
bool is_as_archived(const Store& store, const std::string& fact, std::string_view what, const std::string& now) {
  bool is_there = false;
  for (const Session& session : store.sessions()) {
    const auto its = session.environment.find(fact);
    if (its == session.environment.end()) continue;
    is_there = true;
    if (its->second != now)
      throw std::invalid_argument(fmt::format(
          "{} was {} when it was archived, and now it is {}; if more was solved since, merge it into a new store", what,
          its->second, now));
  }
  return is_there;
}

// Says what a store's seal shows; empty of a store that is no archive. `line` is the fingerprint_line of the study.
// Throws where rows were changed, or the seal is not the one that was given.
std::string said_of_seal(const Store& store, const std::string& given, const StoredStudy& study,
                         const std::string& line) {
  const bool has_seal = std::ranges::any_of(
      store.sessions(), [](const Session& session) { return session.environment.contains(std::string(seal_fact)); });
  const std::string seal = has_seal || !given.empty() ? seal_of(store) : "";  // which reads all rows
  const bool is_sealed = is_as_archived(store, std::string(seal_fact), "its seal", seal);
  const bool is_of_solves =
      is_as_archived(store, fmt::format("{}{}", fingerprint_fact, study.name), "what it holds", line);
  if (!given.empty()) {
    if (!is_sealed && lower_case(given) != seal)
      throw std::invalid_argument("it has no seal, so it is no archive, or an older ikbench made it");
    if (lower_case(given) != seal)
      throw std::invalid_argument(fmt::format(
          "its seal is {}, not the given {}; so it is another archive, or was changed since it was archived", seal,
          given));
    return "It has the given seal, so it is unchanged since it was archived, times and extras included. ";
  }
  if (is_sealed)
    return fmt::format(
        "It is unchanged since it was archived, times and extras included, by whoever archived it: seal {}. --seal "
        "compares with a seal that was printed elsewhere. ",
        seal);
  if (is_of_solves)
    return "Its solves are unchanged since it was archived, but the seal of an older ikbench does not cover times and "
           "extras. ";
  return "";
}

// Throws unless it may be the seal of an archive.
void check_seal(const std::string& seal) {
  constexpr std::size_t digits = 64;
  if (!seal.empty() && (seal.size() != digits || seal.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos))
    throw std::invalid_argument(fmt::format(
        "--seal {}: expected the {} hexadecimal digits that `ikbench export --format archive` prints", seal, digits));
}

}  // namespace

void add_verify(const Command& command, Invocation& invocation) {
  auto arguments = std::make_shared<VerifyArguments>();
  command.add("STORE", &arguments->store, "path of a store.sqlite").required();
  add_study_option(command, arguments->study);
  command.add("--solves", &arguments->solves, "number of solves to make again, drawn at random").whole_number();
  command.add("--seal", &arguments->seal, "the seal of the archive, as printed in a paper or with a release");
  command.footer(
      "  ikbench verify theirs.sqlite\n"
      "  ikbench verify theirs.sqlite --solves 1000000     all of them");
  command.callback([arguments, &invocation] {
    check_seal(arguments->seal);
    const Store store(arguments->store, Store::Mode::read);
    const StoredStudy study = store.study(arguments->study);
    const SolveVisitor redraw = target_replay_check(study);
    const auto all = read_checked(store, study, redraw).solves.size();
    const std::string line = fingerprint_line(store, study), seal = said_of_seal(store, arguments->seal, study, line);
    std::optional<ProgressBar> bar("solving again");
    const RerunReport again =
        rerun_sample(store, study, arguments->solves, [&](const Progress& progress) { bar->show(progress); });
    bar.reset();  // leaves its line to the answer
    std::vector<std::string> unchecked{
        redraw ? "whether times, traces and extras were true when they were stored"
               : "whether times, targets, starts, traces and extras were true when they were "
                 "stored"};
    const auto leave_out = [&](const std::vector<std::string>& labels, const char* why) {
      if (!labels.empty()) unchecked.push_back(fmt::format("answers and counts of {}{}", fmt::join(labels, ", "), why));
    };
    if (!study.definition.check.process.empty()) unchecked.emplace_back("what the study's check said");
    leave_out(again.external, " (programs and libraries)");
    leave_out(again.changed_source, " (the source is another in this version)");
    if (study.definition.stop.seconds > 0) leave_out({"all solves"}, ", which a clock may end");
    const std::string made =
        again.solves == 0 ? "None was made again."
                          : fmt::format("{} of {}, drawn at random, were made again and have the same bits and counts.",
                                        again.solves, again.eligible);
    const std::string text =
        fmt::format("{}: errors, joint motion and status of all {} follow from their answers{}. {}\n{}Not checked: {}.",
                    study.name, base::counted(static_cast<std::int64_t>(all), "solves"),
                    redraw ? ", targets and starts from the seed" : "", made, seal, fmt::join(unchecked, "; "));
    fmt::print("{}\n{}\n", printable(wrapped(text)), printable(line));
    const std::string lack = missing_solves_text(store, study);
    if (lack.empty()) return;
    print_message(fmt::format("{} {}", study.name, lack));
    invocation.exit_code = 5;
  });
}

}  // namespace ikbench::cli
