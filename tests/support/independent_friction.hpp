#pragma once
/// Implements laws of friction for the judges of solutions, written from docs/friction.md and not from the library.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace rollcon::laws {

/// Holds a law with the arguments of rollcon_contact_set_friction. Coefficients are over that of the node, the
/// greatest.
struct Friction {
  std::string name = "coulomb";
  std::vector<double> parameter;

  bool coulomb() const { return name == "coulomb"; }
  bool orthotropic() const { return name.rfind("orthotropic", 0) == 0; }

  /// Returns the coefficient at this speed of slip, over that of no slip.
  double coefficient(double speed) const {
    if (coulomb() || orthotropic()) return 1;
    double at_rest = parameter[0], sum = parameter[0];
    for (std::size_t i = 1; i + 1 < parameter.size(); i += 2) {
      const double ratio = speed / parameter[i + 1];
      at_rest += parameter[i];
      if (name == "linear") sum += parameter[i] * std::max(0.0, 1 - ratio / 2);
      if (name == "rational") sum += parameter[i] / (1 + std::pow(ratio, i == 1 ? 1 : 2));
      if (name == "exponential") sum += parameter[i] * std::exp(-std::log(2.0) * ratio);
    }
    return at_rest > 0 ? sum / at_rest : 1;
  }

  /// Returns the length of a traction, to be compared with mu p.
  double measure(double q1, double q2) const {
    const auto [a, b] = along_axes(q1, q2);
    const auto [r1, r2] = ratios();
    return std::hypot(a / r1, b / r2);
  }

  /// Returns the unit direction against which a node with this traction slides.
  std::array<double, 2> against(double q1, double q2) const {
    auto [a, b] = along_axes(q1, q2);
    if (name == "orthotropic") {
      const auto [r1, r2] = ratios();
      a /= r1 * r1, b /= r2 * r2;
    }
    const double length = std::hypot(a, b);
    return off_axes(a / length, b / length);
  }

  /// Returns the traction over mu p of a node that slides.
  std::array<double, 2> sliding(double s1, double s2) const {
    const auto [a, b] = along_axes(s1, s2);
    const auto [r1, r2] = ratios();
    if (name == "orthotropic") {
      const double length = std::hypot(r1 * a, r2 * b);
      return off_axes(-r1 * r1 * a / length, -r2 * r2 * b / length);
    }
    const double length = std::hypot(a / r1, b / r2);
    return off_axes(-a / length, -b / length);
  }

 private:
  std::pair<double, double> ratios() const {
    if (!orthotropic()) return {1, 1};
    const double largest = std::max(parameter[0], parameter[1]);
    return {parameter[0] / largest, parameter[1] / largest};
  }
  double angle() const { return orthotropic() ? parameter[2] : 0; }
  std::array<double, 2> along_axes(double x, double y) const {
    const double c = std::cos(angle()), s = std::sin(angle());
    return {c * x + s * y, c * y - s * x};
  }
  std::array<double, 2> off_axes(double a, double b) const {
    const double c = std::cos(angle()), s = std::sin(angle());
    return {c * a - s * b, c * b + s * a};
  }
};

}  // namespace rollcon::laws
