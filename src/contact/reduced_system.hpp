#pragma once
/// The linear system of one Newton step on the nodes in contact: unknown tractions of the active
/// components, then the unknown motions (bordering), all in units of traction.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/friction/coulomb.hpp"
#include "contact/problem.hpp"
#include "linalg/gmres.hpp"

namespace rollcon {

/// Which tractions are unknown: the normal ones, the tangential ones under a given bound, or all.
enum class Part : std::int32_t { normal = 2, tangential = 3, full = 4 };

class ReducedSystem final : public LinearOperator {
 public:
  /// Copies the rows and columns of the active nodes, scaled by rn and rt; keeps the storage.
  /// Nothing is copied when part and nodes are those of the last call and `changed` is false.
  /// lambda: current tractions; on a curved frame those that the part holds fixed carry a share of
  /// its loads.
  void gather(const Problem& problem, Part part, std::span<const std::int32_t> active,
              const std::vector<double> (&lambda)[3], bool changed);

  /// Linearised law of active node a; to be set for all before use when tangential.
  TangentialLaw& law(std::int64_t a) { return law_[static_cast<std::size_t>(a)]; }
  const TangentialLaw& law(std::int64_t a) const { return law_[static_cast<std::size_t>(a)]; }

  /// Right side: gap (normal) and minus slip (tangential) that do not depend on the unknowns.
  /// known_gap[a], known_slip1[a], known_slip2[a] are per active node, unscaled.
  void right_side(std::span<const double> known_gap, std::span<const double> known_slip1,
                  std::span<const double> known_slip2, std::vector<double>& b) const;

  /// Right side for the rate of a solution: rates, at constant unknowns, of gap and slip and of
  /// what the tangential rows equal (`bound1`, `bound2`, in units of traction), per active node;
  /// and of the loads that the part's unknown motions belong to.
  void rate_side(std::span<const double> gap, std::span<const double> slip1,
                 std::span<const double> slip2, std::span<const double> bound1,
                 std::span<const double> bound2, const std::array<double, 4>& load,
                 std::vector<double>& b) const;

  void apply(const double* x, double* y) override;
  /// Row-major dense matrix of the whole system.
  template <class T>
  void dense(T* out) const;

  /// Entries of the rows and columns of active node a, by place of the component.
  void pair_block(std::int64_t a, double (&block)[3][3]) const;

  /// Scaled operator rows times the tractions of the last apply().
  std::span<const double> product() const { return product_; }
  /// Unknowns that correspond to given tractions and motions.
  void start(const std::vector<double> (&lambda)[3], const std::array<double, 4>& motion,
             std::vector<double>& x) const;
  /// Value of the unknown motion m, if it is one, in physical units; else the given value.
  double motion(const Problem& problem, int m, const double* x) const;

  Part part() const { return part_; }
  std::int64_t size() const { return size_; }
  std::int64_t active() const { return static_cast<std::int64_t>(nodes_.size()); }
  std::span<const std::int32_t> nodes() const { return nodes_; }
  int components() const { return count_; }
  int component(int k) const { return component_[static_cast<std::size_t>(k)]; }
  std::size_t bytes() const { return matrix_.bytes(); }

 private:
  struct Border {
    int motion = 0;
    double scale = 1;               ///< unknown = motion times scale, a traction
    std::vector<double> column[3];  ///< by component, scaled like the rows; empty: zero
    std::vector<double> row[3];     ///< likewise
    double per_load = 1;            ///< right side per unit of the load
    double right = 0;
  };
  void gather_borders(const Problem& problem, const std::vector<double> (&lambda)[3]);
  void add_border(const Problem& problem, int motion, const std::vector<double> (&lambda)[3]);
  bool tangential() const { return part_ != Part::normal; }
  bool normal() const { return part_ != Part::tangential; }

  Part part_ = Part::normal;
  int count_ = 0;
  std::array<int, 3> component_{};
  std::vector<std::int32_t> nodes_;
  std::int64_t size_ = 0;
  RowMatrix<double> matrix_;
  std::vector<TangentialLaw> law_;
  std::vector<double> product_;
  std::vector<double> rn_, rt_;
  std::array<Border, 4> border_;
  int borders_ = 0;
};

}  // namespace rollcon
