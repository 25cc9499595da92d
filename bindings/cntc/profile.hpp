#pragma once
#include <string>
#include <vector>

#include "handles.hpp"
#include "inputs.hpp"

namespace cntc {

/// A profile as the surface of a half-space: y to the right (of wheels: the flange at lesser y), z down, in mm.
class Profile {
 public:
  /// Reads and checks it; throws Failure with -32.
  void make(rollcon_context* context, const ProfileInput& input, const Material& material);

  rollcon_body* body() const { return body_.get(); }
  double length() const { return length_; }
  void at(double s, double& y, double& z, double& slope) const;
  /// z at a y, on the lowest branch of a wheel's tread.
  double z_at(double y) const;

 private:
  void read(rollcon_context* context, const ProfileInput& input, double unit, int mirror);
  bool upside_down(bool wheel) const;

  BodyHandle body_;
  double length_ = 0;
};

}  // namespace cntc
