#pragma once
/// The prepared bodies of a context by their content: of several equal ones, one is assembled, factorised and kept.
/// (Poses do not count: they are the contacts'.) A body that nobody holds any more is forgotten.

#include <functional>
#include <map>
#include <memory>
#include <mutex>

#include "bodies/body_model.hpp"

namespace rollcon {

class EqualBodies {
 public:
  /// The model of an equal body, if there is one that `serves` accepts; else the given one, after make() has prepared
  /// it. Threads that bring equal models wait for each other. What make() throws is passed on, and the next one tries
  /// by itself.
  std::shared_ptr<BodyModel> share(
      std::shared_ptr<BodyModel> model, const std::function<void(BodyModel&)>& make,
      const std::function<bool(const BodyModel&)>& serves = [](const BodyModel&) { return true; });

 private:
  struct Slot {
    std::mutex turn;
    std::weak_ptr<BodyModel> model;
  };
  std::shared_ptr<Slot> slot_of(const BodyModel& model);

  std::mutex mutex_;
  std::map<ContentDigest, std::shared_ptr<Slot>> slot_;
  std::size_t clean_at_ = 16;
};

}  // namespace rollcon
