#include "contact/plan.hpp"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <numbers>

#include "contact/estimate/few_nodes.hpp"
#include "contact/prepare/lattice_scene.hpp"
#include "contact/results/doubts.hpp"
#include "contact/results/outcome_text.hpp"
#include "contact/scene/geometry.hpp"
#include "contact/solver.hpp"
#include "linalg/blas_kernels.hpp"

namespace rollcon {
namespace {

void line(std::string& text, const char* format, ...) __attribute__((format(printf, 2, 3)));

void line(std::string& text, const char* format, ...) {
  char buffer[768];
  std::va_list args;
  va_start(args, format);
  std::vsnprintf(buffer, sizeof buffer, format, args);
  va_end(args);
  text += buffer;
  text += '\n';
}

const char* where_prepared(const Body& body) {
  if (body.loaded()) return "; from a file: not assembled, not factorised";
  return body.shared() ? "; shared with an equal body of this context" : "";
}

std::string slow_factors(const Body& body) {
  if (!body.traits().dense || !body.response() || body.shared() || body.loaded()) return {};
  return slow_factorization(blas_kernels(), body.response()->statistics().unknowns);
}

// Tells what the factors of boundary elements were foreseen to take, and what they do.
std::string memory_of_factors(const Body& body) {
  if (!body.traits().dense || !body.response()) return {};
  const BodyStatistics s = body.response()->statistics();
  if (s.needed_bytes == 0) return {};
  char text[200];
  if (s.nonzeros == 0)
    std::snprintf(text, sizeof text, "%lld unknowns; factors would take about %.3g GB",
                  static_cast<long long>(s.unknowns), 1e-9 * s.needed_bytes);
  else
    std::snprintf(text, sizeof text, "%lld unknowns, %s factors of %.3g GB (foreseen: %.3g GB)",
                  static_cast<long long>(s.unknowns), s.nonzeros < s.unknowns * s.unknowns ? "hierarchical" : "dense",
                  8e-9 * static_cast<double>(s.nonzeros), 1e-9 * s.needed_bytes);
  return text;
}

void describe_bodies(std::string& text, const Solution& s, const Body& body1, const Body& body2) {
  int number = 1;
  for (const Body* body : {&body1, &body2}) {
    const bool volume = body->traits().volume;
    if (body->rigid())
      line(text, "body %d: rigid%s: no matrix, no factorisation, no compliance", number,
           body->has_surface() ? " surface of its own" : ", no mesh");
    else if (body->meshed()) {
      line(text, "body %d: %s, %lld nodes, %lld %s elements%s%s", number, body->traits().parts,
           static_cast<long long>(body->mesh().surface.nodes()), static_cast<long long>(body->size().second),
           volume ? "volume" : "surface",
           volume ? (", " + std::to_string(body->mesh().surface.elements()) + " boundary faces").c_str() : "",
           where_prepared(*body));
      for (const std::string& more : {memory_of_factors(*body), slow_factors(*body)})
        if (!more.empty()) line(text, "body %d: %s", number, more.c_str());
    }
    if (const std::string& what = body->mesh().passed_over; !what.empty())
      text += "body " + std::to_string(number) + ": of its mesh file, " + what + '\n';
    ++number;
  }
  if (body1.response() && body1.same_as(body2))
    line(text, "body 2 equals body 1: no second assembly, no second factorisation");
  const auto sparse = [](const Body& body) { return body.traits().make_response && !body.traits().dense; };
  if (!sparse(body1) && !sparse(body2) && s.procedure.standard())
    line(text, "no finite-element body: no sparse matrix, no call of a sparse factorisation");
  if (!body1.rigid() && !body2.rigid() && s.prepared->compliance->translation())
    line(text, "both %ss: one compliance with summed constants", body1.traits().name);
  const std::string lattice = describe_lattice(*s.prepared);
  if (!lattice.empty()) text += lattice + '\n';
  const std::string compliance = s.prepared->compliance->description();
  if (!compliance.empty()) text += compliance + '\n';
}

void describe_frame(std::string& text, const Solution& s, const Scene& scene, bool meshed) {
  if (s.prepared->frame_source.body >= 0)
    line(text, "frame: the %lld faces of body %d with tag %d", static_cast<long long>(s.prepared->frame.elements()),
         s.prepared->frame_source.body + 1, s.prepared->frame_source.tag);
  if (s.prepared->placed || s.prepared->frame.strips)
    line(text, "frame: made by the library, strips that end at the contact's edge; solves may move and stretch it");
  else if (!scene.frame_given() && s.prepared->step != StepKind::steady)
    line(text, "frame: made by the library; steps on half-spaces keep its cells as long as they fit the contact");
  if (s.prepared->frame.curved()) {
    double cosine = 1;
    for (const Vec3& n : s.prepared->frame.n) cosine = std::min(cosine, dot(n, s.prepared->frame.axes.n));
    line(text, "frame: curved, local axes at every node, normals up to %.2g degrees off",
         std::acos(cosine) * 180 / std::numbers::pi);
  } else {
    line(text, "frame: flat, one triad for all nodes");
  }
  if (meshed) line(text, "gap: %s", scene.has_gap() ? "as given" : "from the surfaces of the bodies");
  if (const InitialOverlap overlap = initial_overlap(s.prepared->frame, s.prepared->problem.undeformed_gaps());
      overlap.nodes > 0)
    line(text, "gap: negative at %lld node(s), by up to %.3g: the bodies overlap before they approach",
         static_cast<long long>(overlap.nodes), overlap.depth);
  if (!s.prepared->offset_depth.empty())
    line(text, "loads and given displacements of the bodies: added to gap and slip");
}

void describe_procedure(std::string& text, const Solution& s, const Effort& effort, const Options& o) {
  if (s.procedure.monolithic)
    line(text, "system: monolithic, %lld unknowns, %lld nonzeros; nothing condensed",
         static_cast<long long>(effort.unknowns), static_cast<long long>(effort.nonzeros));
  else
    line(text, "system: condensed, %lld unknowns", static_cast<long long>(effort.unknowns));
  line(text, "iteration: generalised Newton method with line search, jacobian %s, linear solver %s",
       o.procedure.jacobian.c_str(), o.linear_solver.c_str());
}

// Says where the solution came from; fallbacks after the first look wherever they can.
const char* branch_of(const NewtonReport& report) {
  const bool by_degrees = report.saved[static_cast<std::size_t>(Rung::follow_loads)] > 0;
  const bool others = report.fallbacks > (report.saved[static_cast<std::size_t>(Rung::cold)] > 0);
  if (!by_degrees && others) return "was found by a fallback, from stick or not";
  return by_degrees || report.from_nothing ? "begins with stick" : "continues the last solution";
}

// Tells how far the solution is that of the bodies: nodes that carry it, and the estimate once known.
void describe_contact(std::string& text, const Solution& s, const Derived& d) {
  if (s.report.outcome != Outcome::converged) return;
  if (too_few_nodes(s)) {
    text += describe_few_nodes(s).str() + '\n';
    return;
  }
  const auto& normal = s.iterate.lambda[2];
  const auto touching = std::count_if(normal.begin(), normal.end(), [](double l) { return l < 0; });
  line(text, "contact: %lld node(s) touch, %lld of them with all their neighbours", static_cast<long long>(touching),
       static_cast<long long>(nodes_inside(s)));
  if (const Line doubt = describe_meshes(s); *doubt.text) text += doubt.str() + '\n';
  if (d.extrapolated && !s.prepared->frame.strips)
    text += "results: extrapolated from this frame and one with half its intervals; fields are those of this one\n";
  const ErrorEstimate& e = d.error_estimate;
  const auto& body = s.prepared->pair.body;
  const bool meshed = body[0]->response() || body[1]->response();
  if (e.known)
    line(text, "discretisation of the frame: the normal force is off by about %.2g %%, friction by %.2g %%%s",
         100 * e.normal, 100 * e.tangential, meshed ? "; errors of the bodies' own meshes come on top" : "");
  else
    line(text, "discretisation: error not estimated (statistic error_estimate)");
}

// Tells what of the last preparation was there already.
void describe_reuse(std::string& text, const Solution& s, const Builds& now, const Builds& before) {
  std::string kept, made;
  const auto tell = [&](bool again, const char* what) {
    std::string& list = again ? made : kept;
    list += (list.empty() ? "" : ", ") + std::string(what);
  };
  if (s.prepared->pair.body[0]->response() || s.prepared->pair.body[1]->response())
    tell(now.bodies != before.bodies, "bodies");
  tell(now.frames != before.frames, "frame");
  tell(now.gaps != before.gaps, "gap");
  tell(now.compliances != before.compliances, "compliance");
  tell(now.stencils != before.stencils, "convective stencils");
  tell(now.operators != before.operators, "operators");
  if (made.empty())
    line(text, "nothing is new since the solve before: no assembly, no preparation");
  else if (!kept.empty())
    line(text, "as before, not made again: %s", kept.c_str());
  if (!made.empty()) line(text, "made for this solve: %s", made.c_str());
}

void describe_results(std::string& text, const Derived& d) {
  std::string missing;
  const auto tell = [&](bool known, const char* what) {
    if (!known) missing += (missing.empty() ? "" : ", ") + std::string(what);
  };
  tell(d.fields, "gap, slip and state of the nodes");
  tell(d.laws_checked, "residuals of the laws");
  tell(d.displacements, "displacements of the bodies");
  tell(d.error_estimate.known, "error estimate");
  tell(std::any_of(d.sensitivities.known.begin(), d.sensitivities.known.end(), [](bool known) { return known; }),
       "sensitivities");
  if (!missing.empty()) line(text, "not computed, as nobody asked: %s", missing.c_str());
}

}  // namespace

std::string describe_plan(Solver& solver, const Body& body1, const Body& body2) {
  const Solution& s = solver.solution();
  const Scene& scene = solver.scene;
  const Effort& effort = solver.effort();
  const StepHistory& steps = solver.steps();
  const Builds& builds = solver.preparation()->builds;
  std::string text;
  const Operators& op = *s.prepared->problem.op;
  describe_bodies(text, s, body1, body2);
  describe_frame(text, s, scene, body1.meshed() || body2.meshed());
  if (s.frictionless) {
    line(text, "friction is zero: no tangential unknowns%s",
         op.tangential ? ""
                       : ", no convective operator assembled, no tangential column of the "
                         "compliance");
  } else if (!s.procedure.standard()) {
    line(text, "the published iteration solves for all unknowns at once, coupled or not");
  } else if (!op.coupled && s.prepared->frame.curved() && s.given.by_force[approach]) {
    line(text,
         "no coupling blocks, but on a curved frame friction carries a part of the normal load: "
         "solved together");
  } else if (op.coupling_vanished) {
    line(text, "coupling blocks vanish (the bodies mirror each other): normal problem first, alone");
  } else if (!op.coupled) {
    line(text, "(1-2nu)/G equal on both sides: normal problem first, alone; no coupling blocks");
  } else {
    line(text, "normal and tangential problems coupled: solved together");
  }
  if (const std::string law = s.frictionless ? "" : s.prepared->problem.law->description(); !law.empty())
    line(text, "%s", law.c_str());
  if (!s.frictionless && s.prepared->problem.law->of_field())
    line(text, "friction follows the whole solution: found by %lld solves with given coefficients, last change %.1e",
         static_cast<long long>(s.settled.rounds), s.settled.change);
  if (s.prepared->pair.layer > 0) line(text, "an elastic layer between the bodies: %g", s.prepared->pair.layer);
  if (!s.frictionless && s.prepared->problem.law->falls() && s.report.outcome == Outcome::converged)
    line(text, "several solutions may exist: this one %s", branch_of(s.report));
  if (op.tangential || s.procedure.monolithic) line(text, "convective scheme: %s", s.prepared->scheme.name);
  if (s.prepared->step != StepKind::steady)
    line(text, "time: step %lld of %.6g, %s; %s", static_cast<long long>(steps.last.steps), 1 / s.prepared->speed,
         s.prepared->step == StepKind::shift ? "bodies are shifted" : "material travels",
         steps.before.loaded ? "displacements of the step before were carried along" : "from rest");
  for (int m = 0; m < int{motion_count}; ++m)
    if (s.given.by_force[static_cast<std::size_t>(m)]) {
      static constexpr const char* names[] = {"longitudinal creepage", "lateral creepage", "approach", "spin",
                                              "tilt about t1",         "tilt about t2"};
      line(text, "%s: unknown of the Newton system (its load is given)", names[m]);
    }
  if (!s.procedure.standard()) describe_procedure(text, s, effort, scene.options);
  if (op.normal && !op.all_at_once())
    line(text, "operators: %lld nodes, %.1f MB, assembled %lld time(s) by this contact",
         static_cast<long long>(op.nodes), static_cast<double>(op.bytes()) / 1e6,
         static_cast<long long>(builds.operators));
  describe_contact(text, s, solver.derived());
  describe_reuse(text, s, builds, effort.builds_before);
  line(text, "result: %s", describe_outcome(s).c_str());
  line(text, "last solve: %lld linear system(s), %lld factorisation(s), %lld Krylov iteration(s)",
       static_cast<long long>(effort.right_sides), static_cast<long long>(effort.factorizations),
       static_cast<long long>(effort.linear_iterations));
  describe_results(text, solver.derived());
  return text;
}

}  // namespace rollcon
