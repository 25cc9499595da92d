#include "mesh/swept_section.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "mesh/box.hpp"
#include "mesh/shape.hpp"
#include "mesh/surface_geometry.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

/// A node counts as in the section's plane when it is nearer to it than this part of the section's size.
constexpr double flat = 1e-9;

long long caller_number(const SurfaceMesh& mesh, std::int64_t i) {
  return static_cast<long long>(i) + mesh.index_base;
}

}  // namespace

SweptSection::SweptSection(const SurfaceMesh& plane, const SectionPath& path) : plane_(plane), path_(path) {
  find_axes();
  orient();
  find_edges();
}

void SweptSection::find_axes() {
  const Vec3& a = path_.axis;
  Vec3 e1{0, 0, 0};
  double reach = 0;
  const auto across = [&](const Vec3& x) {
    const Vec3 d = x - path_.origin;
    return d - dot(d, a) * a;
  };
  for (const Vec3& x : plane_.node) reach = std::max(reach, length(x - path_.origin));
  if (revolved()) {
    double most = 0;
    for (const Vec3& x : plane_.node)
      if (const double r = length(across(x)); r > most) most = r, e1 = (1 / r) * across(x);
    if (!(most > flat * reach))
      fail(Status::err_mesh, "all nodes of the section lie on the axis that it is turned about");
  } else {
    // The first of the body's axes that lies across the line: supports and tractions then count along the body's axes.
    double least = 2;
    for (std::size_t c = 0; c < 3; ++c) {
      Vec3 unit{0, 0, 0};
      unit[c] = 1;
      if (std::abs(a[c]) < least - flat) least = std::abs(a[c]), e1 = normalized(unit - a[c] * a);
    }
  }
  // e1 x along = e2: along is a x e1 about an axis, e2 is e1 x a beside a line.
  start_ = revolved() ? std::array<Vec3, 3>{e1, cross(a, e1), a} : std::array<Vec3, 3>{e1, a, cross(e1, a)};
  for (std::int64_t k = 0; k < plane_.nodes(); ++k) {
    const Vec3 d = plane_.node[at(k)] - path_.origin;
    place_.push_back({dot(d, start_[0]), dot(d, start_[2])});
    const double off = dot(d, start_[1]);
    if (std::abs(off) > flat * reach || (revolved() && place_.back()[0] < -flat * reach))
      fail(Status::err_mesh, "node %lld (counting from %d) does not lie in the %s; it is off by %.6g",
           caller_number(plane_, k), plane_.index_base,
           revolved() ? "half plane of the other nodes that ends at the axis"
                      : "plane through the origin at right angles "
                        "to the direction",
           std::abs(off) > flat * reach ? off : place_.back()[0]);
  }
}

// Elements may run either way round, each by itself.
void SweptSection::orient() {
  std::vector<std::uint8_t> used(plane_.node.size(), 0);
  Shape shape;
  for (std::int64_t e = 0; e < plane_.elements(); ++e) {
    double sign = 0;
    const auto nodes = plane_.element(e);
    for (const ReferencePoint& at_node : reference_nodes(plane_.type[at(e)])) {
      evaluate_shape(plane_.type[at(e)], at_node.xi, at_node.eta, shape);
      double j[4] = {0, 0, 0, 0};
      for (std::size_t a = 0; a < nodes.size(); ++a)
        for (std::size_t c = 0; c < 2; ++c) {
          j[c] += shape.d_xi[a] * place(nodes[a])[c];
          j[2 + c] += shape.d_eta[a] * place(nodes[a])[c];
        }
      const double jacobian = j[0] * j[3] - j[1] * j[2];
      if (sign == 0) sign = jacobian > 0 ? 1 : -1;
      if (!(jacobian * sign > 0))
        fail(Status::err_mesh,
             "element %lld of the section (counting from %d) is degenerate: its area vanishes or turns "
             "over within it",
             caller_number(plane_, e), plane_.index_base);
    }
    for (const std::int32_t k : nodes) used[at(k)] = 1;
    turn_.push_back(sign);
  }
  if (const auto k = std::find(used.begin(), used.end(), 0); k != used.end())
    fail(Status::err_mesh, "node %lld (counting from %d) belongs to no element of the section",
         caller_number(plane_, k - used.begin()), plane_.index_base);
}

void SweptSection::find_edges() {
  std::map<std::pair<std::int32_t, std::int32_t>, std::pair<SectionEdge, int>> found;
  for (std::int64_t e = 0; e < plane_.elements(); ++e) {
    const auto nodes = plane_.element(e);
    const int corners = corner_count(plane_.type[at(e)]);
    for (int s = 0; s < corners; ++s) {
      SectionEdge edge{.element = e, .side = s};
      edge.node[0] = nodes[at(s)];
      edge.node[1] = nodes[at((s + 1) % corners)];
      if (is_quadratic(plane_.type[at(e)])) edge.node[2] = nodes[at(corners + s)];
      if (orientation(e) < 0) std::swap(edge.node[0], edge.node[1]);
      const auto key = std::minmax(edge.node[0], edge.node[1]);
      const auto [entry, first] = found.try_emplace(key, edge, 0);
      if (++entry->second.second > 2 || (!first && entry->second.first.node[2] != edge.node[2]))
        fail(Status::err_mesh,
             "elements %lld and %lld of the section (counting from %d) do not share the side between "
             "nodes %lld and %lld as neighbours do",
             caller_number(plane_, entry->second.first.element), caller_number(plane_, e), plane_.index_base,
             caller_number(plane_, key.first), caller_number(plane_, key.second));
    }
  }
  for (const auto& [key, entry] : found)
    if (entry.second == 1) edge_.push_back(entry.first);
  std::sort(edge_.begin(), edge_.end(), [](const SectionEdge& a, const SectionEdge& b) {
    return a.element != b.element ? a.element < b.element : a.side < b.side;
  });
}

bool SweptSection::meets_axis(const SectionEdge& edge) const {
  const double along = length(plane_.node[at(edge.node[1])] - plane_.node[at(edge.node[0])]);
  return revolved() && std::min(place(edge.node[0])[0], place(edge.node[1])[0]) <= 1e-6 * along;
}

SectionAxes SweptSection::axes(double angle) const {
  if (!revolved()) return {start_[0], start_[1], start_[2]};
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * start_[0] + s * start_[1], c * start_[1] - s * start_[0], start_[2]};
}

Vec3 SweptSection::point(std::int32_t node, double angle) const {
  const SectionAxes here = axes(angle);
  const Vec3 x = path_.origin + place(node)[0] * here.e1 + place(node)[1] * here.e2;
  return revolved() ? x : x + angle * way(0) * here.along;
}

// An extruded body has nodes as far to both sides of the section's place as its section is wide.
void SweptSection::choose_stations(std::int64_t wished, double spacing, double farthest) {
  constexpr double most_faces = 2e5, least = 16;
  const double round = 2 * pi * way(farthest), per_face = quadratic_ ? 2 : 1;
  if (wished > 0) spacing = round / static_cast<double>(wished);
  const Box box = box_of(plane_.node);
  const double reach = revolved() ? round / 2 : std::min(round / 2, std::max(length(box.size()), 20 * spacing));
  const double most = most_faces * per_face / static_cast<double>(chosen_.size()) * round / (2 * reach);
  const double wanted = std::clamp(round / spacing, least, std::max(least, most));
  stations_ = 2 * static_cast<std::int64_t>(std::ceil(wanted / 2));
  if (revolved()) {
    first_ = 0;
    count_ = stations_;
    return;
  }
  const std::int64_t half =
      std::min(stations_ / 2, 2 * static_cast<std::int64_t>(std::ceil(reach / round * wanted / 2)));
  first_ = -half;
  count_ = 2 * half + 1;
}

SurfaceMesh SweptSection::sweep(std::span<const std::size_t> edge, std::int64_t wished) {
  chosen_.assign(edge.begin(), edge.end());
  quadratic_ = edge_[edge[0]].nodes() == 3;
  double whole = 0, farthest = 0;
  std::map<std::int32_t, std::int32_t> number;
  for (const std::size_t i : edge) {
    const SectionEdge& e = edge_[i];
    if ((e.nodes() == 3) != quadratic_)
      fail(Status::err_mesh,
           "the contact part of the section has linear and quadratic elements, such as %lld (counting "
           "from %d): it must have one kind",
           caller_number(plane_, e.element), plane_.index_base);
    for (std::size_t a = 0; a < e.nodes(); ++a)
      number.emplace(e.node[a], 0), farthest = std::max(farthest, place(e.node[a])[0]);
    whole += length(plane_.node[at(e.node[1])] - plane_.node[at(e.node[0])]);
  }
  profile_.clear();
  for (auto& [node, i] : number) i = static_cast<std::int32_t>(profile_.size()), profile_.push_back(node);
  in_profile_.clear();
  for (const std::size_t i : edge) {
    std::array<std::int32_t, 3> in{-1, -1, -1};
    for (std::size_t a = 0; a < edge_[i].nodes(); ++a) in[a] = number.at(edge_[i].node[a]);
    in_profile_.push_back(in);
  }
  // Quadratic faces bend along the way as they do across it; contacts are mostly shorter that way.
  constexpr double closer = 1.5;
  choose_stations(wished, whole / static_cast<double>(edge.size()) / (quadratic_ ? 2 : 1) / closer, farthest);

  SurfaceMesh surface;
  surface.index_base = plane_.index_base;
  const auto width = static_cast<std::int32_t>(profile_.size());
  for (std::int64_t k = 0; k < count_; ++k)
    for (const std::int32_t node : profile_)
      surface.node.push_back(point(node, static_cast<double>(station(k)) * step()));
  const std::int64_t per_face = quadratic_ ? 2 : 1;
  surface.offset = {0};
  for (std::int64_t k = 0; k + (closed() ? 0 : per_face) < count_; k += per_face)
    for (std::size_t i = 0; i < edge.size(); ++i) {
      const std::array<std::int32_t, 3>& in = in_profile_[i];
      const auto id = [&](std::int64_t more, std::size_t a) {
        return static_cast<std::int32_t>((k + more) % count_) * width + in[a];
      };
      const std::int64_t l = per_face;
      if (quadratic_)
        for (const std::int32_t n :
             {id(0, 0), id(l, 0), id(l, 1), id(0, 1), id(1, 0), id(l, 2), id(1, 1), id(0, 2), id(1, 2)})
          surface.connectivity.push_back(n);
      else
        for (const std::int32_t n : {id(0, 0), id(l, 0), id(l, 1), id(0, 1)}) surface.connectivity.push_back(n);
      surface.type.push_back(quadratic_ ? ElementType::quad9 : ElementType::quad4);
      surface.tag.push_back(edge_[edge[i]].tag);
      surface.offset.push_back(static_cast<std::int64_t>(surface.connectivity.size()));
    }
  return surface;
}

}  // namespace rollcon
