// Draws figures as SVG alone, by one gnuplot, which costs far less than each in three formats.
#pragma once

#include "analysis/figures/figure.hpp"
#include "analysis/figures/look.hpp"
#include "analysis/figures/of_study.hpp"
#include "analysis/figures/parts.hpp"
#include "analysis/figures/plots.hpp"
#include "analysis/figures/rows.hpp"
#include "analysis/slim2023/slim2023.hpp"
#include "base/child_process.hpp"
#include "base/files.hpp"
#include "experiments/study/reader.hpp"
#include "results/store.hpp"
#include "tests/judge/studies.hpp"

using namespace ikbench::base;
using namespace ikbench::results;
using namespace ikbench::figures;

namespace ikbench {

// Writes the figures into the folder and draws them. Returns gnuplot's message if one could not be drawn, else "".
inline std::string drawn_as_svg(const std::vector<figures::Figure>& figures, const std::filesystem::path& folder) {
  figures::write_figures(figures, folder, {.gnuplot = "none"});
  const std::filesystem::path scripts = folder / figures::sources;
  std::string all;
  for (const figures::Figure& figure : figures) {
    const std::string script = text_in(scripts / (figure.name + ".gp"));
    all += script.substr(0, script.find("set terminal @pdf")) + "unset output\nreset session\n";
  }
  base::write_file(scripts / "all.gp", all);
  const auto result = base::ChildProcess::run({"gnuplot", "-d", "all.gp"}, scripts, {});
  std::filesystem::remove(scripts / "all.gp");
  for (const figures::Figure& figure : figures) {
    const std::string svg = text_in(folder / (figure.name + ".svg"));
    if (result.succeeded && svg.ends_with("</svg>\n\n")) continue;
    return figure.name + " is not drawn: " + result.output;
  }
  return "";
}

}  // namespace ikbench
