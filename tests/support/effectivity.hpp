#pragma once
/// Compares error estimates with true errors, on scenes whose solution is known: closed forms, published limits, or the
/// same scene on a frame that is much finer.

#include <cstdint>
#include <string>
#include <vector>

#include "mesh/surface_mesh.hpp"

namespace rollcon::scenes {

struct Judged {
  std::string scene, model, mesh, scheme;
  std::string quantity;  ///< normal force, tangential force, tractions
  std::string against;
  std::int64_t nodes = 0, in_contact = 0;
  std::int32_t status = 0;
  double estimate = 0, error = 0;  ///< relative, both as rollcon's statistics define them
  double solve_seconds = 0, estimate_seconds = 0;

  double effectivity() const { return estimate / error; }
};
using Judgement = std::vector<Judged>;

/// Holds a frame of each kind for a contact of semi-axes a, b, `across` nodes across it.
struct JudgedFrame {
  std::string name;
  SurfaceMesh mesh;
};
JudgedFrame judged_grid(double a, double b, int across, bool triangles = false, bool quadratic = false);
JudgedFrame judged_unstructured(double a, double b, int across);  ///< triangles, nodes at random
JudgedFrame judged_rings(double a, double b,
                         int rings);  ///< triangles fitted to the contact's edge

/// Judges a frictionless circle: the force at given approach, and the L2 norm of the pressure's error.
Judgement judge_hertz(const JudgedFrame& frame);
/// Judges a long strip with `across` nodes in contact, equidistant or graded to its edges.
Judgement judge_carter(int across, bool graded, const char* scheme);
/// Judges cases (a) and (b) of tests/data/steady_rolling_limits.csv, with N x N nodes, or a frame for radius 5.
Judgement judge_steady_rolling(const std::string& which, const JudgedFrame& frame, const char* scheme);
/// Judges nearly full adhesion, longitudinal creepage, lateral creepage, or spin (1, 2, 3) on an ellipse a/b = 2 by
/// Kalker's table.
Judgement judge_linear_theory(int direction, int rings, const char* scheme);
/// Judges a point of the creep curve, with the creepage over that at full slip, by 18 rings.
Judgement judge_creep_curve(double xi, const JudgedFrame& frame, const char* scheme);
/// Returns the semi-axes of the creep curve's contact.
std::vector<double> creep_curve_axes();
/// Judges the paper's sphere on a rigid plane at given tangential force by 18 rings. nodes: 673, 703, 1985, 2745, or
/// the number of rings.
Judgement judge_example3(int nodes, const char* scheme);
/// Judges a creeping ball on a block of finite elements (hex8) or boundary elements (quad8) by the same bodies under a
/// frame of 32 x 32.
Judgement judge_block(bool finite_elements, int across, const char* scheme);

}  // namespace rollcon::scenes
