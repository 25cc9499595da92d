#pragma once
/// Generated from bindings/api.toml by bindings/generate.py; do not edit.

#include <cstdint>

#include "build_info.hpp"

namespace rollcon::capi {

// clang-format off
struct Feature { const char* name; bool built; };

constexpr Feature feature_table[] = {
    {"halfspace", true},
    {"rigid", true},
    {"fem", ROLLCON_BUILD_FEM != 0},
    {"bem", ROLLCON_BUILD_BEM != 0},
    {"procedures", ROLLCON_BUILD_PROCEDURES != 0},
    {"cholmod", ROLLCON_BUILD_CHOLMOD != 0},
    {"mumps", ROLLCON_BUILD_MUMPS != 0},
    {"umfpack", ROLLCON_BUILD_UMFPACK != 0},
    {"fftw", ROLLCON_BUILD_FFTW != 0},
    {"hmat", ROLLCON_BUILD_HMAT != 0},
    {"openmp", ROLLCON_BUILD_OPENMP != 0},
    {"mpi", ROLLCON_BUILD_MPI != 0},
    {"vtu", ROLLCON_BUILD_VTU != 0},
};

struct StatusText { std::int32_t status; const char* text; };

constexpr StatusText status_table[] = {
    {0, "success"},
    {1, "iteration limit reached; the best iterate is kept"},
    {2, "the bodies do not touch; tractions are zero"},
    {3, "stopped by the progress callback or by a cancel request"},
    {4, "the contact reaches the rim of the frame (a body's own edge does not count) or the end of a profile: caveat and plan say what to mend"},
    {5, "too few nodes touch, results may be off by half and more: refine the frame there"},
    {6, "the accuracy asked for (option frame_accuracy) was not reached (statistic error_estimate says which was), or the mesh of a body is too coarse to show what the contact does to it"},
    {7, "the bodies are pressed together as no linear material bears: by more than half of a thickness or radius, with pressures above the modulus of contact, or a wheel by more than a thousandth of its radius; check shapes, heights, load and units"},
    {8, "the wheel is beside its rail, whatever its height; forces are zero"},
    {-1, "NULL, negative count, value out of range, unknown number"},
    {-2, "released, garbage or wrong-kind handle"},
    {-3, "NaN or infinity among the inputs, or among the results"},
    {-4, "node id out of range; degenerate or flipped elements, ..."},
    {-5, "calls in the wrong order, or something is missing"},
    {-6, "unknown name, wrong type or value out of range"},
    {-7, "the caller's array is too small; the need is reported"},
    {-8, "a linear system is singular; a body is not held"},
    {-9, "out of memory or of handles"},
    {-10, "not in this build of the library, or made for another one"},
    {-11, "the object is in use by another call"},
    {-12, "the prescribed forces have no steady solution"},
    {-13, "a file cannot be written or read"},
    {-99, "a defect of rollcon; please report it"},
};
// clang-format on

}  // namespace rollcon::capi
