#include "support/section_bodies.hpp"

#include <cmath>
#include <numbers>

#include "mesh/shape.hpp"
#include "support/element_runs.hpp"

namespace rollcon::sections {

std::vector<double> fine_at_ends(int n, double a, double b) {
  std::vector<double> line;
  for (int k = 0; k <= n; ++k) line.push_back(0.5 * (a + b) - 0.5 * (b - a) * std::cos(std::numbers::pi * k / n));
  return line;
}

SurfaceMesh rectangle(const Rectangle& shape, ElementType type, const surfaces::Map& map) {
  // The block's face of most third coordinate has these lines; its nodes then go to the plane.
  surfaces::Block block;
  block.line = {shape.y, shape.z, {0, 1}};
  const SurfaceMesh all = surfaces::block(block, type);
  std::vector<std::int32_t> node;
  SurfaceMesh plane = surfaces::part_with_tag(all, 6);
  for (Vec3& x : plane.node) {
    x = {0, x[0], x[1]};
    if (map) x = map(x);
  }
  for (std::int32_t& tag : plane.tag) tag = 0;
  return plane;
}

SectionBody::SectionBody(SurfaceMesh plane, double young, double poisson)
    : plane_(std::move(plane)),
      context_(std::make_shared<Context>()),
      body_(std::make_unique<Body>(context_, static_cast<std::int32_t>(BodyKind::section))) {
  body_->set_elastic(0, young, poisson);
  body_->set_nodes(plane_.nodes(), plane_.node.front().data(), 3, 1);
  for_runs(plane_, [&](std::int32_t type, std::int32_t tag, std::int64_t count, const std::int32_t* connectivity) {
    body_->add_elements(type, count, connectivity, 0, tag);
  });
}

SectionBody& SectionBody::tag(std::int32_t tag, const std::function<bool(const Vec3&)>& where) {
  const auto nodes = surfaces::nodes_where(plane_, where);
  body_->tag_faces_of_nodes(static_cast<std::int64_t>(nodes.size()), nodes.data(), 0, tag);
  return *this;
}

SectionBody& SectionBody::tag_sides(const Rectangle& shape) {
  const auto near = [](double a, double b) { return std::abs(a - b) < 1e-9; };
  tag(1, [&](const Vec3& x) { return near(x[1], shape.y.front()); });
  tag(2, [&](const Vec3& x) { return near(x[1], shape.y.back()); });
  tag(3, [&](const Vec3& x) { return near(x[2], shape.z.front()); });
  return tag(4, [&](const Vec3& x) { return near(x[2], shape.z.back()); });
}

SectionBody& SectionBody::hold(const std::function<bool(const Vec3&)>& where, std::int32_t mask,
                               const std::function<Vec3(const Vec3&)>& value) {
  const auto nodes = surfaces::nodes_where(plane_, where);
  std::vector<double> values;
  for (const std::int32_t k : nodes) {
    const Vec3 v = value ? value(plane_.node[surfaces::at(k)]) : Vec3{0, 0, 0};
    values.insert(values.end(), v.begin(), v.end());
  }
  body_->set_support(static_cast<std::int64_t>(nodes.size()), nodes.data(), 0, mask, values.data());
  return *this;
}

SectionBody& SectionBody::contact(std::int32_t tag) {
  body_->set_contact_faces(1, &tag);
  return *this;
}

SectionBody& SectionBody::turn_about_y() {
  const double origin[] = {0, 0, 0}, axis[] = {0, 1, 0};
  body_->revolve(origin, axis);
  return *this;
}

SectionBody& SectionBody::draw_along_x(double period) {
  const double origin[] = {0, 0, 0}, direction[] = {1, 0, 0};
  body_->extrude(origin, direction, period);
  return *this;
}

Vec3 SectionBody::displacement(const Vec3& x) const {
  const std::size_t k = 3 * surfaces::at(surfaces::node_at(surface(), x));
  const auto& u = body_->own().displacement;
  return {u[k], u[k + 1], u[k + 2]};
}

}  // namespace rollcon::sections
