// A test that is looked at several times while its sample grows by equal parts: the boundaries of Wang and Tsiatis
// (Biometrics 43 (1987) 193), with Pocock's and O'Brien and Fleming's among them, by the recursive integration of
// Armitage, McPherson and Rowe (J. Royal Statistical Society A 132 (1969) 235).
#pragma once

namespace ikbench::statistics {

// Look k of `looks` rejects where Z_k >= c (k / looks)^(shape - 1/2). A shape of 1/2 is Pocock's, 0 that of O'Brien and
// Fleming, which asks much of early looks.
struct Boundary {
  int looks = 1;        // 1 to 100
  double shape = 0.25;  // 0 to 1/2
};

// The chance that any of the looks rejects where Z_k are sums of k equal normal samples of mean 0, standardized.
// std::invalid_argument where the boundary is out of range; NaN where c is.
double chance_to_cross(double c, const Boundary& boundary);

// The c that the looks together cross with the chance `level`, and the one-sided p below which look `look` then rejects
// (Jennison and Turnbull, Group Sequential Methods (2000), section 3.3). std::invalid_argument where the boundary is
// out of range.
double constant_of(double level, const Boundary& boundary);
double level_of_look(double c, int look, const Boundary& boundary);

}  // namespace ikbench::statistics
