// CSV after RFC 4180 (the examples are those of its section 2), and numbers as text.
#include <clocale>
#include <cstdio>
#include <iostream>

#include "base/number.hpp"
#include "tests/base/cells.hpp"

using namespace ikbench::base;

namespace {

std::string complaint_about(const std::string& text) {
  return complaint<std::invalid_argument>([&] { parse_csv(text, "data.csv"); });
}

}  // namespace

TEST_CASE("the examples of RFC 4180 are read as it says", "[csv]") {
  const CsvTable table = parse_csv("field_name,\"b \r\nbb\",c\r\naaa,\"b\"\"bb\",ccc\r\nzzz,,xxx", "rfc.csv");
  CHECK(table.header == std::vector<std::string>{"field_name", "b \r\nbb", "c"});
  CHECK(cells_of(table) == Cells{table.header, {"aaa", "b\"bb", "ccc"}, {"zzz", "", "xxx"}});
}

TEST_CASE("lines end in LF or CRLF, the last one in nothing or either", "[csv]") {
  for (const std::string text : {"a,b\n1,2", "a,b\n1,2\n", "a,b\r\n1,2\r\n", "a,b\r\n1,2\n", "a,b\n\n1,2\r\n\r\n"}) {
    CAPTURE(text);
    CHECK(cells_of(parse_csv(text, "data.csv")) == Cells{{"a", "b"}, {"1", "2"}});
  }
}

TEST_CASE("malformed CSV is refused with the line and what was expected", "[csv]") {
  CHECK(complaint_about("") == "data.csv:1: the file is empty; expected a line with the names of the columns");
  CHECK(complaint_about("a,b\n1,2\n3\n") == "data.csv:3: 1 cell; expected 2 as in the header");
  CHECK(complaint_about("a,b\n1,2,3\n") ==
        "data.csv:2: 3 cells; expected 2 as in the header; write a title above the names of rows, too");
  CHECK(complaint_about("a,b\n\"1\n\n2\",2\n3\n") == "data.csv:5: 1 cell; expected 2 as in the header");
  CHECK(complaint_about("a,b\n1,\"2\n\n\n") == "data.csv:2: a quote is never closed; expected a closing quote");
  CHECK(complaint_about("a,b\n1,2\"3\n") ==
        "data.csv:2: a quote inside an unquoted cell; expected the cell in quotes and the quote doubled");
  CHECK(complaint_about("a,b\n\"1\"2,3\n") ==
        "data.csv:2: text after a closing quote; expected a separator or the end of the line");
  CHECK(complaint_about("a,b\r1,2\r") == "data.csv:1: a lone carriage return; expected lines to end in LF or CRLF");
  CHECK(complaint_about(std::string(max_csv_columns, ',')) ==
        "data.csv:1: there are too many columns; expected at most 10000");
}

TEST_CASE("any text round-trips through CSV", "[csv][property]") {
  // Pieces that CSV must not trip over, drawn at random; std::mt19937's sequence is fixed by the C++ standard.
  const std::vector<std::string> pieces = {
      ",",    "\"",           "\n",     "\r", "\r\n", " ", "\t", std::string(1, '\0'),
      "\"\"", "\xEF\xBB\xBF", "θ₁ [°]", "a",  "1e-5", ";", "'"};
  std::mt19937 random(4180);
  const auto draw = [&](std::size_t below) { return random() % below; };
  for (int trial = 0; trial < 2000; ++trial) {
    const auto text = [&] {
      std::string cell;
      for (std::size_t i = draw(6); i > 0; --i) cell += pieces[draw(pieces.size())];
      return cell;
    };
    const std::size_t columns = 1 + draw(4);
    Cells cells(1 + draw(5), std::vector<std::string>(columns));
    for (auto& row : cells)
      for (auto& cell : row) cell = text();

    const std::string csv = to_csv(cells);
    CAPTURE(csv);
    REQUIRE(cells_of(parse_csv(csv, "again.csv")) == cells);
  }
}

TEST_CASE("no text is a formula to a spreadsheet, and numbers stay numbers", "[csv]") {
  std::string csv;
  append_csv_row(csv, {"=1+1", "+a", "-a", "@a", "a=1", "-1e-5", "-Inf", "=a,\"b\""});
  CHECK(csv == "'=1+1,'+a,'-a,'@a,a=1,-1e-5,-Inf,\"'=a,\"\"b\"\"\"\n");
}

TEST_CASE("no text makes the CSV reader do anything but read or refuse", "[csv][property]") {
  std::mt19937 random(1);
  const std::string alphabet = "a,\"\r\n";
  for (int trial = 0; trial < 5000; ++trial) {
    std::string text;
    for (auto i = random() % 12; i > 0; --i) text += alphabet[random() % alphabet.size()];
    CAPTURE(text);
    try {
      const Cells cells = cells_of(parse_csv(text, "noise.csv"));
      const std::string again = to_csv(cells);
      REQUIRE(cells_of(parse_csv(again, "again.csv")) == cells);
    } catch (const std::invalid_argument& error) {
      REQUIRE_THAT(error.what(), StartsWith("noise.csv:"));
    }
  }
}

TEST_CASE("a fault of the standard input is none of another stream", "[csv]") {
  REQUIRE(std::freopen("/", "r", stdin) != nullptr);
  REQUIRE(std::getchar() == EOF);
  std::istringstream stream("a\n1\n");
  CHECK(csv_text(stream, "a file") == "a\n1\n");
  CHECK_THROWS_WITH(csv_text(std::cin, "standard input"), ContainsSubstring("cannot read 'standard input'"));
  REQUIRE(std::freopen("/dev/null", "r", stdin) != nullptr);
  std::cin.clear();
}

TEST_CASE("a column is found by its name, and a wrong name is told the right ones", "[csv]") {
  const CsvTable table = parse_csv("run,error,error\n1,2,3\n", "data.csv");
  CHECK(table.column("run") == 0);
  CHECK(complaint<std::invalid_argument>([&] { table.column("seconds"); }) ==
        "there is no column 'seconds'; expected one of: run, error, error");
  CHECK(complaint<std::invalid_argument>([&] { table.column("error"); }) ==
        "there are two columns 'error'; expected one");
}

TEST_CASE("a cell is a number or is refused with its row, column and text", "[csv]") {
  const CsvTable table =
      parse_csv("x\n1.7824e-4\n -2.5 \n+3\nNaN\n-Inf\ninf\n\"1,5\"\n\"\"\n5 cm\n1e999\n+-1\n0x10\n", "d");
  CHECK(table.number(0, "x") == 1.7824e-4);
  CHECK(table.number(1, "x") == -2.5);
  CHECK(table.number(2, "x") == 3.0);
  CHECK(std::isnan(table.number(3, "x")));
  CHECK(table.number(4, "x") == -std::numeric_limits<double>::infinity());
  CHECK(table.number(5, "x") == std::numeric_limits<double>::infinity());
  for (std::size_t row = 6; row < table.rows(); ++row) CHECK_THROWS_AS(table.number(row, "x"), std::invalid_argument);
  CHECK(complaint<std::invalid_argument>([&] { table.number(6, "x"); }) ==
        "row 7 below the header, column 'x': '1,5'; expected a number");
}

TEST_CASE("the text of a double gives the same double again", "[number]") {
  using limits = std::numeric_limits<double>;
  for (const double value : {0.0, -0.0, 0.1, 1.0 / 3.0, 1e23, -2.2250738585072014e-308, limits::denorm_min(),
                             limits::max(), limits::lowest(), limits::epsilon()}) {
    CAPTURE(value);
    CHECK(std::bit_cast<std::uint64_t>(number_from(text_of(value)).value()) == std::bit_cast<std::uint64_t>(value));
  }
  CHECK(text_of(0.1) == "0.1");
  CHECK(text_of(limits::quiet_NaN()) == "NaN");
  CHECK(text_of(limits::infinity()) == "Inf");
  CHECK(text_of(-limits::infinity()) == "-Inf");
}

TEST_CASE("numbers are read and written alike in a locale with a decimal comma", "[number]") {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8"}) std::setlocale(LC_ALL, locale);  // where installed
  CHECK(text_of(1.5) == "1.5");
  CHECK(number_from("1.5") == 1.5);
  std::setlocale(LC_ALL, before.c_str());
}
