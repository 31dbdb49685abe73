#include "results/requirement.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "base/names.hpp"
#include "base/number.hpp"

namespace ikbench::results {

namespace {

constexpr std::array<std::string_view, 2> shares{"solved", "in-time"};

// Returns whether a sweep makes this label of `base`: whether a setting follows, as in "LM damping=0.1".
bool is_made_by_sweep(const std::string& label, const std::string& base) {
  if (!label.starts_with(base + ' ')) return false;
  const std::string setting = label.substr(base.size() + 1);
  return setting.find('=') < setting.find(' ');
}

}  // namespace

std::string Requirement::text() const {
  return fmt::format("{}{}{}={}%", solver, solver.empty() ? "" : ".", metric, 100 * share);
}

Requirement parse_requirement(std::string_view text) {
  const auto refuse = [&](const std::string& reason) {
    throw std::invalid_argument(fmt::format("{}: {}; expected such as solved=95%, or LABEL.solved=95% for one solver",
                                            base::in_quotes(text), reason));
  };
  const std::size_t equals = text.rfind('=');
  if (equals == std::string_view::npos) refuse("it has no \"=\"");
  const std::string_view name = text.substr(0, equals), value = text.substr(equals + 1);
  const std::size_t dot = name.rfind('.');
  Requirement requirement;
  if (dot != std::string_view::npos) requirement.solver = name.substr(0, dot);
  requirement.metric = dot == std::string_view::npos ? name : name.substr(dot + 1);
  if (dot == 0) refuse("the label before \".\" is empty");
  if (std::ranges::count(shares, requirement.metric) == 0)
    refuse(fmt::format("{} is not a share; a requirement is on one of {}", base::in_quotes(requirement.metric),
                       fmt::join(shares, ", ")));
  if (!value.ends_with('%')) refuse(fmt::format("{} has no percent sign", base::in_quotes(value)));
  const auto percent = value.ends_with('%') ? base::number_from(value.substr(0, value.size() - 1)) : std::nullopt;
  if (!percent || !(*percent > 0 && *percent < 100))
    refuse(fmt::format("{} is not a share above 0% and below 100% (no number of targets could show 100%)",
                       base::in_quotes(value)));
  requirement.share = *percent / 100;
  return requirement;
}

std::vector<Requirement> for_swept_labels(const std::vector<Requirement>& requirements,
                                          const std::vector<std::string>& labels) {
  std::vector<Requirement> all;
  for (const Requirement& requirement : requirements) {
    const std::size_t before = all.size();
    const bool is_base = !requirement.solver.empty() && std::ranges::count(labels, requirement.solver) == 0;
    for (const std::string& label : labels) {
      if (!is_base || !is_made_by_sweep(label, requirement.solver)) continue;
      all.push_back(requirement);
      all.back().solver = label;
    }
    if (all.size() == before) all.push_back(requirement);
  }
  return all;
}

}  // namespace ikbench::results
