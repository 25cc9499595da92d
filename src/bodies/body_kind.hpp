#pragma once
/// Lists the models of bodies: a row for each in body_kind.cpp says all that tells it from the others.

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "mesh/surface_check.hpp"

namespace rollcon {

struct BodyModel;
struct Frame;
struct PairOfBodies;
class Compliance;
class SectionReader;
class Condensed;

enum class BodyKind : std::int32_t { fem = 1, bem = 2, halfspace = 3, rigid = 4, section = 5, condensed = 6 };

struct BodyTraits {
  BodyKind kind;
  const char *name, *parts;  ///< words for messages: "finite-element", "finite elements"
  bool meshed = true;        ///< takes nodes and faces
  bool elastic = true;       ///< takes a material, and with a mesh supports and loads
  bool half_space = false;   ///< responds as a half-space of its material does
  bool volume = false;       ///< elements fill the body, and their tags name materials
  bool section = false;      ///< plane elements fill a section, which is carried round or along
  bool given = false;        ///< stiffness or flexibility is given by the caller
  /// Tells whether tags of elements name materials, and faces or edges have tags of their own.
  bool filled() const { return volume || section; }
  SurfaceKind surface = SurfaceKind::open;
  /// Throws err_unsupported in a build without the component; null: always there.
  void (*require_support)() = nullptr;
  /// Makes the body's part of u1 - u2 on a frame; null: rigid.
  std::unique_ptr<Compliance> (*make_compliance)(const Frame& frame, const PairOfBodies& pair, int which,
                                                 double accuracy, int threads) = nullptr;
  /// Makes the equations; null: the body has none.
  std::unique_ptr<Condensed> (*make_response)(BodyModel& model, int threads, SectionReader* saved) = nullptr;
  double worst_condition = 0;  ///< condition beyond which few digits of displacements are left
  bool dense = false;          ///< matrix is dense
  /// Displacement less that of a half-space is smooth between nodes, too.
  bool smooth_difference = false;
  /// Length over thickness from which linear and quadratic elements lose bending.
  double thin_linear = 0, thin_quadratic = 0;
};

std::span<const BodyTraits> all_kinds();
/// Returns "finite-element, ... or half-space": the kinds that deform.
std::string elastic_kinds();
/// Returns null for numbers that are no kind.
const BodyTraits* find_traits(BodyKind kind);
/// Throws err_argument for numbers that are no kind.
const BodyTraits& traits_of(BodyKind kind);

}  // namespace rollcon
