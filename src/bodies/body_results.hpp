#pragma once
/// Tells the statics of a prepared body under its own loads and supports, without any contact.

#include <cstdint>
#include <vector>

#include "bodies/body.hpp"
#include "support/statistic_info.hpp"

namespace rollcon {

/// Returns displacements u[3 * node + c] of every node, in the body's axes; zero without loads and for rigid bodies.
/// err_capacity (in nodes): too small; err_state: not prepared, or a half-space.
void body_displacements(const Body& body, std::int64_t capacity, double* u);

/// Returns the force of the supports on the body and its moment about the origin, in the body's axes: integrals of the
/// tractions on held components less what was prescribed there. err_state: not prepared, or a half-space.
void body_reaction(const Body& body, Vec3& force, Vec3& moment);

/// Holds displacements u[3 * node + c] of all nodes of a body, in its axes; null: body_displacements() gives them.
struct NodalDisplacements {
  std::int64_t nodes = 0;
  const double* u = nullptr;
};

// Stresses 11, 22, 33, 12, 13, 23, in the body's axes, belong to such displacements of finite-element bodies or to a
// boundary-element body's own loads alone. err_unsupported: another kind, or displacements of boundary elements, from
// which no stresses follow; err_state: not prepared; err_argument: not as many nodes as the body has, or stresses
// overflow; err_nonfinite.

/// Returns smoothed stresses at the nodes, stress[6 * node + c]; see BodyFields.
void body_node_stresses(const Body& body, const NodalDisplacements& given, double* stress);
std::int64_t body_stress_points(const Body& body);
/// Returns stresses and places of the body_stress_points() integration points. Either may be null.
void body_point_stresses(const Body& body, const NodalDisplacements& given, double* stress, double* xyz);
/// Returns displacements and smoothed stresses at any points; either may be null. err_argument: a point is outside.
void body_fields_at(const Body& body, const NodalDisplacements& given, std::int64_t n, const double* xyz,
                    double* displacement, double* stress);

// A state adds the tractions of a contact (Compliance::everywhere) to the body's own loads.

std::vector<double> body_displacements(const Body& body, SurfaceState state);
void body_fields_at(const Body& body, SurfaceState state, std::int64_t n, const double* xyz, double* displacement,
                    double* stress);
void write_body(const Body& body, SurfaceState state, const char* path);

/// Writes elements with displacements, smoothed stresses and von Mises's stress at the nodes as a VTU file. err_io.
void write_body(const Body& body, const NodalDisplacements& given, const char* path);

/// Writes nodes, elements (null: those of the surface) and fields of them as a VTU file. err_io.
void write_fields(const char* path, const SurfaceMesh& surface, const VolumeElements* volume,
                  const std::vector<double>& u, std::vector<double> stress);

/// Returns a number about the prepared body by name; 0 for bodies without equations. err_option: unknown name.
double body_statistic(const Body& body, const char* name);
const StatisticInfo* body_statistic_info(std::int64_t i);  ///< null beyond the last

}  // namespace rollcon
