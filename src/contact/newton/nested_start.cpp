#include "contact/newton/nested_start.hpp"

#include <algorithm>
#include <cmath>

#include "support/index.hpp"

namespace rollcon {
namespace {

// Lattices of fewer nodes along a side are solved from nothing.
constexpr std::int64_t coarsest = 12;
constexpr std::int64_t coarse_iterations = 60;
// Nodes along a side of the coarsest lattice that says something about a finer one.
constexpr std::int64_t coarsest_compared = 7;

/// Holds every second node and the cells between them; on an even number of nodes the last one has no coarse neighbour.
struct Coarser {
  Lattice lattice;
  Frame frame;
  std::vector<std::int32_t> fine;  ///< coarse node -> node of the finer frame
};

/// Takes the cells that have all their nodes.
Coarser coarsen(const Frame& frame, const Lattice& lattice) {
  Coarser c;
  const std::int64_t nx = (lattice.nx + 1) / 2, ny = (lattice.ny + 1) / 2;
  SurfaceMesh mesh;
  mesh.offset.push_back(0);
  std::vector<std::int32_t> place, number(at(nx * ny), -1), low_corner;
  for (std::int64_t j = 0; j < ny; ++j)
    for (std::int64_t i = 0; i < nx; ++i) {
      const std::int32_t k = lattice.node[at(2 * j * lattice.nx + 2 * i)];
      if (k < 0) continue;
      number[at(j * nx + i)] = static_cast<std::int32_t>(c.fine.size());
      place.push_back(static_cast<std::int32_t>(j * nx + i));
      c.fine.push_back(k);
      mesh.node.push_back(frame.mesh.node[at(k)]);
    }
  for (std::int64_t j = 0; j + 1 < ny; ++j)
    for (std::int64_t i = 0; i + 1 < nx; ++i) {
      const std::int64_t low = j * nx + i;
      const std::int32_t corner[] = {number[at(low)], number[at(low + 1)], number[at(low + 1 + nx)],
                                     number[at(low + nx)]};
      if (*std::min_element(corner, corner + 4) < 0) continue;
      low_corner.push_back(static_cast<std::int32_t>(low));
      mesh.connectivity.insert(mesh.connectivity.end(), corner, corner + 4);
      mesh.type.push_back(ElementType::quad4);
      mesh.tag.push_back(0);
      mesh.offset.push_back(static_cast<std::int64_t>(mesh.connectivity.size()));
    }
  c.lattice = lattice;
  c.lattice.dx *= 2;
  c.lattice.dy *= 2;
  c.lattice.place(nx, ny, place, low_corner);
  if (c.lattice.has_inner_node()) c.frame = build_frame(std::move(mesh), frame.axes);
  return c;
}

// Makes the coarser problem; coefficients that follow the solution stay as they are.
Problem coarser_problem(const Problem& p, const Prescribed& given, const LatticeScene& scene, const Coarser& c) {
  Problem q;
  take_frame(q, c.frame);
  scene.make_operators(c.frame, c.lattice, q);
  set_scales(q);
  const auto sample = [&](const std::vector<double>& from, std::vector<double>& to) {
    if (from.empty()) return;
    to.resize(c.fine.size());
    for (std::size_t k = 0; k < to.size(); ++k) to[k] = from[at(c.fine[k])];
  };
  sample(p.gap, q.gap);
  sample(p.mu, q.mu);
  for (std::size_t k = 0; k < q.mu.size() && !given.utilisation.empty(); ++k)
    q.mu[k] *= given.utilisation[at(c.fine[k])];
  sample(p.slip1, q.slip1);
  sample(p.slip2, q.slip2);
  sample(p.before_touch, q.before_touch);
  q.motion_scale = p.motion_scale;
  q.stiffness = p.stiffness;
  q.law = p.law;
  q.own_law = p.own_law;
  return q;
}

/// Interpolates bilinearly from every second node; beyond the last there is none.
void interpolate(const Lattice& coarse, const std::vector<double>& from, const Lattice& fine, std::vector<double>& to) {
  const auto value = [&](std::int64_t i, std::int64_t j) {
    const std::int32_t k = i < coarse.nx && j < coarse.ny ? coarse.node[at(j * coarse.nx + i)] : -1;
    return k >= 0 ? from[at(k)] : 0.0;
  };
  for (std::int64_t j = 0; j < fine.ny; ++j)
    for (std::int64_t i = 0; i < fine.nx; ++i) {
      const std::int64_t a = i / 2, b = j / 2, c = (i + 1) / 2, d = (j + 1) / 2;
      const std::int32_t k = fine.node[at(j * fine.nx + i)];
      if (k < 0) continue;
      to[at(k)] = 0.25 * (value(a, b) + value(c, b) + value(a, d) + value(c, d));
    }
}

class Quiet final : public Monitor {
 public:
  explicit Quiet(const std::function<bool()>& cancelled) : cancelled_(cancelled) {}
  bool step(const StepRecord&) override { return cancelled_(); }

 private:
  const std::function<bool()>& cancelled_;
};

bool solve(const Problem& problem, Prescribed given, const LatticeScene& scene, bool frictionless, double tolerance,
           Iterate& iterate) {
  if (frictionless) given.by_force[xi1] = given.by_force[xi2] = given.by_force[spin] = false;
  Newton newton;
  Quiet quiet(scene.cancelled);
  const NewtonReport report = newton.solve(problem, given, iterate, frictionless, tolerance, coarse_iterations, quiet);
  return report.outcome == Outcome::converged;
}

/// Makes tractions and motions for a lattice from what `find` makes of the problem on the next coarser one. Returns
/// false where it found nothing.
template <class Find>
bool take_from_coarser(const Problem& problem, const Prescribed& given, const LatticeScene& scene, Iterate& iterate,
                       Find find) {
  const Coarser coarser = coarsen(scene.frame, scene.lattice);
  if (!coarser.lattice.has_inner_node()) return false;
  const Problem p = coarser_problem(problem, given, scene, coarser);
  Prescribed there = given;
  there.utilisation.clear();
  Iterate start;
  start.resize(p.nodes);
  start.motion = iterate.motion;
  const LatticeScene next{coarser.frame, coarser.lattice, scene.make_operators, scene.cancelled};
  if (!find(p, there, next, start)) return false;
  for (int c = 0; c < 3; ++c) interpolate(coarser.lattice, start.lambda[c], scene.lattice, iterate.lambda[c]);
  for (std::size_t k = 0; k < at(problem.nodes); ++k) {
    double& normal = iterate.lambda[2][k];
    normal = problem.used[k] ? std::min(normal, 0.0) : 0.0;
    const FrictionTraction t =
        problem.law->traction({given.coefficient(problem.mu, k), -normal, iterate.lambda[0][k], iterate.lambda[1][k]});
    iterate.lambda[0][k] = t.t1;
    iterate.lambda[1][k] = t.t2;
  }
  iterate.motion = start.motion;
  iterate.invalidate();
  return true;
}

}  // namespace

bool start_from_coarser(const Problem& problem, const Prescribed& given, const LatticeScene& scene, bool frictionless,
                        double tolerance, Iterate& iterate) {
  if (std::min(scene.lattice.nx, scene.lattice.ny) < 2 * coarsest) return false;
  return take_from_coarser(problem, given, scene, iterate,
                           [&](const Problem& p, const Prescribed& there, const LatticeScene& next, Iterate& start) {
                             start_from_coarser(p, there, next, frictionless, start_tolerance, start);
                             return solve(p, there, next, frictionless, tolerance, start);
                           });
}

bool solve_on_coarser(const Problem& problem, const Prescribed& given, const LatticeScene& scene, bool frictionless,
                      double tolerance, int halvings, Iterate& iterate) {
  if (std::min(scene.lattice.nx, scene.lattice.ny) < 2 * coarsest_compared) return false;
  return take_from_coarser(problem, given, scene, iterate,
                           [&](const Problem& p, const Prescribed& there, const LatticeScene& next, Iterate& start) {
                             if (halvings > 1)
                               return solve_on_coarser(p, there, next, frictionless, tolerance, halvings - 1, start);
                             start_from_coarser(p, there, next, frictionless, start_tolerance, start);
                             return solve(p, there, next, frictionless, tolerance, start);
                           });
}

}  // namespace rollcon
