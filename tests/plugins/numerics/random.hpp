// For shared objects: the random stream of the C interface, under the name that this project's solvers use.
#pragma once

#include <Eigen/Core>
#include <ikbench_plugin.hpp>

namespace ikbench::numerics {

class Random {
 public:
  explicit Random(ikbench_plugin::Objective& suite) : suite_(suite) {}

  double uniform() { return suite_.uniform(); }
  double uniform(double from, double to) { return from + (to - from) * uniform(); }
  int index(int count) { return static_cast<int>(uniform() * count); }
  template <class Numbers>
  void uniforms(Eigen::PlainObjectBase<Numbers>& out) {
    suite_.uniforms(out.data(), out.size());
  }
  template <class Numbers>
  void normals(Eigen::PlainObjectBase<Numbers>& out) {
    suite_.normals(out.data(), out.size());
  }
  template <class Numbers>
  void truncated_normals(Eigen::PlainObjectBase<Numbers>& out) {
    suite_.truncated_normals(out.data(), out.size());
  }

 private:
  ikbench_plugin::Objective& suite_;
};

}  // namespace ikbench::numerics
