#pragma once
/// Makes one linearised step on any pair of bodies, and its solution by condensed formulas: dense compliance,
/// convected, one equation per traction and motion.

#include <memory>
#include <string>
#include <vector>

#include "bodies/model/compliance.hpp"
#include "mesh/frame.hpp"
#include "procedures/step_system.hpp"

namespace rollcon::monolithic_test {

struct Case {
  std::string name;
  std::vector<std::shared_ptr<const void>> keep;
  std::shared_ptr<const Frame> frame;
  std::shared_ptr<const Compliance> compliance;
  Problem problem;  ///< with the dense blocks assembled
  Tangential tangential = Tangential::slip;
  Step step;
  Point z;              ///< tractions and motions of the last iterate; nothing else is filled
  double traction = 1;  ///< size of the tractions
};

struct Motions {
  bool approach_by_force = false, creep_by_force = false;
};

/// Makes a case with gap, loads, states and laws at random, but such that the step has one solution. `length` and
/// `stress` are half the frame's width and Young's modulus; with `dense` it has the condensed blocks.
Case make_case(std::string name, std::shared_ptr<const Frame> frame, std::shared_ptr<const Compliance> compliance,
               Scheme scheme, const Motions& motions, double length, double stress, bool dense = true);
std::shared_ptr<const Frame> square_frame(int n, double length);
/// Makes a square frame of n x n elements on half-spaces: E = 1, Poisson's ratios; below -1: rigid.
Case halfspaces(int n, double poisson1, double poisson2, Scheme scheme, const Motions& motions, double length = 1,
                double stress = 1);
/// Makes two bodies with random equations, one sparse and symmetric, one dense and not symmetric; half of the
/// compliance is direct, if `direct`.
Case random_bodies(int n, bool direct, Scheme scheme, const Motions& motions);

enum class Model { fem, bem, halfspace, rigid };
/// Puts blocks with a fine zone of n x n elements, which is the frame, on top of each other; a body may be a
/// half-space. With `curved`, their tops bulge, and the frame has local triads.
struct MeshedPair {
  Model model[2] = {Model::fem, Model::rigid};
  int n = 4, grade = 1, deep = 2;
  bool curved = false;
  bool own_frame = false;  ///< true for a frame of other elements than the bodies'
  double length = 1, stress = 1;
};
Case meshed(const MeshedPair& pair, Scheme scheme, const Motions& motions);

void make_frictionless(Case& c);
/// Makes the case one of reduced unknowns, with random targets.
void make_reduced(Case& c);

/// Opens a few sliding pairs, lets a few sticking ones slide.
void shift_states(Case& c);

/// Returns what the tractions of z do: slip, depth and, in `shift`, tangential displacements.
Point image_of(const Case& c, Point z);
/// Returns the next iterate from the condensed system.
Point condensed_step(const Case& c);
/// Returns the problem without the dense blocks.
Problem written_out(const Case& c);

/// Returns the largest difference of any field, relative to the field.
double difference(const Case& c, const Point& a, const Point& b);

}  // namespace rollcon::monolithic_test
