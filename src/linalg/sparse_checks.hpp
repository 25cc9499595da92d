#pragma once
/// Checks what sparse factorisations demand of their matrix and of the machine, and judges their results.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "linalg/sparse_factor.hpp"

namespace rollcon {

/// A matrix counts as singular beyond this condition: no digit of a solution can be trusted. The stiffness of a body
/// that is not held comes out at 1e15 and more.
constexpr double singular_condition = 1e15;

/// Throws Error(err_nonfinite) at an entry that is not finite, Error(err_internal) at columns that do not start with
/// their diagonal and at condensed unknowns out of range or listed twice.
void check_sparse(const SparseMatrix& matrix, std::span<const std::int64_t> condensed);

/// Throws Error(err_memory) when a factorisation needs more than this process may have; `held` is what it has already
/// of these bytes.
void require_memory(std::int64_t unknowns, double bytes, double held = 0);
/// Throws Error(err_memory) after an allocation has failed; `bytes` is the need, 0: not known.
[[noreturn]] void out_of_memory(std::int64_t unknowns, double bytes);

/// Returns 1 / sqrt |diagonal|, and 1 where that is zero.
std::vector<double> diagonal_scale(const SparseMatrix& matrix);

/// Estimates the condition of the matrix scaled to a unit diagonal: its row-sum norm times the 2-norm of the inverse
/// from two steps of inverse iteration. The estimate is at most the true value in these norms, close to it when the
/// matrix is nearly singular, and infinite when something is not finite.
double estimate_condition(const SparseMatrix& matrix, const std::function<void(double*)>& solve);

}  // namespace rollcon
