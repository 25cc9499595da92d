#pragma once
/// What preparing and solving a contact took.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rollcon {

struct Timings {
  double compliance = 0, convection = 0, newton = 0, linear = 0, total = 0;
};

/// How often each part of a preparation was made since the contact was.
struct Builds {
  std::int64_t bodies = 0;       ///< prepared by this contact
  std::int64_t frames = 0;       ///< weights, axes, normals
  std::int64_t compliances = 0;  ///< of the pair
  std::int64_t stencils = 0;     ///< of the convective scheme
  std::int64_t gaps = 0, frictions = 0, slips = 0, scales = 0;
  std::int64_t operators = 0;  ///< whole assemblies
};

/// What the last solve took.
struct Effort {
  Timings timings;
  Builds builds_before;                     ///< when it began
  std::vector<double> history;              ///< rows of 8, see Contact::history()
  std::vector<double> merit;                ///< error function of each row
  std::int64_t unknowns = 0, nonzeros = 0;  ///< of the last linear system
  std::int64_t linear_iterations = 0, factorizations = 0, right_sides = 0;
  std::size_t peak_bytes = 0;  ///< since the contact was made
  int threads = 1;             ///< that the BLAS had

  /// Forgets times and history; keeps their storage.
  void begin() {
    timings = {};
    history.clear();
    merit.clear();
  }
};

}  // namespace rollcon
