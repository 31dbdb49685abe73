// Figures as gnuplot scripts with their numbers. Every figure of the program is written by write_figures. The scripts
// are kept in source/ below the pictures, where `gnuplot NAME.gp` draws a picture again.
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

// A figure that is not drawn yet.
struct Figure {
  std::string name;       // stable, the files' name: "path"
  std::string caption;    // plain text
  double width_cm = 8.5;  // one column of a journal
  double height_cm = 6.4;
  std::string settings = {};  // gnuplot commands before the plot; foreign text through gnuplot_text
  std::string plot = {};      // the one plot or splot command, or those from "set multiplot" on; reads `data`
  std::string data = {};      // the numbers as drawn; comment lines start with '#'
  std::string titles = {};    // gnuplot commands that set x_title and y_title, in place of the figure's own
  std::size_t legend = 0;     // rows of the legend; style.gp adds room for the rows
  double sides_cm = 2.2;      // width of everything beside the plot
  std::string pointer = {};  // JSON: what the page says of the place below the pointer (map_pointer.js); empty: nothing
  bool is_dense = false;     // an SVG is too large for a page, so a PNG is drawn, too
};

// The subject of a figure: the name of the files, the plain text below the picture, and the quantity shown.
struct About {
  std::string name, caption;
  std::string quantity = {}, unit = {};
  double floor = 0;       // smaller values stand at the edge of a logarithmic axis
  bool is_share = false;  // then no axis is logarithmic

  // Returns the title of an axis: "error [mm]".
  std::string axis() const { return unit.empty() ? quantity : quantity + " [" + unit + ']'; }
};

// The choices of a user about figures.
struct RenderOptions {
  std::vector<std::string> only = {};  // names of a report's figures (is_meant in look.hpp); "none": none; empty: all
  std::string gnuplot = "gnuplot";     // the program, sought on the PATH
  std::function<void(std::int64_t drawn, std::int64_t all)> progress = {};  // called by one thread at a time
  results::FigureStyle style = {};
};

// Throws std::invalid_argument if the machine lacks the font of the style, because gnuplot would take another font
// without a word. Throws std::invalid_argument, too, if no font has a character of a label, because gnuplot would draw
// black areas.
void refuse_missing_font(const results::FigureStyle& style, const std::vector<std::string>& labels);

// Writes source/NAME.gp and source/style.gp into the folder and draws NAME.svg, NAME.pdf and NAME.png, as the style
// says. No script that was in the folder before is ever run. Removes old pictures that do not show these data. Returns
// a sentence for each figure that could not be drawn or about which gnuplot warns, or one sentence if gnuplot does not
// start. Throws std::invalid_argument if the folder cannot be written to, and std::runtime_error if a disk is full.
std::vector<std::string> write_figures(const std::vector<Figure>& figures, const std::filesystem::path& folder,
                                       const RenderOptions& options);

}  // namespace ikbench::figures
