#include "bodies/halfspace/interior.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "bodies/halfspace/far_field.hpp"
#include "quadrature/near_field.hpp"
#include "quadrature/rules.hpp"
#include "support/index.hpp"
#include "support/parallel.hpp"

namespace rollcon {

using namespace halfspace;

namespace {

/// Error of a rule with m = degree + 1 - degree of N J over (1.9 R/a)^-m times integral of |t|/R^2.
constexpr double plain_constant = 4;
/// Closer than this, in half-lengths of the longest side, the near field decides.
constexpr double nearest = 2.5;
/// Errors over integral of |t|/R^2 add up like the logarithm of the frame's extent in elements.
constexpr double far_share = 1.0 / 15;
/// Part of the accuracy for one element near a point. Rules there are made for Kelvin's double layer; stresses are up
/// to six times as large, and rules judge its size from the element's centre: too small by about the element's
/// slenderness where the point is near a short side.
constexpr double near_share = 0.03;
/// Fewer points than this are cheaper without boxes.
constexpr std::int64_t points_for_boxes = 100;
constexpr std::size_t elements_for_boxes = 64;

LoadedElement loaded_element(const Frame& frame, std::int64_t number, const double* traction) {
  LoadedElement e;
  e.geometry = plane_geometry(frame, number);
  e.element.type = e.geometry.type;
  const auto ids = frame.mesh.element(number);
  for (std::size_t k = 0; k < max_element_nodes; ++k) {
    const std::size_t id = at(ids[std::min(k, ids.size() - 1)]);
    e.element.x[k] = frame.x[id];
    e.element.y[k] = frame.y[id];
    for (std::size_t c = 0; c < 3; ++c) {
      e.element.traction[c][k] = traction[3 * id + c];
      e.largest = std::max(e.largest, std::abs(traction[3 * id + c]));
    }
  }
  return e;
}

}  // namespace

struct HalfspaceInterior::Workspace {
  double sum[interior_count];
  std::vector<std::int32_t> open;  ///< boxes still to look at
  quadrature::NearWorkspace near;
};

HalfspaceInterior::HalfspaceInterior(const Frame& frame, const double* traction, Material material, double accuracy)
    : material_(material), accuracy_(accuracy) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::int64_t i = 0; i < frame.elements(); ++i) {
    const LoadedElement e = loaded_element(frame, i, traction);
    smallest = std::min(smallest, std::sqrt(e.geometry.shape.area));
    if (!(e.largest > 0)) continue;
    largest_ = std::max(largest_, e.largest);
    elements_.push_back(e);
  }
  least_depth_ = 1e-8 * smallest;
  const double error = far_share * accuracy;
  for (const LoadedElement& e : elements_) {
    std::vector<Rule>& rules = rules_[at(node_count(e.element.type))][static_cast<std::size_t>(e.geometry.map)];
    if (!rules.empty()) continue;
    const int p = quadrature::direction_degree(e.element.type, e.geometry.map);
    const bool triangle = corner_count(e.element.type) == 3;
    for (int degree = p + 1; degree <= (triangle ? 12 : 15); ++degree) {
      if (!triangle && degree % 2 == 0) continue;
      Rule rule;
      plain_rule(e.element.type, degree, rule.points);
      pad_points(rule.points);
      if (!rules.empty() && rules.back().points.n == rule.points.n) continue;
      const int m = degree + 1 - p;
      const double distance = std::max(nearest, std::pow(plain_constant / error, 1.0 / m) / 1.9);
      rule.least_distance2 = distance * distance;
      rules.push_back(rule);
    }
  }
}

const std::vector<HalfspaceInterior::Rule>& HalfspaceInterior::rules(const LoadedElement& e) const {
  return rules_[at(node_count(e.element.type))][static_cast<std::size_t>(e.geometry.map)];
}

void HalfspaceInterior::near(const LoadedElement& e, const InteriorPoint& at, Workspace& w) const {
  const double round = std::min(1.0, 0.5 * std::sqrt(e.geometry.shape.area) / e.geometry.shape.half_length);
  const double t = near_share * round * accuracy_ * largest_ / e.largest;
  const quadrature::Tolerance number{t, std::numeric_limits<double>::infinity()};
  const InteriorKernels& kernels = interior_kernels(instruction_set());
  const double kappa = 1 - 2 * material_.poisson;
  quadrature::near_field(e.geometry, {at.x, at.y, at.z}, {}, number, true, w.near, [&] {
    pad_points(w.near.points);
    kernels.element(e.element, w.near.points, at, kappa, w.sum);
  });
}

void HalfspaceInterior::add_element(const LoadedElement& e, const InteriorPoint& at, Workspace& w) const {
  const quadrature::CellShape& shape = e.geometry.shape;
  const double dx = at.x - shape.centre[0], dy = at.y - shape.centre[1];
  const double distance2 = (dx * dx + dy * dy + at.z * at.z) / (shape.half_length * shape.half_length);
  for (const Rule& rule : rules(e)) {
    if (distance2 < rule.least_distance2) continue;
    interior_kernels(instruction_set()).element(e.element, rule.points, at, 1 - 2 * material_.poisson, w.sum);
    return;
  }
  near(e, at, w);
}

void HalfspaceInterior::add_all(const SourceTree* tree, const InteriorPoint& at, Workspace& w) const {
  if (!tree) {
    for (const LoadedElement& e : elements_) add_element(e, at, w);
    return;
  }
  w.open.assign(1, 0);
  while (!w.open.empty()) {
    const std::int32_t number = w.open.back();
    w.open.pop_back();
    const SourceTree::Box& box = tree->boxes()[rollcon::at(number)];
    if (const int grid = tree->grid(box, at); grid >= 0) {
      const InteriorForces forces = tree->forces(number, grid);
      interior_kernels(instruction_set()).push(forces, at, 1 - 2 * material_.poisson, w.sum);
    } else if (box.child >= 0) {
      w.open.push_back(box.child);
      w.open.push_back(box.child + 1);
    } else {
      for (std::int32_t i = box.first; i < box.last; ++i)
        add_element(elements_[rollcon::at(tree->order()[rollcon::at(i)])], at, w);
    }
  }
}

void HalfspaceInterior::evaluate(std::int64_t points, const double* xyz, double* stress, double* displacement,
                                 int threads) const {
  const double of_stress = 1 / (2 * std::numbers::pi), of_motion = 1 / (4 * std::numbers::pi * material_.shear);
  quadrature::line_rule(1);  // tables are made before the threads start
  quadrature::symmetric_triangle_rules();
  std::unique_ptr<SourceTree> tree;
  if (points >= points_for_boxes && elements_.size() >= elements_for_boxes)
    tree = std::make_unique<SourceTree>(elements_, far_share * accuracy_);
  const int most = static_cast<int>(std::clamp<std::int64_t>(points, 1, std::max(1, threads)));
  std::vector<Workspace> workspaces(at(most));
  parallel_for(points, 16, most, [&](std::int64_t p, int thread) {
    Workspace& w = workspaces[at(thread)];
    std::fill(std::begin(w.sum), std::end(w.sum), 0.0);
    const double* x = xyz + 3 * p;
    add_all(tree.get(), {x[0], x[1], std::max(x[2], least_depth_)}, w);
    for (int i = 0; stress && i < 6; ++i) stress[6 * p + i] = of_stress * w.sum[i];
    for (int i = 0; displacement && i < 3; ++i) displacement[3 * p + i] = of_motion * w.sum[6 + i];
  });
}

}  // namespace rollcon
