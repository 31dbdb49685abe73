#include "analysis/figures/figure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <boost/algorithm/string/replace.hpp>
#include <boost/regex/pending/unicode_iterator.hpp>
#include <future>
#include <map>
#include <mutex>
#include <optional>
#include <regex>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include "base/child_process.hpp"
#include "base/embedded_file.hpp"
#include "base/files.hpp"
#include "base/names.hpp"
#include "base/number.hpp"

namespace ikbench::figures {

using namespace base;
using namespace results;

namespace {

constexpr EmbeddedFile style_file[]{
#include "style.inc"
};

// Removes pictures of an earlier report, except those of the types in `but_not`. A link or a device in the place of a
// picture was not made by a report, and stays.
void remove_pictures(const Figure& figure, const std::filesystem::path& folder,
                     const std::vector<std::string>& but_not) {
  for (const std::string& type : results::picture_formats) {
    const std::filesystem::path file = folder / (figure.name + "." + type);
    std::error_code ignored;
    const bool is_own = std::filesystem::is_regular_file(std::filesystem::symlink_status(file, ignored));
    if (is_own && std::ranges::count(but_not, type) == 0) std::filesystem::remove(file, ignored);
  }
}

// Adds a size in units of length, a title and further fonts to an SVG picture, which gnuplot cannot write. Also makes
// the strokes of points as thick as in other pictures, because gnuplot draws them 1 pt times the size of the point.
void complete_svg(std::string& svg, const Figure& figure) {
  const std::size_t box = svg.find("viewBox=\"0 0 "), end = svg.find('"', box + 13);
  if (box == std::string::npos || end == std::string::npos) return;
  std::string size = svg.substr(box + 13, end - box - 13);
  boost::replace_all(size, " ", "pt\" height=\"");
  svg.insert(box, "width=\"" + size + "pt\" ");
  static const std::regex stroke("stroke-width='[0-9.]+' stroke='currentColor'");
  svg = std::regex_replace(svg, stroke, "stroke-width='0.5' stroke='currentColor'");
  std::string title = one_line(figure.caption);
  for (const auto& [mark, entity] : {std::pair("&", "&amp;"), {"<", "&lt;"}, {">", "&gt;"}})
    boost::replace_all(title, mark, entity);
  boost::replace_all(svg, "<title>Gnuplot</title>", "<title>" + title + "</title>");
  boost::replace_all(svg, "font-family=\"Liberation Sans\"",
                     "font-family=\"Liberation Sans, Arial, Helvetica, sans-serif\"");
  boost::replace_all(svg, "]]>", "]]&gt;");  // gnuplot writes the > of a label, and XML forbids ]]> in a text
}

// Blanks out the date at which Cairo made a PDF, so that equal reports have equal bytes. The blanks keep the places
// that the PDF's own table names. Cairo 1.18 packs the date, which then stays.
void remove_date(std::string& pdf) {
  const std::size_t begin = pdf.rfind("/CreationDate (D:"), end = pdf.find(')', begin);
  if (begin == std::string::npos || end == std::string::npos) return;
  std::fill(pdf.begin() + static_cast<long>(begin), pdf.begin() + static_cast<long>(end) + 1, ' ');
}

// Returns the last bytes of a complete picture of this type.
std::string_view end_of_picture(const std::string& type) {
  if (type == "svg") return "</svg>";
  return type == "pdf" ? "%%EOF" : "IEND\xAE\x42\x60\x82";
}

// Returns the types of pictures that are drawn of a figure.
std::vector<std::string> formats_of(const Figure& figure, const FigureStyle& style) {
  std::vector<std::string> formats = style.formats;
  if (figure.is_dense && std::ranges::count(formats, "png") == 0) formats.emplace_back("png");
  return formats;
}

// Draws in the folder `workshop`, then writes the pictures to the folder above. Returns the warnings of gnuplot, such
// as those of unreadable data. Throws std::invalid_argument with the reason if nothing could be drawn, and
// std::runtime_error if a picture was cut, as by a full disk.
std::string draw(const Figure& figure, const std::filesystem::path& workshop, const RenderOptions& options) {
  const std::string& gnuplot = options.gnuplot;
  // With -d the settings of ~/.gnuplot change nothing. Without a locale of UTF-8 gnuplot 6 warns. A date in a PDF is as
  // long in one time zone as in another only if all have the same.
  const ChildProcess::Ran result =
      ChildProcess::run({gnuplot, "-d", figure.name + ".gp"}, workshop / sources, {"LC_ALL=C.UTF-8", "TZ=UTC0"});
  if (!result.succeeded)
    throw std::invalid_argument(result.output.empty() ? gnuplot + " failed without a message" : result.output);
  for (const std::string& type : formats_of(figure, options.style)) {
    const std::string_view end = end_of_picture(type);
    const std::string file = figure.name + "." + type;
    std::optional<std::string> picture = read_file(workshop / file);
    if (!picture) throw std::invalid_argument(fmt::format("{} drew no {}: {}", gnuplot, file, result.output));
    if (picture->find(end, picture->size() - std::min(picture->size(), end.size() + 2)) == std::string::npos)
      throw std::runtime_error(fmt::format("{} wrote only a part of '{}'; if the disk is full, make room", gnuplot,
                                           (workshop.parent_path() / file).string()));
    if (type == "svg") complete_svg(*picture, figure);
    if (type == "pdf") remove_date(*picture);
    write_file(workshop.parent_path() / file, *picture);
  }
  return result.output.find("warning:") == std::string::npos ? "" : result.output;
}

// Returns the complete script of a figure.
std::string script_of(const Figure& figure, const std::vector<std::string>& formats) {
  std::string script = fmt::format(
      "# To draw it again, into the folder above: gnuplot {0}.gp\nwidth_cm = {1}\nheight_cm = {2}\nlegend = {3}\n"
      "sides_cm = {4}\nload 'style.gp'\n{5}data = '$numbers'\n$numbers << END\n{6}END\n\n{7}\n",
      figure.name, text_of(figure.width_cm), text_of(figure.height_cm), figure.legend, text_of(figure.sides_cm),
      figure.titles, figure.data, figure.settings);
  const bool can_repeat = !figure.plot.starts_with("set multiplot");
  for (const std::string& type : formats) {
    const bool is_repeated = can_repeat && type != formats.front();
    if (figure.legend > 0) script += fmt::format("set key spacing {}_rows\n", type);
    script += fmt::format("set terminal @{0}\nset output '../{1}.{0}'\n{2}\n", type, figure.name,
                          is_repeated ? "replot" : figure.plot);
  }
  return script + "unset output\n";
}

// Returns the texts of the scripts and of the style, by their file names.
std::map<std::string, std::string> sources_of(const std::vector<Figure>& figures, const FigureStyle& look) {
  std::string style(style_file->text);
  const std::pair<std::string_view, std::string> values[]{{"TEXT_PT", text_of(look.text_pt)},
                                                          {"FONT", look.font},
                                                          {"WIDTH_CM", text_of(look.width_cm)},
                                                          {"HEIGHT_CM", text_of(look.height_cm)},
                                                          {"DARK", std::to_string(static_cast<int>(look.background))},
                                                          {"COLOURS", fmt::format("{}", fmt::join(look.palette, " "))}};
  for (const auto& [name, value] : values) style.replace(style.find(name), name.size(), value);
  std::map<std::string, std::string> texts{{std::string(style_file->name), style}};
  for (const Figure& figure : figures) texts.emplace(figure.name + ".gp", script_of(figure, formats_of(figure, look)));
  return texts;
}

}  // namespace

void refuse_missing_font(const FigureStyle& style, const std::vector<std::string>& labels) {
  std::map<std::uint32_t, std::string> characters;  // beyond ASCII, with the label that has it
  for (const std::string& label : labels) {
    const std::string line = one_line(label);  // valid UTF-8
    for (boost::u8_to_u32_iterator at(line.begin(), line.begin(), line.end()); at.base() != line.end(); ++at) {
      if (*at >= 0x80) characters.emplace(*at, label);
    }
  }
  if (style.formats == std::vector<std::string>{"svg"}) characters.clear();
  for (const auto& [code, label] : characters) {
    const auto fonts = ChildProcess::run({"fc-list", fmt::format(":charset={:x}", code), "family"}, ".", {});
    if (fonts.succeeded && fonts.output.empty())
      throw std::invalid_argument(
          fmt::format("no font on this machine has the character U+{:04X} of \"{}\"; use another label, draw only "
                      "formats = [\"svg\"] (--style), or add --figures none",
                      code, one_line(label)));
  }
  const std::string& font = style.font;
  if (font == FigureStyle().font) return;
  const ChildProcess::Ran nearest =
      ChildProcess::run({"fc-match", "--format=,%{family},", "--", font}, ".", {});  // the names of one font
  if (!nearest.succeeded || lower_case(nearest.output).find("," + lower_case(font) + ",") != std::string::npos) return;
  throw std::invalid_argument(
      fmt::format("font \"{}\" is not on this machine; choose one that `fc-list : family` lists", font));
}

std::vector<std::string> write_figures(const std::vector<Figure>& figures, const std::filesystem::path& folder,
                                       const RenderOptions& options) {
  if (figures.empty()) return {};
  const auto scripts = sources_of(figures, options.style);
  for (const auto& [file, text] : scripts) write_file(folder / sources / file, text);
  const TemporaryFolder workshop(folder);
  for (const auto& [file, text] : scripts) write_file(workshop.path() / sources / file, text);
  std::atomic<std::size_t> next = 0;
  std::mutex one_at_a_time;
  std::int64_t done = 0;
  std::vector<std::string> warnings(figures.size());
  const auto work = [&] {
    for (std::size_t turn = next++; turn < figures.size(); turn = next++) {
      const std::size_t i = figures.size() - 1 - turn;  // the figure that takes longest is the last, so it begins first
      const Figure& figure = figures[i];
      try {
        const std::string warning = draw(figure, workshop.path(), options);
        remove_pictures(figure, folder, formats_of(figure, options.style));
        if (!warning.empty()) warnings[i] = fmt::format("{} may lack something: {}", figure.name, warning);
      } catch (const std::exception& error) {
        remove_pictures(figure, folder, {});
        if (dynamic_cast<const std::invalid_argument*>(&error) == nullptr) throw;  // ends the report
        warnings[i] = fmt::format("{} is not drawn: {}", figure.name, error.what());
      }
      if (!options.progress) continue;
      const std::scoped_lock lock(one_at_a_time);
      options.progress(++done, static_cast<std::int64_t>(figures.size()));
    }
  };
  std::vector<std::future<void>> workers(
      std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, figures.size()));
  for (std::future<void>& worker : workers) worker = std::async(std::launch::async, work);
  for (std::future<void>& worker : workers) worker.get();
  if (std::ranges::none_of(warnings, &std::string::empty)) {
    const ChildProcess::Ran gnuplot = ChildProcess::run({options.gnuplot, "--version"}, {}, {});
    if (!gnuplot.succeeded)
      return {fmt::format("figures are not drawn: {}; install gnuplot, then run the command again", gnuplot.output)};
  }
  std::erase_if(warnings, [](const std::string& text) { return text.empty(); });
  return warnings;
}

}  // namespace ikbench::figures
