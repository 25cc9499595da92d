/// Tests arc lengths and angles along the section of a conformal contact.

#include "mesh/section_line.hpp"

#include "support/testing.hpp"

namespace rollcon {
namespace {

TEST(section_line, circles_and_straight_lines_are_exact) {
  constexpr double radius = 3;
  std::vector<SectionLine::Place> place;
  for (const double angle : {-0.9, -0.5, -0.1, 0.3, 1.0})
    place.push_back({radius * std::sin(angle), radius * (1 - std::cos(angle)), angle});
  const SectionLine circle(place);
  double arc = 0, turned = 0;
  for (double angle = -0.9; angle < 1; angle += 0.01) {
    const SectionLine::Point at = circle.at(radius * std::sin(angle));
    arc = std::max(arc, std::abs(at.arc - radius * (angle + 0.9)));
    turned = std::max(turned, std::abs(at.angle - angle));
  }
  expect_error("circle of five places: arc length", arc, 1e-14 * radius);
  expect_error("circle of five places: angle", turned, 1e-14);
  const SectionLine line({{0, 0, 0.7}, {2, 2 * std::tan(0.7), 0.7}});
  for (const double y : {-1.0, 0.0, 0.5, 2.0, 7.0}) {
    expect_error("straight line: arc length", line.at(y).arc - y / std::cos(0.7), 1e-14);
    expect_error("straight line: angle", line.at(y).angle - 0.7, 1e-15);
  }
}

TEST(section_line, goes_on_straight_beyond_its_ends) {
  const SectionLine one({{1, 0.2, -0.4}});
  expect_error("one place: arc length", one.at(3).arc - 2 / std::cos(0.4), 1e-15);
  expect_error("one place: angle", one.at(-3).angle + 0.4, 0);
}

TEST(section_line, arcs_between_places_of_other_curves_are_of_fourth_order) {
  // A parabola's arc length has a closed form.
  const auto length = [](double y) { return 0.5 * (y * std::hypot(1, y) + std::asinh(y)); };
  double before = 0;
  for (const int n : {8, 16}) {
    std::vector<SectionLine::Place> place;
    for (int i = 0; i <= n; ++i) {
      const double y = 1.5 * i / n;
      place.push_back({y, 0.5 * y * y, std::atan(y)});
    }
    const double error = SectionLine(place).at(1.5).arc - length(1.5);
    if (before != 0) expect_order("parabola: arc length", observed_order(before, error, 2, 1), 3.8);
    before = error;
  }
}

}  // namespace
}  // namespace rollcon
