// A random local search for ikbench in C++, without a library for JSON: ikbench evaluates the candidates.
// c++ -std=c++17 -O2 -o search search.cpp
#include <algorithm>
#include <iostream>
#include <random>
#include <vector>
// The numbers of a list in a message, of "key":[1,null,3]; null is a large number.
std::vector<double> numbers(const std::string& line, const std::string& key) {
  std::vector<double> all;
  const char* next = line.c_str() + line.find('"' + key + "\":[") + key.size() + 4;
  while (*next != ']') {
    char* end = nullptr;
    all.push_back(*next == 'n' ? 1e300 : std::strtod(next, &end));
    next = *next == 'n' ? next + 4 : end;
    if (*next == ',') ++next;
  }
  return all;
}

void solve(std::string line) {
  const std::vector<double> lower = numbers(line, "lower"), upper = numbers(line, "upper");
  std::mt19937 random(std::stoul(line.substr(line.find("\"seed\":") + 7)));
  std::vector<std::vector<double>> q(10, numbers(line, "start"));
  std::vector<double> best = q[0];
  for (double least = 1e301, reach = 0.5; line.find("\"over\":true") == line.npos;) {
    for (std::size_t i = 0; i < q.size(); ++i) {
      std::cout << (i ? "],[" : R"({"message":"evaluate","candidates":[[)");
      for (std::size_t j = 0; j < best.size(); ++j) {
        const double step = i ? std::uniform_real_distribution(-reach, reach)(random) : 0;
        std::cout << (j ? "," : "") << (q[i][j] = std::clamp(best[j] + step, lower[j], upper[j]));
      }
    }
    std::cout << "]]}" << std::endl;
    if (!std::getline(std::cin, line)) return;
    const std::vector<double> errors = numbers(line, "errors");
    const auto nearest = std::min_element(errors.begin(), errors.end());
    reach = reach < 1e-9 ? 0.5 : reach * (*nearest < least ? 1.2 : 0.9);
    if (*nearest < least) least = *nearest, best = q[nearest - errors.begin()];
  }
  std::cout << R"({"message":"solved"})" << std::endl;  // without q: the best candidate
}

int main() {
  std::cout.precision(17);
  std::cout << R"({"message":"hello","ikbench":2,"name":"cpp_search"})" << std::endl;
  for (std::string line; std::getline(std::cin, line);) {
    if (line.find("\"message\":\"solve\"") != line.npos) solve(line);
  }
}
