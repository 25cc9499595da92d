#include <algorithm>
#include <cmath>

#include "calculate.hpp"
#include "handles.hpp"

namespace cntc {
namespace {

constexpr double pi = 3.141592653589793;

struct Elliptic {
  double K, D;  // D = (K - E)/m
};

/// Complete elliptic integrals of the ellipse of axes 1 and k, by the arithmetic-geometric mean.
Elliptic elliptic(double k) {
  const double m = (1 - k) * (1 + k);
  double a = 1, b = k, sum = .5, weight = 1;  // the first term, c0^2/m, is 1
  for (int n = 0; n < 60; ++n) {
    const double c = (a - b) / 2;
    if (c < 1e-17 * a) break;
    sum += m > 0 ? weight * c * c / m : 0;
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
    weight *= 2;
  }
  const double K = pi / (2 * a);
  return {K, K * sum};
}

/// Ratio of the lesser to the greater curvature of an ellipse of axes 1 and k.
double curvature_ratio(double k) {
  const Elliptic e = elliptic(k);
  return k * k * e.D / (e.K - e.D);
}

double axis_ratio(double curvatures) {
  double low = std::log(1e-8), high = 0;
  for (int n = 0; n < 200; ++n) {
    const double mid = (low + high) / 2;
    (curvature_ratio(std::exp(mid)) < curvatures ? low : high) = mid;
  }
  return std::exp((low + high) / 2);
}

HertzContact line_contact(const Inputs& in, double compliance) {
  if (in.digits.norm != 1) throw Failure(CNTC_err_other, "rectangles of Hertz (-4, -5) need the normal force");
  HertzContact h;
  const double load = in.fn / (2 * in.hertz.second);
  if (!(load > 0)) throw Failure(CNTC_err_other, "the normal force must be above 0");
  h.bb = in.hertz.second;
  if (in.hertz.ipotcn == -4) {
    h.a1 = in.hertz.first;
    h.aa = std::sqrt(4 * load * compliance / (2 * h.a1 * pi));
  } else {
    h.aa = in.hertz.first;
    h.a1 = 4 * load * compliance / (2 * h.aa * h.aa * pi);
  }
  return h;
}

}  // namespace

double contact_compliance(const Material& m) {
  return (1 - m.nu[0]) / (2 * m.g[0]) + (1 - m.nu[1]) / (2 * m.g[1]);
}

HertzContact hertz_contact(const Inputs& in) {
  const HertzInput& input = in.hertz;
  const double compliance = contact_compliance(in.material);
  if (input.ipotcn == -6)
    throw Failure(CNTC_err_other, "two half ellipses (IPOTCN -6, SDEC) are not available: use -3");
  HertzContact h;
  if (input.ipotcn <= -4) {
    h = line_contact(in, compliance);
  } else {
    const bool force = in.digits.norm == 1;
    if (!((force ? in.fn : in.pen) > 0)) throw Failure(CNTC_err_other, "load or approach must be above 0");
    const bool curvatures = input.ipotcn == -1;
    const double ratio_given = input.ipotcn == -2 ? input.second : input.first / input.second;
    const bool along = curvatures ? ratio_given <= 1 : ratio_given >= 1;  // the greater axis
    const double least = std::min(ratio_given, 1 / ratio_given), k = curvatures ? axis_ratio(least) : least;
    const Elliptic e = elliptic(k);
    const double ratio = curvature_ratio(k);
    double lesser = 0, axis = 0;
    if (input.ipotcn == -3) {
      axis = along ? input.first : input.second;
      lesser =
          force ? 3 * in.fn * e.D * compliance / (2 * pi * axis * axis * axis) : in.pen * e.D / (e.K * axis * axis);
    } else {
      lesser = along ? input.first : input.ipotcn == -1 ? input.second : input.first * ratio;
      axis = force ? std::cbrt(3 * in.fn * e.D * compliance / (2 * pi * lesser))
                   : std::sqrt(in.pen * e.D / (e.K * lesser));
    }
    h.a1 = along ? lesser : lesser / ratio;
    h.b1 = along ? lesser / ratio : lesser;
    h.aa = along ? axis : k * axis;
    h.bb = along ? k * axis : axis;
  }
  h.scale = input.scale;
  h.bneg = h.bpos = h.bb;
  return h;
}

Grid hertz_grid(const HertzInput& input, const HertzContact& h) {
  Grid g;
  g.mx = input.mx;
  g.my = input.my;
  const double x = h.scale * h.aa, y = input.ipotcn <= -4 ? h.bb : h.scale * h.bb;
  g.dx = 2 * x / g.mx;
  g.dy = 2 * y / g.my;
  g.xc = -x + g.dx / 2;
  g.yc = -y + g.dy / 2;
  return g;
}

}  // namespace cntc
