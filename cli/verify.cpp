// ikbench verify: checks whether a store has what the solvers did.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "base/names.hpp"
#include "cli/console.hpp"
#include "cli/reporting.hpp"
#include "experiments/known_answers.hpp"
#include "experiments/stored_checks.hpp"
#include "results/fingerprint.hpp"
#include "results/merge.hpp"

namespace ikbench::cli {

namespace {

struct VerifyArguments {
  std::string store, study, seal;
  std::int64_t solves = 100;
};

// Compares a fact that was stored when the store was archived with what holds now. Returns false if the store has no
// such fact. Throws std::invalid_argument, with `name` in the message, if the fact has changed.
bool is_as_archived(const Store& store, const std::string& fact, std::string_view name, const std::string& now) {
  bool is_archived = false;
  for (const Session& session : store.sessions()) {
    const auto archived = session.environment.find(fact);
    if (archived == session.environment.end()) continue;
    is_archived = true;
    if (archived->second != now)
      throw std::invalid_argument(fmt::format(
          "{} was {} when it was archived, and is {} now; if solves were added since then, merge it into a new store",
          name, archived->second, now));
  }
  return is_archived;
}

// Returns a sentence on the store's seal; empty if the store is no archive. `line` is the fingerprint_line of the
// study. Throws std::invalid_argument if rows were changed, or if the seal is not `given`.
std::string seal_text(const Store& store, const std::string& given, const StoredStudy& study, const std::string& line) {
  const bool has_seal = std::ranges::any_of(
      store.sessions(), [](const Session& session) { return session.environment.contains(std::string(seal_fact)); });
  const std::string seal =
      has_seal || !given.empty() ? seal_of(store) : "";  // computed only if needed, because a seal reads all rows
  const bool is_sealed = is_as_archived(store, std::string(seal_fact), "its seal", seal);
  const bool is_of_solves =
      is_as_archived(store, fmt::format("{}{}", fingerprint_fact, study.name), "its content", line);
  if (!given.empty()) {
    if (!is_sealed && lower_case(given) != seal)
      throw std::invalid_argument("it has no seal, so it is not an archive, or an older ikbench made it");
    if (lower_case(given) != seal)
      throw std::invalid_argument(fmt::format(
          "its seal is {}, not the given {}, so it is another archive, or it was changed since it was archived", seal,
          given));
    return "It has the given seal, so it is unchanged since it was archived, times and extras included. ";
  }
  if (is_sealed)
    return fmt::format(
        "It is unchanged since somebody archived it, times and extras included (seal {}). To compare with a seal that "
        "is printed elsewhere, add --seal SEAL. ",
        seal);
  if (is_of_solves)
    return "Its solves are unchanged since it was archived, but the seal of an older ikbench does not cover times and "
           "extras. ";
  return "";
}

// Throws std::invalid_argument if the text cannot be the seal of an archive.
void check_seal(const std::string& seal) {
  constexpr std::size_t digits = 64;
  if (!seal.empty() && (seal.size() != digits || seal.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos))
    throw std::invalid_argument(fmt::format(
        "--seal {}: expected the {} hexadecimal digits that `ikbench export --format archive` prints", seal, digits));
}

// Counts all answers again, if the store has such counts. Returns false if this version cannot. Throws
// std::invalid_argument if the store has other counts.
bool are_counts_repeated(const Store& store, const StoredStudy& study) {
  const CountedAnswers stored = store.counted_answers(study.name);
  if (stored.targets.empty()) return true;
  const std::optional<CountedAnswers> now = experiments::recounted_answers(study, store);
  if (now && *now != stored)
    throw std::invalid_argument("the stored counts of all answers are not those that follow from the solves");
  return now.has_value();
}

// Verifies a study of the store, and prints what was checked. Returns the exit code: 5 if solves are missing.
int verify_study(const Store& store, const StoredStudy& study, const VerifyArguments& arguments) {
  const SolveVisitor redraw = target_replay_check(study);
  const auto checked = read_checked(store, study, redraw).solves.size();
  const std::string line = fingerprint_line(store, study), seal = seal_text(store, arguments.seal, study, line);
  std::optional<ProgressBar> bar("repeating");
  const RerunReport again =
      rerun_sample(store, study, arguments.solves, [&](const Progress& progress) { bar->show(progress); });
  bar.reset();  // clears the line of the bar for the answer
  std::vector<std::string> unchecked{redraw
                                         ? "whether times, traces and extras were true when they were stored"
                                         : "whether times, targets, starts, traces and extras were true when they were "
                                           "stored"};
  const auto leave_out = [&](const std::vector<std::string>& labels, const char* reason) {
    if (labels.empty()) return;
    unchecked.push_back(fmt::format("answers and counts of {}{}", fmt::join(labels, ", "), reason));
  };
  if (!are_counts_repeated(store, study)) unchecked.emplace_back("the counts of all answers");
  if (!study.definition.check.process.empty()) unchecked.emplace_back("the results of the study's own check");
  leave_out(again.external, " (programs and libraries)");
  leave_out(again.changed_source, " (their source differs in this version)");
  if (study.definition.stop.seconds > 0) leave_out({"all solves"}, ", which a time limit may end");
  const std::string repeated =
      again.solves == 0 ? "No solve was repeated."
                        : fmt::format("{} of {} solves, chosen at random, were repeated: same bits, same counts.",
                                      again.solves, again.eligible);
  const std::string text =
      fmt::format("{}: errors, joint motion and status of all {} follow from their answers{}. {}\n{}Not checked: {}.",
                  study.name, base::counted(static_cast<std::int64_t>(checked), "solves"),
                  redraw ? ", targets and starts from the seed" : "", repeated, seal, fmt::join(unchecked, "; "));
  fmt::print("{}\n{}\n", printable(wrapped(text)), printable(line));
  for (const std::string& label : again.changed_answers)
    warn(
        fmt::format("the file of {}'s answers was changed since they were solved; to judge it as it is now, run the "
                    "study again",
                    label));
  const std::string lack = missing_solves_text(store, study);
  if (lack.empty()) return 0;
  print_message(fmt::format("{} {}", study.name, lack));
  return 5;
}

}  // namespace

void add_verify(const Command& command, Invocation& invocation) {
  auto arguments = std::make_shared<VerifyArguments>();
  command.add("STORE", &arguments->store, "path of a store.sqlite").required();
  add_study_option(command, arguments->study,
                   "name of the study; default: all studies of a sweep, otherwise the first in the store");
  command.add("--solves", &arguments->solves, "number of solves to repeat, chosen at random").whole_number();
  command.add("--seal", &arguments->seal, "the seal of the archive, as printed in a paper or with a release");
  command.footer(
      "  ikbench verify theirs.sqlite\n"
      "  ikbench verify theirs.sqlite --solves 1000000     all of them");
  command.callback([arguments, &invocation] {
    check_seal(arguments->seal);
    const Store store(arguments->store, Store::Mode::read);
    std::vector<StoredStudy> studies = store.sweep(arguments->study);  // all studies of a sweep
    if (studies.empty()) studies.push_back(store.study(arguments->study));
    for (const StoredStudy& study : studies)
      invocation.exit_code = std::max(invocation.exit_code, verify_study(store, study, *arguments));
  });
}

}  // namespace ikbench::cli
