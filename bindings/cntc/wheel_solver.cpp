#include "wheel_solver.hpp"

#include <algorithm>
#include <cmath>

#include "calculate.hpp"
#include "sections.hpp"
#include "vectors.hpp"

namespace cntc {

Vec3 WheelPatch::across() const {
  return {0, std::cos(delta), std::sin(delta)};
}
Vec3 WheelPatch::along() const {
  return cross(across(), normal());
}
Vec3 WheelPatch::normal() const {
  return std::cos(tilt) * Vec3{0, -std::sin(delta), std::cos(delta)} + Vec3{std::sin(tilt), 0, 0};
}

/// Makes profiles and the wheel on its rail anew where something of them has changed.
void WheelSolver::prepare(const Problem& p) {
  const Inputs& in = p.in;
  const int threads = in.digits.openmp < 0 ? 0 : std::max(1, in.digits.openmp);
  const double roller = in.digits.roller() ? in.track.nomrad : 0;
  if (in.digits.roller() && !(roller > 0))
    throw Failure(CNTC_err_search, "the roller's radius NOMRAD is " + std::to_string(roller) + "; allowed: above 0");
  const Made made{in.rail.number, in.wheel.number,    threads,           in.material.g,
                  in.material.nu, in.wheelset.nomrad, in.wheelset.ytape, roller};
  if (search_ && made == made_) return;
  search_.reset();
  dimensions_.clear();
  patches.clear();
  create(context_, rollcon_context_create, ROLLCON_ABI);
  rollcon_context* context = context_.get();
  check(rollcon_context_set_threads(context, threads));
  rail_profile.make(context, in.rail, in.material);
  wheel_profile.make(context, in.wheel, in.material);
  create(search_, rollcon_wheelrail_create, context, wheel_profile.body(), rail_profile.body(), ROLLCON_RIGHT);
  rollcon_wheelrail* search = search_.get();
  const double zero[3] = {0, 0, 0}, x[3] = {1, 0, 0}, y[3] = {0, 1, 0}, z[3] = {0, 0, 1};
  check(rollcon_wheelrail_set_int(search, "roll_outside", 1));
  check(rollcon_wheelrail_set_int(search, "roll_about_origin", 1));
  check(rollcon_body_extrude_profile(rail_profile.body(), zero, x, z));
  roller_ = roller;
  depth_ = 0;
  if (roller > 0) roller_profile_.make(context, in.rail, in.material, true);
  const double tape = in.wheelset.ytape, depth = tape < 999 ? Section(wheel_profile).z_at(tape, no_point) : 0;
  if (depth == no_point)
    throw Failure(CNTC_err_profil, "the wheel's profile does not reach y = " + std::to_string(tape));
  radius_ = in.wheelset.nomrad - depth;
  check(rollcon_body_revolve_profile(wheel_profile.body(), zero, y, radius_));
  made_ = made;
}

void WheelSolver::mirror_inputs(const Inputs& in) {
  sign = in.digits.left() ? -1 : 1;
  track_ = in.track;
  set_ = in.wheelset;
  x = roller_ > 0 ? set_.position[0] : 0;
  roller_rate_ = 0;
  onward_ = set_.velocity[0];
  if (roller_ > 0) {
    roller_rate_ = set_.velocity[0];
    onward_ = roller_rate_ * roller_;
    set_.velocity[0] = track_.curv = 0;
  }
  for (double* v :
       {&track_.deviation[0], &track_.deviation[2], &track_.rate[0], &track_.rate[2], &track_.curv, &track_.fy})
    *v *= sign;
  for (const size_t k : {1u, 3u, 4u}) {
    set_.position[k] *= sign;
    set_.velocity[k] *= sign;
    set_.flexibility[k] *= sign;
    set_.flexibility[6 + k] *= sign;
  }
}

/// Places wheelset and wheel: roll about x, then yaw about the new z; the bent wheel stands in the wheelset's axes.
void WheelSolver::place_wheel(double height) {
  z = height;
  const auto& q = set_.position;
  const auto& f = set_.flexibility;
  wheelset.origin = {0, q[1], height - set_.nomrad};
  wheelset.rotation = about_x(q[3]) * about_z(q[4]);
  const Vec3 in_set = {f[0], set_.fbdist / 2 - set_.fbpos + f[1], radius_ + f[2]};
  wheel.origin = wheelset.origin + wheelset.rotation * in_set;
  wheel.rotation = wheelset.rotation * (about_x(f[3]) * about_z(f[4]));
}

int WheelSolver::solve_search() {
  const int status = rollcon_wheelrail_solve(search_.get());
  if (status == ROLLCON_ERR_LOAD) throw Failure(CNTC_err_ftot, rollcon_last_error());
  if (status == ROLLCON_ERR_ARGUMENT) throw Failure(CNTC_err_search, rollcon_last_error());
  return check(status);
}

/// Finds height and patches.
int WheelSolver::search(const Problem& p) {
  const Inputs& in = p.in;
  rollcon_wheelrail* search = search_.get();
  auto velocity = set_.velocity;
  double rate = roller_rate_;
  if (in.digits.tang == 1) {  // shifts are no velocities
    velocity = {roller_ > 0 ? 0. : 1000, 0, 0, 0, 0, -1000 / radius_};
    rate = 1000 / std::max(roller_, 1.);
  }
  if (velocity[0] == 0 && !(roller_ > 0 && rate != 0))
    throw Failure(CNTC_err_search, roller_ > 0 ? "the roller's rate RPITCH is 0: a wheel must roll"
                                               : "the forward speed VS is 0: a wheel must roll");
  if (roller_ > 0) check(rollcon_wheelrail_set_roller(search, roller_, rate));
  if (rail_profile.varies() && track_.gaught > 0)
    throw Failure(CNTC_err_profil,
                  "a variable rail has no gauge: place it by its origin (GAUGHT <= 0, RAILY0, RAILZ0)");
  // The search starts from its last solution as long as its dimensions stay.
  const std::vector<double> dimensions{track_.gaught, track_.gaugwd, track_.raily0, track_.railz0, track_.cant,
                                       set_.fbdist,   set_.fbpos,    set_.nomrad,   set_.ytape};
  if (dimensions != dimensions_) {
    dimensions_.clear();
    check(track_.gaught > 0 ? rollcon_wheelrail_set_track(search, track_.gaugwd, track_.gaught, track_.cant)
                            : rollcon_wheelrail_place_rail(search, track_.raily0, track_.railz0, track_.cant));
    check(rollcon_wheelrail_set_wheelset(search, set_.fbdist, set_.fbpos, set_.nomrad));
    if (set_.ytape < 999) check(rollcon_wheelrail_set_tape_circle(search, set_.ytape));
    dimensions_ = dimensions;
  }
  check(rollcon_wheelrail_set_position(search, set_.position.data()));
  check(rollcon_wheelrail_set_velocity(search, velocity.data()));
  check(rollcon_wheelrail_set_flexibility(search, set_.flexibility.data(), set_.flexibility.data() + 6));
  check(rollcon_wheelrail_set_real(search, "curvature", track_.curv));
  check(rollcon_wheelrail_set_rail_deviation(search, track_.deviation.data(), track_.rate.data()));
  const auto rest = [&](const FrictionRow& row) {
    return std::clamp(in.digits.tang == 0 ? 0 : rest_friction(row, in.friction.law), 0., 10.);
  };
  const double mu = rest(in.friction.rows[0]);
  if (in.friction.variation == 1) {
    std::vector<double> table;
    for (const FrictionRow& row : in.friction.rows) table.insert(table.end(), {row.place, rest(row)});
    check(rollcon_wheelrail_set_friction(search, "by_angle", int32_t(table.size()), table.data()));
  } else {
    check(rollcon_wheelrail_set_friction(search, "coulomb", 1, &mu));
  }
  const bool force = in.digits.norm == 1, pull = in.digits.force == 1;
  check(rollcon_wheelrail_prescribe_vertical(search, force ? ROLLCON_BY_FORCE : ROLLCON_BY_MOTION, force ? in.fz : 0));
  check(rollcon_wheelrail_prescribe_longitudinal(search, pull ? ROLLCON_BY_FORCE : ROLLCON_BY_MOTION, -in.fx));
  const bool springs = in.digits.force == 3;
  const double stiffness[2] = {springs ? track_.ky : 0, springs ? track_.kz : 0}, load[2] = {track_.fy, track_.fz};
  check(rollcon_wheelrail_set_rail_springs(search, stiffness, load));
  const int status = solve_search();
  if (status == ROLLCON_DERAILED) throw Failure(CNTC_err_search, "the wheel is beside its rail");
  const auto stat = [&](const char* name) {
    double v = 0;
    check(rollcon_wheelrail_get_stat(search, name, &v));
    return v;
  };
  deflection = {stat("rail_deflection_y"), stat("rail_deflection_z")};
  place_rail();
  const double depth = roller_ - (track_.gaught > 0 ? rail.origin[2] - track_.deviation[1] - deflection[1] : 0);
  if (roller_ > 0 && depth != depth_) {
    const double zero[3] = {0, 0, 0}, y[3] = {0, 1, 0};
    check(rollcon_body_revolve_profile(roller_profile_.body(), zero, y, depth));
    depth_ = depth;
  }
  if (pull) pitch_rate = stat("pitch_rate");
  set_.velocity[5] = pitch_rate;
  place_wheel(stat("z"));
  return status;
}

/// Takes the rail's pose from two points of its profile, unless its origin is given.
void WheelSolver::place_rail() {
  if (track_.gaught <= 0) {
    rail.rotation = about_x(track_.deviation[2] - track_.cant);
    rail.origin = {0, track_.raily0 + track_.deviation[0] + deflection[0],
                   track_.railz0 + track_.deviation[1] + deflection[1]};
    return;
  }
  double p[2][2], q[2][2], slope = 0;
  const double shares[2] = {.25, .75};
  for (int k = 0; k < 2; ++k) {
    rail_profile.at(shares[k] * rail_profile.length(), p[k][0], p[k][1], slope);
    check(rollcon_wheelrail_get_profile_point(search_.get(), ROLLCON_RAIL, shares[k], q[k]));
  }
  const double angle =
      std::atan2(q[1][1] - q[0][1], q[1][0] - q[0][0]) - std::atan2(p[1][1] - p[0][1], p[1][0] - p[0][0]);
  rail.rotation = about_x(angle);
  rail.origin = Vec3{0, q[0][0], q[0][1]} - rail.rotation * Vec3{0, p[0][0], p[0][1]};
}

/// Finds the ends of a contact from its nodes, along the axes of the patch.
void WheelSolver::read_extents(WheelPatch& patch) const {
  double origin[3], axes[9];
  rollcon_contact* contact = nullptr;
  check(rollcon_wheelrail_get_patch_axes(search_.get(), patch.number, origin, axes));
  origin[0] -= set_.position[0];  // axes of the track go along with the wheelset
  check(rollcon_wheelrail_get_contact(search_.get(), patch.number, &contact));
  const ContactHandle holder(contact);
  int64_t nodes = 0;
  check(rollcon_contact_get_size(contact, &nodes, nullptr));
  std::vector<double> points(3 * size_t(nodes));
  std::vector<int32_t> states(static_cast<size_t>(nodes));
  check(rollcon_contact_get_field(contact, ROLLCON_FIELD_POINT, ROLLCON_GLOBAL, 3 * nodes, points.data(), nullptr));
  check(rollcon_contact_get_node_states(contact, nodes, states.data()));
  patch.x = patch.s = {};
  for (size_t i = 0; i < size_t(nodes); ++i) {
    if (states[i] == ROLLCON_OPEN) continue;
    Vec3 at{};
    for (size_t d = 0; d < 3; ++d)
      at[d] = origin[d] + points[3 * i] * axes[d] + points[3 * i + 1] * axes[3 + d] + points[3 * i + 2] * axes[6 + d];
    const Vec3 from = at - patch.reference;
    patch.x.take(from[0]);
    patch.s.take(dot(from, patch.across()));
  }
}

double WheelSolver::patch_stat(int32_t k, const char* name) const {
  double v = 0;
  check(rollcon_wheelrail_get_patch_stat(search_.get(), k, name, &v));
  return v;
}

/// Returns all patches that the search has found and that carry a load, in its order.
std::vector<WheelPatch> WheelSolver::found_patches() const {
  int64_t n = 0;
  check(rollcon_wheelrail_get_patch_count(search_.get(), &n));
  std::vector<WheelPatch> found;
  for (int32_t k = 0; k < n; ++k) {
    if (!(patch_stat(k, "share") * patch_stat(k, "normal_force") != 0)) continue;
    WheelPatch patch;
    patch.reference = {patch_stat(k, "x") - set_.position[0], patch_stat(k, "y"), patch_stat(k, "z")};
    patch.delta = patch_stat(k, "angle");
    patch.overlap = patch_stat(k, "overlap");
    patch.number = k;
    double origin[3], axes[9];
    check(rollcon_wheelrail_get_patch_axes(search_.get(), k, origin, axes));
    if (roller_ > 0) patch.tilt = std::asin(axes[6]);
    found.push_back(patch);
  }
  return found;
}

namespace {

/// Joins two patches: the reference is the mean, weighted with the depth of the overlaps.
WheelPatch joined(const WheelPatch& a, const WheelPatch& b) {
  const auto weight = [](const WheelPatch& p) { return std::pow(std::max(p.overlap, 1e-12), 2.5) * p.s.length(); };
  const double wa = weight(a) / (weight(a) + weight(b));
  WheelPatch c;
  c.reference = wa * a.reference + (1 - wa) * b.reference;
  c.delta = wa * a.delta + (1 - wa) * b.delta;
  c.overlap = std::max(a.overlap, b.overlap);
  for (const WheelPatch* p : {&a, &b}) {
    for (const double x : {p->x.low, p->x.high}) c.x.take(x + p->reference[0] - c.reference[0]);
    for (const double s : {p->s.low, p->s.high})
      c.s.take(dot(p->reference + s * p->across() - c.reference, c.across()));
  }
  return c;
}

/// Distance between the ends of the overlaps of two patches along the surface.
double distance(const WheelPatch& a, const WheelPatch& b) {
  const Vec3 end = a.reference + (a.s.high + overlap_beyond * a.s.length()) * a.across(),
             begin = b.reference + (b.s.low - overlap_beyond * b.s.length()) * b.across();
  return b.reference[1] > a.reference[1] ? norm(begin - end) : 0;
}

}  // namespace

/// Makes one patch of those that are nearer than D_SEP and not turned by more than A_SEP against each other. Contacts
/// of the last solve are used again.
void WheelSolver::join_patches(const PlaneGrid& grid) {
  std::vector<WheelPatch> found;
  for (WheelPatch& patch : found_patches()) {
    if (patch_stat(patch.number, "share") < .5) continue;
    read_extents(patch);
    if (patch.x.low < patch.x.high) found.push_back(patch);
  }
  std::sort(found.begin(), found.end(),
            [](const WheelPatch& a, const WheelPatch& b) { return a.reference[1] < b.reference[1]; });
  for (size_t k = 0; k + 1 < found.size();) {
    const WheelPatch &a = found[k], &b = found[k + 1];
    const bool join = distance(a, b) < grid.d_sep && std::abs(a.delta - b.delta) < grid.a_sep;
    if (!join) {
      ++k;
      continue;
    }
    WheelPatch c = joined(a, b);
    if (!rail_profile.varies()) {  // the reference lies on the rail
      const Section section(rail_profile);
      const auto in_track = [&](const Vec3& place) { return rail.origin + rail.rotation * place; };
      const auto off = [&](const Vec3& place) { return std::abs(in_track(place)[1] - c.reference[1]); };
      c.reference[2] = in_track(section.at(section.least(4000, off)).place)[2];
    }
    found[k] = c;
    found.erase(found.begin() + long(k) + 1);
  }
  for (size_t k = 0; k < std::min(found.size(), patches.size()); ++k) {
    found[k].solver = patches[k].solver;
    found[k].wanted.grid = patches[k].wanted.grid;
  }
  patches = std::move(found);
}

rollcon_contact* wheel_contact(Problem& p, int patch) {
  if (!p.wheel || patch < 1 || size_t(patch) > p.wheel->patches.size()) return nullptr;
  const auto& solver = p.wheel->patches[size_t(patch - 1)].solver;
  return solver ? solver->handle() : nullptr;
}

}  // namespace cntc
