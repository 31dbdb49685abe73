// Writing a file over what is already in its place.
#include <sys/stat.h>

#include "tests/figures/drawn.hpp"

namespace {

namespace fs = std::filesystem;

fs::perms mode_of(const fs::path& file) { return fs::status(file).permissions(); }

// Every file below, relative to the folder.
std::set<std::string> files_in(const fs::path& folder) {
  std::set<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_directory()) files.insert(fs::relative(entry.path(), folder).string());
  }
  return files;
}

Figure figure_of(const std::string& plot, const std::string& name = "f") {
  return {.name = name, .caption = name, .settings = "", .plot = plot, .data = "1 1\n2 2\n"};
}

constexpr auto through = [](const fs::path& file, const std::string& text = "text") {
  write_through(file, [&](const Write& write) { write(text); });
};

}  // namespace

TEST_CASE("a file that is written anew keeps its permissions, and a new one has the usual", "[files]") {
  const ScratchFolder folder;
  write_file(folder.path / "usual", "");
  std::ofstream(folder.path / "by-stream") << "";
  CHECK(mode_of(folder.path / "usual") == mode_of(folder.path / "by-stream"));
  for (const fs::perms mode : {fs::perms{0600}, fs::perms{0640}, fs::perms{0777}}) {
    const fs::path file = folder.path / "file";
    write_file(file, "old");
    fs::permissions(file, mode);
    write_file(file, "new");
    CHECK(text_in(file) == "new");
    CHECK(mode_of(file) == mode);
  }
}

TEST_CASE("a link in a folder of results is replaced, and what it leads to stays", "[files]") {
  const ScratchFolder folder;
  write_file(folder.path / "far" / "victim", "precious");
  for (const char* target : {"far/victim", "far/not-there", "link"}) {
    const fs::path link = folder.path / "link";
    fs::remove(link);
    fs::create_symlink(target, link);
    write_file(link, "text");
    CHECK_FALSE(fs::is_symlink(link));
    CHECK(text_in(link) == "text");
  }
  CHECK(text_in(folder.path / "far" / "victim") == "precious");
  CHECK(files_in(folder.path) == std::set<std::string>{"far/victim", "link"});
}

TEST_CASE("a file that has another name too is replaced, and the other stays", "[files]") {
  const ScratchFolder folder;
  write_file(folder.path / "victim", "precious");
  for (const auto write :
       {+[](const fs::path& file) { write_file(file, "text"); }, +[](const fs::path& file) { through(file); }}) {
    fs::remove(folder.path / "file");
    fs::create_hard_link(folder.path / "victim", folder.path / "file");
    write(folder.path / "file");
    CHECK(text_in(folder.path / "file") == "text");
    CHECK(text_in(folder.path / "victim") == "precious");
  }
}

TEST_CASE("a link that the user names is followed", "[files]") {
  const ScratchFolder folder;
  const fs::path target = folder.path / "far" / "target", link = folder.path / "link";
  write_file(target, "old");
  fs::create_symlink("far/target", link);
  fs::create_symlink("link", folder.path / "link-to-link");
  for (const std::string text : {"first", "second"}) {
    through(folder.path / "link-to-link", text);
    CHECK(fs::read_symlink(folder.path / "link-to-link") == "link");
    CHECK(fs::read_symlink(link) == "far/target");
    CHECK(text_in(target) == text);
    fs::permissions(target, fs::perms{0600});
  }
  CHECK(mode_of(target) == fs::perms{0600});
  CHECK(files_in(folder.path) == std::set<std::string>{"far/target"});  // links are told as what they lead to
}

TEST_CASE("a pipe that the user names is refused, and one in a folder of results is replaced", "[files]") {
  const ScratchFolder folder;
  const fs::path pipe = folder.path / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  CHECK_THROWS_AS(through(pipe), std::invalid_argument);
  CHECK_THROWS_AS(through("/dev/null"), std::invalid_argument);
  CHECK(fs::is_fifo(pipe));
  CHECK_FALSE(read_file(pipe));
  write_file(pipe, "text");
  CHECK(text_in(pipe) == "text");
  CHECK(files_in(folder.path) == std::set<std::string>{"pipe"});
}

TEST_CASE("a picture takes the place of a link, and keeps the permissions of a file", "[files][figure]") {
  const ScratchFolder folder;
  const fs::path svg = folder.path / "f.svg", pdf = folder.path / "f.pdf";
  write_file(svg, "old");
  fs::permissions(svg, fs::perms{0600});
  write_file(folder.path / "victim", "precious");
  fs::create_symlink("victim", pdf);
  const Figure figure = figure_of("plot data");
  REQUIRE(write_figures({figure}, folder.path, {}).empty());
  CHECK(mode_of(svg) == fs::perms{0600});
  CHECK(text_in(svg) != "old");
  CHECK_FALSE(fs::is_symlink(pdf));
  CHECK(text_in(pdf).starts_with("%PDF"));
  CHECK(text_in(pdf).find("/CreationDate (") == std::string::npos);  // equal figures have equal bytes
  CHECK(text_in(folder.path / "victim") == "precious");
}

TEST_CASE("a script or a style that lies in the folder is written anew and never run", "[files][figure]") {
  const ScratchFolder folder;
  const Figure figure = figure_of("plot data ls 1");
  write_figures({figure}, folder.path, {});
  const fs::path pwned = folder.path / "pwned";
  const std::string picture = text_in(folder.path / "f.svg");
  for (const bool as_link : {false, true}) {
    for (const char* name : {"style.gp", "f.gp"}) {
      const fs::path place = folder.path / sources / name, file = as_link ? folder.path / "far" / name : place;
      CAPTURE(file.string());
      const std::string written = text_in(place);
      write_file(file, written + "system 'touch " + pwned.string() + "'\nset style line 1 lc rgb '#010203'\n");
      if (as_link) fs::remove(place), fs::create_symlink(file, place);
      REQUIRE(write_figures({figure}, folder.path, {}).empty());
      CHECK_FALSE(fs::exists(pwned));
      CHECK_FALSE(fs::is_symlink(place));
      CHECK(text_in(place) == written);
      CHECK(text_in(folder.path / "f.svg") == picture);
    }
  }
}

TEST_CASE("a figure that is not drawn is told, and its old picture goes", "[files][figure]") {
  const ScratchFolder folder;
  Figure figure = figure_of("plot data");
  REQUIRE(write_figures({figure}, folder.path, {}).empty());
  figure.plot = "plot data with nonsense";
  const Figure other = figure_of("plot data", "g");
  const auto errors = write_figures({figure, other}, folder.path, {});
  REQUIRE(errors.size() == 1);
  CHECK(errors[0].starts_with("f is not drawn: "));
  CHECK(contains(errors[0], "nonsense"));
  CHECK_FALSE(fs::exists(folder.path / "f.svg"));
  CHECK(fs::exists(folder.path / "g.svg"));
  const auto without = write_figures({other, figure}, folder.path, {.gnuplot = "no-such-gnuplot"});
  REQUIRE(without.size() == 1);  // for all
  CHECK(contains(without[0], "no-such-gnuplot"));
  CHECK(files_in(folder.path) == std::set<std::string>{"source/f.gp", "source/g.gp", "source/style.gp"});
}

TEST_CASE("what gnuplot warns of is told beside the picture", "[files][figure]") {
  const ScratchFolder folder;
  const Figure figure = figure_of("plot data, 'gone.dat'");
  const auto warnings = write_figures({figure}, folder.path, {});
  REQUIRE(warnings.size() == 1);
  CHECK(contains(warnings[0], "gone.dat"));
  CHECK(fs::exists(folder.path / "f.svg"));
}

TEST_CASE("a picture has its caption as title, a width in points, and as SVG the same bytes each time",
          "[files][figure]") {
  const ScratchFolder folder;
  Figure figure = figure_of("plot data");
  figure.caption = "Error of <mine> & others: as it is.";
  write_figures({figure}, folder.path, {});
  const std::string svg = text_in(folder.path / "f.svg");
  CHECK(contains(svg, "<title>Error of &lt;mine&gt; &amp; others: as it is.</title>"));
  CHECK(contains(svg, "width=\"240pt\" height=\"181pt\""));
  CHECK(contains(svg, "stroke-width='0.5' stroke='currentColor'"));  // of points
  write_figures({figure}, folder.path, {});
  CHECK(text_in(folder.path / "f.svg") == svg);
}

TEST_CASE("a script draws its picture again, with the words of a style", "[files][figure]") {
  const ScratchFolder folder;
  Figure figure = figure_of("plot data ls 1", "f-boxes");
  for (const auto& [axis, title] : {std::pair('x', "error [mm]"), {'y', "share"}})
    figure.settings += linear_axis(axis, std::vector{1.0, 2.0}, title, Begins::around).settings;
  CHECK(reword({&figure}, {.words = {{"f", {{"x", "Fehler größer"}, {"caption", "Bildunterschrift"}}}}}).empty());
  CHECK(reword({&figure}, {.words = {{"g", {{"x", "other"}}}}}) ==
        std::vector<std::string>{"words.g: there is no x; it is in f-boxes"});
  CHECK(figure.caption == "Bildunterschrift");
  REQUIRE(write_figures({figure}, folder.path, {.style = {.formats = {"svg"}}}).empty());
  const std::string svg = text_in(folder.path / "f-boxes.svg");
  for (const char* words : {"Fehler größer", ">share<", "Bildunterschrift"}) CHECK(contains(svg, words));
  CHECK_FALSE(contains(svg, "error [mm]"));
  fs::remove(folder.path / "f-boxes.svg");
  CHECK(ChildProcess::run({"gnuplot", "f-boxes.gp"}, folder.path / sources, {"LC_ALL=C.UTF-8"}).succeeded);
  CHECK(contains(text_in(folder.path / "f-boxes.svg"), "Fehler größer"));
}

TEST_CASE("a figure has the width, height, font, size of text, colours and formats of the style", "[files][figure]") {
  const ScratchFolder folder;
  Figure figure = figure_of("plot data ls 1 title 'x'");
  figure.legend = 1;
  write_figures({figure}, folder.path, {});
  const FigureStyle style{.width_cm = 12.7,
                          .height_cm = 7.62,
                          .font = "Liberation Serif",
                          .text_pt = 10,
                          .palette = {"#AA0001"},
                          .formats = {"svg"}};
  REQUIRE(write_figures({figure}, folder.path, {.style = style}).empty());
  const std::string svg = text_in(folder.path / "f.svg");
  for (const char* const part : {"width=\"360pt\" height=\"216pt\"", "font-family=\"Liberation Serif\"",
                                 "font-size=\"10.00\"", "rgb(170,   0,   1)"}) {
    CAPTURE(part);
    CHECK(contains(svg, part));
  }
  CHECK(!fs::exists(folder.path / "f.pdf"));  // of the look before
}

TEST_CASE("an SVG is well-formed whatever a label has", "[files][figure]") {
  const ScratchFolder folder;
  REQUIRE(write_figures({figure_of("plot x title 'a]]>b'")}, folder.path, {.style = {.formats = {"svg"}}}).empty());
  const std::string svg = text_in(folder.path / "f.svg");
  CHECK(contains(svg, "a]]&gt;b"));
  CHECK_FALSE(contains(svg, "]]>"));
}
