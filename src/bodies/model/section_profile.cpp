#include "bodies/model/section_profile.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "geometry/profile_fit.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

/// Lists the nodes of the contact edges from one end of their line to the other.
std::vector<std::int32_t> line_of_nodes(const SweptSection& section) {
  std::map<std::int32_t, std::size_t> begins;
  std::map<std::int32_t, int> ends;
  for (const std::size_t i : section.swept_edges()) {
    begins[section.edges()[i].node[0]] = i;
    ++ends[section.edges()[i].node[1]];
  }
  std::vector<std::int32_t> node;
  for (const auto& [first, i] : begins)
    if (ends[first] == 0) node = {first};
  for (auto next = node.empty() ? begins.end() : begins.find(node[0]); next != begins.end();
       next = begins.find(node.back())) {
    const SectionEdge& edge = section.edges()[next->second];
    if (edge.nodes() == 3) node.push_back(edge.node[2]);
    node.push_back(edge.node[1]);
  }
  if (node.size() != section.profile().size())
    fail(Status::err_mesh,
         "the contact edges of the section are not one line with two ends: name those of the running surface by "
         "rollcon_body_set_contact_faces");
  return node;
}

std::vector<Vec2> points_of(const SweptSection& section) {
  const Vec3& axis = section.path().axis;
  if (const double along = axis[section.revolved() ? 1 : 0]; !(std::abs(std::abs(along) - 1) <= 1e-9))
    fail(Status::err_argument, "the section is %s (%g, %g, %g); allowed for the profile of a wheel or rail: %s",
         section.revolved() ? "revolved about" : "extruded along", axis[0], axis[1], axis[2],
         section.revolved() ? "the y axis, (0, 1, 0)" : "the x axis, (1, 0, 0)");
  std::vector<Vec2> point;
  for (const std::int32_t k : line_of_nodes(section)) {
    const Vec3& x = section.plane().node[at(k)];
    point.push_back({x[1], section.revolved() ? section.place(k)[0] : x[2]});
  }
  if (point.front()[0] > point.back()[0]) std::reverse(point.begin(), point.end());
  return point;
}

ProfileCurve through(const std::vector<Vec2>& point) {
  return profile_through(point, {}, [](std::size_t i) { return "node " + std::to_string(i) + " of the boundary"; });
}

}  // namespace

SectionProfile profile_of(const SweptSection& section) {
  std::vector<Vec2> point = points_of(section);
  SectionProfile profile{through(point)};
  if (!section.revolved()) return profile;
  if (const std::vector<double> middle = profile.curve.at_y(0); !middle.empty())
    profile.radius = profile.curve.at(middle.back()).x[1];
  else
    for (const Vec2& x : point) profile.radius = std::max(profile.radius, x[1]);
  for (Vec2& x : point) x[1] -= profile.radius;
  profile.curve = through(point);
  return profile;
}

}  // namespace rollcon
