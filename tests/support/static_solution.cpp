#include "support/static_solution.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mesh/quadrature.hpp"
#include "mesh/shape.hpp"
#include "support/element_runs.hpp"
#include "support/surface_meshes.hpp"

namespace rollcon::statics {
namespace {

std::size_t at(std::int64_t i) {
  return static_cast<std::size_t>(i);
}

template <class Mesh>
void add_runs(Body& body, const Mesh& mesh) {
  for_runs(mesh, [&](std::int32_t type, std::int32_t tag, std::int64_t count, const std::int32_t* connectivity) {
    body.add_elements(type, count, connectivity, 0, tag);
  });
}

}  // namespace

Tensor strain_of(const Tensor& stress, double young, double poisson) {
  const double trace = stress[0][0] + stress[1][1] + stress[2][2];
  Tensor strain;
  for (std::size_t i = 0; i < 3; ++i) {
    strain[i] = ((1 + poisson) / young) * stress[i];
    strain[i][i] -= poisson / young * trace;
  }
  return strain;
}

StaticBody::StaticBody(BodyKind kind, double young, double poisson, const std::vector<Vec3>& node)
    : context_(std::make_shared<Context>()), body_(std::make_unique<Body>(context_, static_cast<std::int32_t>(kind))) {
  body_->set_elastic(0, young, poisson);
  body_->set_nodes(static_cast<std::int64_t>(node.size()), node.front().data(), 3, 1);
}

StaticBody::StaticBody(SurfaceMesh mesh, double young, double poisson, double accuracy)
    : StaticBody(BodyKind::bem, young, poisson, mesh.node) {
  mesh_ = std::move(mesh);
  add_runs(*body_, mesh_);
  body_->set_real("accuracy", accuracy);
}

StaticBody::StaticBody(const volumes::Mesh& mesh, double young, double poisson)
    : StaticBody(BodyKind::fem, young, poisson, mesh.surface.node) {
  add_runs(*body_, mesh.volume);
  add_runs(*body_, mesh.surface);
  mesh_ = body_->surface_copy();
}

StaticBody::StaticBody(const surfaces::Block& shape, AnyElement type, double young, double poisson, double accuracy)
    : StaticBody(is_finite_element(type)
                     ? StaticBody(volumes::block(shape, std::get<VolumeType>(type)), young, poisson)
                     : StaticBody(surfaces::block(shape, std::get<ElementType>(type)), young, poisson, accuracy)) {}

StaticBody& StaticBody::hold(std::span<const std::int32_t> nodes, std::int32_t dof_mask,
                             const std::function<Vec3(const Vec3&)>& value) {
  std::vector<double> values;
  if (value)
    for (const std::int32_t k : nodes) {
      const Vec3 v = value(mesh_.node[at(k)]);
      values.insert(values.end(), v.begin(), v.end());
    }
  body_->set_support(static_cast<std::int64_t>(nodes.size()), nodes.data(), 0, dof_mask,
                     value ? values.data() : nullptr);
  return *this;
}

StaticBody& StaticBody::hold_tags(std::initializer_list<std::int32_t> tags, std::int32_t dof_mask,
                                  const std::function<Vec3(const Vec3&)>& value) {
  const auto nodes = surfaces::nodes_with_tag(mesh_, {tags.begin(), tags.size()});
  return hold(nodes, dof_mask, value);
}

StaticBody& StaticBody::hold_statically(const std::function<Vec3(const Vec3&)>& value) {
  // The nodes are far apart in x, then off that line in y.
  const auto by_x = [](const Vec3& a, const Vec3& b) { return a[0] < b[0]; };
  const auto [low, high] = std::minmax_element(mesh_.node.begin(), mesh_.node.end(), by_x);
  const Vec3 axis = *high - *low;
  const auto off =
      std::max_element(mesh_.node.begin(), mesh_.node.end(), [&, from = *low](const Vec3& a, const Vec3& b) {
        return std::abs(cross(axis, a - from)[2]) < std::abs(cross(axis, b - from)[2]);
      });
  const auto number = [&](auto node) { return static_cast<std::int32_t>(node - mesh_.node.begin()); };
  const std::int32_t first[] = {number(low)}, second[] = {number(high)}, third[] = {number(off)};
  return hold(first, 7, value).hold(second, 6, value).hold(third, 4, value);
}

StaticBody& StaticBody::traction(std::int32_t tag, const Vec3& t) {
  body_->set_traction(tag, t.data());
  return *this;
}

StaticBody& StaticBody::pressure(std::int32_t tag, double p) {
  body_->set_pressure(tag, p);
  return *this;
}

StaticBody& StaticBody::solve() {
  body_->prepare();
  return *this;
}

Vec3 StaticBody::displacement(std::int32_t node) const {
  const auto& u = body_->own().displacement;
  return {u[3 * at(node)], u[3 * at(node) + 1], u[3 * at(node) + 2]};
}

Vec3 StaticBody::displacement(const Vec3& near) const {
  return displacement(surfaces::node_at(mesh_, near));
}

Vec3 StaticBody::traction_at(std::int64_t fan) const {
  const auto& t = body_->own().traction;
  return {t[3 * at(fan)], t[3 * at(fan) + 1], t[3 * at(fan) + 2]};
}

Resultant StaticBody::resultant(std::initializer_list<std::int32_t> tags) const {
  const TractionNodes& fans = body_->traction_nodes();
  const PlaneRule triangle = triangle_rule(10), square = square_rule(10);
  Resultant sum;
  for (const std::int32_t tag : tags)
    for (const std::int64_t e : surfaces::elements_with_tag(mesh_, tag)) {
      const ElementType type = mesh_.type[at(e)];
      const PlaneRule& rule = corner_count(type) == 3 ? triangle : square;
      const auto n = mesh_.element(e);
      Shape s;
      for (std::size_t p = 0; p < rule.size(); ++p) {
        evaluate_shape(type, rule.xi[p], rule.eta[p], s);
        Vec3 x{0, 0, 0}, u{0, 0, 0}, v{0, 0, 0}, t{0, 0, 0};
        for (std::size_t a = 0; a < n.size(); ++a) {
          const Vec3& node = mesh_.node[at(n[a])];
          x = x + s.value[a] * node;
          u = u + s.d_xi[a] * node;
          v = v + s.d_eta[a] * node;
          t = t + s.value[a] * traction_at(fans.of[at(mesh_.offset[at(e)]) + a]);
        }
        const Vec3 force = (rule.w[p] * length(cross(u, v))) * t;
        sum.force = sum.force + force;
        sum.moment = sum.moment + cross(x, force);
      }
    }
  return sum;
}

double StaticBody::displacement_error(const std::function<Vec3(const Vec3&)>& exact) const {
  double error = 0, size = 0;
  for (std::int64_t k = 0; k < mesh_.nodes(); ++k) {
    const Vec3 u = exact(mesh_.node[at(k)]);
    size = std::max(size, length(u));
    error = std::max(error, length(displacement(static_cast<std::int32_t>(k)) - u));
  }
  return error / size;
}

double StaticBody::traction_error(const std::function<Tensor(const Vec3&)>& stress) const {
  const TractionNodes& fans = body_->traction_nodes();
  double error = 0, size = 0;
  for (std::int64_t f = 0; f < fans.size(); ++f) {
    const Vec3 t = times(stress(mesh_.node[at(fans.node[at(f)])]), fans.normal[at(f)]);
    size = std::max(size, length(t));
    error = std::max(error, length(traction_at(f) - t));
  }
  return error / size;
}

Vec3 Loaded::at(std::int32_t node_of_body) const {
  const auto place = std::lower_bound(node.begin(), node.end(), node_of_body);
  if (place == node.end() || *place != node_of_body)
    throw std::out_of_range("node " + std::to_string(node_of_body) + " has no row");
  return u[static_cast<std::size_t>(place - node.begin())];
}

Loaded load_faces(Body& body, std::span<const std::int64_t> faces, const std::function<Vec3(const Vec3&)>& traction,
                  int threads) {
  const auto rows = body.response()->rows({{faces.begin(), faces.end()}, {}, {}}, threads);
  std::vector<double> t;
  for (const std::int32_t k : rows->column) {
    const Vec3 value = traction(body.mesh().surface.node[at(k)]);
    t.insert(t.end(), value.begin(), value.end());
  }
  std::vector<double> u(3 * rows->row.size());
  multiply(rows->u.data(), rows->u.rows(), rows->u.columns(), t.data(), 0, u.data());
  Loaded loaded;
  loaded.node = rows->row;
  for (std::size_t r = 0; r < rows->row.size(); ++r) loaded.u.push_back({u[3 * r], u[3 * r + 1], u[3 * r + 2]});
  return loaded;
}

}  // namespace rollcon::statics
