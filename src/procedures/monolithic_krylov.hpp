#pragma once
/// GMRES on the monolithic system after its trivial pivots, with a choice of preconditioners.

#include "linalg/gmres.hpp"
#include "linalg/kept_lu.hpp"
#include "procedures/monolithic_core.hpp"
#include "procedures/monolithic_lu.hpp"

namespace rollcon {

/// Products with the core's matrix, without its entries.
class CoreProduct final : public LinearOperator {
 public:
  void take(const MonolithicCore& core) { core_ = &core; }
  void apply(const double* x, double* y) override;
  std::size_t bytes() const { return sizeof(double) * (t_.capacity() + u_.capacity()); }

 private:
  const MonolithicCore* core_ = nullptr;
  std::vector<double> t_, u_;
};

/// Every unknown from its own equation, divided by its entry there or by that one's sign alone.
class CoreDiagonal final : public LinearOperator {
 public:
  void take(const MonolithicCore& core, bool divide);
  void apply(const double* x, double* y) override;

 private:
  std::vector<std::int64_t> row_;
  std::vector<double> factor_;
};

/// The bodies' matrices factorised once; contact equations with the compliance of half-spaces of
/// the pair's modulus in place of the bodies' own, factorised in single precision and kept as long
/// as they serve:
///
///   c = S^-1 r_contact,   d = K^-1 (r_bodies + B c)
class CoreBodies final : public LinearOperator {
 public:
  explicit CoreBodies(MonolithicBodies& bodies) : bodies_(bodies) {}
  /// fresh: factorise S of this step; else it is that of an earlier one, if there is any. False: S
  /// is singular to single precision.
  bool take(const MonolithicCore& core, const Frame& frame, bool fresh);
  void apply(const double* x, double* y) override;
  bool valid() const { return contact_.valid(); }
  std::size_t bytes() const { return contact_.bytes() + matrix_.capacity() * sizeof(double); }

 private:
  void fill(const Frame& frame);

  MonolithicBodies& bodies_;
  const MonolithicCore* core_ = nullptr;
  KeptLu contact_;
  std::vector<std::int64_t> key_;
  std::vector<double> matrix_, t_, forces_, still_;
};

/// Factors of an earlier step, of the whole system.
class KeptFactors final : public LinearOperator {
 public:
  explicit KeptFactors(MonolithicLu& lu) : lu_(lu) {}
  void apply(const double* x, double* y) override { lu_.solve(x, y); }

 private:
  MonolithicLu& lu_;
};

}  // namespace rollcon
