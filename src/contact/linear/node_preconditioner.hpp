#pragma once
/// Inverts Newton's systems approximately where operators are not formed: rows of the normal law and of sticking nodes
/// as derived classes do, rows of sliding nodes node by node, borders exactly.

#include <vector>

#include "contact/linear/reduced_system.hpp"
#include "linalg/lu.hpp"

namespace rollcon {

class NodePreconditioner : public FieldPreconditioner {
 public:
  void take(const ReducedSystem& system) final;
  void apply(const double* x, double* y) final;
  std::size_t bytes() const override { return (inverse_.capacity() + columns_.capacity()) * sizeof(double); }

 protected:
  const ReducedSystem& system() const { return *system_; }
  /// Says of an active node whether it sticks.
  bool sticks(std::int64_t a) const { return stick_[static_cast<std::size_t>(a)] != 0; }

 private:
  /// Brings what rows are inverted by up to date.
  virtual void take_rows() {}
  /// Finds tractions y of the active nodes from rows x of the normal law.
  virtual void normal_rows(const double* x, double* y) = 0;
  /// Finds both tangential tractions of sticking nodes from their rows, with those along t2 active() places behind.
  virtual void sticking_rows(const double* x, double* y) = 0;
  void apply_rows(const double* x, double* y);
  void sliding_rows(const double* x, double* y) const;

  const ReducedSystem* system_ = nullptr;
  std::vector<std::uint8_t> stick_;  ///< flags by active node
  std::vector<double> inverse_;      ///< inverses of sliding nodes' own 2 x 2, by active node
  std::vector<double> columns_, work_;
  Lu<double> schur_;
  int borders_ = 0;
};

}  // namespace rollcon
