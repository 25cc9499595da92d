#include "bodies/halfspace/halfspace_kernel.hpp"

#include <numbers>
#include <vector>

#include "bodies/halfspace/lattice_kernel.hpp"

namespace rollcon {
namespace {

using namespace halfspace;

class HalfspaceRows final : public LatticeRows {
 public:
  HalfspaceRows(HalfspaceConstants c, const LatticeHat& source, double shift_x, double shift_y, OffsetReach reach)
      : c_(c),
        integrals_(source, shift_x, shift_y, (c.cv != 0 ? with_shear : 0) + (c.ck != 0 ? with_coupling : 0), reach) {}

  void row(std::int64_t j, std::int64_t first, std::int64_t count, double* const (&u)[3][3]) const override {
    const auto n = static_cast<std::size_t>(count);
    std::vector<double> memory(integral_count * n, 0.0);
    double* integral[integral_count];
    for (std::size_t k = 0; k < integral_count; ++k) integral[k] = memory.data() + k * n;
    integrals_.row(j, first, count, integral);
    const double *i0 = integral[0], *xx = integral[1], *xy = integral[2], *jx = integral[3], *jy = integral[4];
    const double cn = c_.cn, cv = c_.cv, ck = c_.ck;
    const auto fill = [&](int r, int c, auto value) {
      if (u[r][c] == nullptr) return;
      for (std::size_t m = 0; m < n; ++m) u[r][c][m] = value(m);
    };
    fill(0, 0, [=](std::size_t m) { return cn * i0[m] + cv * xx[m]; });
    fill(1, 1, [=](std::size_t m) { return cn * i0[m] + cv * (i0[m] - xx[m]); });
    fill(2, 2, [=](std::size_t m) { return cn * i0[m]; });
    for (int t = 0; t < 2; ++t) {
      const double* along = t == 0 ? jx : jy;
      fill(t, 1 - t, [=](std::size_t m) { return cv * xy[m]; });
      fill(t, 2, [=](std::size_t m) { return ck * along[m]; });
      fill(2, t, [=](std::size_t m) { return -ck * along[m]; });
    }
  }

 private:
  HalfspaceConstants c_;
  LatticeIntegrals integrals_;
};

class HalfspaceKernel final : public TranslationKernel {
 public:
  explicit HalfspaceKernel(HalfspaceConstants c) : c_(c) {}
  bool scales() const override { return true; }
  bool couples() const override { return c_.ck != 0; }
  bool shears() const override { return c_.cv != 0; }
  std::unique_ptr<LatticeRows> on_lattice(const LatticeHat& source, double shift_x, double shift_y,
                                          OffsetReach reach) const override {
    return std::make_unique<HalfspaceRows>(c_, source, shift_x, shift_y, reach);
  }
  Softness softness(double k) const override {
    const double unit = 2 * std::numbers::pi / k;
    return {unit * c_.cn, unit * c_.cn, unit * (c_.cn + c_.cv)};
  }

 private:
  HalfspaceConstants c_;
};

}  // namespace

std::shared_ptr<const TranslationKernel> make_halfspace_kernel(HalfspaceConstants c) {
  return std::make_shared<HalfspaceKernel>(c);
}

}  // namespace rollcon
