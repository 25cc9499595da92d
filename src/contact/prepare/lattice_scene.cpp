#include "contact/prepare/lattice_scene.hpp"

#include <algorithm>
#include <cstdio>
#include <string>

#include "contact/newton/nested_start.hpp"
#include "contact/operators/hierarchical/hierarchical_operator.hpp"
#include "contact/operators/lattice/corrected_lattice.hpp"
#include "contact/operators/lattice/lattice_dense.hpp"
#include "contact/operators/lattice/lattice_operator.hpp"
#include "contact/prepare/preparation.hpp"
#include "linalg/fft.hpp"
#include "support/clock.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

// FFT takes less time from so many nodes on, one cold solve and one warm taken together (docs/speed.md): cold solves
// gain from the first node on, warm ones lose where few nodes touch.
constexpr std::int64_t fft_from = 400;
// Hierarchical operators take less time than matrices from so many nodes on, one cold solve and one warm taken together
// (docs/howto/choose.md): cold solves gain from 1,000 nodes on, warm ones lose up to 5,000.
constexpr std::int64_t hierarchical_from = 3000;
// Matrices of bodies that are nearly half-spaces take less time up to here (docs/sections.md).
constexpr std::int64_t corrected_from = 1000;

// Says why a table of one node's influence does not serve for all; null: it does.
const char* obstacle_to_table(const Prepared& on) {
  if (!on.compliance->translation()) return "not both bodies respond alike everywhere, as half-spaces do";
  if (!on.lattice) return on.no_lattice.c_str();
  if (!on.lattice->has_inner_node()) return "the grid has no inner node";
  if (on.lattice->ey != 0 && !on.compliance->translation()->turns())
    return "the grid is turned against the rolling direction, along which viscoelastic bodies creep";
  return nullptr;
}

// Says why operators cannot be applied by FFT; null: they can.
const char* obstacle_to_fft(const Preparation& preparation) {
  const Procedure& procedure = preparation.procedure;
  if (!has_fft()) return "this build is without FFTW (ROLLCON_WITH_FFTW=OFF)";
  if (const char* reason = obstacle_to_table(*preparation.made)) return reason;
  if (procedure.monolithic) return "system is monolithic";
  if (!procedure.standard()) return "jacobian is not 'exact'";
  if (procedure.linear == LinearMethod::lu) return "linear_solver is 'lu'";
  return nullptr;
}

std::shared_ptr<const Operators> make_operators(const Prepared& on, bool frictionless, const Lattice& lattice,
                                                const Convection& convection) {
  const double delta = convection.ahead.empty() ? 0 : characteristic_step * lattice.spacing_along_flow();
  auto op = std::make_shared<LatticeOperator>(lattice, on.compliance->translation(), delta, convection.rows,
                                              on.scheme == Scheme::time_step);
  op->tangential = !frictionless;
  return op;
}

// Says why operators cannot be hierarchical; null: they can.
const char* obstacle_to_hierarchy(const Preparation& preparation) {
  const Prepared& on = *preparation.made;
  const Procedure& procedure = preparation.procedure;
  const auto kernel = on.compliance->translation();
  if (!kernel || !kernel->knows_points() || on.frame.curved() || on.frame.strips || on.frame.section)
    return "the frame is not a plane one above elastic half-spaces";
  if (on.scheme == Scheme::time_step) return "time steps take displacements of the step before from matrices";
  if (procedure.monolithic) return "system is monolithic";
  if (!procedure.standard()) return "jacobian is not 'exact'";
  if (procedure.linear == LinearMethod::lu) return "linear_solver is 'lu'";
  return nullptr;
}

std::shared_ptr<const Operators> make_hierarchical(const Prepared& on, int threads) {
  return std::make_shared<HierarchicalOperator>(on.frame, *on.compliance, on.problem.convection, !on.frictionless,
                                                on.accuracy, threads);
}

// Says whether the frame is a lattice on which bodies may be half-spaces with a correction.
bool may_be_corrected(const Preparation& preparation, const std::string& asked) {
  const Prepared& on = *preparation.made;
  const Procedure& procedure = preparation.procedure;
  return asked == "auto" && has_fft() && !on.compliance->translation() && on.frame.nodes() >= corrected_from &&
         on.lattice && on.lattice->has_inner_node() && !on.frame.curved() && on.scheme != Scheme::time_step &&
         !procedure.monolithic && procedure.standard() && procedure.linear != LinearMethod::lu;
}

// Returns null where the bodies have no such form.
std::shared_ptr<const Operators> make_corrected(const Prepared& on) {
  const Convection& convection = on.problem.convection;
  std::vector<double> x = on.frame.x, y = on.frame.y;
  for (std::size_t k = 0; k < convection.ahead.size(); ++k)
    x.push_back(on.frame.x[k] + convection.ahead[k]), y.push_back(on.frame.y[k]);
  NearHalfspaces near;
  if (!on.compliance->near_halfspaces({x, y}, near)) return nullptr;
  const double delta = convection.ahead.empty() ? 0 : characteristic_step * on.lattice->spacing_along_flow();
  auto half_spaces = std::make_shared<LatticeOperator>(
      *on.lattice, make_halfspace_compliance(on.frame, near.constants, on.accuracy, 1)->translation(), delta,
      convection.rows);
  half_spaces->tangential = !on.frictionless;
  return std::make_shared<CorrectedLattice>(std::move(half_spaces), near, convection, on.accuracy);
}

// Forgets rows that are of another kind than is needed now.
void forget_rows(Preparation& preparation) {
  forget_operators(preparation);
  preparation.changes.operators = preparation.changes.system = true;
}

void choose_table(Preparation& preparation, bool wanted) {
  if (preparation.made->table == wanted) return;
  preparation.made->table = wanted;
  if (preparation.dense && preparation.dense->normal) forget_rows(preparation);
}

LatticeScene scene_of(const Solution& s, const Scheme& scheme, std::function<bool()> cancelled) {
  const auto make = [&s, scheme](const Frame& frame, const Lattice& lattice, Problem& p) {
    p.convection = make_convection(frame, scheme, s.prepared->ends_at_edge);
    p.op = make_operators(*s.prepared, s.frictionless, lattice, p.convection);
  };
  return {s.prepared->frame, *s.prepared->lattice, make, std::move(cancelled)};
}

}  // namespace

void build_lattice_operators(Preparation& preparation, const Options& options) {
  Prepared& on = *preparation.made;
  if (preparation.lattice.enter(preparation.frame.version())) {
    on.lattice = find_lattice(on.frame, &on.no_lattice);
    on.no_lattice.insert(0, "the frame is not a regular grid of quad4 elements: ");
  }
  const char *no_fft = obstacle_to_fft(preparation), *no_table = obstacle_to_table(on),
             *no_hierarchy = obstacle_to_hierarchy(preparation);
  const std::string& asked = options.operators;
  const bool any = asked == "auto";
  const char* reason = asked == "fft"            ? no_fft
                       : asked == "table"        ? no_table
                       : asked == "hierarchical" ? no_hierarchy
                                                 : nullptr;
  if (reason) fail(Status::err_unsupported, "option operators is '%s' but %s", asked.c_str(), reason);
  const bool fft = !no_fft && (asked == "fft" || (any && on.frame.nodes() >= fft_from));
  const bool hierarchy =
      !fft && !no_hierarchy && (asked == "hierarchical" || (any && on.frame.nodes() >= hierarchical_from));
  choose_table(preparation, !fft && !hierarchy && !no_table && (any || asked == "table"));
  const bool formed = preparation.dense != nullptr;
  const bool corrected = !fft && !hierarchy && may_be_corrected(preparation, asked);
  if (corrected && !formed && (on.problem.op->tangential || on.frictionless)) return;
  if (corrected && (!formed || !preparation.dense->normal)) {
    const Stopwatch watch(preparation.timings.compliance);
    if (auto op = make_corrected(on)) {
      forget_rows(preparation);
      on.problem.op = std::move(op);
      preparation.dense.reset();
      preparation.changes.images = true;
      ++preparation.rows;
      return;
    }
  }
  if (!fft && !hierarchy) return formed ? void() : forget_rows(preparation);
  const bool kept = !formed && on.problem.op->on_lattice() == fft;
  if (kept && (on.problem.op->tangential || on.frictionless)) return;
  const Stopwatch watch(preparation.timings.compliance);
  forget_rows(preparation);
  on.problem.op = fft ? make_operators(on, on.frictionless, *on.lattice, on.problem.convection)
                      : make_hierarchical(on, preparation.threads);
  preparation.dense.reset();
  preparation.changes.images = true;
  ++preparation.rows;
}

bool fill_from_table(Preparation& preparation) {
  const Prepared& on = *preparation.made;
  if (!on.table) return false;
  DenseOperators& op = *preparation.dense;
  fill_lattice_operators(*on.lattice, *on.compliance->translation(), on.problem.convection,
                         !on.frictionless || op.tangential, op);
  return true;
}

void start_on_lattice(Solution& s, const Monitor& monitor) {
  if (!s.prepared->problem.op->on_lattice()) return;
  const std::vector<double>& pressure = s.iterate.lambda[2];
  if (std::any_of(pressure.begin(), pressure.end(), [](double l) { return l != 0; })) return;
  const bool steady = s.prepared->scheme != Scheme::time_step;
  const LatticeScene scene =
      scene_of(s, steady ? Scheme::characteristic : Scheme::time_step, [&] { return monitor.cancelled(); });
  start_from_coarser(s.prepared->problem, s.given, scene, s.frictionless, start_tolerance, s.iterate);
}

bool solve_on_coarser_lattice(const Solution& s, double tolerance, int halvings, Iterate& iterate) {
  Prescribed given = s.given;
  given.by_force = {};
  given.value = s.iterate.motion;
  iterate.resize(s.prepared->problem.nodes);
  iterate.motion = s.iterate.motion;
  return solve_on_coarser(s.prepared->problem, given, scene_of(s, s.prepared->scheme, [] { return false; }),
                          s.frictionless, tolerance, halvings, iterate);
}

bool displacements_on_lattice(const Solution& s, const Compliance& body, const std::vector<double> (&lambda)[3],
                              double* u) {
  const auto kernel = body.translation();
  if (!kernel || !s.prepared->lattice->loose.empty()) return false;
  const std::size_t n = s.prepared->frame.x.size();
  SparseRows same;  // rows of an upwind scheme that leave displacements as they are
  for (std::size_t k = 0; k <= n; ++k) same.start.push_back(static_cast<std::int64_t>(k));
  for (std::size_t k = 0; k < n; ++k) same.column.push_back(static_cast<std::int32_t>(k));
  same.value.assign(n, 1.0);
  LatticeOperator displacements(*s.prepared->lattice, kernel, 0, std::move(same));
  std::vector<double> part[3];
  for (auto& v : part) v.resize(n);
  displacements.images({}, {}, {}, lambda, part);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < 3; ++i) u[3 * k + i] = part[i][k];
  return true;
}

namespace {

// Tells what makes the grid differ from a full one with all nodes on their places.
std::string describe_flaws(const Prepared& on) {
  const Lattice& l = *on.lattice;
  char text[120];
  std::string all;
  const auto missing = (l.nx - 1) * (l.ny - 1) - on.frame.elements();
  if (missing > 0) {
    std::snprintf(text, sizeof text, "; %lld cell(s) of the grid missing", static_cast<long long>(missing));
    all += text;
  }
  if (l.misfit > 1e-9) {
    std::snprintf(text, sizeof text, "; nodes taken as on its places, up to %.1g of a spacing off", l.misfit);
    all += text;
  }
  return all;
}

}  // namespace

std::string describe_lattice(const Prepared& on) {
  if (on.table)
    return "operators: rows of a regular grid, copied from a table of one node's influence: no "
           "integrals" +
           describe_flaws(on);
  const Operators& op = *on.problem.op;
  if (op.all_at_once() && !on.compliance->translation())
    return "operators: half-spaces on a regular grid, applied by FFT, and a correction of low rank for the bodies";
  if (op.all_at_once() && !op.on_lattice()) {
    char text[200];
    std::snprintf(text, sizeof text,
                  "operators: hierarchical, integrals near each node and series between squares; %.1f MB, applied %lld "
                  "time(s)",
                  static_cast<double>(op.bytes()) / 1e6, static_cast<long long>(op.applications()));
    return text;
  }
  if (!op.on_lattice())
    return on.compliance->translation() && !on.lattice ? "operators: dense, by integrals; " + on.no_lattice
                                                       : std::string();
  char text[200];
  std::snprintf(text, sizeof text,
                "operators: regular %lld x %lld grid, applied by FFT: no integrals, no "
                "matrices; %.1f MB, applied %lld time(s)",
                static_cast<long long>(on.lattice->nx), static_cast<long long>(on.lattice->ny),
                static_cast<double>(op.bytes()) / 1e6, static_cast<long long>(op.applications()));
  return text + describe_flaws(on);
}

}  // namespace rollcon
