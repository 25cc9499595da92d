#pragma once
/// Holds the linear system of one Newton step on the nodes in contact: unknown tractions of the active components, then
/// the unknown motions (bordering), all in units of traction.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/laws/friction_law.hpp"
#include "contact/problem/problem.hpp"
#include "linalg/dense.hpp"
#include "linalg/gmres.hpp"

namespace rollcon {

class ReducedSystem final : public LinearOperator {
 public:
  /// Copies the rows and columns of the active nodes, scaled by rn and rt; keeps the storage. Nothing is copied when
  /// part and nodes are those of the last call and `changed` is false. lambda: current tractions; on a curved frame
  /// those that the part holds fixed carry some of its loads.
  void gather(const Problem& problem, const Prescribed& given, Part part, std::span<const std::int32_t> active,
              const std::vector<double> (&lambda)[3], bool changed);

  /// Returns the linearised law of active node a; to be set for all before use when tangential.
  TangentialLaw& law(std::int64_t a) { return law_[static_cast<std::size_t>(a)]; }
  const TangentialLaw& law(std::int64_t a) const { return law_[static_cast<std::size_t>(a)]; }

  /// Makes the right side: gap (normal) and minus slip (tangential) that do not depend on the unknowns. known_gap[a],
  /// known_slip1[a], known_slip2[a] are per active node, unscaled.
  void right_side(std::span<const double> known_gap, std::span<const double> known_slip1,
                  std::span<const double> known_slip2, std::vector<double>& b) const;

  /// Makes the right side for the rate of a solution: rates, at constant unknowns, of gap and slip and of what the
  /// tangential rows equal (`bound1`, `bound2`, in units of traction), per active node; and of the loads that the
  /// part's unknown motions belong to.
  void rate_side(std::span<const double> gap, std::span<const double> slip1, std::span<const double> slip2,
                 std::span<const double> bound1, std::span<const double> bound2, const MotionValues& load,
                 std::vector<double>& b) const;

  void apply(const double* x, double* y) override;
  /// Applies the system where the scaled operator rows times the tractions of x are known.
  void apply_known(const double* x, std::span<const double> product, double* y);

  /// Copies the entries of the rows and columns of active node a, by place of the component.
  void pair_block(std::int64_t a, double (&block)[3][3]) const;

  /// Returns false where the operators are not formed, so that there are no rows.
  bool formed() const { return formed_; }
  const Operators& operators() const { return *op_; }
  /// Returns the scale of the rows of traction component c at active node a.
  double scale_of(int c, std::size_t a) const { return c == 2 ? rn_[a] : rt_[a]; }
  double normal_scale(std::int64_t a) const { return rn_[static_cast<std::size_t>(a)]; }
  double slip_scale(std::int64_t a) const { return rt_[static_cast<std::size_t>(a)]; }
  int borders() const { return borders_; }
  /// Returns the column of border k: what its motion adds to the rows of the active nodes, the laws included.
  void border_column(int k, double* y) const;
  /// Returns the motion of border k; those that change the gap are the last.
  int border_motion(int k) const { return border_[static_cast<std::size_t>(k)].motion; }
  /// Returns border k's column or row at the active nodes by traction component, without the laws; empty: zero.
  std::span<const double> border_column_part(int k, int component) const {
    return border_[static_cast<std::size_t>(k)].column[component];
  }
  std::span<const double> border_row_part(int k, int component) const {
    return border_[static_cast<std::size_t>(k)].row[component];
  }
  /// Returns a scaled operator row without law and borders, over all tractions, where formed().
  const double* row(std::int64_t i) const { return matrix_.row(i); }
  /// Returns the load row of border k times the tractions x.
  double border_product(int k, const double* x) const;

  /// Returns the scaled operator rows times the tractions of the last apply().
  std::span<const double> product() const { return product_; }
  /// Completes the product of an apply() that was done in parts.
  void add_to_product(std::span<const double> other) {
    for (std::size_t i = 0; i < other.size(); ++i) product_[i] += other[i];
  }
  /// Finds the unknowns that correspond to given tractions and motions.
  void start(const std::vector<double> (&lambda)[3], const MotionValues& motion, std::vector<double>& x) const;
  /// Returns the value of the unknown motion m, if it is one, in physical units; else the given value.
  double motion(const Prescribed& given, int m, const double* x) const;

  Part part() const { return part_; }
  std::int64_t size() const { return size_; }
  std::int64_t active() const { return static_cast<std::int64_t>(nodes_.size()); }
  std::span<const std::int32_t> nodes() const { return nodes_; }
  int components() const { return count_; }
  int component(int k) const { return component_[static_cast<std::size_t>(k)]; }
  std::size_t bytes() const {
    std::size_t sum = matrix_.bytes();
    for (int c = 0; c < 3; ++c) sum += (field_lambda_[c].capacity() + field_image_[c].capacity()) * sizeof(double);
    return sum;
  }

 private:
  struct Border {
    int motion = 0;
    double scale = 1;               ///< unknown = motion times scale, a traction
    std::vector<double> column[3];  ///< column by component, scaled like the rows; empty: zero
    std::vector<double> row[3];     ///< row by component, scaled like the column
    double per_load = 1;            ///< right side per unit of the load
    double right = 0;
  };
  template <class Constant, class OfLoad>
  void fill_side(std::span<const double> gap, std::span<const double> slip1, std::span<const double> slip2,
                 Constant constant, OfLoad of_load, std::vector<double>& b) const;
  void gather_borders(const Problem& problem, const Prescribed& given, const std::vector<double> (&lambda)[3]);
  void add_border(const Problem& problem, const Prescribed& given, int motion, const std::vector<double> (&lambda)[3]);
  void apply_field(const double* x);
  void add_laws(const double* x, double* y) const;
  bool tangential() const { return has_tangential(part_); }
  bool normal() const { return has_normal(part_); }

  Part part_ = Part::normal;
  int count_ = 0;
  std::array<int, 3> component_{};
  std::vector<std::int32_t> nodes_;
  std::int64_t size_ = 0, rows_ = 0;  ///< unknowns with and without the borders
  RowMatrix<double> matrix_;
  const Operators* op_ = nullptr;
  bool formed_ = true;
  std::vector<double> field_lambda_[3], field_image_[3];  ///< tractions and images at all nodes of the frame
  std::vector<TangentialLaw> law_;
  std::vector<double> product_;
  std::vector<double> rn_, rt_;
  std::array<Border, motion_count> border_;
  int borders_ = 0;
};

}  // namespace rollcon
