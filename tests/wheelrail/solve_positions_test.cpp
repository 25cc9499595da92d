/// Tests lists of positions: the same numbers to the last bit however many threads, in any order, by themselves.

#include "wheelrail/solve_positions.hpp"

#include <cstring>
#include <random>

#include "wheel_rail_fixture.hpp"

using namespace rollcon;

namespace {

class positions : public wheels {
 protected:
  struct List {
    std::vector<std::array<double, 6>> position, velocity;
  };
  struct Found {
    std::vector<std::array<double, position_totals>> total;
    std::vector<std::int32_t> status;
    Status worst = Status::ok;
  };

  static List list() {
    List l;
    for (const double y : {2.0, 5.0, -1.0, 6.4, 5.1, 0.0, 2.0}) {
      l.position.push_back({0, y, 0, 0, 2.4e-3 * y, 0});
      l.velocity.push_back({2000, 0, 0, 0, 0, -4.3459});
    }
    return l;
  }
  static Found solve(WheelRail& w, const List& l) {
    Found f;
    f.total.resize(l.position.size());
    f.status.assign(l.position.size(), 99);
    f.worst = solve_positions(w, {std::ssize(l.position), l.position[0].data(), l.velocity[0].data()},
                              f.total[0].data(), f.status.data());
    return f;
  }
  std::unique_ptr<WheelRail> make() const {
    auto w = wheels::make();
    w->set_real("accuracy", 1);
    w->prescribe_vertical(2, 10000);
    return w;
  }
};

bool same_bits(const std::array<double, position_totals>& a, const std::array<double, position_totals>& b) {
  return std::memcmp(a.data(), b.data(), sizeof a) == 0;
}

}  // namespace

TEST_F(positions, threads_order_and_neighbours_do_not_matter) {
  const auto w = make();
  const List l = list();
  context->set_threads(1);
  const Found one = solve(*w, l);
  EXPECT_EQ(one.worst, Status::ok);
  context->set_threads(3);
  const Found three = solve(*w, l);
  List back = l;
  std::reverse(back.position.begin(), back.position.end());
  const Found turned = solve(*w, back);
  context->set_threads(1);  // more threads may divide sums among them otherwise
  const std::size_t n = l.position.size();
  int same = 0;
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_EQ(one.status[i], 0);
    w->reset();
    w->set_position(l.position[i].data());
    w->solve();
    std::array<double, position_totals> by_itself{};
    w->resultant(false, by_itself.data(), by_itself.data() + 3);
    by_itself[6] = w->stat("z");
    by_itself[7] = w->stat("vertical_force");
    by_itself[8] = w->stat("friction_power");
    for (const auto& other : {three.total[i], turned.total[n - 1 - i], by_itself}) {
      EXPECT_TRUE(same_bits(one.total[i], other)) << i;
      same += same_bits(one.total[i], other);
    }
  }
  EXPECT_TRUE(same_bits(one.total[0], one.total[6])) << "equal positions";
  std::printf("%d of %zu rows are the same to the last bit\n", same, 3 * n);
}

TEST_F(positions, failures_are_told_and_leave_the_others_alone) {
  std::string told;
  context->set_log(
      2, [](std::int32_t, const char* text, void* user) { *static_cast<std::string*>(user) += text; }, &told);
  const auto w = make();
  List l = list();
  l.position[1][1] = 150;
  l.position[2][3] = 3;
  l.velocity[3][0] = 0;
  const Found f = solve(*w, l);
  EXPECT_EQ(f.worst, Status::not_converged);
  EXPECT_EQ(f.status, (std::vector<std::int32_t>{0, -12, -1, -1, 0, 0, 0}));
  for (const std::size_t i : {1, 2, 3}) EXPECT_TRUE(std::isnan(f.total[i][0]));
  EXPECT_FALSE(std::isnan(f.total[4][0]));
  for (const char* words : {"position 1 (counting from 0)", "derailed", "position 2", "-0.5 to 0.5", "forward speed"})
    EXPECT_NE(told.find(words), std::string::npos) << told;
}

TEST_F(positions, the_wheel_stays_as_it_is) {
  const auto w = make();
  ASSERT_EQ(w->solve(), Status::ok);
  double before[3], after[3];
  w->resultant(false, before, nullptr);
  solve(*w, list());
  w->resultant(false, after, nullptr);
  EXPECT_EQ(std::memcmp(before, after, sizeof before), 0);
  WheelRail bare(context, wheel, rail, 1);
  refused([&] { solve(bare, list()); }, Status::err_state, {"set_track"});
  const Found none{};
  EXPECT_EQ(solve_positions(*w, {0, nullptr, nullptr}, nullptr, nullptr), Status::ok);
}
