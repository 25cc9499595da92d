/// Tests states saved, restored and copied: to the last bit as if nothing had been done in between.

#include <random>

#include "wheel_rail_fixture.hpp"

using namespace rollcon;

namespace {

struct Result {
  Status status;
  std::vector<double> numbers;
  bool operator==(const Result&) const = default;
};

Result result_of(const WheelRail& w, Status status) {
  Result r{status, {}};
  std::array<double, 6> f{};
  w.resultant(false, f.data(), f.data() + 3);
  r.numbers.assign(f.begin(), f.end());
  for (std::int64_t i = 0; const StatisticInfo* s = WheelRail::stat_info(i); ++i) r.numbers.push_back(w.stat(s->name));
  for (std::int64_t p = 0; p < w.patches(); ++p)
    for (std::int64_t i = 0; const StatisticInfo* s = WheelRail::patch_stat_info(i); ++i)
      r.numbers.push_back(w.patch_stat(p, s->name));
  return r;
}

/// Expects equal results, and tells which number differs.
void expect_same(const Result& a, const Result& b, const std::string& where) {
  EXPECT_EQ(a.status, b.status) << where;
  ASSERT_EQ(a.numbers.size(), b.numbers.size()) << where;
  for (std::size_t i = 0; i < a.numbers.size(); ++i)
    EXPECT_EQ(a.numbers[i], b.numbers[i]) << where << ", number " << i << " off by " << b.numbers[i] - a.numbers[i];
}

class state : public wheels {
 protected:
  /// Makes a coarse wheel, which is quick.
  std::unique_ptr<WheelRail> make(std::int32_t side = 1) const {
    auto w = wheels::make(side);
    w->set_real("accuracy", 1);
    return w;
  }
  /// Takes a step of a path that goes from one patch to two.
  static Result step(WheelRail& w, double y) {
    place(w, y);
    const Status status = w.solve();
    return result_of(w, status);
  }
};

}  // namespace

TEST_F(state, derivatives_are_those_of_the_state_gone_back_to) {
  const auto w = make();
  w->prescribe_vertical(2, 10000);
  const auto derivatives = [&] {
    std::array<double, 24> d{};
    for (std::int32_t i = 1; i < 5; ++i) {
      const WheelRail::Derivative of = w->derivative(i);
      std::copy(of.force.begin(), of.force.end(), d.begin() + 6 * (i - 1));
      std::copy(of.moment.begin(), of.moment.end(), d.begin() + 6 * (i - 1) + 3);
    }
    return d;
  };
  step(*w, 1);
  w->snapshot(0);
  const auto right = derivatives();
  step(*w, 3);
  const auto elsewhere = derivatives();
  w->rollback(0);
  const auto here = derivatives();
  double off = 0, most = 0, other = 0;
  for (std::size_t i = 0; i < right.size(); ++i) {
    most = std::max(most, std::abs(right[i]));
    off = std::max(off, std::abs(here[i] - right[i]));
    other = std::max(other, std::abs(elsewhere[i] - right[i]));
  }
  std::printf("gone back to: off by %.1e of the largest (bound 1e-6); elsewhere by %.1e\n", off / most, other / most);
  EXPECT_LT(off, 1e-6 * most);
  EXPECT_GT(other, 1e-3 * most);
}

TEST_F(state, a_rejected_step_leaves_no_trace) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(-1, 6.5);
  const auto never = make(), tried = make();
  for (WheelRail* w : {never.get(), tried.get()}) w->prescribe_vertical(2, 10000);
  int same = 0, steps = 0, several = 0;
  for (const double y : {4.5, 4.8, 5.0, 5.02, 5.02, 5.2, 4.9, 2.0, 2.1, 6.4, 0.3, 5.1}) {
    tried->snapshot(3);
    const std::int64_t patches = steps > 0 ? tried->patches() : 0;
    const Result before = steps > 0 ? result_of(*tried, Status::ok) : Result{};
    for (int k = 0; k < 1 + steps % 3; ++k) step(*tried, anywhere(random));
    const double velocity[6] = {1000, 5, 0, 0, 1e-3, -2.2};
    tried->set_velocity(velocity);
    tried->set_friction(0);
    tried->prescribe_vertical(1, 0);
    tried->set_real("accuracy", steps % 6 == 0 ? 0.01 : 1);
    step(*tried, 1);
    tried->rollback(3);
    if (steps > 0) {
      EXPECT_EQ(tried->patches(), patches);
      expect_same(result_of(*tried, Status::ok), before, "results of the state, step " + std::to_string(steps));
    }
    const Result a = step(*never, y), b = step(*tried, y);
    several += never->patches() > 1;
    expect_same(a, b, "y " + std::to_string(y));
    same += a == b;
    ++steps;
  }
  std::printf("%d of %d steps are the same to the last bit, %d with several patches\n", same, steps, several);
  EXPECT_GT(several, 2);
}

TEST_F(state, copies_go_on_alike) {
  const auto w = make(-1);
  w->prescribe_vertical(2, 10000);
  for (const double y : {-4.6, -5.0}) step(*w, y);
  const auto other = w->copy();
  expect_same(result_of(*w, Status::ok), result_of(*other, Status::ok), "the copy");
  for (const double y : {-5.1, -5.3, -2.0, 1.0}) expect_same(step(*w, y), step(*other, y), "y " + std::to_string(y));
  const auto unused = make()->copy();
  EXPECT_EQ(unused->solve(), Status::no_contact) << "z of the position is 0 there";
}

TEST_F(state, after_a_reset_nothing_is_left_of_what_was) {
  const auto used = make();
  used->prescribe_vertical(2, 10000);
  for (const double y : {0.5, 5.0, 6.4, 5.1}) step(*used, y);
  used->set_real("accuracy", 0.01);
  step(*used, 1);
  used->set_real("accuracy", 1);
  for (const double y : {2.0, 5.0, 6.3}) {
    const auto fresh = make();
    fresh->prescribe_vertical(2, 10000);
    used->reset();
    Result a = step(*fresh, y), b = step(*used, y);
    // Counters go on, so they are left out.
    for (Result* r : {&a, &b}) r->numbers[9] = r->numbers[10] = 0;
    expect_same(a, b, "y " + std::to_string(y));
  }
}

TEST_F(state, what_cannot_be_restored_is_told) {
  const auto w = make();
  refused([&] { w->rollback(0); }, Status::err_state, {"nothing was saved at place 0"});
  refused([&] { w->snapshot(16); }, Status::err_argument, {"place is 16", "0 to 15"});
  refused([&] { w->rollback(-1); }, Status::err_argument, {"place is -1"});
  w->snapshot(15);
  w->rollback(15);
  w->set_track(1436, 14, 0.025);
  refused([&] { w->rollback(15); }, Status::err_state, {"other dimensions"});
}

// Bodies have other profiles after a solve: worn ones that stand 0.2 mm beside and a little more inclined.
TEST_F(state, profiles_that_are_given_later_count) {
  for (const bool of_wheel : {true, false}) {
    const auto w = make();
    w->prescribe_vertical(2, 10000);
    const Result before = step(*w, 2);
    w->snapshot(0);
    Body& body = of_wheel ? *wheel : *rail;
    const auto points = body.profile()->points();
    std::vector<double> worn;
    for (const Vec2& x : points) worn.insert(worn.end(), {x[0], x[1] + 2e-3 * x[0]});
    body.set_profile(static_cast<std::int64_t>(points.size()), worn.data(), 0);
    refused([&] { w->derivative(1); }, Status::err_state, {"no solution yet"});
    refused([&] { w->rollback(0); }, Status::err_state, {"other bodies"});
    const auto copied = w->copy();
    copied->prescribe_vertical(2, 10000);
    const auto fresh = make();
    fresh->prescribe_vertical(2, 10000);
    Result a = step(*fresh, 2), b = step(*w, 2), c = step(*copied, 2);
    for (Result* r : {&a, &b, &c}) r->numbers[9] = r->numbers[10] = 0;
    expect_same(a, b, of_wheel ? "wheel" : "rail");
    expect_same(a, c, "copy");
    EXPECT_GT(std::abs(a.numbers[1] / before.numbers[1] - 1), 1e-3) << "the profiles differ too little to tell";
    SetUp();
  }
}
