// Figures: a gnuplot script with its numbers each, kept in source/ below the pictures, which `gnuplot NAME.gp` there
// draws again. Every figure of the program uses this module.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "results/figure_style.hpp"

namespace ikbench::figures {

constexpr const char* sources = "source";  // the folder of scripts

struct Figure {
  std::string name;       // stable, the files' name: "path"
  std::string caption;    // plain text
  double width_cm = 8.5;  // one column of a journal
  double height_cm = 6.4;
  std::string settings = {};  // gnuplot commands before the plot; foreign text through gnuplot_text
  std::string plot = {};      // the one plot or splot command, or those from "set multiplot" on; reads `data`
  std::string data = {};      // the numbers as drawn; comment lines start with '#'
  std::string titles = {};    // gnuplot commands that set x_title and y_title, in place of the figure's own
  std::size_t legend = 0;     // its rows; style.gp adds the room for them
  double sides_cm = 2.2;      // the width of all beside the plot
};

// The subject of a figure: the name of the files, the plain text below the picture, and the quantity shown.
struct About {
  std::string name, caption;
  std::string quantity = {}, unit = {};
  double floor = 0;       // a logarithmic axis has smaller values at its edge
  bool is_share = false;  // of which no axis is logarithmic

  std::string axis() const { return unit.empty() ? quantity : quantity + " [" + unit + ']'; }
};

struct RenderOptions {
  std::vector<std::string> only = {};  // names of a report's figures (is_meant in look.hpp); "none": none; empty: all
  std::string gnuplot = "gnuplot";     // the program, sought on the PATH
  std::function<void(std::int64_t drawn, std::int64_t all)> progress = {};  // called by one thread at a time
  results::FigureStyle style = {};
};

// Throws std::invalid_argument if the machine lacks the font, for which gnuplot would take another without a word, or
// has no font for a character of a label, in whose place gnuplot would draw black areas.
void refuse_missing_font(const results::FigureStyle& style, const std::vector<std::string>& labels);

// Writes source/NAME.gp and source/style.gp into the folder and draws NAME.svg, NAME.pdf, NAME.png, as the style says;
// no script that was there is ever run. Removes old pictures that do not show these data. Returns a sentence for each
// figure that could not be drawn or of which gnuplot warns, or one if gnuplot does not start. Throws
// std::invalid_argument if the folder cannot be written to, std::runtime_error if a disk is full.
std::vector<std::string> write_figures(const std::vector<Figure>& figures, const std::filesystem::path& folder,
                                       const RenderOptions& options);

}  // namespace ikbench::figures
