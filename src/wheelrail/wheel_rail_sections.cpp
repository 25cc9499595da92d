/// Solves wheels and rails by a section. Half-spaces say where the wheel touches once the bodies have given way and how
/// hard it presses there; the bodies then carry these forces and say how far they gave way (docs/wheelrail.md).

#include <algorithm>
#include <array>
#include <cmath>

#include "bodies/displacement_beside.hpp"
#include "contact/solver.hpp"
#include "support/error.hpp"
#include "support/index.hpp"
#include "support/small_system.hpp"
#include "wheelrail/wheel_rail.hpp"

namespace rollcon {
namespace {

constexpr int most = 20;  // solves for a force or a height
constexpr std::size_t most_patches = 8;

/// Returns how much nearer the patch's surfaces come for a length that the wheelset sinks.
double rise_of(const OverlapPatch& patch) {
  return -patch.normal[2];
}

}  // namespace

Status PatchContact::solve_whole(double normal, bool alone) {
  now_.solves = ++solves_;
  now_.normal = normal;
  now_.on_strips = shown_ = false;
  now_.whole = true;
  now_.alone = alone;
  whole_->reset();
  if (alone)
    whole_->scene.forget_frame();
  else
    put_frame(whole_->scene, now_.lattice, place(false), true);
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

double PatchContact::parts(const OverlapPatch& there) const {
  const Solution& on = whole_->solver->solution();
  const Frame& frame = on.prepared->frame;
  std::vector<double> traction(3 * frame.x.size());
  for (std::size_t k = 0; k < traction.size(); ++k) traction[k] = on.iterate.lambda[k % 3][k / 3];
  const auto turned = [this](const Vec3& v) {
    return Vec3{dot(v, now_.axes.t1), dot(v, now_.axes.t2), dot(v, now_.axes.n)};
  };
  const Vec3 place = turned(there.reference - now_.axes.origin), normal = turned(there.normal);
  double apart = 0;
  for (const int b : {0, 1}) {
    Vec3 moved{0, 0, 0};
    if (on.prepared->pair.body[at(b)]->meshed()) {
      moved = displacement_beside(frame, on.prepared->pair, b, traction, place);
    } else {
      const Vec3 d = place - frame.axes.origin;
      const double xy[2] = {dot(d, frame.axes.t1), dot(d, frame.axes.t2)};
      Vec3 local;
      whole_->displacements_at(b + 1, 1, xy, local.data());
      moved = local[0] * frame.axes.t1 + local[1] * frame.axes.t2 + local[2] * frame.axes.n;
    }
    apart += (b == 0 ? 1 : -1) * dot(moved, normal);
  }
  return apart;
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
                     : roller_ > 0         ? "a roller (rollcon_wheelrail_set_roller)"
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

// Solves the whole bodies under the forces of the half-spaces. They carry the vertical force together.
Status WheelRail::solve_sections(Flexibility& found) {
  constexpr double tolerance = 1e-6;
  found.slot = pressed();
  const std::size_t n = found.slot.size();
  if (n > most_patches)
    fail(Status::err_unsupported,
         "the wheel touches its rail in %d patches (z of the half-spaces is %g), but the wheel or the rail is a "
         "section; allowed: 1 to %d patches",
         static_cast<int>(n), z_, static_cast<int>(most_patches));
  std::vector<double> normal;
  for (const Slot* slot : found.slot) normal.push_back(dot(slot->contact.force(), slot->contact.overlap().normal));
  Status status = Status::ok;
  for (int i = 0; i < most; ++i) {
    status = Status::ok;
    double carried = 0;
    for (std::size_t k = 0; k < n; ++k) {
      PatchContact& patch = found.slot[k]->contact;
      status = worse(status, patch.solve_whole(normal[k], n == 1));
      if (status == Status::cancelled) return status;
      carried += patch.overlap().share * rise_of(patch.overlap()) * normal[k];
    }
    const double off = in_.load - vertical_force();
    if (!in_.by_force || std::abs(off) <= tolerance * in_.load) break;
    for (double& force : normal) force *= 1 + off / carried;
  }
  found.apart.assign(n * n, 0.0);
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) {
      const PatchContact &there = found.slot[i]->contact, &own = found.slot[j]->contact;
      const double apart =
          i == j ? own.farther() + found.slot[i]->give_way : own.overlap().share * own.parts(there.overlap());
      found.apart[i * n + j] = apart / normal[j];
    }
  return status;
}

std::vector<WheelRail::Slot*> WheelRail::pressed() const {
  std::vector<Slot*> slots;
  for (Slot* slot : active_)
    if (slot->contact.status() != Status::no_contact) slots.push_back(slot);
  return slots;
}

// Forces grow with the depth to the power 3/2, and the bodies give way by what the flexibility says: a step of Newton's
// method for the depths of all patches, and for the wheelset's height under a vertical force.
WheelRail::DepthStep WheelRail::step_of_depths(const Flexibility& flexibility) const {
  const std::size_t n = flexibility.slot.size();
  std::array<std::array<double, most_patches + 1>, most_patches + 1> a{};
  std::array<double, most_patches + 1> b{}, x{}, normal{}, slope{};
  for (std::size_t i = 0; i < n; ++i) {
    const Slot& slot = *flexibility.slot[i];
    normal[i] = dot(slot.contact.force(), slot.contact.overlap().normal);
    slope[i] = 1.5 * normal[i] / (slot.contact.overlap().overlap - slot.give_way);
  }
  const double down = in_.position.z - z_;
  for (std::size_t i = 0; i < n; ++i) {
    const OverlapPatch& patch = flexibility.slot[i]->contact.overlap();
    a[i][i] = 1;
    b[i] = flexibility.slot[i]->give_way;
    for (std::size_t j = 0; j < n; ++j) {
      a[i][j] += flexibility.apart[i * n + j] * slope[j];
      b[i] -= flexibility.apart[i * n + j] * normal[j];
    }
    a[i][n] = -rise_of(patch);
    a[n][i] = in_.by_force ? patch.share * rise_of(patch) * slope[i] : 0;
  }
  if (!in_.by_force) a[n][n] = 1, b[n] = down;
  DepthStep step;
  if (!solve_small(n + 1, a, b, x)) return step;
  step.solved = true;
  step.down = x[n];
  for (std::size_t i = 0; i < n; ++i) {
    const Slot& slot = *flexibility.slot[i];
    step.deeper.push_back(std::max(x[i], -0.8 * (slot.contact.overlap().overlap - slot.give_way)));
    step.largest = std::max(step.largest, std::abs(x[i]));
  }
  return step;
}

// Sinks the half-spaces so far that none of them has to come nearer than its overlap.
double WheelRail::take(const DepthStep& step, const Flexibility& flexibility) const {
  double down = -INFINITY;
  for (std::size_t i = 0; i < step.deeper.size(); ++i) {
    const Slot& slot = *flexibility.slot[i];
    down = std::max(down, (step.deeper[i] - slot.give_way) / rise_of(slot.contact.overlap()));
  }
  for (std::size_t i = 0; i < step.deeper.size(); ++i) {
    Slot& slot = *flexibility.slot[i];
    slot.give_way = std::max(0.0, slot.give_way - step.deeper[i] + rise_of(slot.contact.overlap()) * down);
  }
  return z_ + down;
}

// Takes the bodies' own flexibility from the last forces, and finds the half-spaces' depths that belong to it. Frames
// that fit a little otherwise move heights by 1e-6 of the depth.
Status WheelRail::find_height_of_sections() {
  constexpr double tolerance = 2e-5, within = 0.1, little = 1e-4;
  const double z = in_.position.z;
  for (const auto& slot : slot_) slot->give_way = 0;
  on_lattices_ = false;
  seek_strips();
  const double depth = in_.by_force ? 0 : -search_->first_touch(motion_at(z).pose);
  if (!in_.by_force && !(depth > 0)) return solve_at(z);
  Status half_spaces =
      in_.by_force ? find_height_of_half_spaces() : solve_at(z - depth + std::min(0.25 * depth, little * radius_));
  Flexibility flexibility;
  for (int i = 0; i < most; ++i) {
    const bool answer = half_spaces != Status::not_converged && half_spaces != Status::too_deep && !pressed().empty();
    if (!answer || half_spaces == Status::cancelled)
      return in_.by_force || half_spaces == Status::cancelled ? half_spaces : solve_at(z);
    const Status status = solve_sections(flexibility);
    if (status == Status::cancelled) return status;
    double deepest = 0;
    for (const Slot* slot : flexibility.slot) deepest = std::max(deepest, slot->contact.overlap().overlap);
    DepthStep step = step_of_depths(flexibility);
    if (step.solved && step.largest <= tolerance * std::max(depth, deepest)) {
      z_ = in_.by_force ? z_ + step.down : z;
      return half_spaces == Status::coarse || half_spaces == Status::inaccurate ? status : worse(half_spaces, status);
    }
    for (int k = 0; k < most && step.solved; ++k) {
      const double sunk = take(step, flexibility);
      if (!in_.by_force) seek_strips();
      half_spaces = in_.by_force ? find_height_of_half_spaces() : solve_at(sunk);
      if (pressed() != flexibility.slot) break;
      step = step_of_depths(flexibility);
      if (step.largest <= within * tolerance * std::max(depth, deepest)) break;
    }
  }
  context_->caveat(Status::not_converged, "z is %.10g: no heights of half-spaces were found that fit the sections", z_);
  return Status::not_converged;
}

}  // namespace rollcon
