#pragma once
/// Counts what preparing and solving a contact took.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rollcon {

struct Timings {
  double compliance = 0, convection = 0, newton = 0, linear = 0, total = 0;
};

/// Counts how often each part of a preparation was made in the contact's life.
struct Builds {
  std::int64_t bodies = 0;       ///< bodies prepared by this contact
  std::int64_t frames = 0;       ///< frames with weights, axes and normals
  std::int64_t compliances = 0;  ///< compliances of the pair
  std::int64_t stencils = 0;     ///< stencils of the convective scheme
  std::int64_t gaps = 0, frictions = 0, slips = 0, scales = 0;
  std::int64_t operators = 0;  ///< assemblies of the whole operators
};

/// Holds what the last solve took.
struct Effort {
  Timings timings;
  Builds builds_before;                     ///< builds when it began
  std::vector<double> history;              ///< rows of 8, see Contact::history()
  std::vector<double> merit;                ///< error function of each row
  std::int64_t unknowns = 0, nonzeros = 0;  ///< size of the last linear system
  std::int64_t linear_iterations = 0, factorizations = 0, right_sides = 0;
  std::size_t peak_bytes = 0;  ///< greatest number of bytes since the contact was made
  int threads = 1;             ///< threads that the BLAS had

  /// Forgets times and iteration log; keeps their storage.
  void begin() {
    timings = {};
    history.clear();
    merit.clear();
  }
};

}  // namespace rollcon
