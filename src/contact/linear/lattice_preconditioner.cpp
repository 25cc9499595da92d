/// Inverts Newton's systems approximately on a lattice of half-spaces, by FFT in single precision.
///
/// Rows of sticking nodes say D (A lambda)_t = given. Convection is undone first, summing slip along the flow from the
/// leading edge (an upwind sweep), which leaves displacements; these are turned into tractions by the symbol of A^-1 on
/// the infinite plane,
///   k / (2 pi) (e e^T / cn + (1 - e e^T) / (cn + cv)),   e = k / |k|,
/// divided by the delay of waves along the flow where bodies creep, and restricted to the nodes in question. Rows of
/// the normal law are inverted by k / (2 pi cn). Iterations grow slowly with the lattice (docs/theory.md, section 7).

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "contact/linear/node_preconditioner.hpp"
#include "contact/operators/lattice/lattice_operator.hpp"
#include "linalg/plane_fft.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

// Returns a period with a narrow margin, which keeps the periods apart: the kernel of A^-1 falls off like 1/r^3.
constexpr std::int64_t margin(std::int64_t n) {
  return n + n / 10 + 2;
}

class LatticePreconditioner final : public NodePreconditioner {
 public:
  explicit LatticePreconditioner(const LatticeInfluence& influence)
      : lattice_(influence.lattice),
        displacements_(influence.displacements),
        fft_(lattice_.nx, lattice_.ny, margin(lattice_.nx), margin(lattice_.ny)),
        place_(static_cast<std::size_t>(lattice_.frame_nodes()), -1) {
    for (std::size_t k = 0; k < lattice_.node.size(); ++k)
      if (lattice_.node[k] >= 0) place_[at(lattice_.node[k])] = static_cast<std::int32_t>(k);
    make_symbols(influence.kernel);
  }

  std::size_t bytes() const override {
    std::size_t sum = NodePreconditioner::bytes() + fft_.bytes() + spectrum_[0].bytes() + spectrum_[1].bytes();
    for (const auto& s : symbol_) sum += s.capacity() * sizeof(float);
    sum += ahead_.capacity() * sizeof(std::complex<float>);
    for (const auto& g : grid_) sum += g.capacity() * sizeof(float);
    return sum + masked_.capacity() * sizeof(float) + place_.capacity() * sizeof(std::int32_t);
  }

 private:
  void make_symbols(const TranslationKernel& kernel);
  void sticking_rows(const double* x, double* y) override;
  void normal_rows(const double* x, double* y) override;
  void sum_along_flow(std::vector<float>& s) const;

  Lattice lattice_;
  bool displacements_;  ///< slip rows give displacements, not their derivatives along the flow
  PlaneFft<float> fft_;
  std::vector<std::int32_t> place_;           ///< frame node -> place on the lattice
  std::array<std::vector<float>, 4> symbol_;  ///< symbols of A^-1: 11, 12, 22 and normal
  std::vector<std::complex<float>> ahead_;    ///< factor of all of them for bodies that creep; empty: 1
  std::array<std::vector<float>, 2> grid_;
  std::vector<float> masked_;
  AlignedArray<std::complex<float>> spectrum_[2];

  double softness_ = 1;  ///< softness under normal waves of 2 pi dx
};

void LatticePreconditioner::make_symbols(const TranslationKernel& kernel) {
  const std::int64_t mx = fft_.period_x(), my = fft_.period_y();
  for (auto& s : symbol_) s.assign(at(fft_.waves_x() * fft_.stride()), 0.0f);
  const double lx = static_cast<double>(lattice_.nx) * lattice_.dx;
  const double ly = static_cast<double>(lattice_.ny) * lattice_.dy;
  const double least = 1 / std::max(lx, ly);  // wave number of a mean traction on a finite patch
  // Symbols count by the softness, as single precision has a narrow range, and include the transform's unit.
  softness_ = kernel.softness(2 * std::numbers::pi / lattice_.dx).normal;
  const double unit = softness_ / static_cast<double>(mx * my);
  for (std::int64_t i = 0; i < fft_.waves_x(); ++i)
    for (std::int64_t j = 0; j < my; ++j) {
      const double kx = 2 * std::numbers::pi * static_cast<double>(i) / (static_cast<double>(mx) * lattice_.dx);
      const double ky = 2 * std::numbers::pi * static_cast<double>(j <= my / 2 ? j : j - my) /
                        (static_cast<double>(my) * lattice_.dy);
      // Wave numbers are turned into the axes of the frame.
      const double k1 = kx * lattice_.ex - ky * lattice_.ey;
      const double k2 = kx * lattice_.ey + ky * lattice_.ex;
      const double k = std::hypot(k1, k2);
      const TranslationKernel::Softness soft = kernel.softness(std::max(k, least));
      const double along = unit / soft.along, across = unit / soft.across;
      const double e1 = k > 0 ? k1 / k : 1, e2 = k > 0 ? k2 / k : 0;
      const std::size_t s = at(i * fft_.stride() + j);
      symbol_[0][s] = static_cast<float>(k > 0 ? along * e1 * e1 + across * e2 * e2 : along);
      symbol_[1][s] = static_cast<float>(k > 0 ? (along - across) * e1 * e2 : 0);
      symbol_[2][s] = static_cast<float>(k > 0 ? along * e2 * e2 + across * e1 * e1 : along);
      symbol_[3][s] = static_cast<float>(unit / soft.normal);
    }
  if (!kernel.turns())
    for (std::int64_t i = 0; i < fft_.waves_x(); ++i) {
      const double kx = 2 * std::numbers::pi * static_cast<double>(i) / (static_cast<double>(mx) * lattice_.dx);
      ahead_.insert(ahead_.end(), at(fft_.stride()), std::complex<float>(1.0 / kernel.delay(kx)));
    }
  for (auto& g : grid_) g.resize(lattice_.node.size());
  masked_.resize(lattice_.node.size());
  for (auto& s : spectrum_) s = fft_.make_spectrum();
}

void LatticePreconditioner::normal_rows(const double* x, double* y) {
  const std::int64_t na = system().active();
  const auto nodes = system().nodes();
  std::vector<float>& grid = grid_[0];
  std::fill(grid.begin(), grid.end(), 0.0f);
  double largest = 0;
  for (std::int64_t a = 0; a < na; ++a) largest = std::max(largest, std::abs(x[a]));
  const double unit = largest > 0 ? 1 / largest : 0;
  for (std::int64_t a = 0; a < na; ++a) grid[at(place_[at(nodes[at(a)])])] = static_cast<float>(unit * x[a]);
  fft_.forward(grid.data(), spectrum_[0].data());
  std::complex<float>* wave = spectrum_[0].data();
  for (std::size_t s = 0; s < symbol_[3].size(); ++s) wave[s] *= symbol_[3][s];
  for (std::size_t s = 0; s < ahead_.size(); ++s) wave[s] *= ahead_[s];
  fft_.backward(spectrum_[0].data(), grid.data());
  for (std::int64_t a = 0; a < na; ++a)
    y[a] = largest / (softness_ * system().normal_scale(a)) * static_cast<double>(grid[at(place_[at(nodes[at(a)])])]);
}

// Sums w_i = (cx w_(i+1) + cy w_(j+1) + s) / (cx + cy), where i + 1 and j + 1 lie upstream; w in units of dx.
void LatticePreconditioner::sum_along_flow(std::vector<float>& s) const {
  const std::int64_t nx = lattice_.nx, ny = lattice_.ny;
  // Upstream is +t1: ex along the first axis, -ey along the second.
  const double ux = lattice_.ex, uy = -lattice_.ey;
  const auto cx = static_cast<float>(std::abs(ux));
  const auto cy = static_cast<float>(std::abs(uy) * lattice_.dx / lattice_.dy);
  const float unit = 1 / (cx + cy);
  const bool slanted = cy > 1e-6f * cx;
  for (std::int64_t b = 0; b < ny; ++b) {
    const std::int64_t j = uy > 0 ? ny - 1 - b : b;
    const std::int64_t up = b == 0 || !slanted ? -1 : (uy > 0 ? j + 1 : j - 1);
    float ahead = 0;
    for (std::int64_t a = 0; a < nx; ++a) {
      const std::int64_t i = ux > 0 ? nx - 1 - a : a;
      float& w = s[at(j * nx + i)];
      const float beside = up < 0 ? 0 : s[at(up * nx + i)];
      w = unit * (w + cx * ahead + cy * beside);
      ahead = w;
    }
  }
}

void LatticePreconditioner::sticking_rows(const double* x, double* y) {
  const std::int64_t na = system().active();
  const auto nodes = system().nodes();
  double largest = 0;
  for (std::int64_t a = 0; a < na; ++a)
    if (sticks(a)) largest = std::max({largest, std::abs(x[a]), std::abs(x[na + a])});
  const double unit = largest > 0 ? 1 / largest : 0;
  for (std::size_t c = 0; c < 2; ++c) {
    std::vector<float>& grid = grid_[c];
    std::fill(grid.begin(), grid.end(), 0.0f);
    for (std::int64_t a = 0; a < na; ++a)
      if (sticks(a))
        grid[at(place_[at(nodes[at(a)])])] = static_cast<float>(unit * x[static_cast<std::int64_t>(c) * na + a]);
  }
  if (largest > 0) {
    for (std::size_t c = 0; c < 2; ++c) {
      if (!displacements_) sum_along_flow(grid_[c]);
      std::vector<float>& mask = masked_;
      std::fill(mask.begin(), mask.end(), 0.0f);
      for (std::int64_t a = 0; a < na; ++a)
        if (sticks(a)) {
          const std::size_t k = at(place_[at(nodes[at(a)])]);
          mask[k] = grid_[c][k];
        }
      fft_.forward(mask.data(), spectrum_[c].data());
    }
    std::complex<float>*first = spectrum_[0].data(), *second = spectrum_[1].data();
    for (std::size_t s = 0; s < symbol_[0].size(); ++s) {
      const std::complex<float> u1 = first[s], u2 = second[s];
      first[s] = symbol_[0][s] * u1 + symbol_[1][s] * u2;
      second[s] = symbol_[1][s] * u1 + symbol_[2][s] * u2;
    }
    for (std::size_t s = 0; s < ahead_.size(); ++s) first[s] *= ahead_[s], second[s] *= ahead_[s];
    for (std::size_t c = 0; c < 2; ++c) fft_.backward(spectrum_[c].data(), grid_[c].data());
  }
  for (std::int64_t a = 0; a < na; ++a) {
    if (!sticks(a)) continue;
    const std::size_t k = at(place_[at(nodes[at(a)])]);
    const double scale = largest * (displacements_ ? 1 : lattice_.dx) / (softness_ * system().slip_scale(a));
    y[a] = scale * static_cast<double>(grid_[0][k]);
    y[na + a] = scale * static_cast<double>(grid_[1][k]);
  }
}

}  // namespace

// Flow goes along -t1 of the frame's axes.
std::unique_ptr<FieldPreconditioner> LatticeOperator::make_preconditioner() const {
  return std::make_unique<LatticePreconditioner>(influence());
}

}  // namespace rollcon
