// Tests images of tractions under operators that are not formed: those that were asked for are made, and no others
// unless they come from the same transforms.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>

#include "contact/problem/problem.hpp"

namespace rollcon {
namespace {

/// Notes which images it was asked for.
class Noting final : public Operators {
 public:
  mutable std::array<int, 3> asked{};
  void images(Components wanted, Components, std::span<const std::int32_t>, const std::vector<double> (&)[3],
              std::vector<double> (&)[3]) const override {
    ++calls_;
    for (int r = wanted.first; r <= wanted.last; ++r) ++asked[static_cast<std::size_t>(r)];
  }
  bool all_at_once() const override { return true; }
  double own(int, int, std::size_t) const override { return 1; }
  double slip_norm(int, std::size_t) const override { return 1; }
  std::size_t bytes() const override { return 0; }
  std::int64_t applications() const override { return calls_; }

 private:
  mutable std::int64_t calls_ = 0;
};

struct Images {
  std::shared_ptr<Noting> field = std::make_shared<Noting>();
  Problem problem;
  Iterate iterate;

  Images(bool coupled, bool tangential) {
    problem.nodes = field->nodes = 4;
    field->coupled = coupled;
    field->normal = true;
    field->tangential = tangential;
    problem.op = field;
    iterate.resize(4);
    iterate.invalidate();
  }
  bool all_valid(const std::vector<std::uint8_t>& valid) const {
    return std::all_of(valid.begin(), valid.end(), [](std::uint8_t v) { return v == 1; });
  }
};

using Asked = std::array<int, 3>;

TEST(images_wanted, without_coupling_gaps_and_slips_are_made_apart) {
  Images s(false, true);
  s.iterate.update_gap(s.problem, 2);
  EXPECT_EQ(s.field->asked, (Asked{0, 0, 1})) << "a gap needs no slips";
  EXPECT_TRUE(s.all_valid(s.iterate.gap_valid));
  EXPECT_FALSE(s.iterate.slip_valid[0]);
  s.iterate.update_gap(s.problem, 1);
  EXPECT_EQ(s.field->applications(), 1) << "it is there";
  s.iterate.update_slip(s.problem, 0);
  EXPECT_EQ(s.field->asked, (Asked{1, 1, 1})) << "slips need no gap";
  EXPECT_TRUE(s.all_valid(s.iterate.slip_valid));
  EXPECT_EQ(s.field->applications(), 2);
}

TEST(images_wanted, with_coupling_one_transform_serves_all) {
  Images s(true, true);
  s.iterate.update_gap(s.problem, 0);
  EXPECT_EQ(s.field->asked, (Asked{1, 1, 1}));
  s.iterate.update_slip(s.problem, 3);
  EXPECT_EQ(s.field->applications(), 1);
}

TEST(images_wanted, without_friction_there_are_no_slips) {
  Images s(true, false);
  s.iterate.update_gap(s.problem, 0);
  EXPECT_EQ(s.field->asked, (Asked{0, 0, 1}));
  EXPECT_FALSE(s.iterate.slip_valid[0]);
}

}  // namespace
}  // namespace rollcon
