#pragma once
/// Prints what validation tests say about scenes.

#include "support/frames.hpp"
#include "support/graded_disc.hpp"
#include "support/hertz_fit.hpp"
#include "support/rolling_errors.hpp"
#include "support/scene.hpp"
#include "support/testing.hpp"

namespace rollcon::validation {

using closed_forms::Carter;
using closed_forms::Elastic;
using closed_forms::Hertz;
using scenes::fit_hertz;
using scenes::FittedEllipse;
using scenes::graded_disc;
using scenes::meshed;
using scenes::MeshedBody;
using scenes::RigidBody;
using scenes::RollingPair;
using scenes::Solution;

/// Takes the faces of a block that hold it, and those that may come into contact.
inline MeshedBody held(MeshedBody body, std::vector<std::int32_t> at, std::vector<std::int32_t> contact = {}) {
  body.held_tag = std::move(at);
  body.contact_tag = std::move(contact);
  return body;
}
template <class Mesh>
MeshedBody held(Mesh mesh, const Elastic& material, std::vector<std::int32_t> at,
                std::vector<std::int32_t> contact = {}) {
  return held(meshed(std::move(mesh), material), std::move(at), std::move(contact));
}

inline void expect_laws_kept(const std::string& what, const RollingPair& pair, double bound,
                             std::initializer_list<const char*> laws = {"law_normal", "law_friction", "law_slip"}) {
  for (const char* law : laws) expect_error(what + law, pair.stat(law), bound);
}

}  // namespace rollcon::validation
