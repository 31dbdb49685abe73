// One name, one definition. If two sources define a type, an inline function or an inline variable differently, the
// linker keeps any one and says nothing (the rule of one definition, [basic.def.odr]).
//
// This reads text and is no compiler. It knows namespaces, also anonymous ones, whose names belong to their source. It
// skips the inside of classes, functions and initializers, and the products of macros. It reads both sides of an #if.
// It tells functions apart by the text of their parameters, so it misses a second definition with other parameter
// names.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "tests/catch.hpp"
#include "tests/sources.hpp"

namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

// The end of a comment, a directive or a quoted text that begins at `at`; `at` for anything else.
std::size_t end_of_passed(const std::string& text, std::size_t at) {
  const auto after = [&](std::string_view closing, std::size_t from) {
    const std::size_t found = text.find(closing, from);
    return found == std::string::npos ? text.size() : found + closing.size();
  };
  const char before = at == 0 ? ' ' : text[at - 1];
  if (text.compare(at, 2, "//") == 0) return after("\n", at);
  if (text.compare(at, 2, "/*") == 0) return after("*/", at + 2);
  if (text.compare(at, 2, "R\"") == 0) {
    const std::size_t opening = text.find('(', at);
    return after(")" + text.substr(at + 2, opening - at - 2) + "\"", opening);
  }
  const bool separates_digits = text[at] == '\'' && std::isalnum(static_cast<unsigned char>(before)) != 0;
  const bool is_quote = text[at] == '"' || (text[at] == '\'' && !separates_digits);
  if (!is_quote && text[at] != '#') return at;
  for (std::size_t i = at + 1; i < text.size(); ++i) {
    if (text[i] == '\\')
      ++i;
    else if (text[i] == (is_quote ? text[at] : '\n'))
      return i + 1;
  }
  return text.size();
}

// The code alone; every stretch of white space or of skipped text becomes one space.
std::string bare(const std::string& text) {
  std::string code;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = end_of_passed(text, at);
    const bool is_space = end > at || std::isspace(static_cast<unsigned char>(text[at])) != 0;
    if (!is_space)
      code += text[at];
    else if (!code.empty() && code.back() != ' ')
      code += ' ';
    at = std::max(end, at + 1);
  }
  return code;
}

// The name that a definition at namespace scope defines for other sources too; empty if it defines none. `head` is all
// before its brace, or before a declaration's semicolon.
std::string defined_by(const std::string& head, char end) {
  static const std::regex type(
      R"(^ ?(?:export )?(?:enum (?:class |struct )?|struct |class |union )(?:\[\[.*?\]\] ?)*([\w:<>, ]+?)(?: final)?(?: : .*)? ?$)");
  static const std::regex variable(R"(\binline\b.*?(\w+) ?(?:=.*)?$)");
  static const std::regex function(R"(((?:[\w:~]|<[^()]*>)*\b(?:operator ?[^\w ]+|operator [\w ]+|\w+)) ?(\(.*\)))");
  std::string code = head;
  if (const std::size_t at = code.find("template <"); at != std::string::npos && at <= 1) {
    std::size_t from = code.find('<'), depth = 0;
    do {
      if (code[from] == '<') ++depth;
      if (code[from] == '>') --depth;
    } while (++from < code.size() && depth > 0);
    code.erase(0, from);
  }
  std::smatch found;
  if (end == '{' && std::regex_match(code, found, type)) return found[1];
  const std::size_t parameters = code.find('('), equals = code.find('=');
  if (parameters < equals || code.find("operator") < parameters) {
    if (end != '{' || std::regex_search(code, std::regex(R"(^ ?static\b)"))) return "";
    return std::regex_search(code, found, function) ? found[1].str() + found[2].str() : "";
  }
  return std::regex_search(code, found, variable) ? found[1].str() : "";
}

// The names, with namespaces, that a source defines for others too.
Names definitions_in(const std::string& source) {
  static const std::regex name_space(R"(^ ?(?:inline )?namespace ?([\w:]*) ?$)");
  struct Scope {
    bool is_namespace, is_own;
    std::string name;
  };
  std::vector<Scope> scopes{{true, false, ""}};
  Names names;
  std::string head;
  int parentheses = 0;
  const auto define = [&](char end) {
    if (const std::string name = defined_by(head, end); !name.empty() && !scopes.back().is_own) {
      names.insert(scopes.back().name + name);
    }
  };
  for (const char c : bare(source)) {
    const bool at_namespace = scopes.back().is_namespace;
    if (at_namespace && c == '(') ++parentheses;
    if (at_namespace && parentheses > 0) {  // parameters: a default may be {}
      head += c;
      if (c == ')') --parentheses;
    } else if (c == '{') {
      std::smatch found;
      if (at_namespace && std::regex_match(head, found, name_space)) {
        const std::string name = found[1];
        scopes.push_back({true, scopes.back().is_own || name.empty(), scopes.back().name + name + "::"});
      } else {
        if (at_namespace) define(c);
        scopes.push_back({false, false, ""});
      }
      head.clear();
    } else if (c == '}') {
      if (scopes.size() > 1) scopes.pop_back();
      head.clear();
    } else if (at_namespace && c == ';') {
      define(c);
      head.clear();
    } else if (at_namespace) {
      head += c;
    }
  }
  return names;
}

// The sources of the program, and of the programs that measure it.
std::vector<fs::path> sources() {
  std::vector<fs::path> files;
  for (const char* folder : {"robots", "solvers", "results", "experiments", "analysis", "cli"}) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      const std::string type = entry.path().extension().string();
      if (type == ".hpp" || type == ".cpp") files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

TEST_CASE("the reader finds what a source defines for others, and nothing else", "[architecture]") {
  CHECK(definitions_in(
            "namespace a::b { struct S { struct Inner {}; int f() { return 1; } }; enum class E : int { x }; }") ==
        Names{"a::b::S", "a::b::E"});
  CHECK(
      definitions_in(
          "namespace a { namespace { struct S {}; void f() {} namespace c { class D {}; } } class T final : X {}; }") ==
      Names{"a::T"});
  CHECK(definitions_in("struct S; enum class E; int f(int); extern int x; using T = int; // struct U {}\n") == Names{});
  CHECK(definitions_in("const char* t = \"struct S {\"; char c = '{'; auto r = R\"x(class C {)\" )x\"; struct T {};") ==
        Names{"T"});
  CHECK(definitions_in("template <class A, class B = X<A>> struct S {}; template <> struct std::hash<S> { };") ==
        Names{"S", "std::hash<S>"});
  CHECK(definitions_in(
            "inline int f(int a, B<C> b = {}) { return a; } static int g() { return 1; } int C::h() const { }") ==
        Names{"f(int a, B<C> b = {})", "C::h()"});
  CHECK(
      definitions_in("inline constexpr double x = f(1); constexpr int y = 2; inline const std::vector<int> z{1, 2};") ==
      Names{"x", "z"});
  CHECK(definitions_in("bool operator==(const S& a, const S& b) { return true; }") ==
        Names{"operator==(const S& a, const S& b)"});
  CHECK(definitions_in("#define BEGIN {\nconst auto f = [](int x) { return x; };\nstruct S {};\n") == Names{"S"});
}

TEST_CASE("no two sources define the same name", "[architecture]") {
  std::map<std::string, std::vector<std::string>> where;
  for (const fs::path& file : sources()) {
    for (const std::string& name : definitions_in(text_of(file))) where[name].push_back(file.string());
  }
  CHECK(where.size() >= 500);  // or the reader is broken
  for (const auto& [name, files] : where) {
    if (name.starts_with("main(")) continue;  // each program has one
    INFO(name);
    CHECK(files == std::vector<std::string>{files.front()});
  }
}
