#pragma once
/// Gives displacements and stresses anywhere in a body that a section gives. What acts on its surface is summed over
/// the samples of the harmonics, each factorised once more for as many points as are asked for.

#include <memory>
#include <vector>

#include "bodies/section/system.hpp"

namespace rollcon::section {

class SectionFields final : public BodyFields {
 public:
  /// force: as System::load() numbers it, empty: none; own: displacements of the plane nodes under own loads, empty:
  /// none. The system must outlive it.
  SectionFields(const System& system, std::vector<double> force, std::vector<double> own)
      : system_(system), force_(std::move(force)), own_(std::move(own)) {}
  void at_points(std::int64_t n, const double* xyz, double* displacement, double* stress, int threads) const override;
  void at_nodes(double* stress, int threads) const override;

 private:
  /// Names a point of an element, at an angle of the way.
  struct Place {
    std::int64_t element = 0;
    double xi = 0, eta = 0;
  };
  /// Holds what is asked for at one angle, and what was found: displacements of plane nodes along e1, the way and e2,
  /// and their derivatives by the angle, [2 * (3 * i + c)].
  struct Angle {
    double angle = 0;
    std::vector<std::int64_t> point;
    std::vector<std::int32_t> node;  ///< ascending
    std::vector<double> moved;
  };
  void sum(std::vector<Angle>& angles, int threads) const;
  /// Returns stress[6] in the body's axes and the displacement.
  void evaluate(const Angle& angle, const Place& place, Vec3* moved, double* stress) const;
  Place find(const Vec3& x, double& angle) const;
  std::vector<Angle> by_angle(std::vector<double> angle, const std::vector<Place>& place) const;

  const System& system_;
  std::vector<double> force_, own_;
};

}  // namespace rollcon::section
