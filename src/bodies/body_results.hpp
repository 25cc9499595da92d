#pragma once
/// What a prepared body can tell: statics under its own loads and supports, without any contact.

#include <cstdint>
#include <vector>

#include "bodies/body.hpp"

namespace rollcon {

/// u[3 * node + c] of every node, in the body's axes; zero without loads and for rigid bodies. err_capacity (in nodes)
/// when too small; err_state before prepare, and for half-spaces.
void body_displacements(const Body& body, std::int64_t capacity, double* u);

/// Force of the supports on the body and its moment about the origin, in the body's axes: integrals of the tractions on
/// held components less what was prescribed there. err_state as above.
void body_reaction(const Body& body, Vec3& force, Vec3& moment);

/// Displacements u[3 * node + c] of all nodes of a body, in its axes; null: those of body_displacements().
struct NodalDisplacements {
  std::int64_t nodes = 0;
  const double* u = nullptr;
};

// Stresses of finite-element bodies under such displacements, and of boundary-element bodies under their own loads
// alone; 11, 22, 33, 12, 13, 23 in the body's axes. err_unsupported: another kind, or displacements of boundary
// elements, from which no stresses follow; err_state: not prepared; err_argument: not as many nodes as the body has, or
// stresses overflow; err_nonfinite.

/// Smoothed, stress[6 * node + c]; see BodyFields.
void body_node_stresses(const Body& body, const NodalDisplacements& given, double* stress);
std::int64_t body_stress_points(const Body& body);
/// Stresses and places of the body_stress_points() integration points. Both may be null.
void body_point_stresses(const Body& body, const NodalDisplacements& given, double* stress, double* xyz);
/// Displacements and smoothed stresses at any points; both may be null. err_argument: a point is outside.
void body_fields_at(const Body& body, const NodalDisplacements& given, std::int64_t n, const double* xyz,
                    double* displacement, double* stress);

// Fields under tractions of a contact (Compliance::everywhere) and the body's own loads.

std::vector<double> body_displacements(const Body& body, SurfaceState state);
void body_fields_at(const Body& body, SurfaceState state, std::int64_t n, const double* xyz, double* displacement,
                    double* stress);
void write_body(const Body& body, SurfaceState state, const char* path);

/// Elements with displacements, smoothed stresses and von Mises's stress at the nodes, as a VTU file. err_io.
void write_body(const Body& body, const NodalDisplacements& given, const char* path);

/// A number about the prepared body by name; 0 for bodies without equations. err_option: unknown name.
double body_statistic(const Body& body, const char* name);
std::int64_t body_statistic_count();
const char* body_statistic_name(std::int64_t i);

}  // namespace rollcon
