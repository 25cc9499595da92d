#pragma once
/// Solves load cases of a scene that has no frame, each on frames that the library makes for it.

#include <memory>

#include "contact/cases/case_solver.hpp"
#include "contact/contact.hpp"

namespace rollcon {

class OwnFramesSolver final : public CaseSolver {
 public:
  /// Solves cases of `asked`, which has no frame and outlives this object unchanged. err_state: time steps;
  /// err_unsupported: a factor on friction under another law than Coulomb's.
  OwnFramesSolver(const Contact& asked, std::span<const Parameter> parameter);

  void begin_chain() override;
  Status solve(std::span<const Parameter> parameter, const double* value, Monitor& monitor) override;
  void write(const CaseColumn& column, std::span<const Parameter> parameter, const double* value, double* to) override;
  std::size_t bytes() const override;

 private:
  const Contact& asked_;
  std::unique_ptr<Contact> contact_;  ///< worker that solves the present chain
  Status status_ = Status::ok;
};

}  // namespace rollcon
