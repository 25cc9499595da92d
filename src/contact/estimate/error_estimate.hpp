#pragma once
/// Estimates how far the last solution is from that of the continuous problem of the same bodies, by the gap between
/// the nodes, another convective scheme and a coarser frame (docs/theory.md, section 8). It is found when first asked
/// for and kept until the next solve; it changes nothing else.

namespace rollcon {

struct Derived;        // contact/derived.hpp
struct ErrorEstimate;  // contact/derived.hpp
struct Solution;

/// Returns 0 without contact; 1 where nothing can be said: the solve did not converge, or the frame has too few nodes
/// to leave any out.
const ErrorEstimate& find_error_estimate(const Solution& solution, Derived& derived);

}  // namespace rollcon
