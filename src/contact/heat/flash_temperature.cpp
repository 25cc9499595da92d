#include "contact/heat/flash_temperature.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/index.hpp"

namespace rollcon {
namespace {

/// Holds where heat comes from along one line.
class HeatedLine {
 public:
  HeatedLine(const HeatedSurface& surface, double y, std::vector<LinePiece>& pieces) : surface_(surface) {
    surface.lines.cut(y, pieces);
    for (const LinePiece& piece : pieces) {
      const double p1 = piece.upstream.value(surface.pressure.data());
      const double p0 = piece.downstream.value(surface.pressure.data());
      if (!(p1 > 0) && !(p0 > 0)) continue;
      // An edge between two nodes is taken in the middle between them.
      const double middle = 0.5 * (piece.upstream.x + piece.downstream.x);
      if (!touches_) entry_ = p1 > 0 ? piece.upstream.x : middle;
      touches_ = true;
      exit_ = p0 > 0 ? piece.downstream.x : middle;
    }
    // Only pieces with heat count from here on.
    std::erase_if(pieces, [&](const LinePiece& piece) {
      return piece.upstream.value(surface.power.data()) == 0 && piece.downstream.value(surface.power.data()) == 0;
    });
    pieces_ = pieces;
    for (std::size_t b = 0; b < 2; ++b)
      penetration_[b] = std::sqrt(surface.heat[b].conductivity * surface.heat[b].capacity);
  }

  std::array<double, 2> temperatures(double x) const {
    const double sum = penetration_[0] + penetration_[1], rise = flash(x, sum);
    const auto& heat = surface_.heat;
    const double common = (penetration_[0] * heat[0].temperature + penetration_[1] * heat[1].temperature) / sum;
    double share = 0;  // fraction of the way from a body's own temperature to the common one
    if (touches_ && x <= entry_)
      share = x >= exit_ ? 1 : 2 / std::numbers::pi * std::asin(std::sqrt((entry_ - exit_) / (entry_ - x)));
    std::array<double, 2> t{};
    for (std::size_t b = 0; b < 2; ++b) t[b] = heat[b].temperature + share * (common - heat[b].temperature) + rise;
    return t;
  }

 private:
  // Returns 1/((beta1 + beta2) sqrt(pi V)) times the integral of q(x')/sqrt(x' - x) over x' > x, with beta =
  // sqrt(lambda rho c); exact for a q that is linear on each piece.
  double flash(double x, double sum) const {
    double integral = 0;
    for (const LinePiece& piece : pieces_) {
      if (!(piece.upstream.x > x)) break;
      const double q1 = piece.upstream.value(surface_.power.data());
      double q0 = piece.downstream.value(surface_.power.data()), from = piece.downstream.x;
      const double slope = (q1 - q0) / piece.length();
      if (from < x) q0 += slope * (x - from), from = x;
      // The form with roots s, r of the ends' distances has no difference of nearly equal numbers.
      const double h = piece.upstream.x - from, s = std::sqrt(from - x), r = std::sqrt(piece.upstream.x - x);
      integral += q0 * 2 * h / (r + s) + slope * (2.0 / 3) * h * h * (r + 2 * s) / ((r + s) * (r + s));
    }
    return integral / (sum * std::sqrt(std::numbers::pi * surface_.speed));
  }

  const HeatedSurface& surface_;
  std::span<const LinePiece> pieces_;
  std::array<double, 2> penetration_{};
  bool touches_ = false;
  double entry_ = 0, exit_ = 0;
};

}  // namespace

void surface_temperatures(const HeatedSurface& surface, std::span<const double> x, std::span<const double> y,
                          std::span<double> temperature) {
  std::vector<LinePiece> pieces;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const auto t = HeatedLine(surface, y[k], pieces).temperatures(x[k]);
    std::copy(t.begin(), t.end(), temperature.begin() + static_cast<std::ptrdiff_t>(2 * k));
  }
}

void surface_temperatures(const HeatedSurface& surface, std::span<const double> x, std::span<double> temperature) {
  std::vector<LinePiece> pieces;
  for (std::size_t b = 0; b < temperature.size(); ++b) temperature[b] = surface.heat[b % 2].temperature;
  for (std::size_t i = 0; i < surface.lines.size(); ++i) {
    const HeatedLine line(surface, surface.lines.y(i), pieces);
    for (const std::int32_t k : surface.lines.nodes(i)) {
      const auto t = line.temperatures(x[at(k)]);
      std::copy(t.begin(), t.end(), temperature.begin() + static_cast<std::ptrdiff_t>(2 * at(k)));
    }
  }
}

}  // namespace rollcon
