#pragma once
/// The discrete contact problem in the form that Newton's iteration sees: affine relations between
/// tractions, gap and slip, laws per node, and loads. Slip is per unit rolling speed throughout.
///
///   kn = gap - approach - (A lambda)_n
///   s  = rigid slip + D (A lambda)_t,   rigid slip = (xi1 - phi y, xi2 + phi x) + given field

#include <array>
#include <cstdint>
#include <vector>

#include "contact/operators.hpp"

namespace rollcon {

/// Indices of motions and of their conjugate loads (Direction minus one).
enum Motion : int { xi1 = 0, xi2 = 1, approach = 2, spin = 3 };

struct Problem {
  std::int64_t nodes = 0;
  ContactOperators op;
  std::vector<double> rn, rt;  ///< per-node scales of the augmented tractions
  std::vector<double> gap;
  /// Friction coefficient; 0 at nodes without an upstream neighbour (the inflow rim), whose slip
  /// does not depend on any traction: material enters the frame unstressed.
  std::vector<double> mu;
  std::vector<double> slip1, slip2;        ///< given field of rigid slip over speed; empty: none
  std::vector<double> weight;              ///< integral of N_i: force from tractions
  std::vector<double> moment_x, moment_y;  ///< integrals of N_i x and N_i y: spin moment
  std::vector<std::uint8_t> used;          ///< nodes that may carry traction
  std::array<bool, 4> by_force{};          ///< motion unknown, conjugate load given
  std::array<double, 4> value{};           ///< load (on body 1) where by force, else motion
  double length = 1;                       ///< of the frame; scales spin
  double stiffness = 1;                    ///< E* of the pair, for the first guess of an approach
  std::vector<double> cell_area;

  double rigid_slip1(std::int64_t i, const std::array<double, 4>& m) const {
    const auto k = static_cast<std::size_t>(i);
    return m[xi1] - m[spin] * op.slip_y[k] + (slip1.empty() ? 0 : slip1[k]);
  }
  double rigid_slip2(std::int64_t i, const std::array<double, 4>& m) const {
    const auto k = static_cast<std::size_t>(i);
    return m[xi2] + m[spin] * op.slip_x[k] + (slip2.empty() ? 0 : slip2[k]);
  }
};

/// An iterate: tractions by component, the operator rows applied to them, and the motions.
struct Iterate {
  std::vector<double> lambda[3];         ///< t1, t2, n
  std::vector<double> image[3];          ///< D (A lambda)_t1, D (A lambda)_t2, (A lambda)_n
  std::vector<std::uint8_t> slip_valid;  ///< image[0], image[1] up to date at this node
  std::vector<std::uint8_t> gap_valid;   ///< image[2] up to date at this node
  std::array<double, 4> motion{};

  void resize(std::int64_t n);
  void clear();
  void invalidate();
  /// Zero tractions, motions kept.
  void clear_tractions();
  /// Computes the wanted image rows of one node from the tractions.
  void update_slip(const Problem& problem, std::int64_t i);
  void update_gap(const Problem& problem, std::int64_t i);
};

/// A load on body 1 that tractions add up to (the compressive load for the approach), and the sum
/// of its terms' magnitudes.
struct LoadSum {
  double value = 0, magnitude = 0;
};
LoadSum load_on_body1(const Problem& problem, int motion, const std::vector<double> (&lambda)[3]);

/// rn = 1/diagonal of the normal compliance; rt = 1/(2-norm of the node's slip rows)
/// (docs/theory.md, section 2). A node whose rows vanish gets the mean of the others.
void set_scales(Problem& problem, double normal_factor, double tangential_factor);

}  // namespace rollcon
