// ikbench verify: whether a store has what its solvers did.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <optional>

#include "base/names.hpp"
#include "cli/console.hpp"
#include "cli/reporting.hpp"
#include "experiments/runner.hpp"
#include "results/fingerprint.hpp"
#include "results/merge.hpp"

namespace ikbench::cli {

void add_verify(const Command& command, Invocation& invocation) {
  struct Arguments {
    std::string store, study;
    std::int64_t solves = 100;
  };
  auto arguments = std::make_shared<Arguments>();
  command.add("STORE", &arguments->store, "path of a store.sqlite").required();
  add_study_option(command, arguments->study);
  command.add("--solves", &arguments->solves, "number of solves to make again, drawn at random").whole_number();
  command.footer(
      "  ikbench verify theirs.sqlite\n"
      "  ikbench verify theirs.sqlite --solves 1000000     all of them");
  command.callback([arguments, &invocation] {
    const Store store(arguments->store, Store::Mode::read);
    const StoredStudy study = store.study(arguments->study);
    const TakeSolve redraw = redraw_of(study);
    const auto all = checked_study(store, study, redraw).solves.size();
    const std::string seal = seal_of(store, study);
    for (const Session& session : store.sessions()) {
      const auto its = session.environment.find(fmt::format("{}{}", seal_fact, study.name));
      if (its != session.environment.end() && its->second != seal)
        throw std::invalid_argument(
            fmt::format("it was archived as {}; now it is {}; if more was solved since, merge it into a new store",
                        its->second, seal));
    }
    std::optional<ProgressBar> bar("solving again");
    const SolvedAgain again =
        solve_again(store, study, arguments->solves, [&](const Progress& progress) { bar->show(progress); });
    bar.reset();  // leaves its line to the answer
    std::vector<std::string> unchecked{redraw ? "times, traces and extras"
                                              : "times, targets, starts, traces and extras"};
    const auto leave_out = [&](const std::vector<std::string>& labels, const char* why) {
      if (!labels.empty()) unchecked.push_back(fmt::format("answers and counts of {}{}", fmt::join(labels, ", "), why));
    };
    if (!study.definition.check.process.empty()) unchecked.emplace_back("what the study's check said");
    leave_out(again.foreign, " (programs and libraries)");
    leave_out(again.of_other_source, " (the source is another in this version)");
    if (study.definition.stop.seconds > 0) leave_out({"all solves"}, ", which a clock may end");
    const std::string made =
        again.solves == 0 ? "None was made again."
                          : fmt::format("{} of {}, drawn at random, were made again and have the same bits and counts.",
                                        again.solves, again.of);
    const std::string text =
        fmt::format("{}: errors, joint motion and status of all {} follow from their answers{}. {}\nNot checked: {}.",
                    study.name, base::counted(static_cast<std::int64_t>(all), "solves"),
                    redraw ? ", targets and starts from the seed" : "", made, fmt::join(unchecked, "; "));
    fmt::print("{}\n{}\n", printable(wrapped(text)), printable(seal));
    const std::string lack = lack_of(store, study);
    if (lack.empty()) return;
    say(fmt::format("{} {}", study.name, lack));
    invocation.exit_code = 5;
  });
}

}  // namespace ikbench::cli
