#include "analysis/figures/figure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <thread>

#include "analysis/figures/dark.hpp"
#include "analysis/figures/edited.hpp"
#include "analysis/figures/process.hpp"
#include "analysis/inference/text.hpp"
#include "numerics/number.hpp"
#include "results/files.hpp"

namespace ikbench::figures {

using namespace numerics;
using namespace results;

namespace {

const std::string style_file = "style.gp";

struct PictureType {
  std::string_view name, end;  // the end of a whole file
};
constexpr std::array<PictureType, 3> picture_types{
    {{"svg", "</svg>"}, {"pdf", "%%EOF"}, {"png", "IEND\xAE\x42\x60\x82"}}};

// Removes pictures of an earlier report; a link or a device in their place is not ours to remove.
void remove_pictures(const std::string& name, const std::filesystem::path& folder) {
  std::error_code ignored;
  for (const PictureType& type : picture_types) {
    const std::filesystem::path file = folder / fmt::format("{}.{}", name, type.name);
    if (std::filesystem::is_regular_file(std::filesystem::symlink_status(file, ignored)))
      std::filesystem::remove(file, ignored);
  }
}

// Makes the same figure the same bytes: Cairo writes the time of drawing into a PDF. Fills with blanks, because offsets
// follow.
void blank_date(std::string& pdf) {
  const std::size_t begin = pdf.find("/CreationDate (");
  if (begin == std::string::npos) return;
  const std::size_t end = std::min(pdf.find(')', begin), pdf.size() - 1) + 1;
  std::fill(pdf.begin() + static_cast<std::ptrdiff_t>(begin), pdf.begin() + static_cast<std::ptrdiff_t>(end), ' ');
}

// Adds similar fonts: gnuplot names only one, and machines without it would show other letters.
void name_similar_fonts(std::string& svg) {
  constexpr std::string_view one = "font-family=\"Liberation Sans\"",
                             several = "font-family=\"Liberation Sans, Arial, Helvetica, sans-serif\"";
  for (std::size_t at = svg.find(one); at != std::string::npos; at = svg.find(one, at + several.size())) {
    svg.replace(at, one.size(), several);
  }
}

// Draws in the workshop, then writes the pictures to their place. Throws std::invalid_argument with the reason if it
// could not, std::runtime_error if a disk is full.
void draw(const Figure& figure, const std::filesystem::path& workshop, const std::string& gnuplot) {
  // -d gives the same look whatever ~/.gnuplot says.
  const ProcessResult result = run_process({gnuplot, "-d", figure.name + ".gp"}, workshop);
  if (!result.succeeded) {
    throw std::invalid_argument(result.output.empty() ? fmt::format("{} failed without a message", gnuplot)
                                                      : result.output);
  }
  for (const auto& [type, end] : picture_types) {
    const std::string file = fmt::format("{}.{}", figure.name, type);
    std::optional<std::string> picture = read_file(workshop / file);
    if (!picture) throw std::invalid_argument(fmt::format("{} drew no {}: {}", gnuplot, file, result.output));
    const std::filesystem::path place = workshop.parent_path() / file;
    if (picture->find(end, picture->size() - std::min(picture->size(), end.size() + 2)) == std::string::npos)
      // gnuplot does not say that a disk is full
      throw std::runtime_error(
          fmt::format("cannot write '{}': {} wrote only a part of it; is the disk full?", place.string(), gnuplot));
    if (type == "pdf") blank_date(*picture);
    if (type == "svg") name_similar_fonts(*picture);
    write_file(place, *picture);
  }
}

struct Source {
  std::string file, text;
  bool is_edited = false;  // by the user, so it stays
};

// The files that a report writes beside its pictures, or the user's edited scripts.
std::vector<Source> sources_of(const std::vector<Figure>& figures, const std::filesystem::path& folder) {
  std::vector<Source> sources;
  const auto add_script = [&](const std::string& file, const std::string& script) {
    const std::optional<std::string> edited = edited_script(folder / file);
    sources.push_back({file, edited.value_or(with_digest(script)), edited.has_value()});
  };
  add_script(style_file, figure_style());
  for (const Figure& figure : figures) {
    add_script(figure.name + ".gp", script_of(figure));
    sources.push_back({.file = figure.name + ".dat", .text = figure.data});
  }
  return sources;
}

}  // namespace

std::string figure_style() {
  std::string style = R"(# The look of every figure in this folder. Change it here, then draw again: gnuplot NAME.gp
set encoding utf8

# Characters that mean something to gnuplot, for labels.
array character[126]
do for [i = 33:126] { character[i] = sprintf("%c", i) }

# A palette that the colour-blind can tell apart, and none of it too pale for white; markers tell the curves apart without
# colour, and dashes those that would repeat a colour.
colours = "COLOURS"
markers = "7 5 9 11 13 4 2 6 8 10 12 1 3"
dashes = "1 11 12 13 14"
set dashtype 11 (5, 2)
set dashtype 12 (1.5, 2)
set dashtype 13 (6, 2, 1.5, 2)
set dashtype 14 (2.5, 1.5)
do for [i = 1:91] {
  set style line i lw 0.9 ps 0.45 lc rgb word(colours, (i - 1) % 7 + 1) pt int(word(markers, (i - 1) % 13 + 1)) \
    dt int(word(dashes, int((i - 1) / 7) % 5 + 1))
}
set style line 100 lw 0.4 lc rgb "#DDDDDD" dt 1
set style line 101 lw 1.3 lc rgb "#000000" dt 1

set border 3 lw 0.6
set tics out nomirror scale 0.6, 0.3
set grid xtics ytics ls 100
set key below horizontal Left reverse noenhanced samplen 2 spacing 1.1 height 0.8
set xtics noenhanced offset 0, 0.3
set xlabel offset 0, 0.85
set ylabel offset 0.5, 0

# The size of text [pt]. Names beside an axis are smaller, remarks smaller still. Heights, margins and legends follow it.
text = 8
height_cm = height_cm * text / 8
names = sprintf(",%g", 0.875 * text)
remarks = sprintf(",%g", 0.75 * text)
margin(cm) = cm * text / 8 < 0.65 * width_cm ? cm * text / 8 / width_cm : 0.65
columns(cm) = cm * text / 8 < width_cm ? int(width_cm / cm / text * 8) : 1

# Three outputs of the same size, with thin lines in each: SVG in units of a point, PDF, PNG at 300 dpi. To Cairo a point of
# text is 1/96 inch.
svg = sprintf("svg enhanced size %d,%d dynamic font 'Liberation Sans,%g' linewidth 0.8 background '#FFFFFF'", \
  width_cm / 2.54 * 72, height_cm / 2.54 * 72, text)
pdf = sprintf("pdfcairo enhanced size %gcm,%gcm font 'Liberation Sans,%g' fontscale 0.75 linewidth 1.2 pointscale 1.1", \
  width_cm, height_cm, text)
png = sprintf("pngcairo enhanced size %d,%d font 'Liberation Sans,%g' fontscale 3.125 linewidth 4 pointscale 3.5", \
  width_cm / 2.54 * 300, height_cm / 2.54 * 300, text)
)";
  constexpr std::string_view place = "COLOURS";
  return style.replace(style.find(place), place.size(), fmt::format("{}", fmt::join(series_colours, " ")));
}

std::string script_of(const Figure& figure) {
  std::string script = fmt::format("# To draw it again: gnuplot {}.gp\n", figure.name);
  script += fmt::format("width_cm = {}\nheight_cm = {}\nload 'style.gp'\n\n", text_of(figure.width_cm),
                        text_of(figure.height_cm));
  script += figure.settings + '\n';
  for (const PictureType& type : picture_types) {
    script += fmt::format("set terminal @{0}\nset output '{1}.{0}'\n", type.name, figure.name);
    const bool is_to_be_said = &type == &picture_types.front() || figure.plot.starts_with("set multiplot");
    script += is_to_be_said ? figure.plot + '\n' : "replot\n";
  }
  return script + "unset output\n";
}

WrittenFigures write_figures(const std::vector<Figure>& figures, const std::filesystem::path& folder,
                             const RenderOptions& options) {
  const std::vector<Source> sources = sources_of(figures, folder);
  WrittenFigures written;
  for (const Source& source : sources) {
    if (source.is_edited) {
      written.edited_scripts.push_back(source.file);
    } else {
      write_file(folder / source.file, source.text);
    }
  }
  std::vector<FigureOutcome>& outcomes = written.outcomes;
  for (const Figure& figure : figures) outcomes.push_back({.name = figure.name});
  if (!options.render) return written;

  const TemporaryFolder workshop(folder);
  for (const Source& source : sources) write_file(workshop.path() / source.file, source.text);
  std::atomic<std::size_t> next = 0;
  std::vector<std::exception_ptr> failures(figures.size());  // these end the report, not only a figure
  const auto work = [&] {
    for (std::size_t i = next++; i < figures.size(); i = next++) {
      try {
        draw(figures[i], workshop.path(), options.gnuplot);
        outcomes[i].rendered = true;
      } catch (const std::invalid_argument& error) {
        outcomes[i].error = error.what();
      } catch (...) {
        failures[i] = std::current_exception();
        next = figures.size();
      }
      if (!outcomes[i].rendered) remove_pictures(figures[i].name, folder);
    }
  };
  std::vector<std::jthread> others;
  for (int job = 1; job < options.jobs; ++job) others.emplace_back(work);
  work();
  others.clear();  // joins
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
  return written;
}

}  // namespace ikbench::figures
