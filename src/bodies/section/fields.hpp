#pragma once
/// Gives displacements and stresses anywhere in a body by a section. Responses to the loads on its surface are summed
/// over the sampled harmonics; each sample is factorised once more for a call, however many points it asks for.

#include <memory>
#include <vector>

#include "bodies/section/system.hpp"

namespace rollcon::section {

class SectionFields final : public BodyFields {
 public:
  /// Takes forces in the order of System::load(), displacements of the plane nodes under the body's own loads (empty:
  /// none), and the rate at which a body that creeps passes by. The system must outlive the fields.
  SectionFields(const System& system, std::vector<double> force, std::vector<double> own, double rate)
      : system_(system), force_(std::move(force)), own_(std::move(own)), rate_(rate) {}
  void at_points(std::int64_t n, const double* xyz, double* displacement, double* stress, int threads) const override;
  void at_nodes(double* stress, int threads) const override;

 private:
  /// Names a point of an element; its angle along the way is kept beside it.
  struct Place {
    std::int64_t element = 0;
    double xi = 0, eta = 0;
  };
  /// Holds displacements of plane nodes: for each angle a row of values and a row of derivatives by the angle.
  struct Moved {
    RowMatrix<double> across, along;  ///< along e1 and e2, in turn; along the way
  };
  /// Holds the points asked for, in ascending order of their angles, and displacements there. The first displacements
  /// are the body's; each of the others is convolved with the moduli of one way to relax, for stresses.
  struct Stations {
    std::vector<double> angle;
    std::vector<std::vector<std::int64_t>> point;
    std::vector<std::int32_t> node;  ///< ascending
    std::vector<Moved> moved;        ///< by System::relaxation_of()
  };
  void sum(Stations& all, int threads) const;
  /// Returns the displacement at the angle of number k, or stress[6], in the body's axes.
  void evaluate(const Stations& all, std::size_t k, const Place& place, Vec3* moved, double* stress) const;
  Place find(const Vec3& x, double& angle) const;
  Stations by_angle(const std::vector<double>& angle, const std::vector<Place>& place) const;

  const System& system_;
  std::vector<double> force_, own_;
  double rate_;
};

}  // namespace rollcon::section
