#include "analysis/inference/text.hpp"

#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::inference;

TEST_CASE("one line has no control characters and only valid UTF-8", "[text]") {
  CHECK(one_line("a\nb\tc\r\x7f") == "a b c  ");
  CHECK(one_line("bat \xF0\x9F\xA6\x87, \xCE\xB8") == "bat \xF0\x9F\xA6\x87, \xCE\xB8");
  CHECK(one_line("\xC2\x85") == " ");                                                 // NEL, a line break of Unicode
  CHECK(one_line("a\u202Eb\u2066c\u2069d\u061Ce\u200Ff\u2028g") == "a b c d e f g");  // they turn lines, or end them
  CHECK(one_line("\u05E9\u05DC \u0633 \u95A2") == "\u05E9\u05DC \u0633 \u95A2");
  CHECK(one_line("\xFFz") == "\uFFFDz");                    // never a lead byte
  CHECK(one_line("\xC0\xAF") == "\uFFFD\uFFFD");            // overlong '/'
  CHECK(one_line("\xED\xA0\x80") == "\uFFFD\uFFFD\uFFFD");  // a surrogate
  CHECK(one_line("\xE2\x82") == "\uFFFD\uFFFD");            // cut short
  CHECK(one_line(std::string_view("a\0b", 3)) == "a b");
}

TEST_CASE("a long text is cut between characters, and says so", "[text]") {
  CHECK(shortened("abcdef", 6) == "abcdef");
  CHECK(shortened("abcdefg", 6) == "abcde…");
  CHECK(shortened("θθθθ", 3) == "θθ…");
}

TEST_CASE("Markdown shows any text as text", "[text]") {
  CHECK(markdown_text("<script>alert(1)</script>") == "&lt;script&gt;alert(1)&lt;/script&gt;");
  CHECK(markdown_text("a|b`c`") == "a&#124;b&#96;c&#96;");
  CHECK(markdown_text("*x* _y_ [z](u) \\ # ~ $") == "\\*x\\* \\_y\\_ \\[z\\](u) \\\\ \\# \\~ \\$");
  CHECK(markdown_text("position_error_cm") == "position_error_cm");  // inside a word _ marks nothing
  CHECK(markdown_text("a\nb") == "a b");
  CHECK(markdown_text("&amp;") == "&amp;amp;");
}

TEST_CASE("LaTeX shows any text as text", "[text]") {
  CHECK(latex_text("50 % & $3 #1 a_b {c}") == "50 \\% \\& \\$3 \\#1 a\\_b \\{c\\}");
  CHECK(latex_text("\\input{x}") == "\\textbackslash{}input\\{x\\}");
  CHECK(latex_text("~^<>|") == "\\textasciitilde{}\\textasciicircum{}\\textless{}\\textgreater{}\\textbar{}");
  CHECK(latex_text("`\"") == "\\textasciigrave{}{\\char34}");
  CHECK(latex_text("[2cm]*") == "{[}2cm{]}{*}");  // after \\ these would be arguments
  CHECK(latex_text("a---b") == "a-{}-{}-b");      // no ligature
}

TEST_CASE("nothing that means something to gnuplot stands in a script", "[text]") {
  CHECK(gnuplot_string("K-ABC (50 %)") == "'K-ABC (50 %)'");
  CHECK(gnuplot_string("it's") == "'it'.character[39].'s'");
  for (const char c : std::string("'\"`@$\\#{}!;")) {
    CHECK(gnuplot_string(std::string(1, c)) == "''.character[" + std::to_string(c) + "].''");
  }
  CHECK(gnuplot_string("a\nb") == "'a b'");
  CHECK(gnuplot_string("θ") == "'θ'");
}

TEST_CASE("rounded numbers have the digits asked for", "[text]") {
  CHECK(rounded_number(388.9396, 5) == "388.94");
  CHECK(rounded_number(1.7824e-4, 4) == "0.0001782");
  CHECK(rounded_number(1.7824e-5, 3) == "1.78e-05");
}

TEST_CASE("a rounded number has all digits before the point, and an exponent from ten million on", "[text]") {
  CHECK(rounded_number(2431.7, 2) == "2432");
  CHECK(rounded_number(-98765.4, 3) == "-98765");
  CHECK(rounded_number(999.6, 3) == "1000");
  CHECK(rounded_number(12345678, 3) == "1.23e+07");
  CHECK(short_number(1e4) == "10000");
}

TEST_CASE("shares are said in percent with three digits", "[text]") {
  CHECK(percent(0.05) == "5 %");
  CHECK(percent(0.12345) == "12.3 %");
  CHECK(percent(1) == "100 %");
}
