/// Makes the discrete problem from the scene, redoing only what a change made stale.

#include <algorithm>
#include <cmath>
#include <string>

#include "contact/prepare/lattice_scene.hpp"
#include "contact/prepare/preparation.hpp"
#include "contact/prepare/rigid_slip.hpp"
#include "contact/prepare/time_step.hpp"
#include "contact/scene/conformal.hpp"
#include "contact/scene/geometry.hpp"
#include "mesh/strip_mesh.hpp"
#include "support/clock.hpp"
#include "support/error.hpp"
#include "support/index.hpp"
#include "support/memory_limit.hpp"

namespace rollcon {
namespace {

using Poses = Preparation::Poses;

// Returns the revisions of the poses of meshed bodies; other bodies' do not matter here.
Poses poses_of_meshes(const Scene& scene, const PairOfBodies& pair) {
  Poses poses = poses_of_surfaces(scene, pair);
  for (std::size_t b = 0; b < 2; ++b)
    if (!pair.body[b]->meshed()) poses[b] = -1;
  return poses;
}

// Returns what changes where a body ends over a frame, as far as gaps tell.
Poses where_gap_ends(const Scene& scene, const PairOfBodies& pair) {
  return scene.has_gap() ? Poses{scene.revision.gap, -1} : poses_of_surfaces(scene, pair);
}

// Returns poses that the frame depends on: not that of a rigid body that neither carries it nor gives its normals.
Poses poses_of_frame(const Scene& scene, const PairOfBodies& pair) {
  if (is_conformal(scene, pair)) return poses_of_surfaces(scene, pair);
  Poses poses = poses_of_meshes(scene, pair);
  for (int b = 0; b < 2; ++b) {
    const auto k = static_cast<std::size_t>(b);
    const bool own = b == normal_source(pair) || b == scene.frame_source().body;
    if (pair.body[k]->rigid() && !own) poses[k] = -1;
  }
  return poses;
}

// Tells where the frame comes from now: the body may have got another mesh between the call that took the frame from it
// and its preparation, and the frame then belongs to no body.
FrameSource present_source(const Scene& scene, const PairOfBodies& pair) {
  const FrameSource& source = scene.frame_source();
  if (source.body < 0) return {};
  const SurfaceMesh& mesh = pair.body[static_cast<std::size_t>(source.body)]->mesh().surface;
  for (std::size_t k = 0; k < source.node.size(); ++k) {
    if (source.node[k] >= mesh.nodes() || mesh.node[static_cast<std::size_t>(source.node[k])] != source.place[k])
      return {};
  }
  if (source.element.back() >= mesh.elements()) return {};
  std::vector<std::uint8_t> known(static_cast<std::size_t>(mesh.nodes()), 0);
  for (const std::int32_t k : source.node) known[static_cast<std::size_t>(k)] = 1;
  // A frame of corners is compared with the corners of the faces.
  for (std::size_t i = 0; i < source.element.size(); ++i) {
    const auto own = scene.mesh().element(static_cast<std::int64_t>(i));
    const auto face = mesh.element(source.element[i]);
    if (face.size() < own.size()) return {};
    for (const std::int32_t k : face.first(own.size()))
      if (!known[static_cast<std::size_t>(k)]) return {};
  }
  return source;
}

// Refuses frames of which memory does not hold one block of the operators, before anybody waits for their checks. Grids
// may do without the block; what every solve on them was seen to take is 700 bytes a node.
void refuse_too_many_nodes(const Preparation& preparation, const Scene& scene) {
  const SurfaceMesh& mesh = scene.mesh();
  constexpr std::int64_t few = 10'000;
  constexpr double least_bytes_a_node = 650;
  const double least = least_bytes_a_node * static_cast<double>(mesh.nodes());
  if (mesh.nodes() > few && may_be_lattice(mesh))
    return require_memory({least, least}, "take a coarser or smaller frame",
                          "a solve on a frame of %lld nodes needs at least", static_cast<long long>(mesh.nodes()));
  const bool hierarchy = preparation.made->pair.half_spaces() && scene.step_kind() == StepKind::steady &&
                         (scene.options.operators == "auto" || scene.options.operators == "hierarchical");
  if (mesh.nodes() <= few || preparation.procedure.monolithic || hierarchy) return;
  DenseOperators op;
  op.nodes = mesh.nodes();
  op.require_memory_for({{false, false, false}, {false, false, false}, {false, false, true}});
}

bool follows_its_place(const Scene& scene, const PairOfBodies& pair) {
  return !pair.meshed() && !is_conformal(scene, pair);
}

// Puts what depends on strips where these are.
void put_strips(Preparation& preparation, const Scene& scene) {
  Prepared& on = *preparation.made;
  *on.frame.strips = *scene.strips();
  std::copy(scene.mesh().node.begin(), scene.mesh().node.end(), on.frame.mesh.node.begin());
  strips::put_frame(on.frame);
  take_strips(on.problem, on.frame);
  if (!on.compliance) return;
  for (auto& own : preparation.body_compliance) own.reset();
  if (!on.compliance->follow_frame()) return preparation.compliance.forget();
  if (on.scheme == Scheme::characteristic)
    convect_on_strips(on.frame, on.problem.convection);
  else
    preparation.convection.forget();
  if (preparation.dense) preparation.dense->normal = preparation.dense->tangential = false;
}

void put_in_place(Preparation& preparation, const Scene& scene) {
  Prepared& on = *preparation.made;
  if (scene.strips()) return put_strips(preparation, scene);
  on.place = scene.place();
  preparation.unit.put_frame(on.place, scene.mesh().node, on.frame);
  preparation.unit.put_problem(on.place, on.problem);
  if (!on.compliance) return;
  for (auto& own : preparation.body_compliance) own.reset();
  preparation.changes.system = true;
  if (!on.compliance->follow_frame()) return preparation.compliance.forget();
  if (on.scheme == Scheme::characteristic)
    preparation.unit.put_convection(on.place, on.frame, on.problem.convection);
  else if (on.scheme != Scheme::time_step)
    preparation.convection.forget();
  // The blocks stay, to be filled again.
  if (preparation.dense) preparation.dense->normal = preparation.dense->tangential = false;
}

// Takes the frame before it was placed, which depends no more on where the first one lay than what is made from it.
void take_unit_frame(Preparation& preparation, const Scene& scene) {
  Prepared& on = *preparation.made;
  Frame unit = build_frame(scene.mesh_at({}), scene.axes());
  unit.used = on.frame.used;
  Problem of_unit;
  take_frame(of_unit, unit);
  preparation.unit.take_frame(unit, of_unit);
  preparation.unit.put_frame(on.place, scene.mesh().node, on.frame);
  preparation.unit.put_problem(on.place, on.problem);
}

void build_frame_part(Preparation& preparation, const Scene& scene) {
  Prepared& on = *preparation.made;
  const bool conformal = is_conformal(scene, on.pair);
  const auto placed = follows_its_place(scene, on.pair) ? 0 : scene.revision.place;
  // Nodes at which a body ends carry tractions, unless the frame follows the contact.
  const bool known = is_gap_known(scene, on.pair);
  const Poses ends =
      scene.ends_at_edge() && !scene.frame_moves() && known ? where_gap_ends(scene, on.pair) : Poses{-1, -1};
  if (preparation.frame.enter(scene.revision.mesh, placed, scene.revision.axes, poses_of_frame(scene, on.pair), ends,
                              conformal)) {
    refuse_too_many_nodes(preparation, scene);
    ++preparation.builds.frames;
    Frame frame = build_frame(scene.mesh(), scene.axes());
    on.frame_source = present_source(scene, on.pair);
    on.ends_at_edge = scene.ends_at_edge();
    if (on.ends_at_edge) {
      find_rim(frame, on.pair, scene.frame_moves() ? nullptr : known_gap(scene, on.pair).get());
      for (std::size_t k = 0; k < frame.used.size(); ++k) frame.used[k] &= frame.rim[k] == 0;
    }
    if (normal_source(on.pair) >= 0) curve_frame(frame, surface_normals(frame, on.frame_source, on.pair));
    if (conformal) follow_section(frame, on.pair);
    const bool same_size = preparation.mesh == scene.revision.mesh
                               ? frame.nodes() == on.frame.nodes()
                               : scene.ends_at_edge() && frame.mesh.connectivity == on.frame.mesh.connectivity;
    preparation.mesh = scene.revision.mesh;
    if (scene.strips()) frame.strips = std::make_shared<strips::StripFrame>(*scene.strips());
    on.frame = std::move(frame);
    on.place = scene.place();
    take_frame(on.problem, on.frame);
    if (on.frame.strips) put_strips(preparation, scene);
    preparation.place.enter(preparation.frame.version(), scene.revision.place);
    on.placed = scene.placed();
    if (on.placed && !on.frame.curved()) take_unit_frame(preparation, scene);
    preparation.changes.nodes = preparation.changes.nodes || !same_size;
  }
  if (preparation.place.enter(preparation.frame.version(), scene.revision.place)) put_in_place(preparation, scene);
  const bool moved = preparation.rim.enter(preparation.frame.version(), poses_of_meshes(scene, on.pair),
                                           known ? where_gap_ends(scene, on.pair) : Poses{-1, -1});
  if (moved && !on.ends_at_edge) find_rim(on.frame, on.pair, known_gap(scene, on.pair).get());
}

void build_compliance(Preparation& preparation, const Scene& scene, int threads) {
  Prepared& on = *preparation.made;
  preparation.threads = threads;
  if (!preparation.compliance.enter(preparation.frame.version(), scene.options.accuracy, scene.layer(), on.pair.speed))
    return on.compliance->set_threads(threads);
  const Stopwatch watch(preparation.timings.compliance);
  ++preparation.builds.compliances;
  on.accuracy = scene.options.accuracy;
  on.compliance.reset();
  on.compliance = make_pair_compliance(on.frame, on.pair, on.accuracy, threads);
  on.meshes = {};
  on.compliance->find_meshes(on.meshes);
  for (auto& own : preparation.body_compliance) own.reset();
  on.problem.stiffness = contact_modulus(on.pair);
  forget_operators(preparation);
  preparation.changes.system = true;
}

void build_stencils(Preparation& preparation, const Scene& scene) {
  Prepared& on = *preparation.made;
  const bool steady = scene.step_kind() == StepKind::steady;
  const Scheme& scheme = steady ? scheme_of(scene.options.convection) : Scheme::time_step;
  if (!preparation.convection.enter(preparation.compliance.version(), scheme)) return;
  const Stopwatch watch(preparation.timings.convection);
  if (preparation.dense)
    preparation.dense->release_slip();
  else
    forget_operators(preparation);
  if (scheme == Scheme::characteristic && on.frame.strips) {
    on.problem.convection = {};
    convect_on_strips(on.frame, on.problem.convection);
  } else {
    on.problem.convection = make_convection(on.frame, scheme, on.ends_at_edge);
  }
  if (scheme == Scheme::characteristic && on.placed && !on.frame.curved()) {
    Frame unit = on.frame;
    preparation.unit.put_frame({}, scene.mesh_at({}).node, unit);
    on.problem.convection = make_convection(unit, scheme, on.ends_at_edge);
    preparation.unit.take_convection(unit, on.problem.convection);
    preparation.unit.put_convection(on.place, on.frame, on.problem.convection);
  }
  ++preparation.builds.stencils;
  on.scheme = scheme;
  preparation.field_rows = {};
  preparation.changes.system = true;
}

void build_operators(Preparation& preparation, const Scene& scene) {
  build_lattice_operators(preparation, scene.options);
  if (!preparation.procedure.monolithic) assemble_missing(preparation);
  choose_scales(preparation);
}

// Reads the coefficients, which are 0 on the inflow rim.
void read_friction(Preparation& preparation, const Scene& scene) {
  if (!preparation.friction.enter(preparation.convection.version(), scene.revision.friction,
                                  scene.friction_varies_across() ? preparation.place.version() : -1))
    return;
  ++preparation.builds.frictions;
  Problem& p = preparation.made->problem;
  p.own_law = scene.law();
  p.law = p.own_law ? p.own_law.get() : &coulomb();
  p.mu.resize(at(p.nodes));
  bool frictionless = true;
  for (std::size_t k = 0; k < p.mu.size(); ++k) {
    p.mu[k] = scene.friction(static_cast<std::int64_t>(k), preparation.made->frame.y[k]);
    if (p.mu[k] < least_friction) p.mu[k] = 0;
    frictionless = frictionless && !(p.mu[k] > 0);
  }
  preparation.made->frictionless = frictionless;
  const SparseRows& d = p.convection.rows;
  for (std::size_t i = 0; i < p.mu.size(); ++i)
    if (preparation.made->frame.used[i] && d.start[i] == d.start[i + 1]) p.mu[i] = 0;
}

// Binds the law to the rolling speed, by which its own speeds are divided.
void bind_law(Preparation& preparation, const Scene& scene) {
  if (!scene.law()) return;
  Prepared& on = *preparation.made;
  if (!preparation.law.enter(preparation.friction.version(), on.speed)) return;
  if (auto bound = scene.law()->at_speed(on.speed)) on.problem.own_law = std::move(bound);
  on.problem.law = on.problem.own_law.get();
}

// Prepares a body; a failure names which of the two it is.
void prepare_body(Body& body, int which, Builds& builds) {
  try {
    const bool before = body.prepared();
    body.prepare();
    if (!before && body.response() && !body.shared() && !body.loaded()) ++builds.bodies;
  } catch (const Error& error) {
    throw Error(error.status(), "body " + std::to_string(which) + ": " + error.what());
  }
}

// Says how fast bodies that creep are passed, and refuses what is not known of them.
double speed_of_creep(const Scene& scene, const PairOfBodies& pair) {
  if (!pair.creeps()) return 0;
  if (scene.step_kind() != StepKind::steady)
    fail(
        Status::err_unsupported,
        "a body is viscoelastic (rollcon_body_set_viscoelastic): it is followed in steady rolling alone, as time steps "
        "do not keep its past; allowed: steady rolling (rollcon_contact_set_step)");
  if (is_conformal(scene, pair))
    fail(Status::err_unsupported,
         "a body is viscoelastic (rollcon_body_set_viscoelastic), which conformal frames do not know; allowed: option "
         "conformal = 0");
  if (!scene.speed_given())
    fail(Status::err_state,
         "a body is viscoelastic (rollcon_body_set_viscoelastic), and the rolling speed is not known: call "
         "rollcon_contact_set_rolling or rollcon_contact_set_velocity");
  return scene.speed({0, 0, 0});
}

}  // namespace

Prescribed prescribed_by(const Scene& scene, const Preparation& preparation) {
  Prescribed given;
  for (const Direction d : {Direction::longitudinal, Direction::lateral, Direction::normal, Direction::spin,
                            Direction::tilt1, Direction::tilt2}) {
    const std::size_t m = motion_of(d);
    const Load& load = scene.load(d);
    given.by_force[m] = load.how == How::by_force;
    given.value[m] = load.how == How::by_velocity ? preparation.creepage[m] : load.value;
  }
  given.prescribe_normal(given.by_force[approach], given.value[approach], preparation.made->problem.datum);
  return given;
}

void forget_operators(Preparation& preparation) {
  if (!preparation.dense) preparation.made->problem.op = preparation.dense = std::make_shared<DenseOperators>();
  preparation.dense->release();
  preparation.dense->nodes = preparation.made->frame.nodes();
}

void prepare_bodies(Preparation& preparation, Body& body1, Body& body2) {
  if (body1.prepared() && body2.prepared()) return;
  const Stopwatch watch(preparation.timings.compliance);
  prepare_body(body1, 1, preparation.builds);
  prepare_body(body2, 2, preparation.builds);
}

void prepare(Preparation& preparation, const Scene& scene, Body& body1, Body& body2, int threads) {
  preparation.procedure = choose_procedure(scene.options);
  scene.require_complete(body1.has_surface() || body2.has_surface());
  if (!preparation.procedure.standard() && scene.law())
    fail(Status::err_unsupported,
         "the published procedures solve Coulomb's law alone; allowed with this law: system = condensed and "
         "jacobian = exact");
  prepare_bodies(preparation, body1, body2);
  Prepared& on = *preparation.made;
  on.pair = {{&body1, &body2}, {scene.pose(0), scene.pose(1)}, scene.layer()};
  on.pair.speed = speed_of_creep(scene, on.pair);
  on.heat = scene.heat();
  build_frame_part(preparation, scene);
  build_compliance(preparation, scene, threads);
  build_stencils(preparation, scene);
  find_offset(preparation);
  read_friction(preparation, scene);
  read_gap(preparation, scene);
  on.bears = std::min(
      {on.meshes[0].glued, on.meshes[1].glued, std::abs(body1.revolved_radius()), std::abs(body2.revolved_radius())});
  if (const auto gap = scene.quadratic_gap())
    on.bears = std::min(on.bears, 0.5 / std::max({(*gap)[0], (*gap)[1], 1e-300}));
  read_slip(preparation, scene, poses_of_surfaces(scene, on.pair));
  bind_law(preparation, scene);
  build_operators(preparation, scene);
}

}  // namespace rollcon
