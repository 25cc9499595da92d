#pragma once
/// Leaves out of the linear system of a Newton step what friction's law gives at once: at a sliding node the traction
/// along the direction of slip is -mu times the pressure (or a given number), so that only the component across it is
/// unknown.

#include <cstdint>
#include <span>
#include <vector>

#include "contact/linear/reduced_system.hpp"

namespace rollcon {

/// Orders unknowns and rows alike: each active node's first tangential component, or at sliding nodes the one across
/// the direction of slip; the second one of every node that does not slide; the normal ones; the motions. It has those
/// of them that the part has.
class FreeSystem final : public LinearOperator {
 public:
  enum class Rows { tangential, normal, all };

  /// Takes a system, which must outlive its use here and keep its laws.
  void take(ReducedSystem& system);
  /// Makes the right side b of the free rows for right side `whole` of all rows; keeps what expand() adds.
  void reduce(const std::vector<double>& whole, std::vector<double>& b);
  /// Returns all unknowns. The system's product() is then that of x; the last apply() must be of y.
  void expand(const double* y, double* x);
  void apply(const double* y, double* out) override;
  /// Writes some rows, with the same columns, row by row; tangential rows leave out motions that change the gap.
  template <class T>
  void dense(Rows rows, T* out);
  /// Subtracts what tangential unknowns y add to the normal rows: out -= A_nt y.
  void subtract_from_normal(const double* y, double* out);

  ReducedSystem& system() const { return *system_; }
  std::int64_t size() const { return size_; }
  std::int64_t size(Rows rows) const;
  std::int64_t active() const { return static_cast<std::int64_t>(na_); }
  bool tangential() const { return tangential_; }
  bool normal() const { return normal_; }
  /// Counts the motions among the unknowns of the rows.
  std::int64_t borders(Rows rows) const;
  /// Lists the active nodes that do not slide.
  std::span<const std::int32_t> whole() const { return whole_; }
  /// Returns the unit vector across the direction of slip of active node a; (1, 0) where it does not slide.
  double across(int c, std::size_t a) const { return across_[c][a]; }
  std::size_t bytes() const;

 private:
  template <class T>
  void columns(Rows rows, const double* row, T* out) const;
  void write(const double* y, double* x) const;
  void write_across(const double* y, double* x) const;
  void select(const double* full, double* free) const;

  ReducedSystem* system_ = nullptr;
  std::size_t na_ = 0;
  bool tangential_ = false, normal_ = false;
  std::int64_t size_ = 0;
  std::vector<std::int32_t> whole_;
  std::vector<double> across_[2];
  std::vector<double> along_[2];  ///< traction along slip per unit of the normal one; 0: none
  std::vector<double> slip_[2];   ///< direction of slip; (0, 0) where it does not slide
  std::vector<double> given_;     ///< unknowns that the laws give at once, all rows
  std::vector<double> x_, y_, row_, product_;
  bool any_given_ = false;
};

}  // namespace rollcon
