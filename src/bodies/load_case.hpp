#pragma once
/// A body that differs from another one in its loads and given displacements alone: it has the other's equations.

#include <memory>

#include "bodies/body_model.hpp"

namespace rollcon {

/// Solves for the loads of `loaded`; see SurfaceResponse::solve_loads. base: prepared, with a response.
std::unique_ptr<SurfaceResponse> make_load_case(std::shared_ptr<BodyModel> base, const BodyMesh& loaded, int threads);

}  // namespace rollcon
