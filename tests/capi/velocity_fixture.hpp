#pragma once
/// Sets velocities through the public interface.

#include "fixture.hpp"
#include "space.hpp"

namespace capi_test {

inline constexpr Vector none{};

inline std::int32_t move(rollcon_contact* c, std::int32_t which, const Vector& v, const Vector& omega,
                         const Vector& at) {
  return rollcon_contact_set_velocity(c, which, v.data(), omega.data(), at.data());
}

inline Vector creep_of(rollcon_contact* c) {
  Vector creep{};
  EXPECT_OK(rollcon_contact_get_motion(c, nullptr, creep.data()));
  return creep;
}

inline std::vector<double> field_of(rollcon_contact* c, std::int32_t field, std::int32_t axes = ROLLCON_LOCAL) {
  std::int64_t n = 0;
  EXPECT_OK(rollcon_contact_get_field(c, field, axes, 0, nullptr, &n));
  std::vector<double> v(static_cast<std::size_t>(n));
  EXPECT_OK(rollcon_contact_get_field(c, field, axes, n, v.data(), nullptr));
  return v;
}

inline double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  EXPECT_EQ(a.size(), b.size());
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
  return worst;
}

}  // namespace capi_test
