#pragma once
#include <string>
#include <vector>

#include "handles.hpp"
#include "inputs.hpp"

namespace cntc {

/// Makes a profile the surface of a half-space: y to the right (the flange of a wheel at smaller y), z down, in mm. A
/// profile that varies has several slices; length and points are those of the slice nearest to 0.
class Profile {
 public:
  /// Reads and checks the profile; throws Failure with -32. turned_over: z counts upwards then, as a roller's does that
  /// is revolved about an axis below.
  void make(rollcon_context* context, const ProfileInput& input, const Material& material, bool turned_over = false);

  rollcon_body* body() const { return body_.get(); }
  bool varies() const { return varies_; }
  double length() const { return length_; }
  void at(double s, double& y, double& z, double& slope) const;

 private:
  void read(rollcon_context* context, const ProfileInput& input, double unit, int mirror);
  bool upside_down(bool wheel) const;

  BodyHandle body_;
  double length_ = 0;
  bool varies_ = false;
};

}  // namespace cntc
