#include "analysis/figures/figure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <thread>

#include "analysis/figures/dark.hpp"
#include "analysis/figures/process.hpp"
#include "analysis/inference/text.hpp"
#include "numerics/embedded_file.hpp"
#include "numerics/number.hpp"
#include "results/files.hpp"

namespace ikbench::figures {

using namespace numerics;
using namespace results;

namespace {

constexpr EmbeddedFile style_file[]{
#include "style.inc"
};

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

// The complete script of a figure.
std::string script_of(const Figure& figure) {
  std::string script = fmt::format(
      "# To draw it again: gnuplot {0}.gp\ndata = '{0}.dat'\nwidth_cm = {1}\nheight_cm = {2}\nload 'style.gp'\n\n{3}\n",
      figure.name, text_of(figure.width_cm), text_of(figure.height_cm), figure.settings);
  const bool can_repeat = !figure.plot.starts_with("set multiplot");
  for (const PictureType& type : picture_types) {
    script += fmt::format("set terminal @{0}\nset output '{1}.{0}'\n{2}\n", type.name, figure.name,
                          can_repeat && type.name != "svg" ? "replot" : figure.plot);
  }
  return script + "unset output\n";
}

// A line above a script with its digest, so that an edit shows.
std::string first_line(std::string_view script) {
  std::uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a
  for (const char c : script) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return fmt::format("# Written by ikbench ({:016x}). Edit it: the next report keeps it and draws with it.\n", hash);
}

// The script in the file if the user has edited it. Ignores links, which may lead anywhere.
std::optional<std::string> edited_script(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(file, ignored))) return std::nullopt;
  std::optional<std::string> text = read_file(file);
  if (!text || text->empty()) return std::nullopt;
  const std::string_view rest = std::string_view(*text).substr(std::min(text->find('\n'), text->size() - 1) + 1);
  return *text == first_line(rest).append(rest) ? std::nullopt : text;
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
    sources.push_back({file, edited.value_or(first_line(script) + script), edited.has_value()});
  };
  std::string style(style_file->text);
  constexpr std::string_view place = "COLOURS";
  style.replace(style.find(place), place.size(), fmt::format("{}", fmt::join(series_colours, " ")));
  add_script(std::string(style_file->name), style);
  for (const Figure& figure : figures) {
    add_script(figure.name + ".gp", script_of(figure));
    sources.push_back({.file = figure.name + ".dat", .text = figure.data});
  }
  return sources;
}

}  // namespace

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
  std::mutex one_at_a_time;
  std::int64_t done = 0;
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
      if (!options.progress) continue;
      const std::scoped_lock lock(one_at_a_time);
      options.progress(++done, static_cast<std::int64_t>(figures.size()));
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
