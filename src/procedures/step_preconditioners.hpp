#pragma once
/// Provides preconditioners of GMRES on the system of a step.

#include "linalg/lu.hpp"
#include "procedures/step_factors.hpp"

namespace rollcon {

/// Solves every unknown from its own equation, divided by its entry there or by that one's sign alone.
class OwnEntries final : public LinearOperator {
 public:
  void take(const ContactEquations& equations, const std::vector<std::int64_t>& own_rows, bool divide);
  void apply(const double* x, double* y) override;

 private:
  std::vector<std::int64_t> row_;
  std::vector<double> factor_;
};

/// Maps vectors of a later step to the tractions of an earlier one, by node and direction; pairs may stick where they
/// slid. Unknowns that the earlier step lacks do not change.
class KeptDirections {
 public:
  void keep(const ContactEquations& equations);
  /// Counts unknowns of another step that have no counterpart, or whose pair had other ones.
  int changed(const ContactEquations& equations) const;
  /// Moves the contact part x of the later step's right side to that of the earlier one, and back to y.
  void to_kept(const ContactEquations& equations, const double* x, std::vector<double>& kept);
  void from_kept(const ContactEquations& equations, const std::vector<double>& kept, double* y);
  std::int64_t size() const { return static_cast<std::int64_t>(direction_.size()) + motions_; }

 private:
  struct Direction {
    std::size_t node = 0;
    std::array<double, 3> vector{}, traction{};
  };
  std::vector<Direction> direction_;
  std::int64_t motions_ = 0;
  std::vector<double> nodal_;
};

/// Preconditions by factors of an earlier step's contact equations in single precision, used as
/// long as they serve, and of the bodies' matrices, where these are written out.
/// S is then roughly that of half-spaces of the pair's modulus, in place of the bodies:
///
///   c = S^-1 r_contact,   d = K^-1 (r_bodies + B c)
class KeptFactors final : public LinearOperator {
 public:
  /// Takes the images whose rough ones make S; null leaves S unchanged.
  KeptFactors(BodiesEquations& bodies, Images* images, const Frame& frame)
      : bodies_(bodies), images_(images), frame_(frame) {}
  /// Factorises the matrix of this step. Returns false if it is singular to single precision.
  bool factor(const ContactEquations& equations);
  bool valid() const { return valid_; }
  int changed(const ContactEquations& equations) const { return directions_.changed(equations); }
  /// Returns how many iterations beyond good ones cost as much as new factors.
  int price(const ContactEquations& equations) const;
  /// Takes the step that vectors belong to.
  void take(const ContactEquations& equations) { equations_ = &equations; }
  void apply(const double* x, double* y) override;
  std::size_t bytes() const { return lu_.bytes() + matrix_.bytes(); }

 private:
  BodiesEquations& bodies_;
  Images* images_;
  const Frame& frame_;
  bool valid_ = false;
  const ContactEquations* equations_ = nullptr;
  KeptDirections directions_;
  Lu<float> lu_;
  RowMatrix<double> matrix_;
  std::vector<float> single_;
  std::vector<double> kept_, t_;
};

}  // namespace rollcon
