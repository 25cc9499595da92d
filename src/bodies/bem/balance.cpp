/// Tells whether a boundary-element body's solutions are in equilibrium. Nothing in H u = G t makes them so: tractions
/// found on held faces balance the loads as well as the mesh can show what the body does. Where it cannot (thin bodies
/// under long elements) displacements are wrong by any factor, the equations look healthy, and the balance shows it.

#include <algorithm>
#include <cmath>

#include "bodies/bem/system.hpp"
#include "mesh/quadrature.hpp"
#include "mesh/shape.hpp"
#include "mesh/surface_geometry.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon::bem {
namespace {

/// Displacements are off by about the part of the load that is missed. Coarse rings that are right where they are
/// loaded miss 0.78, plates that hardly bend 0.84 and more.
constexpr double most_imbalance = 0.8;
/// Elements whose edges are longer than these multiples of the thickness there do not bend rightly (by the hub of
/// rings).
constexpr double too_long = 1.2, too_long_quadratic = 2.7;

/// Calls add(weight times area, position, shape) at the points of a rule on an element, with its own shape functions;
/// geometry: the elements as the equations see them.
template <class Add>
void for_points(const SurfaceMesh& surface, const SurfaceMesh& geometry, std::int64_t e, Add add) {
  // Exact for plane elements; on curved ones the Jacobian is not a polynomial.
  constexpr int degree = 9;
  static const PlaneRule triangle = triangle_rule(degree), square = square_rule(degree);
  const ElementType type = surface.type[at(e)];
  const PlaneRule& rule = corner_count(type) == 3 ? triangle : square;
  Shape shape;
  for (std::size_t q = 0; q < rule.size(); ++q) {
    evaluate_shape(type, rule.xi[q], rule.eta[q], shape);
    const SurfaceFrame here = evaluate_surface(geometry, e, rule.xi[q], rule.eta[q]);
    add(rule.w[q] * length(here.normal), here.x, shape);
  }
}

/// Calls add(force, position) at the points of all elements with tractions.
template <class Add>
void for_forces(const SurfaceMesh& surface, const SurfaceMesh& geometry, const TractionNodes& fans,
                std::span<const double> traction, Add add) {
  for (std::int64_t e = 0; e < surface.elements(); ++e) {
    const std::span fan(fans.of.data() + surface.offset[at(e)], surface.element(e).size());
    const bool loaded = std::any_of(fan.begin(), fan.end(), [&](std::int32_t f) {
      const auto own = traction.subspan(3 * at(f), 3);
      return std::any_of(own.begin(), own.end(), [](double t) { return t != 0; });
    });
    if (!loaded) continue;
    for_points(surface, geometry, e, [&](double area, const Vec3& x, const Shape& shape) {
      Vec3 t{0, 0, 0};
      for (std::size_t k = 0; k < fan.size(); ++k)
        for (std::size_t c = 0; c < 3; ++c) t[c] += shape.value[k] * traction[3 * at(fan[k]) + c];
      add(area * t, x);
    });
  }
}

}  // namespace

void System::add_reactions(const double* b, std::vector<double>& traction) const {
  for (std::size_t k = 0; k < traction.size(); ++k)
    if (const std::int32_t column = unknowns_.traction[k]; column >= 0)
      traction[k] += shear_ * b[at(column)] / fan_size_[k / 3];
  for (const SpreadReaction& spread : unknowns_.spread) {
    const std::size_t own = 3 * at(spread.fan) + at(spread.component);
    const double value = shear_ * b[at(unknowns_.traction[own])] / fan_size_[at(spread.fan)];
    for (const auto& [f, part] : spread.others) traction[3 * at(f) + at(spread.component)] += part * value;
  }
}

Resultant System::resultant(std::span<const double> traction) const {
  Resultant sum;
  for_forces(surface_, lifted_.mesh, fans_, traction, [&](const Vec3& force, const Vec3& x) {
    sum.force = sum.force + force;
    sum.moment = sum.moment + cross(x, force);
  });
  return sum;
}

// Returns the resultant of tractions less the given ones. (The reaction of a node held alone is spread over its
// neighbours, which are not held.)
Resultant System::support_reaction(const std::vector<double>& traction, const std::vector<double>& given) const {
  std::vector<double> support = traction;
  for (std::size_t k = 0; k < std::min(support.size(), given.size()); ++k) support[k] -= shear_ * given[k];
  return resultant(support);
}

double System::imbalance(const Resultant& sum, const Vec3& centre, double force) const {
  const double moment = length(sum.moment - cross(centre, sum.force));
  const double arm = std::clamp(length(centre - held_at_), 0.5 * reach_, reach_);
  return std::max(length(sum.force), moment / arm) / force;
}

double System::missed(std::span<const double> load, std::span<const double> traction) const {
  double force = 0;
  Vec3 first{0, 0, 0};
  for_forces(surface_, lifted_.mesh, fans_, load, [&](const Vec3& part, const Vec3& x) {
    force += length(part);
    first = first + length(part) * x;
  });
  return force > 0 ? imbalance(resultant(traction), (1 / force) * first, force) : 0;
}

// An edge bends by how far its middle moves beyond the mean of its ends. The work is that of a plate as thick as the
// body there; half of it belongs to either side.
double System::bent(const std::vector<double>& displacement, double force) const {
  const auto moved = [&](std::int32_t k) {
    return Vec3{displacement[3 * at(k)], displacement[3 * at(k) + 1], displacement[3 * at(k) + 2]};
  };
  double work = 0, largest = 0;
  for (std::int64_t e = 0; e < surface_.elements(); ++e) {
    const std::span<const std::int32_t> nodes = surface_.element(e), lifted = lifted_.mesh.element(e);
    for (const std::int32_t k : nodes) largest = std::max(largest, length(moved(k)));
    const std::size_t corners = at(corner_count(surface_.type[at(e)]));
    const double thickness = mesh_.thickness.empty() ? 0 : mesh_.thickness[at(e)];
    for (std::size_t k = 0; k < corners && thickness > 0; ++k) {
      const std::int32_t from = nodes[k], to = nodes[(k + 1) % corners], middle = lifted[corners + k];
      const double size = length(surface_.node[at(to)] - surface_.node[at(from)]);
      if (size <= thickness * (middle < lifted_.nodes ? too_long_quadratic : too_long)) continue;
      Vec3 bow = -0.5 * (moved(from) + moved(to));
      if (middle < lifted_.nodes)
        bow = bow + moved(middle);
      else
        for (const Part& part : lifted_.parts_of(middle)) bow = bow + part.value * moved(part.of);
      const double curvature = 8 * dot(bow, unit_normal(surface_, e, 1.0 / 3, 1.0 / 3)) / (size * size);
      work += std::pow(thickness, 3) * curvature * curvature * element_area(surface_, e) / static_cast<double>(corners);
    }
  }
  return largest > 0 ? shear_ / (12 * (1 - poisson_)) * work / (force * largest) : 0;
}

void System::check_balance(const std::vector<double>& b, const LoadedSurface& loaded) {
  const bool faces = loaded.of_faces();
  const SurfaceMesh &surface = faces ? surface_ : loaded.layer, &geometry = faces ? lifted_.mesh : loaded.layer;
  double area = 0;
  Vec3 first{0, 0, 0}, normal{0, 0, 0};
  const std::int64_t count = faces ? static_cast<std::int64_t>(loaded.face.size()) : surface.elements();
  for (std::int64_t i = 0; i < count; ++i) {
    const std::int64_t e = faces ? loaded.face[at(i)] : i;
    double of_element = 0;
    for_points(surface, geometry, e, [&](double part, const Vec3& x, const Shape&) {
      of_element += part;
      first = first + part * x;
    });
    area += of_element;
    constexpr double middle = 1.0 / 3;
    normal = normal + of_element * unit_normal(surface, e, middle, middle);
  }
  if (!(area > 0)) return;
  const Vec3 centre = (1 / area) * first, pressed = normalized(normal);
  const std::size_t n = at(unknowns_.columns), columns = b.size() / n;
  std::vector<double> sum(n), traction(unknowns_.traction.size()), moved(unknowns_.displacement.size());
  Resultant under_pressure;
  for (std::size_t c = 0; c < 3; ++c) {
    std::fill(sum.begin(), sum.end(), 0.0);
    for (std::size_t k = c; k < columns; k += 3)
      for (std::size_t i = 0; i < n; ++i) sum[i] += b[k * n + i];
    factor_->substitute(sum.data(), 1, 0);
    std::fill(traction.begin(), traction.end(), 0.0);
    add_reactions(sum.data(), traction);
    Resultant all = resultant(traction);
    Vec3 load{0, 0, 0};
    load[c] = area;
    all.force = all.force + load;
    all.moment = all.moment + cross(centre, load);
    for (std::size_t k = 0; k < moved.size(); ++k)
      moved[k] = unknowns_.displacement[k] < 0 ? 0 : sum[at(unknowns_.displacement[k])];
    imbalances_.bent[c] = std::max(imbalances_.bent[c], bent(moved, area));
    double& along = imbalances_.along[c];
    along = std::max(along, imbalance(all, centre, area));
    under_pressure.force = under_pressure.force + pressed[c] * all.force;
    under_pressure.moment = under_pressure.moment + pressed[c] * all.moment;
  }
  const double missed = imbalance(under_pressure, centre, area);
  imbalances_.pressure = std::max(imbalances_.pressure, missed);
  if (missed <= most_imbalance) return;
  fail(Status::err_mesh,
       "the mesh of the boundary-element body cannot show how it bears a pressure on the frame: the "
       "reactions of its supports miss that by %.3g %%; allowed: %g %%; where the body is thin, "
       "take quadratic elements no longer than it is thick, or finite elements",
       100 * missed, 100 * most_imbalance);
}

}  // namespace rollcon::bem
