/// Tests splines through points: order of their error, smoothing, kinks, and points that come from measurements.

#include "geometry/profile_fit.hpp"

#include <random>

#include "support/error.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

constexpr double pi = std::numbers::pi;

std::string numbered(std::size_t i) {
  return "point " + std::to_string(i);
}

std::vector<Vec2> circle(double radius, double from, double to, int n) {
  std::vector<Vec2> point;
  for (int i = 0; i < n; ++i) {
    const double a = from + (to - from) * i / (n - 1);
    point.push_back({radius * std::sin(a), -radius * std::cos(a)});
  }
  return point;
}

ProfileFit fit_of(double filter) {
  ProfileFit fit;
  fit.filter_length = filter;
  return fit;
}

ProfileCurve through(const std::vector<Vec2>& point, double filter = 0) {
  return profile_through(point, fit_of(filter), numbered);
}

void expect_refused(const std::vector<Vec2>& point, double filter, const std::string& text) {
  try {
    through(point, filter);
    ADD_FAILURE() << "taken: " << text;
  } catch (const Error& e) {
    EXPECT_EQ(e.status(), Status::err_argument);
    EXPECT_NE(std::string(e.what()).find(text), std::string::npos) << e.what();
  }
}

/// Returns the errors of point and curvature, up to the ends.
std::array<double, 2> errors(const ProfileCurve& curve, double radius) {
  std::array<double, 2> most{0, 0};
  for (int i = 0; i <= 1000; ++i) {
    const ProfilePoint p = curve.at(curve.length() * i / 1000);
    most[0] = std::max(most[0], std::abs(length(p.x) / radius - 1));
    most[1] = std::max(most[1], std::abs(p.curvature() * radius - 1));
  }
  return most;
}

TEST(profile_fit, a_circle_comes_out_with_fourth_and_second_order) {
  const auto coarse = errors(through(circle(5, -2.5, 2.5, 41)), 5), fine = errors(through(circle(5, -2.5, 2.5, 81)), 5);
  expect_error("circle of 81 points: radius", fine[0], 1e-6);
  expect_order("circle: points", observed_order(coarse[0], fine[0], 2, 1), 3.7);
  expect_order("circle: curvature, up to the ends", observed_order(coarse[1], fine[1], 2, 1), 1.8);
  const ProfileCurve curve = through(circle(5, -2.5, 2.5, 81));
  expect_error("circle: length", relative(curve.length(), 25), 1e-6);
  expect_error("circle: speed by arc length", length(curve.at(3.21).d1) - 1, 1e-5);
}

TEST(profile_fit, derivatives_join_between_kinks) {
  std::vector<Vec2> point;
  for (int i = 0; i <= 30; ++i) point.push_back({i + 0.3 * std::sin(i), 3 * std::cos(0.3 * i)});
  const ProfileCurve curve = through(point);
  double jump[3] = {0, 0, 0};
  for (std::size_t i = 0; i + 1 < curve.pieces().size(); ++i) {
    const ProfilePoint a = curve.at(i, curve.pieces()[i].length), b = curve.at(i + 1, 0);
    jump[0] = std::max(jump[0], length(a.x - b.x));
    jump[1] = std::max(jump[1], length(a.d1 - b.d1));
    jump[2] = std::max(jump[2], length(a.d2 - b.d2));
  }
  expect_error("jump of points", jump[0], 1e-13);
  expect_error("jump of tangents", jump[1], 1e-13);
  expect_error("jump of second derivatives", jump[2], 1e-12);
}

TEST(profile_fit, kinks_stay_kinks) {
  std::vector<Vec2> roof;
  for (int i = -20; i <= 20; ++i) roof.push_back({0.5 * i, std::abs(0.5 * i)});
  const ProfileCurve curve = through(roof);
  expect_error("a roof: length", curve.length() - 20 * std::numbers::sqrt2, 1e-12);
  for (const double s : {3.0, 14.0, 14.2, 27.0}) {
    const ProfilePoint p = curve.at(s);
    expect_error("a roof: z", p.x[1] - std::abs(p.x[0]), 1e-13);
    expect_error("a roof: curvature", p.curvature(), 1e-12);
  }
}

TEST(profile_fit, order_doubles_and_zigzags_are_made_right) {
  const std::vector<Vec2> good = circle(5, -1, 1, 101);
  const ProfileCurve curve = through(good);
  std::vector<Vec2> reversed(good.rbegin(), good.rend());
  double off = 0;
  const ProfileCurve turned = through(reversed);
  for (const double s : {0.1, 2.0, 7.0}) off = std::max(off, length(turned.at(s).x - curve.at(s).x));
  expect_error("points in the reverse order", off, 1e-13);

  std::vector<Vec2> doubled = good;
  doubled.insert(doubled.begin() + 50, good[49]);
  doubled.insert(doubled.begin() + 20, good[20] + Vec2{1e-9, -1e-9});
  EXPECT_EQ(through(doubled).pieces().size(), curve.pieces().size());

  std::vector<Vec2> zigzag = good;
  std::swap(zigzag[30], zigzag[31]);
  const ProfileCurve mended = through(zigzag);
  EXPECT_EQ(mended.pieces().size(), curve.pieces().size() - 1);
  expect_error("two points in the wrong order: radius", errors(mended, 5)[0], 1e-4);
}

// An arc, a straight line given by its ends alone, and an arc again occur in drawings and in gaps of measurements.
TEST(profile_fit, distances_that_jump_leave_the_curve_at_its_points) {
  for (const double radius : {13.0, 80.0})
    for (const double line : {1.0, 20.0, 1e3, 1e6})
      for (const bool second_arc : {false, true}) {
        const double last = 0.6;
        std::vector<Vec2> point = circle(radius, 0, last, 101);
        const Vec2 along{std::cos(last), std::sin(last)}, end = point.back() + line * along;
        point.push_back(end);
        if (second_arc)
          for (const Vec2& x : circle(radius, last, 0, 101))
            if (length(x - Vec2{radius * std::sin(last), -radius * std::cos(last)}) > 0)
              point.push_back(end - (x - Vec2{radius * std::sin(last), -radius * std::cos(last)}));
        std::string told;
        const ProfileCurve curve = profile_through(point, {}, numbered, &told);
        const std::string where = std::to_string(radius) + ", " + std::to_string(line);
        const bool jumps = line > 5 * radius * last / 100;
        const double whole = (second_arc ? 2 : 1) * radius * last + line;
        expect_error("arc and line: length " + where, curve.length() / whole - 1, 1e-5);
        double off = 0;
        for (int i = 0; i <= 1000; ++i) {
          const Vec2 x = curve.at(radius * last + line * i / 1000).x - point[100];
          off = std::max(off, std::abs(cross(along, x)));
        }
        expect_error("arc and line: off the line " + where, off / line, jumps ? 1e-6 : 1e-3);
        EXPECT_EQ(told.find("the distances of the profile's points jump fivefold"), jumps ? 0U : told.npos) << told;
      }
  const std::vector<Vec2> even = circle(13, -1, 1, 60);
  EXPECT_EQ(through(even).pieces(), spline_through(even)) << "even distances: one spline";
  // The measured points of a circle have a gap, and random distances besides.
  std::mt19937 random(11);
  std::vector<Vec2> gap;
  for (double a = -1; a < 1; a += 0.002 + 0.03 * std::generate_canonical<double, 53>(random))
    if (std::abs(a) > 0.15) gap.push_back({13 * std::sin(a), -13 * std::cos(a)});
  expect_error("a gap of 0.3 rad: radius", errors(through(gap), 13)[0], 1e-4);
}

// Chords of up to 38 mm leave the parabola by up to 0.6 mm, the curve does not.
TEST(profile_fit, points_drawn_from_a_parabola_lead_back_to_it) {
  std::mt19937 random(9);
  const auto draw = [&](double least, double most) {
    return least + (most - least) * std::generate_canonical<double, 53>(random);
  };
  const auto height = [](double y) { return y * y / 600; };
  double most = 0;
  for (int drawn = 0; drawn < 300; ++drawn) {
    std::vector<double> y(static_cast<std::size_t>(draw(8, 40)));
    for (double& at : y) at = draw(-40, 40);
    std::sort(y.begin(), y.end());
    std::vector<Vec2> point;
    double longest = 0;
    for (const double at : y) {
      point.push_back({at, height(at)});
      longest = std::max(longest, at - point[point.size() - std::min<std::size_t>(point.size(), 2)][0]);
    }
    const ProfileCurve curve = through(point);
    for (int i = 0; i <= 200; ++i) {
      const Vec2 x = curve.at(curve.length() * i / 200).x;
      most = std::max(most, std::abs(x[1] - height(x[0])) / longest);
    }
  }
  expect_error("drawn parabolas: off them, over the longest chord", most, 2e-3);
}

TEST(profile_fit, an_outermost_point_that_turns_back_is_left_out_and_named) {
  const std::vector<Vec2> good = circle(5, -1, 1, 101);
  const ProfileCurve curve = through(good);
  for (const bool last : {false, true}) {
    std::vector<Vec2> wrong = good;
    wrong.insert(last ? wrong.end() : wrong.begin(), (last ? good[99] : good[1]) + Vec2{0, -0.1});
    std::string told;
    EXPECT_EQ(profile_through(wrong, {}, numbered, &told).pieces(), curve.pieces());
    EXPECT_EQ(told, last ? "the profile turns back at its end: point 101 is left out; "
                         : "the profile turns back at its end: point 0 is left out; ");
  }
}

TEST(profile_fit, bad_points_are_named) {
  expect_refused({}, 0, "the profile has 0 point(s); allowed: 2 or more");
  expect_refused({{1, 2}}, 0, "the profile has 1 point(s)");
  expect_refused({{1, 2}, {1, 2}, {1, 2}}, 0, "all 3 points of the profile are one");
  expect_refused({{0, 0}, {1, NAN}, {2, 0}}, 0, "z of point 1 is ");
  expect_refused({{0, 0}, {1e31, 0}, {2, 0}}, 0, "y of point 1 is 1e+31");
  expect_refused({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {2, 1}, {1, 1}, {0, 1}}, 0, "the profile turns back at point 3, y 3");
  expect_refused({{0, 0}, {1, 0}, {2, 0}}, -1, "filter_length is -1; allowed: 0 to the length of the profile, 2");
  expect_refused({{0, 0}, {1, 0}, {2, 0}}, 3, "filter_length is 3");
  expect_refused({{0, 0}, {1, 0}, {2, 0}}, NAN, "filter_length is ");
  std::mt19937 random(3);
  std::vector<Vec2> jumbled = circle(5, -1, 1, 101);
  std::shuffle(jumbled.begin(), jumbled.end(), random);
  EXPECT_THROW(through(jumbled), Error);
}

// The points are those of a rail-like arc of radius 80 with noise of 0.02: curvature is lost without smoothing.
TEST(profile_fit, smoothing_brings_the_curvature_back) {
  constexpr double radius = 80, filter = 12;
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 0.02);
  std::vector<Vec2> point = circle(radius, -0.4, 0.4, 321);
  for (Vec2& x : point) x[1] += noise(random);
  const auto rough = errors(through(point), radius);
  EXPECT_GT(rough[1], 10) << "the noise alone must spoil the curvature";
  const ProfileCurve smooth = through(point, filter);
  double inside = 0, off = 0;
  for (int i = 0; i <= 400; ++i) {
    const ProfilePoint p = smooth.at(smooth.length() * (0.15 + 0.7 * i / 400));
    inside = std::max(inside, std::abs(p.curvature() * radius - 1));
    off = std::max(off, std::abs(length(p.x) - radius));
  }
  // The filter's linear theory, f(w) = 1/(1 + (L w / 2 pi)^6), predicts the squares of the deviations caused by white
  // noise s: s^2 h/pi integral f^2 dw for the points and s^2 h/pi integral w^4 f^2 dw for the curvature; the largest of
  // 400 is below 4.
  const double h = 0.8 * radius / 320, w0 = 2 * pi / filter;
  double points = 0, curvatures = 0;
  for (int i = 0; i < 4000; ++i) {
    const double t = (i + 0.5) * 0.001, f = 1 / (1 + std::pow(t, 6));
    points += f * f * 0.001;
    curvatures += std::pow(t, 4) * f * f * 0.001;
  }
  expect_error("smoothed: points", off, 4 * 0.02 * std::sqrt(h / pi * w0 * points));
  expect_error("smoothed: curvature", inside, 4 * radius * 0.02 * std::sqrt(h / pi * std::pow(w0, 5) * curvatures));
}

// Waves are halved at the filter's length, unchanged at 3 times, and gone at a third of it; a circle does not change up
// to its ends.
TEST(profile_fit, filter_length_is_where_waves_are_halved) {
  constexpr double filter = 10, height = 1e-3;
  for (const double wave : {filter / 3, filter, 3 * filter}) {
    std::vector<Vec2> point;
    for (int i = 0; i <= 2000; ++i) point.push_back({0.1 * i, height * std::cos(2 * pi * (0.1 * i - 100) / wave)});
    smooth_points(point, fit_of(filter));
    const double left = point[1000][1] / height, due = 1 / (1 + std::pow(filter / wave, 6));
    expect_error("wave " + std::to_string(wave) + ": what is left less theory", left - due, 1e-3);
  }
  // The third derivative 1/R^2 is lost at ends over the filter's reach L / 2 pi.
  constexpr double radius = 80, length = 12, reach = length / (2 * pi) / radius;
  std::vector<Vec2> arc = circle(radius, -0.4, 0.4, 321);
  smooth_points(arc, fit_of(length));
  expect_error("smoothed circle: radius, ends included", errors(through(arc), radius)[0], std::pow(reach, 3));
  expect_error("smoothed circle: curvature, ends included", errors(through(arc), radius)[1], reach);
}

// The filter of second order halves waves of its length, too, and falls off more slowly. Where all points weigh the
// same, its length is longer where they are far apart.
TEST(profile_fit, the_filter_of_second_order_falls_off_with_the_fourth_power) {
  constexpr double length = 10, height = 1e-3, near = 0.1, far = 0.4;
  std::vector<double> y;
  for (int i = 0; i <= 1000; ++i) y.push_back(near * i);
  for (int i = 1; i <= 250; ++i) y.push_back(100 + far * i);
  const double mean = 200.0 / 1250;
  for (const bool alike : {false, true})
    for (const double wave : {length / 3, length, 3 * length}) {
      ProfileFit fit = fit_of(length);
      fit.filter_order = 2;
      fit.points_alike = alike;
      std::vector<Vec2> point;
      for (const double at : y) point.push_back({at, height * std::cos(2 * pi * at / wave)});
      std::vector<Vec2> smooth = point;
      smooth_points(smooth, fit);
      for (const bool right : {false, true}) {
        double found = 0, whole = 0;
        for (std::size_t i = 0; i < y.size(); ++i)
          if (std::abs(y[i] - (right ? 150 : 50)) < 25)
            found += smooth[i][1] * point[i][1], whole += point[i][1] * point[i][1];
        const double weight = alike ? mean / (right ? far : near) : 1;
        expect_error((alike ? "points alike, wave " : "wave ") + std::to_string(wave),
                     found / whole - 1 / (1 + std::pow(length / wave, 4) / weight), 4e-3);
      }
    }
}

// A shallow parabola f becomes the solution of a^4 u'''' + u = f with u'' = u''' = 0 at both ends, where a is the
// filter's length over 2 pi.
TEST(profile_fit, the_filter_of_second_order_is_the_smoothing_spline) {
  constexpr double half = 10, length = 12, height = 1e-4;
  const double k = 2 * pi / length / std::numbers::sqrt2, x = k * half;
  const auto even = [](double v) { return std::cosh(v) * std::cos(v); };
  const auto odd = [](double v) { return std::sinh(v) * std::sin(v); };
  // The derivatives of b even + c odd are 2 k^2 (c even - b odd) and 2 k^3 (c p - b q).
  const double p = std::sinh(x) * std::cos(x) - std::cosh(x) * std::sin(x),
               q = std::cosh(x) * std::sin(x) + std::sinh(x) * std::cos(x);
  const double b = -(1 / (k * k)) / (even(x) * q / p - odd(x)), c = b * q / p;
  for (const bool alike : {false, true}) {
    ProfileFit fit = fit_of(length);
    fit.filter_order = 2;
    fit.points_alike = alike;
    std::vector<Vec2> point;
    for (int i = -400; i <= 400; ++i) {
      const double y = half * (i / 400.0 + (alike ? 0 : 0.1 * std::sin(pi * i / 400)));
      point.push_back({y, height * y * y});
    }
    std::vector<Vec2> smooth = point;
    smooth_points(smooth, fit);
    double off = 0, moved = 0;
    for (std::size_t i = 0; i < point.size(); ++i) {
      const double v = k * point[i][0], due = b * even(v) + c * odd(v);
      off = std::max(off, std::abs((smooth[i][1] - point[i][1]) / height - due));
      moved = std::max(moved, std::abs(due));
    }
    expect_error("smoothing spline beside its closed form, over what it moves", off / moved, 0.01);
  }
}

TEST(profile_fit, thresholds_say_what_is_a_kink_and_a_zigzag) {
  const auto fitted = [](const std::vector<Vec2>& point, const ProfileFit& fit, FitReport& report) {
    return profile_through(point, fit, numbered, nullptr, &report);
  };
  const auto sharpest = [](const ProfileCurve& curve) {
    double most = 0;
    for (int i = 0; i <= 4000; ++i) most = std::max(most, std::abs(curve.at(curve.length() * i / 4000).curvature()));
    return most;
  };
  FitReport report;
  std::vector<Vec2> roof;
  for (int i = -20; i <= 20; ++i) roof.push_back({0.5 * i, 0.18 * std::abs(0.5 * i)});  // 20.4 degrees
  ProfileFit fit;
  EXPECT_GT(sharpest(fitted(roof, fit, report)), 0.1);
  EXPECT_EQ(report.kinks, 0);
  fit.kink_angle = 15;
  for (const double filter : {0.0, 5.0}) {
    fit.filter_length = filter;
    expect_error("a kink of 20 degrees kept: curvature beside it", sharpest(fitted(roof, fit, report)), 1e-6);
    EXPECT_EQ(report.kinks, 1);
  }
  fit = {};
  roof[21][1] += 0.06;  // the path turns beside the kink, too, by half as much
  fit.kink_angle = 10;
  fitted(roof, fit, report);
  EXPECT_EQ(report.kinks, 0);
  fit.kink_beside = 0.9;
  fitted(roof, fit, report);
  EXPECT_EQ(report.kinks, 1);

  // The path goes to and fro by more than 30 degrees; a corner of two points by 60 each is no zig-zag.
  fit = {};
  std::vector<Vec2> path;
  for (int i = 0; i <= 40; ++i) path.push_back({0.5 * i, i == 20 ? 0.2 : i == 21 ? -0.2 : 0});
  fitted(path, fit, report);
  EXPECT_EQ(report.zigzags, 0);
  fit.zigzag_angle = 30;
  const ProfileCurve mended = fitted(path, fit, report);
  EXPECT_EQ(report.zigzags, 1);
  expect_error("a zig-zag replaced by its mean: curvature", sharpest(mended), 1e-12);
  const std::vector<Vec2> corner{{-2, 0}, {-1, 0}, {0, 0}, {0.5, 0.866}, {0, 1.732}, {-1, 1.732}, {-2, 1.732}};
  fitted(corner, fit, report);
  EXPECT_EQ(report.zigzags, 0);

  // A turn of 100 degrees is refused with its place, unless the threshold says otherwise.
  const std::vector<Vec2> sharp{{-2, 0}, {-1, 0}, {0, 0}, {-0.1736, 0.9848}, {-0.3473, 1.9696}};
  expect_refused(sharp, 0, "turns back at point 2, y 0, z 0");
  fit = {};
  fit.zigzag_angle = 120;
  fitted(sharp, fit, report);
  EXPECT_EQ(report.kinks, 1);
}

// What a filter takes away of the curvature is known where there is no noise; the report tells how much, and where.
TEST(profile_fit, what_a_filter_changes_is_told) {
  constexpr double height = 0.5, width = 8;
  std::vector<Vec2> point;
  std::vector<double> curvature;
  for (double y = -40; y < 40.1; y += 0.25) {
    const double z = height * std::exp(-y * y / (width * width)), slope = -2 * y / (width * width) * z;
    point.push_back({y, z});
    curvature.push_back((4 * y * y / (width * width) - 2) / (width * width) * z / std::pow(1 + slope * slope, 1.5));
  }
  FitReport report;
  profile_through(point, fit_of(0), numbered, nullptr, &report);
  EXPECT_EQ(report.moved, 0);
  EXPECT_EQ(report.curvature, 0);
  for (const std::int64_t order : {2, 3})
    for (const double filter : {8.0, 12.0}) {
      ProfileFit fit = fit_of(filter);
      fit.filter_order = order;
      const ProfileCurve smooth = profile_through(point, fit, numbered, nullptr, &report);
      double lost = 0, moved = 0;
      for (std::size_t i = 0; i + 1 < point.size(); ++i) {
        lost = std::max(lost, std::abs(smooth.at(i, 0).curvature() - curvature[i]));
        moved = std::max(moved, length(smooth.at(i, 0).x - point[i]));
      }
      const std::string name = "order " + std::to_string(order) + ", filter " + std::to_string(filter);
      expect_error(name + ": curvature that is lost, told over true", report.curvature / lost - 0.8, 0.3);
      expect_error(name + ": its place", report.y, 1);
      expect_error(name + ": way of points", report.moved / moved - 1, 1e-9);
    }
}

}  // namespace
}  // namespace rollcon
