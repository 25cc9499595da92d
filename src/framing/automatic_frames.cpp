#include "framing/automatic_frames.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "framing/hertz.hpp"
#include "framing/makers.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

/// Intervals of the coarser frame of a pair, along and across the rolling direction; the finer one has twice as many.
struct Level {
  std::int64_t along, across;
  /// Error of the finer frame as its pair shows it, on average over 40 random Hertzian contacts: measured for the first
  /// three, halved for the others.
  double usual;
};
constexpr std::array levels{Level{6, 4, 0.012}, Level{8, 6, 0.0053}, Level{12, 8, 0.0026}, Level{16, 12, 0.0013},
                            Level{24, 16, 0.0007}};

class AutomaticFrames final : public FrameMaker {
 public:
  Status solve(Contact& contact) override {
    const FramePlace place = find_place(contact);
    // A level is kept while the accuracy asked for is.
    if (const double asked = contact.scene.options.frame_accuracy; level_ == levels.size() || asked != asked_) {
      level_ = first_level(asked);
      asked_ = asked;
    }
    for (;; ++level_) {
      const Status status = solve_on(contact, place);
      if (status != Status::ok) return status;
      const double wanted = contact.scene.options.frame_accuracy, reached = contact.error_estimate();
      if (reached <= wanted) return status;
      if (level_ + 1 == levels.size()) {
        char text[160];
        std::snprintf(text, sizeof text,
                      "frames: the error on the finest frames is about %.2g %%, %.2g %% was asked for "
                      "(option frame_accuracy)",
                      100 * reached, 100 * wanted);
        contact.log(LogLevel::warning, text);
        level_ = levels.size();  // the next scene may be an easier one
        return Status::inaccurate;
      }
    }
  }

  void reset() override {
    level_ = levels.size();
    if (coarse_) coarse_->reset();
  }

 private:
  static std::size_t first_level(double accuracy) {
    std::size_t level = 0;
    while (level + 1 < levels.size() && levels[level].usual > 1.1 * accuracy) ++level;
    return level;
  }

  static FramePlace find_place(Contact& contact) {
    const Scene& scene = contact.scene;
    if (contact.meshed())
      fail(
          Status::err_state,
          "no frame was given: the library makes one for half-spaces and rigid planes only, and a body of this contact "
          "has a mesh; call rollcon_contact_frame_from_body, rollcon_contact_set_frame_nodes or a maker of frames");
    const auto quadratic = scene.quadratic_gap();
    if (!quadratic)
      fail(Status::err_state,
           "no frame was given: the library makes one where the gap is known between nodes, too "
           "(rollcon_contact_set_gap_quadratic); else call rollcon_contact_frame_ellipse, "
           "rollcon_contact_set_frame_nodes or rollcon_contact_frame_from_body");
    const QuadraticGap gap{(*quadratic)[0], (*quadratic)[1], (*quadratic)[2]};
    if (!has_ellipse(gap))
      fail(Status::err_state,
           "no frame was given, and the gap %g x^2 + %g y^2 + %g x y does not grow in all directions: no ellipse "
           "bounds the contact; call rollcon_contact_frame_rectangle or another maker of frames",
           gap.a, gap.b, gap.c);
    const Load& normal = scene.load(Direction::normal);
    const double modulus = contact.modulus();
    HertzContact hertz = normal.how == How::by_force ? hertz_by_load(gap, modulus, normal.value)
                                                     : hertz_by_approach(gap, modulus, normal.value);
    // Bodies that do not touch still have a frame: of the size under a thousandth of the radius of curvature.
    if (!(hertz.larger > 0 && hertz.smaller > 0 && std::isfinite(hertz.larger)))
      hertz = hertz_by_approach(gap, modulus, 1e-6 / (gap.a + gap.b));
    return place_of_disc(hertz.larger, hertz.smaller, hertz.angle);
  }

  static SurfaceMesh mesh(std::int64_t along, std::int64_t across) {
    return strips_mesh({}, strips_of_ellipse(1, 1, 0, across), along);
  }

  Status solve_on(Contact& contact, const FramePlace& place) {
    const Level& l = levels[level_];
    if (!coarse_) coarse_ = contact.make_follower();
    coarse_->follow(contact);
    Scene &fine = contact.scene, &coarse = coarse_->scene;
    if (level_ != made_at_ || mesh_ != fine.revision.mesh) {
      fine.set_placed_frame(mesh(2 * l.along, 2 * l.across), place);
      coarse.set_placed_frame(mesh(l.along, l.across), place);
      made_at_ = level_;
      mesh_ = fine.revision.mesh;
      axes_ = fine.revision.axes;
    } else if (!(place == fine.place()) || axes_ != fine.revision.axes) {
      fine.place_frame(place);
      coarse.place_frame(place);
      axes_ = fine.revision.axes;
    }
    const Status status = contact.solve_on_frame();
    if (status != Status::ok) return status;
    const Status below = coarse_->solve_on_frame();
    if (below != Status::ok) return below;
    contact.extrapolate_from(*coarse_);
    return status;
  }

  std::unique_ptr<Contact> coarse_;
  std::size_t level_ = levels.size();  ///< none yet
  double asked_ = 0;
  std::size_t made_at_ = levels.size();
  std::int64_t axes_ = -1, mesh_ = -1;  ///< revisions when it was made
};

}  // namespace

std::unique_ptr<FrameMaker> make_frame_maker() {
  return std::make_unique<AutomaticFrames>();
}

}  // namespace rollcon
