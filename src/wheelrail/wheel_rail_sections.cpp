/// Solves wheels and rails by a section. Half-spaces say where the wheel touches once the bodies have given way and how
/// hard it presses there; the bodies then carry that force and say how far they gave way (docs/wheelrail.md).

#include <algorithm>
#include <cmath>

#include "support/error.hpp"
#include "wheelrail/false_position.hpp"
#include "wheelrail/wheel_rail.hpp"

namespace rollcon {
namespace {

constexpr int most = 20;  // solves for a force or a height

/// Returns the x with x + given (x / sink)^1.5 = depth: forces of half-spaces grow about so.
double next_sink(double sink, double given, double depth) {
  const auto beyond = [&](double x) { return x + given * std::pow(x / sink, 1.5) - depth; };
  return false_position(0.0, -depth, 2 * depth, beyond(2 * depth), beyond,
                        [&](double v) { return std::abs(v) <= 1e-9 * depth; });
}

}  // namespace

Status PatchContact::solve_whole(double normal) {
  now_.solves = ++solves_;
  now_.normal = normal;
  now_.on_strips = shown_ = false;
  now_.whole = true;
  whole_->reset();
  place_bodies(whole_->scene, whole_place_);
  give_friction(whole_->scene);
  whole_->scene.prescribe(static_cast<std::int32_t>(Direction::normal), static_cast<std::int32_t>(How::by_force),
                          normal);
  now_.status = whole_->solve();
  if (now_.status == Status::cancelled) return now_.status;
  Vec3 force, moment;
  whole_->resultant(InAxes::local, force.data(), moment.data());
  whole_->motion(&now_.farther, nullptr);
  take_results(force, moment);
  return now_.status;
}

// A section has y of its profile, and z: from the axle, or of the rail's profile.
WholeBodies WheelRail::whole_bodies() const {
  WholeBodies whole{{wheel_, rail_}, {}};
  if (given_wheel_->traits().section) {
    const Vec3& origin = given_wheel_->mesh().section.path().origin;
    whole.body[0] = given_wheel_;
    whole.place[0].translation = {-origin[0], 0, -given_wheel_->section_profile()->radius - origin[2]};
  }
  if (given_rail_->traits().section) {
    const Vec3& down = rail_shape_.down;
    whole.body[1] = given_rail_;
    whole.place[1] = {{{{1, 0, 0}, {0, down[2], down[1]}, {0, -down[1], down[2]}}}, rail_shape_.origin};
    whole.place[1].translation[0] -= given_rail_->mesh().section.path().origin[0];
  }
  return whole;
}

void WheelRail::refuse_for_sections() const {
  const char* what = in_.options.conformal ? "conformal contacts (option conformal)"
                     : in_.table           ? "forces from a table (rollcon_wheelrail_set_table)"
                                           : nullptr;
  if (what) fail(Status::err_unsupported, "the wheel or the rail is a section, which does not take %s", what);
  if (!given_wheel_->traits().section) return;
  constexpr double least = 0.98, largest = 1.02;
  const double own = given_wheel_->section_profile()->radius;
  if (!(radius_ >= least * own && radius_ <= largest * own))
    fail(Status::err_argument,
         "the radius of the wheelset is %g where the wheel's section has y = 0; allowed: %g to %g, within 2 percent of "
         "the section's own, %g",
         radius_, least * own, largest * own, own);
}

Status WheelRail::solve_sections(Status half_spaces) {
  Slot* pressed = nullptr;
  int patches = 0;
  for (Slot* slot : active_)
    if (slot->contact.status() != Status::no_contact) pressed = slot, ++patches;
  if (patches == 0 || half_spaces == Status::cancelled || half_spaces == Status::not_converged ||
      half_spaces == Status::too_deep)
    return half_spaces;
  if (patches > 1)
    fail(Status::err_unsupported,
         "the wheel touches its rail in %d patches (z of the half-spaces is %g), but the wheel or the rail is a "
         "section; "
         "allowed: one patch",
         patches, z_);
  PatchContact& patch = pressed->contact;
  const double up = patch.overlap().share * -patch.overlap().normal[2];
  constexpr double tolerance = 1e-6;
  double normal = dot(patch.force(), patch.overlap().normal);
  Status status = Status::ok;
  for (int i = 0; i < most; ++i) {
    status = patch.solve_whole(normal);
    const double off = in_.load - vertical_force();
    if (!in_.by_force || status == Status::cancelled || std::abs(off) <= tolerance * in_.load) break;
    normal += off / up;
  }
  z_ += patch.farther() / up;
  return half_spaces == Status::coarse || half_spaces == Status::inaccurate ? status : worse(half_spaces, status);
}

// Takes the bodies' own compliance from the last force, and finds the half-spaces' height that belongs to it. Frames
// that fit a little otherwise move heights by 1e-6 of the depth.
Status WheelRail::meet_height_of_sections() {
  constexpr double tolerance = 2e-5, little = 1e-4;
  const double z = in_.position.z, touch = z + search_->first_touch(motion_at(z).pose), depth = z - touch;
  on_lattices_ = false;
  if (!(depth > 0)) return solve_at(z);
  double sink = std::min(0.25 * depth, little * radius_);
  Status status = solve_at(touch + sink);
  for (int i = 0; i < most; ++i) {
    const double force = vertical_force();
    status = solve_sections(status);
    if (!(force > 0) || status == Status::too_deep) return solve_at(z);
    if (status == Status::cancelled || std::abs(z_ - z) <= tolerance * depth) {
      z_ = z;
      return status;
    }
    const double compliance = (z_ - touch - sink) / force;
    double given = compliance * force;
    for (int k = 0; k < most && std::abs(sink + given - depth) > 0.1 * tolerance * depth; ++k) {
      sink = next_sink(sink, given, depth);
      status = solve_at(touch + sink);
      given = compliance * vertical_force();
    }
  }
  context_->caveat(Status::not_converged, "z is %.10g for %.10g: no height of the half-spaces was nearer", z_, z);
  return Status::not_converged;
}

}  // namespace rollcon
