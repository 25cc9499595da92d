#pragma once
/// Sum of compliances on one frame: the two bodies of a pair.

#include <memory>
#include <vector>

#include "bodies/model/compliance.hpp"

namespace rollcon {

class SumCompliance final : public Compliance {
 public:
  explicit SumCompliance(std::vector<std::unique_ptr<Compliance>> parts);

  std::int64_t nodes() const override;
  bool couples() const override;
  void block(Points points, const ComplianceBlock& out) const override;
  void apply(Points points, const double* traction, double* displacement) const override;
  bool offset(Points points, double* u) const override;
  bool expand(Points points, ExpandedCompliance& out) const override;
  std::string description() const override;
  void set_threads(int threads) override;
  std::int64_t kernel_evaluations() const override;
  std::size_t bytes() const override;

 private:
  std::vector<std::unique_ptr<Compliance>> parts_;  ///< at least one
};

}  // namespace rollcon
