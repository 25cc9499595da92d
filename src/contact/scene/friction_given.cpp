#include "contact/scene/friction_given.hpp"

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

#include "support/input_checks.hpp"

namespace rollcon {

bool FrictionGiven::set_law(const char* law, std::int32_t n, const double* parameters, std::int32_t index_base) {
  require_pointer(law, "law");
  require_count(n, "n");
  const auto names = law_names();
  const auto named =
      std::find_if(names.begin(), names.end(), [&](const LawName& l) { return !std::strcmp(law, l.name); });
  if (named == names.end()) {
    std::string allowed;
    for (const LawName& l : names) allowed += std::string(allowed.empty() ? "'" : ", '") + l.name + "'";
    fail(Status::err_argument, "law is '%.64s'; allowed: %s", law, allowed.c_str());
  }
  if (n < named->least || n > named->greatest)
    fail(Status::err_argument, "n is %d; '%s' has %s", n, named->name, named->parameters);
  require_pointer(parameters, "parameters");
  const auto count = static_cast<std::size_t>(n);
  if (count == 1)
    require_finite(parameters[0], "mu");
  else
    require_finite(n, 1, parameters, "parameters", index_base);
  const bool same_law = name_ == &*named;
  if (same_law && std::equal(parameters, parameters + n, parameters_.begin(), parameters_.end())) return false;
  GivenFriction made = named->make({parameters, count});
  parameters_.reserve(count);
  parameters_.assign(parameters, parameters + n);
  name_ = &*named;
  law_ = std::move(made.law);
  mu_ = made.mu;
  choose_law();
  return true;
}

bool FrictionGiven::set_coefficient(double mu) {
  return std::exchange(mu_, mu) != mu;
}

void FrictionGiven::scale(const FrictionGiven& of, double factor) {
  mu_ = factor * of.mu_;
  parameters_ = of.parameters_;
  for (double& p : parameters_) p *= factor;
}

// Combines the law with memory and yield; what does not fit is refused before a solve.
void FrictionGiven::choose_law() {
  law_in_use_ = memory_.length > 0 && law_ && law_->falls() ? with_memory(law_, memory_) : law_;
  if (yield_.stress > 0 && (!law_in_use_ || law_in_use_->of_field())) law_in_use_ = with_yield(law_in_use_, yield_);
}

bool FrictionGiven::set_memory(double length, double least_speed) {
  require_finite(length, "length");
  require_finite(least_speed, "least_speed");
  if (length < 0) fail(Status::err_argument, "length is %g; allowed: 0 (none) or more", length);
  if (least_speed < 0) fail(Status::err_argument, "least_speed is %g; allowed: 0 or more", least_speed);
  const FrictionMemory memory{length, length > 0 ? least_speed : 0};
  if (memory_ == memory) return false;
  memory_ = memory;
  choose_law();
  return true;
}

bool FrictionGiven::set_layer(double flexibility, double stress, double hardening) {
  require_finite(flexibility, "flexibility");
  require_finite(stress, "stress");
  require_finite(hardening, "hardening");
  if (flexibility < 0) fail(Status::err_argument, "flexibility is %g; allowed: 0 or more", flexibility);
  if (stress < 0) fail(Status::err_argument, "stress is %g; allowed: 0 (never) or more", stress);
  const LayerYield yield{stress, stress > 0 ? hardening : 0};
  const bool another = std::exchange(layer_, flexibility) != flexibility;
  if (yield_ == yield) return another;
  yield_ = yield;
  choose_law();
  return true;
}

bool FrictionGiven::set_heat(std::int32_t which, double conductivity, double capacity, double temperature) {
  if (which != 1 && which != 2) fail(Status::err_argument, "which is %d; allowed: 1, 2", which);
  require_finite(conductivity, "conductivity");
  require_finite(capacity, "heat_capacity");
  require_finite(temperature, "temperature");
  if (conductivity < 0) fail(Status::err_argument, "conductivity is %g; allowed: 0 or more", conductivity);
  if (capacity < 0) fail(Status::err_argument, "heat_capacity is %g; allowed: 0 or more", capacity);
  const Heat heat{conductivity, capacity, temperature, true};
  Heat& held = heat_[static_cast<std::size_t>(which) - 1];
  if (held == heat) return false;
  held = heat;
  return true;
}

void FrictionGiven::require_consistent(const char* handle) const {
  if (memory_.length > 0 && !(law_ && law_->falls()))
    fail(Status::err_state,
         "a length of slip was given (%s_set_friction_memory), but this law does not fall with the slip "
         "speed; allowed: 'linear', 'rational', 'exponential', or a length of 0",
         handle);
  if (yield_.stress > 0 && law_ && !law_->of_field() && !(law_->falls() && memory_.length > 0))
    fail(Status::err_unsupported,
         "a layer that flows (%s_set_layer) is not there for this law; allowed: 'coulomb', "
         "'temperature', or a law that falls with a memory (%s_set_friction_memory)",
         handle, handle);
}

}  // namespace rollcon
