#pragma once
#include <string>
#include <vector>

#include "handles.hpp"
#include "inputs.hpp"

namespace cntc {

/// Makes a profile the surface of a half-space: y to the right (the flange of a wheel at smaller y), z down, in mm.
class Profile {
 public:
  /// Reads and checks the profile; throws Failure with -32.
  void make(rollcon_context* context, const ProfileInput& input, const Material& material);

  rollcon_body* body() const { return body_.get(); }
  double length() const { return length_; }
  void at(double s, double& y, double& z, double& slope) const;
  /// Returns z at a y; for a wheel z of the lowest branch of its tread.
  double z_at(double y) const;

 private:
  void read(rollcon_context* context, const ProfileInput& input, double unit, int mirror);
  bool upside_down(bool wheel) const;

  BodyHandle body_;
  double length_ = 0;
};

}  // namespace cntc
