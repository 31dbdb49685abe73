// Kernel density of a sample: Gaussian, with the bandwidth of Silverman, Density Estimation (1986), Eq. 3.31.
#pragma once

#include <span>
#include <vector>

namespace ikbench::statistics {

struct DensityPoint {
  double value = 0;
  double density = 0;
};

// 0.9 min(sd, interquartile range / 1.34) n^(-1/5) as R's bw.nrd0 has it; 0 where the values do not differ.
double silverman_bandwidth(std::span<const double> values);

// At evenly spaced values from the smallest to the largest; empty where there are fewer than 5 values or no two differ.
// The values are finite.
std::vector<DensityPoint> kernel_density(std::span<const double> values);

}  // namespace ikbench::statistics
