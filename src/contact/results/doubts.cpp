#include "contact/results/doubts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bodies/model/imbalance.hpp"

namespace rollcon {
namespace {

/// Returns half of the lesser extent of touching nodes along t1 and t2, where it ends before the frame does.
double half_width(const Solution& s) {
  double width = INFINITY;
  for (const std::vector<double>* along : {&s.prepared->frame.x, &s.prepared->frame.y}) {
    double least = INFINITY, most = -INFINITY;
    for (std::size_t k = 0; k < along->size(); ++k)
      if (s.iterate.lambda[2][k] < 0) least = std::min(least, (*along)[k]), most = std::max(most, (*along)[k]);
    const auto [first, last] = std::minmax_element(along->begin(), along->end());
    if (least > *first || most < *last) width = std::min(width, most - least);
  }
  return 0.5 * width;
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

Line doubt_about(const Solution& s, int which) {
  // Rings of boundary elements whose axial displacements are within 2 % have 0.016 at most, rings off by 6 to 36 %
  // 0.028 at least.
  constexpr double most_bent = 0.02, little_force = 0.05, shallow = 1.9;
  const MeshOnFrame& mesh = s.prepared->meshes[static_cast<std::size_t>(which)];
  if (const Line other = doubt_about_units(s, which); *other.text) return other;
  if (!mesh.response || s.report.outcome != Outcome::converged) return {};
  if (const double half = half_width(s); half > 0 && std::isfinite(mesh.element) && mesh.element > half)
    return line_of(
        "body %d: its elements under the frame are too deep for the contact, which is %.3g wide: pressures and "
        "creepages may be off by a quarter and more; take linear elements no deeper than %.3g there, or quadratic ones "
        "twice as deep",
        which + 1, 2 * half, half);
  if (mesh.between_nodes && mesh.under_faces < shallow)
    return line_of(
        "body %d: under the frame it is %.2g times as thick as its faces are long: between their nodes a half-space is "
        "too soft; take its own faces as the frame, or faces no longer than half the thickness",
        which + 1, mesh.under_faces);
  // Contacts of 12 nodes on frames three times as fine have rolling resistances that are 4 to 6 % too small; of 18, 1
  // %.
  constexpr double few_nodes = 15, finer = 0.8;
  const std::vector<double>& area = s.prepared->problem.cell_area;
  const double across = 2 * half_width(s),
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
  const std::vector<double>& normal = s.iterate.lambda[2];
  const double largest = normal.empty() ? 0 : -*std::min_element(normal.begin(), normal.end());
  return describe_pressure(largest, s.prepared->problem.stiffness);
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
  const Line first = doubt_about(s, 0);
  return *first.text ? first : doubt_about(s, 1);
}

Status with_doubts(const Solution& s, Status status) {
  return status == Status::ok && *describe_meshes(s).text ? Status::inaccurate : status;
}

}  // namespace rollcon
