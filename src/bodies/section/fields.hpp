#pragma once
/// Gives displacements and stresses anywhere in a body by a section. Responses to the loads on its surface are summed
/// over the sampled harmonics; each sample is factorised once more for a call, however many points it asks for.

#include <memory>
#include <vector>

#include "bodies/section/system.hpp"

namespace rollcon::section {

class SectionFields final : public BodyFields {
 public:
  /// Takes forces as System::load() numbers them, and displacements of the plane nodes under the body's own loads;
  /// empty: none. The system must outlive the fields.
  SectionFields(const System& system, std::vector<double> force, std::vector<double> own)
      : system_(system), force_(std::move(force)), own_(std::move(own)) {}
  void at_points(std::int64_t n, const double* xyz, double* displacement, double* stress, int threads) const override;
  void at_nodes(double* stress, int threads) const override;

 private:
  /// Names a point of an element; its angle along the way is kept beside it.
  struct Place {
    std::int64_t element = 0;
    double xi = 0, eta = 0;
  };
  /// Holds the points asked for at one angle, and their answers: displacements of plane nodes along e1, the way and e2,
  /// each with its derivative by the angle, from [2 * (3 * i + c)] on.
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
