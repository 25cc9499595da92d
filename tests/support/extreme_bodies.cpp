#include "support/extreme_bodies.hpp"

#include <algorithm>
#include <cmath>

#include "support/frames.hpp"

namespace rollcon::extremes {
namespace {

using scenes::Elastic;
using scenes::MeshedBody;

std::size_t at(std::int64_t i) {
  return static_cast<std::size_t>(i);
}

Elastic elastic(double young, double poisson) {
  return {.shear = young / (2 * (1 + poisson)), .poisson = poisson};
}

}  // namespace

MeshedBody make_block(const BlockShape& s) {
  surfaces::Block block;
  for (std::size_t c = 0; c < 3; ++c) {
    const double low = c == 2 ? -s.half[2] : -s.half[c], high = c == 2 ? 0 : s.half[c];
    if (s.line[c].empty()) {
      block.line[c] = frames::uniform_lines(low, high, s.n[c]);
    } else {
      for (const double t : s.line[c]) block.line[c].push_back(t == 1 ? high : low + 0.5 * (t + 1) * (high - low));
    }
  }
  const auto map = [shear = s.shear](const Vec3& x) {
    return Vec3{x[0] + shear[0] * x[2] + shear[2] * x[1], x[1] + shear[1] * x[2], x[2]};
  };
  MeshedBody body;
  if (s.model == Model::fem) {
    volumes::Mesh mesh = volumes::block(block, s.cell);
    if (s.distort > 0) mesh = volumes::distort(std::move(mesh), s.distort, s.seed);
    body = scenes::meshed(volumes::transform(std::move(mesh), map), elastic(s.young, s.poisson));
  } else {
    SurfaceMesh mesh = surfaces::block(block, s.face);
    if (s.distort > 0) mesh = surfaces::distort(std::move(mesh), s.distort, s.seed);
    body = scenes::meshed(surfaces::transform(std::move(mesh), map), elastic(s.young, s.poisson));
  }
  body.held_tag = s.held;
  body.contact_tag = {6};
  return body;
}

SurfaceMesh top_of(const MeshedBody& body, int which, std::int32_t tag) {
  SurfaceMesh top;
  top.offset.push_back(0);
  std::vector<std::int32_t> number(at(body.mesh.nodes()), -1);
  for (const std::int64_t e : surfaces::elements_with_tag(body.mesh, tag))
    for (const std::int32_t k : body.mesh.element(e)) number[at(k)] = 0;
  for (std::size_t k = 0; k < number.size(); ++k)
    if (number[k] == 0) {
      number[k] = static_cast<std::int32_t>(top.nodes());
      const Vec3& x = body.mesh.node[k];
      top.node.push_back(which == 1 ? x : Vec3{x[0], -x[1], -x[2]});
    }
  for (const std::int64_t e : surfaces::elements_with_tag(body.mesh, tag)) {
    for (const std::int32_t k : body.mesh.element(e)) top.connectivity.push_back(number[at(k)]);
    top.type.push_back(body.mesh.type[at(e)]);
    top.tag.push_back(tag);
    top.offset.push_back(static_cast<std::int64_t>(top.connectivity.size()));
  }
  return which == 1 ? top : surfaces::turn_inside_out(std::move(top));
}

bool equal_cells(const SurfaceMesh& mesh) {
  const auto edge = [&](std::int64_t e, std::size_t a, std::size_t b) {
    const auto n = mesh.element(e);
    return mesh.node[static_cast<std::size_t>(n[b])] - mesh.node[static_cast<std::size_t>(n[a])];
  };
  const Vec3 u = edge(0, 0, 1), v = edge(0, 1, 2);
  constexpr double tolerance = 1e-9;
  const double size = length(u) + length(v);
  if (mesh.nodes() < 9 || std::abs(dot(u, v)) > tolerance * size * size) return false;
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    if (mesh.type[static_cast<std::size_t>(e)] != ElementType::quad4) return false;
    const Vec3 a = edge(e, 0, 1), b = edge(e, 3, 2), c = edge(e, 1, 2), f = edge(e, 0, 3);
    if (length(a - b) + length(c - f) > tolerance * size) return false;
    const double along = std::min(length(a - u), length(a + u)), turned = std::min(length(a - v), length(a + v));
    if (std::min(along, turned) > tolerance * size) return false;
  }
  return true;
}

void turn_body_2(scenes::RollingPair& pair) {
  pair.pose(2, {{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}}, {0, 0, 0});
}

void give_press(Scene& scene, const Press& press, double e_star) {
  const double radius = press.size / press.strain, curvature = 1 / (2 * radius);
  const auto hertz =
      closed_forms::hertz_from_axes(press.size, press.size, 2 / 3.14159265 * e_star * press.strain, e_star);
  scene.given.quadratic = {curvature, curvature, 0};
  scene.load(hertz.load).friction(press.friction);
  const double saturating = 4 * press.friction * hertz.p0 / e_star;
  scene.creep(press.creep * saturating, -0.5 * press.creep * saturating, 0.2 * press.creep * saturating / press.size);
}

}  // namespace rollcon::extremes
