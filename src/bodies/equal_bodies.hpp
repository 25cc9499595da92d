#pragma once
/// Finds the prepared bodies of a context by their content: only one of several equal ones is assembled, factorised and
/// kept. (Poses do not count: they belong to contacts.) Bodies that differ in their loads alone have the equations of
/// the first. A body that nobody holds any more is forgotten.

#include <functional>
#include <map>
#include <memory>
#include <mutex>

#include "bodies/body_model.hpp"

namespace rollcon {

class EqualBodies {
 public:
  /// Returns the model of an equal body, if there is one that `serves` accepts; else the given one, after make() has
  /// prepared it. Threads that bring equal models wait for each other. What make() throws is passed on, and the next
  /// thread tries by itself.
  std::shared_ptr<BodyModel> share(
      std::shared_ptr<BodyModel> model, const std::function<void(BodyModel&)>& make,
      const std::function<bool(const BodyModel&)>& serves = [](const BodyModel&) { return true; });
  /// Calls make with a prepared body that differs in its loads at most, or with null, after which this one serves
  /// others. Threads that bring models with such equations wait for each other.
  void share_equations(const std::shared_ptr<BodyModel>& model,
                       const std::function<void(BodyModel&, std::shared_ptr<BodyModel>)>& make);

 private:
  struct Slot {
    std::mutex turn;
    std::weak_ptr<BodyModel> model;
  };
  using Slots = std::map<ContentDigest, std::shared_ptr<Slot>>;
  std::shared_ptr<Slot> slot_of(const ContentDigest& digest, Slots& slots);

  std::mutex mutex_;
  Slots slot_, equations_;
  std::size_t clean_at_ = 16;
};

}  // namespace rollcon
