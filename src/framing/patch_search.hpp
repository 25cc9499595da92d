#pragma once
/// Finds where bodies touch each other: from the undeformed gap and what presses them together, without friction, on a
/// lattice that closes in on the contact (docs/theory.md, section 4).

#include <functional>
#include <memory>
#include <vector>

#include "contact/solver.hpp"
#include "framing/contact_edge.hpp"

namespace rollcon {

struct PatchScene {
  GapBetween gap;
  Rectangle bounds;  ///< region over which the gap is known, in the axes
  double modulus = 0;
  double speed = 0;  ///< speed of bodies that creep, for which lattices lie along the rolling direction; else 0
  bool by_force = false;
  double value = 0;        ///< load or approach
  bool no_inside = false;  ///< bodies' surfaces have no inside: the gap alone tells on which sides they lie
};

struct Patches {
  std::vector<Outline> outline;
  bool at_bounds = false;  ///< the contact reaches the bounds
};

class PatchSearch {
 public:
  /// Finds the patches, within the context and cancelling of `contact`, which outlives this object. Where the bodies do
  /// not touch one outline tells where they are nearest to each other. err_argument: there is no finite gap, or the
  /// bodies' order is the other one. Throws Cancelled.
  Patches find(Solver& contact, const PatchScene& scene);
  /// Finds the patches of the last find() again, each in a plane of its own that is inclined to the axes across the
  /// rolling direction. cosine: that of the inclination at a point.
  Patches find_inclined(Solver& contact, const PatchScene& scene,
                        const std::function<double(double x, double y)>& cosine);

 private:
  void lay(const SearchGrid& lattice, const PatchScene& scene);
  void press(const PatchScene& scene);
  bool press_bodies(Solver& contact, const PatchScene& scene, std::vector<PatchEdge>& edge);
  void solve(Solver& solver);
  SearchGrid close_in(Solver& contact, const PatchScene& scene);
  std::vector<PatchEdge> look(Solver& contact, const PatchScene& scene);
  /// Holds a patch's scene in a plane of its own, y' = middle + (y - middle) / cosine. back(): y from y'.
  struct Inclined {
    PatchScene scene;
    double middle = 0, cosine = 1;
    double back(double y) const { return middle + (y - middle) * cosine; }
  };
  Inclined inclined(const PatchScene& scene, std::size_t which,
                    const std::function<double(double x, double y)>& cosine) const;
  static void add_outlines(const std::vector<PatchEdge>& edge, const EdgePoint& cell, const Rectangle& bounds,
                           Patches& found);

  std::unique_ptr<Solver> half_space_;  ///< half-spaces on the lattice
  double modulus_ = 0, speed_ = 0;
  SearchGrid lattice_;
  std::vector<PatchEdge> edge_;  ///< edges of the last find()
  std::vector<double> gap_, pressure_, deformed_;
  double depth_ = 0;  ///< approach
  bool pressed_ = false;
};

}  // namespace rollcon
