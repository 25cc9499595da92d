#pragma once
/// A body: its model and what the caller gave for it. Half-spaces and rigid bodies need no mesh.

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>

#include "support/context.hpp"

namespace rollcon {

enum class BodyKind : std::int32_t { fem = 1, bem = 2, halfspace = 3, rigid = 4 };

class Body {
 public:
  /// Throws Error(err_unsupported) for kinds this build does not have, err_argument for others.
  Body(std::shared_ptr<Context> context, std::int32_t kind);

  /// E > 0, -1 < nu <= 0.5, finite. Not for rigid bodies (err_state). After prepare: err_state.
  void set_elastic(std::int32_t tag, double young, double poisson);
  /// Checks that the body is complete (err_state) and freezes it. Idempotent; contacts in several
  /// threads may call it at the same time. Only a prepared body may be read.
  void prepare();

  BodyKind kind() const { return kind_; }
  bool prepared() const { return prepared_.load(); }
  bool rigid() const { return kind_ == BodyKind::rigid; }
  double young() const { return young_; }
  double poisson() const { return poisson_; }
  Context& context() const { return *context_; }

 private:
  std::shared_ptr<Context> context_;
  BodyKind kind_;
  std::mutex mutex_;  ///< of everything below until prepared
  std::atomic<bool> prepared_{false};
  bool elastic_set_ = false;
  double young_ = 0, poisson_ = 0;
};

}  // namespace rollcon
