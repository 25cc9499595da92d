#include "quadrature/rules.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace rollcon::quadrature {
namespace {

/// Holds a rule by its orbits under the symmetries of the triangle: `centre` (0 or 1) weight of the centroid; then
/// (weight, a) of points with barycentric coordinates (a, a, 1-2a) in 3 orders; then (weight, a, b) of points (a, b,
/// 1-a-b) in 6 orders. Weights sum to 1 over all points.
struct Orbits {
  int degree;
  int centre, threes, sixes;
  double data[19];
};

// The values solve the moment equations of the symmetric polynomials up to each degree.
constexpr std::array orbits = {
    Orbits{2, 0, 1, 0, {0.3333333333333332, 0.16666666666666613}},
    Orbits{4, 0, 2, 0, {0.22338158967801136, 0.4459484909159652, 0.10995174365532186, 0.09157621350977001}},
    Orbits{5,
           1,
           2,
           0,
           {0.22499999999999945, 0.12593918054482706, 0.10128650732345564, 0.13239415278850633, 0.47014206410511544}},
    Orbits{6,
           0,
           2,
           1,
           {0.1713331241529808, 0.21942998254978258, 0.08073108959303103, 0.4801379641122154, 0.04063455979366069,
            0.019371724361239795, 0.14161901592396772}},
    Orbits{8,
           1,
           3,
           1,
           {0.1443156076777863, 0.032458497623198176, 0.0505472283170302, 0.10321737053471802, 0.1705693077517599,
            0.09509163426728424, 0.4592925882927233, 0.027230314174435326, 0.008394777409957211, 0.2631128296346382}},
    Orbits{10,
           1,
           2,
           3,
           {0.09081799038275339, 0.045321059435528006, 0.1094815754850363, 0.036725957756466934, 0.48557763338365734,
            0.00942166696373283, 0.009540815400298587, 0.06680325101219946, 0.07275791684541988, 0.14170721941487974,
            0.550352941821, 0.02832724253105753, 0.025003534762685232, 0.24667256063990323}},
    Orbits{12,
           0,
           5,
           3,
           {0.0625412131958994, 0.27146250701492874, 0.028486052068878717, 0.10925782765932164, 0.007931642509976794,
            0.024646363436339983, 0.04991833492806977, 0.4401116486585957, 0.02426683808144688, 0.4882037509455453,
            0.04322736365941475, 0.11629601967793558, 0.25545422863849565, 0.021783585038611945, 0.2916556797383465,
            0.023034156355275705, 0.015083677576504136, 0.021382490256155733, 0.12727971723361217}},
};

TriangleRule expand(const Orbits& orbit) {
  TriangleRule rule{orbit.degree, {}};
  const double* d = orbit.data;
  auto add = [&rule](double weight, double xi, double eta) {
    rule.points.w.push_back(0.5 * weight);
    rule.points.xi.push_back(xi);
    rule.points.eta.push_back(eta);
  };
  if (orbit.centre != 0) add(*d++, 1.0 / 3, 1.0 / 3);
  for (int k = 0; k < orbit.threes; ++k, d += 2) {
    const double a = d[1], c = 1 - 2 * a;
    add(d[0], a, a);
    add(d[0], a, c);
    add(d[0], c, a);
  }
  for (int k = 0; k < orbit.sixes; ++k, d += 3) {
    const double p[3] = {d[1], d[2], 1 - d[1] - d[2]};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (i != j) add(d[0], p[i], p[j]);
  }
  return rule;
}

}  // namespace

const LineRule& line_rule(int n) {
  static const std::vector<LineRule> rules = [] {
    std::vector<LineRule> all;
    for (int k = 1; k <= max_line_points; ++k) {
      LineRule rule = gauss_legendre(k);
      // The mean of each pair makes the rule exactly symmetric.
      for (std::size_t i = 0, j = rule.x.size() - 1; i <= j && j < rule.x.size(); ++i, --j) {
        const double x = 0.5 * (rule.x[j] - rule.x[i]), w = 0.5 * (rule.w[j] + rule.w[i]);
        rule.x[i] = -x;
        rule.x[j] = x;
        rule.w[i] = rule.w[j] = w;
      }
      all.push_back(rule);
    }
    return all;
  }();
  return rules[static_cast<std::size_t>(n - 1)];
}

const std::vector<TriangleRule>& symmetric_triangle_rules() {
  static const std::vector<TriangleRule> rules = [] {
    std::vector<TriangleRule> all;
    for (const Orbits& orbit : orbits) all.push_back(expand(orbit));
    return all;
  }();
  return rules;
}

void fill_rule(bool triangle, int first, int second, NearPoints& points) {
  points.n = 0;
  const auto add = [&](double xi, double eta, double w) {
    points.xi[points.n] = xi;
    points.eta[points.n] = eta;
    points.w[points.n++] = w;
  };
  if (triangle) {
    const auto& rules = symmetric_triangle_rules();
    const auto found = std::find_if(rules.begin(), rules.end() - 1, [&](const auto& r) { return r.degree >= first; });
    for (std::size_t q = 0; q < found->points.size(); ++q)
      add(found->points.xi[q], found->points.eta[q], found->points.w[q]);
    return;
  }
  const LineRule &one = line_rule(first), &other = line_rule(second);
  for (std::size_t i = 0; i < one.x.size(); ++i)
    for (std::size_t j = 0; j < other.x.size(); ++j) add(one.x[i], other.x[j], one.w[i] * other.w[j]);
}

}  // namespace rollcon::quadrature
