/// Copies the start of a contact's next time step out as numbers, and restores it on this or another contact.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "contact/contact.hpp"
#include "contact/solver.hpp"
#include "mesh/lattice_values.hpp"
#include "support/checksum.hpp"
#include "support/error.hpp"
#include "support/index.hpp"
#include "support/input_checks.hpp"

namespace rollcon {
namespace {

// The numbers are magic, version, count of all, nodes, checksum of frame and bodies, loaded, time, steps, four motions;
// sides and cells of a lattice that the library made, or zeros; tractions t1, t2, n of all nodes, checksum of all
// before it.
constexpr double magic = 7274830.5, version = 3;
constexpr std::size_t of_lattice = 12, header = of_lattice + 6;

// Returns a checksum that is exact in a double.
double checksum_of(const double* v, std::size_t n, std::uint64_t seed = 0) {
  Checksum sum(seed);
  sum.add(v, n * sizeof(double));
  return static_cast<double>(sum.value() >> 12);
}

double mark_of(const Frame& frame, const PairOfBodies& pair) {
  Checksum sum;
  for (const Body* body : pair.body) {
    const double own[] = {static_cast<double>(body->kind()), body->rigid() ? 0 : body->young(),
                          body->rigid() ? 0 : body->poisson(), static_cast<double>(body->size().first), pair.layer};
    sum.add(own, sizeof own);
  }
  sum.add(frame.x.data(), frame.x.size() * sizeof(double));
  sum.add(frame.y.data(), frame.y.size() * sizeof(double));
  return static_cast<double>(sum.value() >> 12);
}

std::size_t numbers_for(std::size_t nodes) {
  return header + 3 * nodes + 1;
}

// Writes the lattice of a step that the library made. err_state: it made another frame.
void write_lattice(const Frame& frame, double* to) {
  const std::optional<Lattice> l = find_lattice(frame);
  if (!l || !lies_along_axes(*l))
    fail(Status::err_state,
         "the library makes the frame of this contact anew for every step, because a body has a mesh, tilts are found, "
         "or the contact is conformal or ends sharply: what was before a time step is saved on a frame that stays; "
         "call rollcon_contact_frame_ellipse, rollcon_contact_frame_nodes, ...");
  const double cells[] = {static_cast<double>(l->nx - 1), static_cast<double>(l->ny - 1)};
  const double all[] = {l->x0, l->x0 + cells[0] * l->dx, l->y0, l->y0 + cells[1] * l->dy, cells[0], cells[1]};
  std::copy(std::begin(all), std::end(all), to);
}

}  // namespace

std::int64_t Contact::past_get(std::int64_t capacity, double* to) const {
  const Solution& s = solver->solution();
  const PastStep& last = solver->steps().last;
  if (!s.prepared || !solver->steps().of_steps || !last.on)
    fail(Status::err_state, "no time step was solved yet: rollcon_contact_set_step and rollcon_contact_solve");
  const std::size_t n = last.lambda[0].size(), needed = numbers_for(n);
  if (capacity == 0 && !to) return static_cast<std::int64_t>(needed);
  if (capacity < static_cast<std::int64_t>(needed))
    fail(Status::err_capacity, "capacity is %lld but %lld doubles are needed", static_cast<long long>(capacity),
         static_cast<long long>(needed));
  double head[header] = {magic,
                         version,
                         static_cast<double>(needed),
                         static_cast<double>(n),
                         mark_of(scene.frame_given() ? last.on->frame : Frame{}, s.prepared->pair),
                         last.loaded ? 1.0 : 0.0,
                         last.time,
                         static_cast<double>(last.steps),
                         last.motion[0],
                         last.motion[1],
                         last.motion[2],
                         last.motion[3]};
  if (!scene.frame_given()) write_lattice(last.on->frame, head + of_lattice);
  std::copy_n(head, header, to);
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t k = 0; k < n; ++k) to[header + c * n + k] = last.loaded ? last.lambda[c][k] : 0;
  to[needed - 1] = checksum_of(to, needed - 1);
  return static_cast<std::int64_t>(needed);
}

void Contact::past_set(std::int64_t count, const double* from) {
  require_count(count, "n");
  require_pointer(from, "past");
  require_finite(count, 1, from, "past", 0);
  const auto given = static_cast<std::size_t>(count);
  if (given < numbers_for(0) || from[0] != magic)
    fail(Status::err_argument, "past does not begin as what rollcon_contact_past_get gives");
  if (from[1] != version)
    fail(Status::err_argument, "past is of version %g; this library reads version %g", from[1], version);
  if (from[2] != static_cast<double>(given))
    fail(Status::err_argument, "n is %lld, but past says it has %.0f numbers", static_cast<long long>(count), from[2]);
  if (checksum_of(from, given - 1) != from[given - 1])
    fail(Status::err_argument, "past has changed since it was saved: its checksum does not fit");
  const double* const lattice = from + of_lattice;
  const bool made = lattice[4] > 0;
  if (made == scene.frame_given())
    fail(Status::err_argument, "past is of a frame that %s, and this contact's frame is %s",
         made ? "the library made" : "was given", made ? "given" : "left to the library");
  if (made) {
    if (!frames_) frames_ = make_frames_();
    frames_->lay(*solver, {lattice[0], lattice[1], lattice[2], lattice[3]}, to_index(lattice[4]), to_index(lattice[5]));
  }
  solver->forget();
  solver->prepare();
  const Solution& s = solver->solution();
  StepHistory& steps = solver->steps();
  const Frame& frame = s.prepared->frame;
  const std::size_t n = frame.x.size();
  if (from[3] != static_cast<double>(n) || from[4] != mark_of(made ? Frame{} : frame, s.prepared->pair))
    fail(Status::err_argument,
         "past is of another frame (%.0f nodes; this one has %zu), or of bodies of other kinds, elastic constants or "
         "layers",
         from[3], n);
  PastStep& last = steps.last;
  last.loaded = from[5] != 0;
  last.time = from[6];
  last.steps = to_index(from[7]);
  std::copy_n(from + 8, 4, last.motion.begin());
  for (std::size_t c = 0; c < 3; ++c) last.lambda[c].assign(from + header + c * n, from + header + (c + 1) * n);
  last.mesh = scene.revision.mesh;
  if (!last.on || last.on->frame.x != frame.x || last.on->frame.y != frame.y) {
    last.on = std::make_shared<FrameOfPast>();
    last.on->frame = frame;
  }
  steps.of_steps = true;
  steps.failed = steps.can_repeat = steps.iterate_is_last = false;
}

}  // namespace rollcon
