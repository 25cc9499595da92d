#pragma once
/// Describes surfaces that respond alike wherever they are loaded: a displacement depends on its offset from the load
/// alone. On lattices this saves integrals and matrices.

#include <array>
#include <complex>
#include <cstdint>
#include <memory>

namespace rollcon {

/// Names a linear hat along one axis, 1 at 0 and 0 at distance h, or the half of it beside 0.
enum class Hat {
  before,  ///< [-h, 0]
  whole,   ///< [-h, h]
  after,   ///< [0, h]
};

/// Describes the shape function of one node of a lattice: the product of two hats of half-widths dx, dy. Nodes on the
/// rim of a frame have halves.
struct LatticeHat {
  double dx = 0, dy = 0;
  Hat x = Hat::whole, y = Hat::whole;
};

/// Holds the largest offsets, in cells, that are asked for.
struct OffsetReach {
  std::int64_t x, y;
};

/// Gives displacements on a lattice by a source at its origin.
class LatticeRows {
 public:
  virtual ~LatticeRows() = default;
  /// Fills u[r][c][m], m < count (null: not wanted), with component r at offset (shift_x + (first + m) dx,
  /// shift_y + j dy) by unit tractions c, along the lattice's axes and the normal. Safe for several threads.
  virtual void row(std::int64_t j, std::int64_t first, std::int64_t count, double* const (&u)[3][3]) const = 0;
};

/// Holds displacements by a unit force at a point, from source to observer: u_nn, u_11, u_22, u_12, u_1n, u_2n by index
/// [component, force]; u_21 = u_12, u_n1 = -u_1n and u_n2 = -u_2n.
inline constexpr int point_displacements = 6;
using PointDisplacements = std::array<double, point_displacements>;

class TranslationKernel {
 public:
  virtual ~TranslationKernel() = default;
  /// Returns false where normal tractions cause no tangential displacement, nor the reverse.
  virtual bool couples() const = 0;
  /// Returns false where tractions along t1 cause no displacement along t2, nor the reverse.
  virtual bool shears() const = 0;
  /// Tells whether displacements grow in the same ratio when all lengths are stretched and tractions held.
  virtual bool scales() const { return false; }
  /// Says whether the first axis of lattices may have any direction; else it is t1.
  virtual bool turns() const { return true; }
  /// Returns the rows of a source, which the kernel must outlive.
  virtual std::unique_ptr<LatticeRows> on_lattice(const LatticeHat& source, double shift_x, double shift_y,
                                                  OffsetReach reach) const = 0;
  /// Holds displacements under unit tractions that are waves of wave number k > 0: normal ones, and tangential ones
  /// along the direction of the wave and across it.
  struct Softness {
    double normal, along, across;
  };
  virtual Softness softness(double k) const = 0;
  /// Says whether of_point() knows displacements by forces at points, which fall with the distance alone.
  virtual bool knows_points() const { return false; }
  /// Returns displacements at the offset (dx, dy) from a force.
  virtual PointDisplacements of_point(double /*dx*/, double /*dy*/) const { return {}; }
  /// Returns the factor of displacements of bodies that creep, under waves exp(i k1 x) along the rolling direction.
  virtual std::complex<double> delay(double /*k1*/) const { return 1; }
};

}  // namespace rollcon
