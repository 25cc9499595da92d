#include "bodies/missed_nodes.hpp"

#include <algorithm>
#include <string>

#include "support/error.hpp"

namespace rollcon {
namespace {

/// Counts nodes of one kind, and keeps the first few.
struct Listed {
  long long count = 0;
  std::string first;

  void add(long long id) {
    constexpr long long named = 5;
    if (count < named) first += (count == 0 ? "" : ", ") + std::to_string(id);
    if (count++ == named) first += ", ...";
  }
  std::string text(const char* what) const {
    if (count == 0) return {};
    return "; " + std::to_string(count) + " such node(s) " + what + ": " + first;
  }
};

}  // namespace

std::optional<SurfacePoint> meet_contact_faces(const Frame& frame, std::size_t k, const Vec3& n, const Body& body,
                                               const Pose& pose, int which) {
  const Vec3 direction = pose.turn_back(n);
  const Vec3 facing = which == 0 ? direction : -1.0 * direction;
  return look_aside(pose.to_body(frame.mesh.node[k]), direction, element_size(frame, k),
                    [&](const Vec3& from) { return body.search().along(from, direction, facing); });
}

std::string MissedNodes::off_profile() const {
  Listed off;
  for (const auto& [k, n] : missed_) off.add(static_cast<long long>(k) + frame_.mesh.index_base);
  return ": they are beyond its ends, or beside the body; such nodes: " + off.first;
}

std::string MissedNodes::off_faces() const {
  const SurfaceSearch everything(body_.mesh().surface, {});
  Listed behind, other, beyond;
  for (const auto& [k, n] : missed_) {
    const Vec3 from = pose_.to_body(frame_.mesh.node[k]), direction = pose_.turn_back(n);
    const Vec3 facing = which_ == 0 ? direction : -1.0 * direction;
    const long long id = static_cast<long long>(k) + frame_.mesh.index_base;
    // Through a closed body every line meets faces that look either way.
    if (body_.search().along(from, direction, {}))
      behind.add(id);
    else
      (everything.along(from, direction, facing) ? other : beyond).add(id);
  }
  return beyond.text("beyond the edge of the body, whose contact faces the frame outgrows") +
         other.text("over faces that are held, loaded or not among rollcon_body_set_contact_faces") +
         behind.text("meet a contact face from behind (the normal of the axes must point out of body 1, into body 2)");
}

void MissedNodes::fail_if_any() const {
  if (missed_.empty()) return;
  const auto used = std::count(frame_.used.begin(), frame_.used.end(), std::uint8_t{1});
  fail(Status::err_mesh,
       "%lld of the %lld nodes of the frame (counting from %d) do not lie over the %s of body %d, along the normal "
       "there%s; check frame, axes and poses",
       static_cast<long long>(missed_.size()), static_cast<long long>(used), frame_.mesh.index_base,
       body_.meshed() ? "contact faces" : "profile", which_ + 1,
       (body_.meshed() ? off_faces() : off_profile()).c_str());
}

}  // namespace rollcon
