#pragma once
/// Solves contacts without a given frame on strips that are as fine as the accuracy asked for needs (docs/theory.md,
/// section 4).

#include <array>
#include <memory>
#include <optional>

#include "framing/strip_frames.hpp"

namespace rollcon {

class StripLevels final : public MovingFrame {
 public:
  /// Solves on strips of two counts that fit the contact inside of the box, then on finer ones until the accuracy that
  /// the scene asks for is met. area: area of the contact, if known. Returns nothing if strips do not fit. Errors are
  /// those of Solver::solve().
  std::optional<Status> solve(Solver& fine, const Rectangle& box, const std::optional<double>& area);
  /// Reports that the error of the finest frames is `reached`, more than was asked for; returns the status for it.
  static Status tell_inaccurate(const Solver& fine, double reached);
  /// Says whether the last strips that were tried missed peaks of pressure where curvatures jump.
  bool missed_corners() const { return missed_corners_; }
  void forget();  ///< drops warm starts
  /// Takes differences where results of several counts are mixed, because the weights of the mixture change, too.
  bool rates(Parameter parameter, Rates& found) override;

 private:
  static constexpr std::size_t levels = 6;
  /// Holds the results of levels, extrapolated and mixed, the last of these levels and its error.
  struct Mixture {
    Rates sure;
    std::size_t level = 0;
    bool mixed = false;
    ErrorEstimate error;
  };
  template <class Find>
  std::optional<Mixture> mix(const Scene& scene, Find find, std::size_t last);
  bool fit(Solver& fine, const Rectangle& box, std::size_t level, Rates& found);
  double area_at(std::size_t level) const;
  double step_for(const Scene& scene, Parameter parameter, const Rates& rates) const;

  std::array<StripFrames, levels> strips_;
  std::unique_ptr<Solver> coarse_;
  const Scene* scene_ = nullptr;  ///< scene of the last mixture
  std::size_t last_ = 0;          ///< last level of that mixture
  bool mixed_ = false;            ///< that mixture has more than one level
  bool missed_corners_ = false;
};

/// Reports normals that a plane frame is not accurate enough for, by their angles.
Status tell_inclined(const Solver& fine, double inclined, double turned);

/// Returns the relative error of normal forces on a plane frame, where pressures act along n of the axes. Contacts
/// whose normals are inclined by an angle carry 1 / cos(angle) times as much. turned: root mean square angle by which
/// normals turn to both sides of their mean; forces of balls in grooves differ by 0.55 of that from those on conformal
/// frames.
double off_by_plane(double inclined, double turned);

}  // namespace rollcon
