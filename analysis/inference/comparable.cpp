#include "analysis/inference/comparable.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "analysis/inference/study_facts.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

using SolverLabels = std::vector<std::string>;

std::string list_of(const SolverLabels& labels) { return one_line(fmt::format("{}", fmt::join(labels, ", "))); }

template <class Is>
SolverLabels those(const StudyResults& study, Is is) {
  SolverLabels labels;
  std::ranges::copy_if(study.solvers, std::back_inserter(labels), is);
  return labels;
}

std::ptrdiff_t timed(const StudyResults& study, Timing how) {
  return std::ranges::count(study.solves, how, &Solve::timing);
}

bool has(std::span<const Solve> solves, CountedBy by) {
  return std::ranges::find(solves, by, &Solve::counted_by) != solves.end();
}

void add_sentence(std::string& text, const std::string& sentence) {
  text += text.empty() || sentence.empty() ? sentence : " " + capitalised(sentence);
}

struct Disturbed {
  std::ptrdiff_t solves = 0, timed = 0;
};

Disturbed disturbed(std::span<const Solve> solves) {
  const auto is_timed = [](const Solve& solve) {
    return solve.timing == Timing::clean || solve.timing == Timing::process;
  };
  return {std::ranges::count_if(solves, [](const Solve& solve) { return solve.is_disturbed; }),
          std::ranges::count_if(solves, is_timed)};
}

// Where solves end by their wall time, more than times depend on the machine.
std::string and_errors(const StudyResults& study) {
  return study.facts.stop.seconds > 0 ? " Solves end by their wall time, so that errors depend on that too." : "";
}

// Why times of solvers are left out, one kind after another. Those of a kind lack nothing else.
struct TimesLeftOut {
  SolverLabels imported, disturbed, programs;

  explicit TimesLeftOut(const StudyResults& study) {
    imported = those(study, [&](const std::string& solver) { return is_imported(study, solver); });
    disturbed = those(study, [&](const std::string& solver) { return times_were_disturbed(study, solver); });
    const bool is_mixed = std::ranges::any_of(study.solvers, [&](const std::string& solver) {
      return !solves_of(study, solver).empty() && !is_imported(study, solver) && !is_program(study, solver);
    });
    if (!is_mixed || study.plan.program_times == ProgramTimes::compared) return;
    programs = those(study, [&](const std::string& solver) {
      return is_program(study, solver) && !times_were_disturbed(study, solver);
    });
  }

  std::size_t size() const { return imported.size() + disturbed.size() + programs.size(); }
};

std::string disturbed_words(const StudyResults& study, const SolverLabels& labels) {
  Disturbed found;
  bool has_programs = false;
  for (const std::string& label : labels) {
    const Disturbed own = disturbed(solves_of(study, label));
    found.solves += own.solves;
    found.timed += own.timed;
    has_programs |= is_program(study, label);
  }
  return fmt::format("{} of {} solves took more than 1.1 times their CPU time{}, so other programs were running.{}",
                     found.solves, found.timed,
                     has_programs ? ", or waited for a processor for more than a tenth of it" : "", and_errors(study));
}

LeftOut times_left_out(const StudyResults& study) {
  const TimesLeftOut kinds(study);
  LeftOut result;
  for (const SolverLabels* labels : {&kinds.imported, &kinds.disturbed, &kinds.programs}) {
    result.solvers.insert(labels->begin(), labels->end());
  }
  const auto add = [&](const SolverLabels& labels, const std::string& why) {
    if (!labels.empty()) {
      add_sentence(result.note, fmt::format("Times are left out: those of {}, because {}", list_of(labels), why));
    }
  };
  add(kinds.imported, "its solves were imported, so their times were taken elsewhere.");
  if (!kinds.disturbed.empty()) add(kinds.disturbed, disturbed_words(study, kinds.disturbed));
  add(kinds.programs, programs_words("they"));
  return result;
}

LeftOut evaluations_left_out(const StudyResults& study) {
  const SolverLabels nobody =
      those(study, [&](const std::string& solver) { return has(solves_of(study, solver), CountedBy::nobody); });
  const bool is_counted_here = std::ranges::any_of(study.solvers, [&](const std::string& solver) {
    const std::span<const Solve> solves = solves_of(study, solver);
    return has(solves, CountedBy::suite) && !has(solves, CountedBy::nobody);
  });
  const SolverLabels claimed = those(study, [&](const std::string& solver) {
    const std::span<const Solve> solves = solves_of(study, solver);
    return is_counted_here && has(solves, CountedBy::solver) && !has(solves, CountedBy::nobody);
  });
  LeftOut result;
  for (const SolverLabels* labels : {&nobody, &claimed}) result.solvers.insert(labels->begin(), labels->end());
  if (!nobody.empty()) result.note = fmt::format("Nobody counted the evaluations of {}.", list_of(nobody));
  if (!claimed.empty()) {
    add_sentence(result.note,
                 fmt::format("Evaluations of {} are not compared: they are its own word, and the others' were counted.",
                             list_of(claimed)));
  }
  return result;
}

// Of the whole study, whoever solved it.
std::string machine_note(const StudyResults& study) {
  const auto parallel = timed(study, Timing::parallel), debug = timed(study, Timing::debug_build);
  if (parallel + debug > 0) {
    return fmt::format(
        "Times are not comparable: of {} solves, {} ran in parallel with others and {} in a debug build.{}",
        study.solves.size(), parallel, debug, and_errors(study));
  }
  std::string note = cpu_note(study.cpus);
  return note.empty() ? note : note + and_errors(study);
}

}  // namespace

std::string programs_words(std::string_view whose) {
  return fmt::format(
      "{} have messages and another process in them. analysis.program_times = \"compared\" compares them all the same.",
      whose);
}

LeftOut left_out(const StudyResults& study, Metric metric) {
  if (metric == Metric::evaluations) return evaluations_left_out(study);
  return info_of(metric).kind == Kind::time ? times_left_out(study) : LeftOut{};
}

StudyResults compared_in(StudyResults study, Metric metric) {
  const LeftOut without = left_out(study, metric);
  if (without.solvers.empty()) return study;
  return of_solvers(std::move(study), [&](std::string_view solver) { return !without.solvers.contains(solver); });
}

std::string timing_note(const StudyResults& study) {
  if (std::string note = machine_note(study); !note.empty()) return note;
  const TimesLeftOut without(study);
  if (without.size() == 0 || without.size() + 2 <= study.solvers.size()) return "";
  std::string why;
  if (!without.imported.empty()) {
    add_sentence(why, fmt::format("{} of {} solves were imported, so their times were taken elsewhere.",
                                  timed(study, Timing::imported), study.solves.size()));
  }
  if (!without.disturbed.empty()) add_sentence(why, disturbed_words(study, study.solvers));
  if (!without.programs.empty()) add_sentence(why, programs_words("those of " + list_of(without.programs)));
  return "Times are not comparable: " + why;
}

std::string timing_note(const StudyResults& study, std::string_view solver) {
  if (std::string note = machine_note(study); !note.empty()) return note;
  return timing_note(of_solvers(study, [&](std::string_view name) { return name == solver; }));
}

std::string times_note(const StudyResults& study) {
  std::string note = timing_note(study);
  return note.empty() ? left_out(study, Metric::seconds).note : note;
}

bool times_are_comparable(const StudyResults& study) { return timing_note(study).empty(); }

bool is_comparable(const StudyResults& study, Metric metric) {
  return info_of(metric).kind != Kind::time || times_are_comparable(study);
}

bool times_were_disturbed(const StudyResults& study, std::string_view solver) {
  const Disturbed found = disturbed(solves_of(study, solver));
  return found.solves > 1 && 10 * found.solves > found.timed;
}

bool is_program(const StudyResults& study, std::string_view solver) {
  const std::span<const Solve> solves = solves_of(study, solver);
  return std::ranges::find(solves, Timing::process, &Solve::timing) != solves.end();
}

std::string cpu_note(const std::set<std::string>& cpus) {
  return cpus.size() < 2
             ? ""
             : fmt::format("Times are not comparable: they come from different machines ({}).", fmt::join(cpus, ", "));
}

std::string transport_note(const StudyResults& study) {
  std::vector<std::string> found;
  for (const std::string& solver : study.solvers) {
    const std::vector<double>& shares = gathered_of(study, solver).transport_shares;
    if (!shares.empty() && median(shares) >= 0.5) found.push_back(one_line(solver));
  }
  return found.empty() ? ""
                       : fmt::format("At least half of the time of {} is transport: messages to the program and back.",
                                     fmt::join(found, ", "));
}

std::string evaluation_note(const StudyResults& measured) {
  if (!times_are_comparable(measured)) return "";
  const StudyResults study = compared_in(measured, Metric::seconds);
  if (study.external.empty() || study.external.size() == study.solvers.size()) return "";
  return fmt::format(
      "Times depend on how candidates are evaluated: built-in swarms evaluate many at once, which costs less each; {} "
      "(library, program or shared object) may evaluate one by one.",
      one_line(fmt::format("{}", fmt::join(study.external, ", "))));
}

}  // namespace ikbench::inference
