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

// The c that a one-sided p of look k reaches: Phi^-1(1 - p) (k / looks)^(1/2 - shape), by the significance levels of
// Jennison and Turnbull, Group Sequential Methods (2000), section 3.3. NaN where p is.
double constant_of(double p, int look, const Boundary& boundary);

// The chance that any of the looks rejects where Z_k are sums of k equal normal samples of mean 0, standardized: of the
// largest constant of the looks so far it is the p-value of the whole (Liu and Anderson, JASA 103 (2008) 1621), to be
// used like any other. std::invalid_argument where the boundary is out of range; NaN where c is.
double chance_to_cross(double c, const Boundary& boundary);

}  // namespace ikbench::statistics
