#include "contact/results/doubts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

#include "bodies/body.hpp"
#include "bodies/model/imbalance.hpp"
#include "bodies/pair.hpp"

namespace rollcon {
namespace {

/// Returns halves of the extents of touching nodes along t1 and t2, where these end before the frame does.
std::array<double, 2> half_widths(const Solution& s) {
  std::array<double, 2> half{INFINITY, INFINITY};
  const std::vector<double>* const places[] = {&s.prepared->frame.x, &s.prepared->frame.y};
  for (std::size_t c = 0; c < 2; ++c) {
    const std::vector<double>& along = *places[c];
    double least = INFINITY, most = -INFINITY;
    for (std::size_t k = 0; k < along.size(); ++k)
      if (s.iterate.lambda[2][k] < 0) least = std::min(least, along[k]), most = std::max(most, along[k]);
    const auto [first, last] = std::minmax_element(along.begin(), along.end());
    if (least > *first || most < *last) half[c] = 0.5 * (most - least);
  }
  return half;
}

double half_width(const Solution& s) {
  const auto [along, across] = half_widths(s);
  return std::min(along, across);
}

double largest_pressure(const Solution& s) {
  const std::vector<double>& normal = s.iterate.lambda[2];
  return normal.empty() ? 0 : -*std::min_element(normal.begin(), normal.end());
}

double largest_friction(const Solution& s) {
  const std::vector<double>& mu = s.prepared->problem.mu;
  return mu.empty() ? 0 : *std::max_element(mu.begin(), mu.end());
}

// Pressure strains both surfaces along the rolling direction, and a difference of the two strains acts as creepage.
// Volume elements show less of the strain the deeper they are: on rings, linear ones of a quarter, half and all of the
// contact's half width in depth lose 3, 9 and 25 %, quadratic ones of five times that depth. Equal meshes of equal
// bodies lose the same part.
Line doubt_about_strain(const Solution& s) {
  constexpr double lost = 0.25, power = 1.5, most = 0.05;
  const auto [along, across] = half_widths(s);
  const double half = std::min(along, across), pressure = largest_pressure(s);
  if (s.frictionless || s.report.outcome != Outcome::converged || !(half > 0 && std::isfinite(half))) return {};
  double strain[2] = {};
  for (std::size_t b = 0; b < 2; ++b) {
    const MeshOnFrame& mesh = s.prepared->meshes[b];
    if (!mesh.response || !std::isfinite(mesh.rolled)) continue;
    const Body& body = *s.prepared->pair.body[b];
    strain[b] = lost * std::pow(mesh.rolled / (2 * half), power) * (1 - 2 * body.poisson()) * (1 + body.poisson()) *
                pressure / body.young() / (1 + (std::isfinite(across) ? along / across : 0));
  }
  const double creepage = std::max(std::hypot(s.iterate.motion[xi1], s.iterate.motion[xi2]),
                                   largest_friction(s) * pressure / s.prepared->problem.stiffness);
  const double off = std::abs(strain[0] - strain[1]);
  if (!(off > most * creepage)) return {};
  const int which = strain[0] > strain[1] ? 1 : 2;
  return line_of(
      "body %d: its elements under the frame show less of the strain along the surface than those of body %d, another "
      "mesh or model: that acts as a creepage of about %.2g; take elements that are less deep there, or like meshes "
      "for both bodies",
      which, 3 - which, off);
}

// Matrices of finite elements show 0.2 to 0.3 of their modulus.
Line doubt_about_units(const Solution& s, int which) {
  constexpr double most_ratio = 30;
  const double shown = imbalances_of(s.prepared->meshes[static_cast<std::size_t>(which)].response).local_young;
  const double own = s.prepared->pair.body[static_cast<std::size_t>(which)]->young(), ratio = shown / own;
  if (shown == 0 || (ratio < most_ratio && ratio > 1 / most_ratio)) return {};
  return line_of(
      "body %d: its matrix gives way between neighbouring nodes as a half-space of Young's modulus %.3g, but "
      "rollcon_body_set_elastic gave %.3g, apart by a factor of %.3g: check the units of matrix, nodes and modulus",
      which + 1, shown, own, ratio);
}

Line doubt_about_file(const Solution& s, int which) {
  const std::string& what = s.prepared->pair.body[static_cast<std::size_t>(which)]->mesh().passed_over;
  if (!what.starts_with("passed over")) return {};
  return line_of("body %d: its mesh is not all of its file, %s", which + 1, what.c_str());
}

Line doubt_about(const Solution& s, int which) {
  // Rings of boundary elements whose axial displacements are within 2 % have 0.016 at most, rings off by 6 to 36 %
  // 0.028 at least.
  constexpr double most_bent = 0.02, little_force = 0.05, shallow = 1.9;
  const MeshOnFrame& mesh = s.prepared->meshes[static_cast<std::size_t>(which)];
  if (const Line other = doubt_about_units(s, which); *other.text) return other;
  if (!mesh.response || s.report.outcome != Outcome::converged) return {};
  // Between nodes a half-space shows the pressures of contacts that are 0.4 times as wide.
  const double half = half_width(s), pressed = (mesh.between_nodes ? 0.4 : 1) * mesh.pressed,
               shown = s.frictionless ? pressed : std::max(pressed, mesh.rolled);
  if (half > 0 && std::isfinite(shown) && shown > half)
    return line_of(
        "body %d: its elements under the frame are too deep for the contact, which is %.3g wide: %s may be off by a "
        "tenth and more; take linear elements no deeper than %.3g there, or quadratic ones no deeper than %.3g",
        which + 1, 2 * half, s.frictionless ? "pressures" : "creepages and pressures", s.frictionless ? half : half / 2,
        2 * half);
  if (mesh.between_nodes && mesh.under_faces < shallow)
    return line_of(
        "body %d: under the frame it is %.2g times as thick as its faces are long: between their nodes a half-space is "
        "too soft; take its own faces as the frame, or faces no longer than half the thickness",
        which + 1, mesh.under_faces);
  // Contacts of 12 nodes on frames three times as fine have rolling resistances that are 4 to 6 % too small; of 18, 1
  // %.
  constexpr double few_nodes = 15, finer = 0.8;
  const std::vector<double>& area = s.prepared->problem.cell_area;
  const double across = 2 * half,
               spacing = std::sqrt(std::accumulate(area.begin(), area.end(), 0.0) / static_cast<double>(area.size()));
  if (s.prepared->pair.body[static_cast<std::size_t>(which)]->creeps() && mesh.between_nodes &&
      spacing < finer * mesh.spacing && across < few_nodes * mesh.spacing)
    return line_of(
        "body %d: it is viscoelastic, and what its faces do not feel of a finer frame loses no power: the contact is "
        "%.2g times as wide as nodes of these faces are apart, so that rolling resistance may be too small by a "
        "twentieth and more; take nodes that are at most %.3g apart there (edges of the section, and option stations)",
        which + 1, across / mesh.spacing, across / few_nodes);
  Vec3 local{}, moment{};
  sum_tractions(s.prepared->problem, s.iterate.lambda, local, moment);
  const Axes& axes = s.prepared->frame.axes;
  const Vec3 force = s.prepared->pair.pose[static_cast<std::size_t>(which)].turn_back(
      local[0] * axes.t1 + local[1] * axes.t2 + local[2] * axes.n);
  const Imbalances found = imbalances_of(mesh.response);
  std::size_t worst = 0;
  for (const std::size_t c : {1, 2})
    if (found.bent[c] * std::abs(force[c]) > found.bent[worst] * std::abs(force[worst])) worst = c;
  if (!(found.bent[worst] > most_bent && std::abs(force[worst]) > little_force * length(force))) return {};
  return line_of(
      "body %d: a force along its axis %c bends it (%.2g %% of the work) where its elements are too long for its "
      "thickness: displacements along that may be too small by a tenth and more; take elements no longer than it "
      "is thick there, or quadratic ones",
      which + 1, "xyz"[worst], 100 * found.bent[worst]);
}

}  // namespace

Line describe_pressure(double largest, double modulus) {
  if (!(largest > modulus)) return {};
  return line_of(
      "the largest pressure is %.4g, more than the modulus of contact (%.4g), as no material bears: check shapes, "
      "sides, loads and all units",
      largest, modulus);
}

Line describe_too_deep(const Solution& s) {
  const double deep = s.iterate.motion[approach], bears = s.prepared->bears;
  if (deep > 0.5 * bears)
    return line_of(
        "the bodies approach each other by %.4g, more than half of what is %.4g thick or round there, as no linear "
        "material bears: check loads, moduli and all units",
        deep, bears);
  const double largest = largest_pressure(s), modulus = s.prepared->problem.stiffness;
  // Single nodes have up to 400 times the mean pressure where this is 1 or more.
  constexpr double much = 0.5;
  const PairOfBodies& pair = s.prepared->pair;
  const double coupled = pair.meshed() ? 0 : std::abs(dundurs_beta(pair)) * largest_friction(s);
  if (largest > modulus && coupled > much)
    return line_of(
        "the largest pressure is %.4g, more than the modulus of contact (%.4g), as no material bears: with so much "
        "friction between such unlike bodies (Dundurs' beta times mu is %.2g) single nodes may have pressures that "
        "come from the frame alone; take less friction, or check units and loads",
        largest, modulus, coupled);
  return describe_pressure(largest, modulus);
}

Line describe_sharp_end(const Solution& s) {
  const Frame& frame = s.prepared->frame;
  if (s.prepared->pair.meshed()) return {};
  for (std::size_t k = 0; k < frame.ends.size(); ++k)
    if (frame.ends[k] && s.iterate.lambda[2][k] < 0)
      return {
          "the contact reaches a sharp end of a body, where the pressure of a half-space has no bound: it grows as 1 / "
          "sqrt(distance to the end), so that elements of a quarter of the size double the largest pressure, whereas "
          "force and approach converge; relieve the end or give it a radius (shape \"roller\"), or take the mean over "
          "a length (option pressure_length)"};
  return {};
}

Line describe_units(const Solution& s) {
  const Line first = doubt_about_units(s, 0);
  return *first.text ? first : doubt_about_units(s, 1);
}

Line describe_meshes(const Solution& s) {
  for (const int which : {0, 1})
    for (const auto doubt : {doubt_about, doubt_about_file})
      if (const Line line = doubt(s, which); *line.text) return line;
  return doubt_about_strain(s);
}

Status with_doubts(const Solution& s, Status status) {
  return status == Status::ok && *describe_meshes(s).text ? Status::inaccurate : status;
}

}  // namespace rollcon
