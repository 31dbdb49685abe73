// Draws figures as SVG alone, by one gnuplot, which costs far less than each in three formats.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "results/child_process.hpp"
#include "results/files.hpp"
#include "tests/scratch_folder.hpp"

namespace ikbench {

inline std::string text_of_file(const std::filesystem::path& file) { return results::read_file(file).value_or(""); }

// Writes the figures into the folder and draws them. Returns gnuplot's message if one could not be drawn, else "".
inline std::string drawn_as_svg(const std::vector<figures::Figure>& figures, const std::filesystem::path& folder) {
  figures::write_figures(figures, folder, {.render = false});
  std::string all;
  for (const figures::Figure& figure : figures) {
    const std::string script = text_of_file(folder / (figure.name + ".gp"));
    all += script.substr(0, script.find("set terminal @pdf")) + "unset output\nreset session\n";
  }
  results::write_file(folder / "all.gp", all);
  const auto result = results::ChildProcess::run({"gnuplot", "-d", "all.gp"}, folder, {});
  std::filesystem::remove(folder / "all.gp");
  for (const figures::Figure& figure : figures) {
    const std::string svg = text_of_file(folder / (figure.name + ".svg"));
    if (result.succeeded && svg.ends_with("</svg>\n\n")) continue;
    return figure.name + " is not drawn: " + result.output;
  }
  return "";
}

}  // namespace ikbench
