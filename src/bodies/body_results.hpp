#pragma once
/// What a prepared body can tell: statics under its own loads and supports, without any contact.

#include <cstdint>

#include "bodies/body.hpp"

namespace rollcon {

/// u[3 * node + c] of every node, in the body's axes; zero without loads and for rigid bodies. err_capacity (in nodes)
/// when too small; err_state before prepare, and for half-spaces.
void body_displacements(const Body& body, std::int64_t capacity, double* u);

/// Force of the supports on the body and its moment about the origin, in the body's axes: integrals of the tractions on
/// held components less what was prescribed there. err_state as above.
void body_reaction(const Body& body, Vec3& force, Vec3& moment);

/// A number about the prepared body by name; 0 for bodies without equations. err_option: unknown name.
double body_statistic(const Body& body, const char* name);
std::int64_t body_statistic_count();
const char* body_statistic_name(std::int64_t i);

}  // namespace rollcon
