/// Tests the derivative of smooth fields, and the equation that the stick zone solves with it.

#include "contact/convection/convection.hpp"
#include "contact/convection_frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using namespace convection_test;

double smooth(double x, double y) {
  return std::sin(1.3 * x + 0.4) * std::cos(0.9 * y - 0.2);
}
double smooth_x(double x, double y) {
  return 1.3 * std::cos(1.3 * x + 0.4) * std::cos(0.9 * y - 0.2);
}
double smooth_y(double x, double y) {
  return -0.9 * std::sin(1.3 * x + 0.4) * std::sin(0.9 * y - 0.2);
}

/// Returns the root mean square over inner nodes of D w - v . grad w.
double truncation(const Frame& frame, const SparseRows& d, Direction e) {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < frame.x.size(); ++i) {
    if (frame.rim[i]) continue;
    const double x = frame.x[i], y = frame.y[i];
    const double exact = -(e.ex * smooth_x(x, y) + e.ey * smooth_y(x, y));
    const double error = apply(frame, d, i, smooth) - exact;
    sum += error * error;
    ++count;
  }
  return std::sqrt(sum / count);
}

/// Solves D w = v . grad(smooth) at inner nodes, w given on the rim, by sweeps downstream. The stick zone does this
/// with D: rows that amplify make it blow up. Returns the root mean square error of w.
double march(const Frame& frame, const SparseRows& d, Direction e) {
  const std::size_t n = frame.x.size();
  std::vector<double> w(n);
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return frame.x[a] * e.ex + frame.y[a] * e.ey > frame.x[b] * e.ex + frame.y[b] * e.ey;
  });
  for (std::size_t i = 0; i < n; ++i) w[i] = frame.rim[i] ? smooth(frame.x[i], frame.y[i]) : 0;
  for (int sweep = 0; sweep < 500; ++sweep) {
    double change = 0;
    for (std::size_t i : order) {
      if (frame.rim[i] || empty_row(d, i)) continue;
      double sum = -(e.ex * smooth_x(frame.x[i], frame.y[i]) + e.ey * smooth_y(frame.x[i], frame.y[i]));
      double diagonal = 0;
      for (auto k = static_cast<std::size_t>(d.start[i]); k < static_cast<std::size_t>(d.start[i + 1]); ++k) {
        const auto j = static_cast<std::size_t>(d.column[k]);
        if (j == i)
          diagonal = d.value[k];
        else
          sum -= d.value[k] * w[j];
      }
      change = std::max(change, std::abs(sum / diagonal - w[i]));
      w[i] = sum / diagonal;
    }
    if (change < 1e-13) break;
  }
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += std::pow(w[i] - smooth(frame.x[i], frame.y[i]), 2);
  return std::sqrt(sum / static_cast<double>(n));
}

TEST(Convection, FirstOrderForSmoothFields) {
  const Direction e(30);
  for (ElementType type : {ElementType::tri3, ElementType::quad4}) {
    double ls[2], flux[2], marched_ls[2], marched_flux[2];
    for (int k = 0; k < 2; ++k) {
      const auto u = frames::uniform_lines(-1, 1, 16 << k);
      const SurfaceMesh regular = frames::rectangle(type, u, u);
      const Frame uniform = build_frame(regular, Axes{});
      const Frame random = build_frame(frames::perturb(regular, 0.25, 9), Axes{});
      ls[k] = truncation(random, least_squares(random, e.ex, e.ey), e);
      flux[k] = truncation(uniform, godunov(uniform, e.ex, e.ey), e);
      marched_ls[k] = march(random, least_squares(random, e.ex, e.ey), e);
      marched_flux[k] = march(random, godunov(random, e.ex, e.ey), e);
    }
    const std::string id = ", type " + std::to_string(static_cast<int>(type));
    expect_order("least squares on random nodes" + id, observed_order(ls[0], ls[1], 2, 1), 0.85);
    if (type == ElementType::quad4)
      expect_order("Godunov on squares at 30 degrees" + id, observed_order(flux[0], flux[1], 2, 1), 0.9);
    expect_order("march with least squares, random nodes" + id, observed_order(marched_ls[0], marched_ls[1], 2, 1),
                 0.8);
    expect_order("march with Godunov, random nodes" + id, observed_order(marched_flux[0], marched_flux[1], 2, 1), 0.7);
  }
}

TEST(Convection, MarchDoesNotAmplify) {
  // The plain fit over upwind neighbours ends above 1e3 on graded rings and 1e12 on slender cells.
  for (ElementType type : all_types)
    for (const NamedFrame& f : frames_of(type)) {
      double worst_ls = 0, worst_flux = 0;
      for (double degrees : directions) {
        const Direction e(degrees);
        worst_ls = std::max(worst_ls, march(f.frame, least_squares(f.frame, e.ex, e.ey), e));
        worst_flux = std::max(worst_flux, march(f.frame, godunov(f.frame, e.ex, e.ey), e));
      }
      // The march is of first order: half the spacing 1/8 times second derivatives times the length 2.
      expect_error("march with least squares, " + f.name, worst_ls, 0.12);
      expect_error("march with Godunov, " + f.name, worst_flux, 0.25);
    }
}

}  // namespace
}  // namespace rollcon
