#pragma once
/// Reads what a contact's scene gives for a solve on strips (framing/strips/).

#include <array>
#include <memory>
#include <optional>

#include "contact/scene/known_gap.hpp"
#include "contact/solver.hpp"
#include "framing/strips/strip_contact.hpp"

namespace rollcon {

/// Says whether strips can be tried: elastic half-spaces or rigid surfaces in steady rolling, on a plane, under loads
/// without tilts.
bool strips_may_fit(const Scene& scene, const PairOfBodies& pair);

/// Holds the fields of a scene, as it was when it was read, for strips. It refers to the bodies alone.
class StripGivens {
 public:
  StripGivens() = default;
  StripGivens(const StripGivens&) = delete;
  StripGivens& operator=(const StripGivens&) = delete;

  /// Reads the scene of a solver whose bodies are prepared; box: where the contact lies.
  void read(Solver& on, const Rectangle& box);
  const strips::StripScene& scene() const { return scene_; }
  /// Adds a multiple of rates to the values of the scene, but not to its fields.
  void shift(const strips::StripParameter& rates, double factor);
  /// Says whether Coulomb's law with one coefficient or those across is all that resists slip.
  bool coulomb() const { return coulomb_; }
  /// Returns creepages, spin and fields of slip over speed, which frictionless scenes do not have.
  std::array<double, 2> rigid_slip(const Vec2& point) const;
  double speed() const { return speed_; }
  /// Returns the slope of the mean surface against the plane of the axes.
  Vec2 slope(const Vec2& point) const;
  /// Says whether both bodies are at a point.
  bool both_at(const Vec2& point) const;

 private:
  /// Gives the undeformed gap; where a body has ended it is large.
  struct Gap : strips::PlaneField {
    const StripGivens* of = nullptr;
    void at(std::span<const Vec2> point, double* value, Vec2* slope) const override;
  };
  /// Gives slip over speed that depends on the height at which both bodies are compared.
  struct Slip : strips::PlaneField {
    const StripGivens* of = nullptr;
    double per_height = 0;
    void at(std::span<const Vec2> point, double* value, Vec2* slope) const override;
  };
  struct Friction : strips::PlaneField {
    std::vector<double> y, mu;
    void at(std::span<const Vec2> point, double* value, Vec2* slope) const override;
  };
  void read_motions(const Scene& scene, const Rectangle& box);
  double height_between(double x, double y, Vec2* slope) const;

  strips::StripScene scene_;
  std::unique_ptr<KnownGap> known_;
  std::optional<std::array<double, 3>> quadratic_;
  Gap gap_;
  Slip slip_[2];
  Friction friction_;
  std::array<double, 2> weight_{0.5, 0.5};  ///< weights of the bodies' heights where velocities are compared
  std::array<double, 3> creepage_{};
  double origin_height_ = 0, speed_ = 1, far_ = 0;
  bool coulomb_ = true;
};

}  // namespace rollcon
