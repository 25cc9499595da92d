// Wheels on frames that rollcon makes (flag CNTC_if_frames): totals at once, fields of elements when they are asked
// for.
#include "calculate.hpp"
#include "log.hpp"
#include "vectors.hpp"
#include "wheel_solver.hpp"

namespace cntc {

int WheelSolver::solve_on_frames(Problem& p, std::string& why) {
  const Inputs& in = p.in;
  if (in.friction.law != 0 || in.friction.variation == 2 || in.digits.tang == 2 || in.digits.mater != 0 ||
      in.digits.heat != 0 || in.digits.sens >= 2)
    throw Failure(CNTC_err_other,
                  "frames of rollcon (flag 2901) are for Coulomb friction in steady rolling, without layer, heat and "
                  "sensitivities: set it to 0");
  rollcon_wheelrail* search = search_.get();
  check(rollcon_wheelrail_set_real(search, "accuracy", .01));
  check(rollcon_wheelrail_set_int(search, "conformal", in.digits.discns == 4));
  const int status = this->search(p);
  framed_ = in;
  if (status > ROLLCON_OK) why = rollcon_last_caveat();
  patches = found_patches();
  for (WheelPatch& patch : patches) {
    const auto stat = [&](const char* name) { return patch_stat(patch.number, name); };
    const double share = stat("share");
    stand_patch(patch);
    set_velocities(in, patch);
    set_creepages(patch);
    ContactResult r;
    r.solved = r.deferred = true;
    r.veloc = patch.wanted.veloc;
    r.fstat = in.digits.tang == 0 ? 0 : rest_friction(in.friction.rows[0], 0);
    r.dq = in.plane.dx;
    r.pen = patch.overlap;
    r.cksi = -stat("longitudinal_creepage");
    r.ceta = -stat("lateral_creepage");
    r.cphi = -stat("spin");
    r.fn = share * stat("normal_force");
    r.tx = -share * stat("longitudinal_force");
    r.ty = -share * stat("lateral_force");
    r.mz = -share * stat("spin_moment");
    r.pmax = stat("max_pressure");
    r.power = share * stat("friction_power");
    if (sign < 0)
      for (double* v : {&r.ty, &r.mz, &r.ceta, &r.cphi}) *v = -*v;
    p.patches.push_back(std::move(r));
  }
  solved = true;
  return status == ROLLCON_NOT_CONVERGED ? CNTC_err_tang : 0;
}

/// Solves the patch on the caller's grid, under the normal force that the frames have found.
void WheelSolver::fill_elements(Problem& p, size_t patch_number) {
  WheelPatch& patch = patches[patch_number];
  ContactResult& r = p.patches[patch_number];
  read_extents(patch);
  ready_patch(framed_, patch);
  ContactCase& w = patch.wanted;
  w.placement = &patch.placement;
  patch.placement.by_velocity = w.moved = w.normal_by_force = true;
  w.fn = r.fn;
  std::string why;
  solve_patch(framed_, patch, why);
  if (!why.empty())
    log_line("elements", p.ire, int(patch_number) + 1, "the patch on the caller's grid: %s", why.c_str());
  ContactResult elements;
  read_patch(framed_, patch, elements);
  // What the frames have found stays.
  r.chi = elements.chi;
  r.dq = elements.dq;
  r.fstat = elements.fstat;
  r.deferred = false;
  r.wx.swap(elements.wx);
  r.wy.swap(elements.wy);
  static_cast<Totals&>(elements) = r;
  r = std::move(elements);
}

}  // namespace cntc
