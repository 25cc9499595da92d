#pragma once
/// Provides dense operators of a frame that is stretched from solve to solve, above bodies that respond alike at all
/// places and sizes: those of one shape serve all sizes, those of other shapes are interpolated (docs/theory.md, 4).

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "contact/operators/dense_operators.hpp"
#include "contact/scene/scene.hpp"

namespace rollcon {

class OperatorFamily {
 public:
  /// Integrates for a frame at a place; fills the rows that `op` is to have.
  using Assemble = std::function<void(const FramePlace&, DenseOperators& op)>;

  /// Names the version of compliance and scheme that the operators belong to; another number forgets all of them.
  void belong_to(std::int64_t version, bool tangential);
  /// Puts the operators at a place into blocks that are there or are made at the first call; returns how many were
  /// assembled. displacements: the slip rows are displacements, too, and grow with the size.
  std::int64_t fill(const FramePlace& place, bool displacements, const Assemble& assemble, DenseOperators& op);
  std::size_t bytes() const;

 private:
  /// Holds operators at width 1.
  struct Entry {
    double length = 0, shear = 0;
    std::int64_t step = none;  ///< step on the grid of shapes; none: beside it
    DenseOperators op;
  };
  static constexpr std::int64_t none = INT64_MIN;

  const Entry* beside_grid(double length, double shear) const;
  const Entry& on_grid(std::int64_t step, const Assemble& assemble);
  Entry& add(double length, double shear, std::int64_t step, const Assemble& assemble);
  void forget_farthest(double length);
  void forget_oldest_beside_grid();

  std::int64_t version_ = none;
  bool tangential_ = false;
  double last_length_ = 0;
  std::int64_t assemblies_ = 0;
  std::vector<std::unique_ptr<Entry>> entry_;
};

}  // namespace rollcon
