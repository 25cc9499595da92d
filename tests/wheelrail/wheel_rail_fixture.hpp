#pragma once
/// Makes S1002 on 60E1, canted 1:40, gauge 1435: wheels of the Manchester benchmark; mm, N, s.

#include "manchester.hpp"
#include "support/context.hpp"
#include "support/testing.hpp"
#include "wheelrail/wheel_rail.hpp"

namespace rollcon {

class wheels : public ::testing::Test {
 protected:
  static constexpr double mu = 0.3;

  void SetUp() override {
    for (auto* body : {&wheel, &rail}) {
      *body = std::make_shared<Body>(context, static_cast<std::int32_t>(BodyKind::halfspace));
      (*body)->set_elastic(0, 2 * 82000 * 1.28, 0.28);
    }
    const double unit = 1;
    wheel->set_profile_shape("s1002", 1, &unit);
    rail->set_profile_shape("60e1", 1, &unit);
  }
  std::unique_ptr<WheelRail> make(std::int32_t side = 1) const {
    auto w = std::make_unique<WheelRail>(context, wheel, rail, side);
    w->set_track(1435, 14, std::atan(1.0 / 40));
    w->set_wheelset(1360, -70, 460);
    w->set_friction(mu);
    const double velocity[6] = {2000, 0, 0, 0, 0, -4.3459};
    w->set_velocity(velocity);
    place(*w, 2);
    return w;
  }
  /// Places the wheel on the benchmark's path: yaw of 2.4 mrad for each millimetre.
  static void place(WheelRail& w, double y, double z = 0) {
    const double position[6] = {0, y, z, 0, 2.4e-3 * y, 0};
    w.set_position(position);
  }
  /// Expects the call to be refused with this status, and words of its text.
  template <class Call>
  static void refused(Call call, Status status, std::initializer_list<const char*> words) {
    try {
      call();
      ADD_FAILURE() << "not refused";
    } catch (const Error& e) {
      EXPECT_EQ(e.status(), status);
      for (const char* w : words) EXPECT_NE(std::string(e.what()).find(w), std::string::npos) << e.what();
    }
  }

  std::shared_ptr<Context> context = std::make_shared<Context>();
  std::shared_ptr<Body> wheel, rail;
};

}  // namespace rollcon
