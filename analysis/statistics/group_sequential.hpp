// A test with several looks while its sample grows by equal parts: the boundaries of Wang and Tsiatis (Biometrics 43
// (1987) 193), including Pocock's and O'Brien and Fleming's, by the recursive integration of Armitage, McPherson and
// Rowe (J. Royal Statistical Society A 132 (1969) 235).
#pragma once

namespace ikbench::statistics {

// Look k of `looks` rejects if Z_k >= c (k / looks)^(shape - 1/2). A shape of 1/2 is Pocock's; 0 is O'Brien and
// Fleming's, which demands much of early looks.
struct Boundary {
  int looks = 1;        // 1 to 100
  double shape = 0.25;  // 0 to 1/2
};

// The chance that any look rejects if Z_k are sums of k equal normal samples of mean 0, standardized. Throws
// std::invalid_argument if the boundary is out of range; NaN if c is.
double chance_to_cross(double c, const Boundary& boundary);

// The c that the looks together cross with the chance `level`; and the one-sided p below which look `look` then rejects
// (Jennison and Turnbull, Group Sequential Methods (2000), section 3.3). Throws std::invalid_argument if the boundary
// is out of range.
double constant_of(double level, const Boundary& boundary);
double level_of_look(double c, int look, const Boundary& boundary);

}  // namespace ikbench::statistics
