#pragma once
/// What sparse factorisations demand of their matrix and of the machine, and how they judge the result.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "linalg/sparse_factor.hpp"

namespace rollcon {

/// Beyond it a matrix counts as singular: no digit of a solution can be trusted. The stiffness of a body that is not
/// held comes out at 1e15 and more.
constexpr double singular_condition = 1e15;

/// Throws Error(err_nonfinite) at an entry that is not finite, Error(err_internal) at columns that do not start with
/// their diagonal and at condensed unknowns out of range or listed twice.
void check_sparse(const SparseMatrix& matrix, std::span<const std::int64_t> condensed);

/// Throws Error(err_memory) when a factorisation needs more than this process may have. held: what of these bytes it
/// has already.
void require_memory(std::int64_t unknowns, double bytes, double held = 0);
/// Throws Error(err_memory) after an allocation has failed.
[[noreturn]] void out_of_memory(std::int64_t unknowns, double bytes);

/// 1 / sqrt |diagonal|; 1 where that is zero.
std::vector<double> diagonal_scale(const SparseMatrix& matrix);

/// Condition of the matrix scaled to a unit diagonal: its row-sum norm times the 2-norm of the inverse from two steps
/// of inverse iteration. At most the true value in these norms; close to it when the matrix is nearly singular.
/// Infinite when something is not finite.
double estimate_condition(const SparseMatrix& matrix, const std::function<void(double*)>& solve);

}  // namespace rollcon
