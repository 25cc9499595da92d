#include "framing/contact_edge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "support/index.hpp"

namespace rollcon {
namespace {

// Open lines between parts that are one patch: its strips cover them.
constexpr std::int64_t bridge = 2;

// Returns the fraction of the interval from a node in contact to its open neighbour at which the contact ends. Near it
// the pressure is A sqrt(d) inside, the gap 4/3 A/E* d^1.5 outside (Hertz's line contact); the node inside is the
// second one, as the pressure of the first is the lattice's worst.
double end_of_contact(double second_pressure, double gap, double spacing, double modulus) {
  double low = 0, high = 1;
  constexpr int halvings = 30;
  for (int i = 0; i < halvings; ++i) {
    const double part = 0.5 * (low + high);
    const double rise = second_pressure / std::sqrt((1 + part) * spacing), beyond = (1 - part) * spacing;
    (4.0 / 3 * rise / modulus * beyond * std::sqrt(beyond) > gap ? low : high) = part;
  }
  return 0.5 * (low + high);
}

class Edges {
 public:
  Edges(const SearchGrid& lattice, std::span<const double> pressure, std::span<const double> gap, double modulus,
        const GapBetween& undeformed)
      : lattice_(lattice),
        pressure_(pressure),
        gap_(gap),
        modulus_(modulus),
        undeformed_(undeformed),
        patch_of_(pressure.size(), -1) {}

  std::vector<PatchEdge> find() {
    label();
    const std::int64_t n = lattice_.lines();
    for (std::int64_t j = 0; j < n; ++j)
      for (std::int64_t i = 0; i < n; ++i) {
        if (!touches(i, j)) continue;
        for (const auto& [di, dj] : {std::array<int, 2>{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
          if (!touches(i + di, j + dj)) add_end(i, j, di, dj);
      }
    return std::move(edge_);
  }

 private:
  bool within(std::int64_t i, std::int64_t j) const {
    return i >= 0 && j >= 0 && i < lattice_.lines() && j < lattice_.lines();
  }
  std::size_t number(std::int64_t i, std::int64_t j) const { return at(j * lattice_.lines() + i); }
  bool touches(std::int64_t i, std::int64_t j) const { return within(i, j) && pressure_[number(i, j)] > 0; }

  void label() {
    const std::int64_t n = lattice_.lines();
    std::vector<std::array<std::int64_t, 2>> open;
    for (std::int64_t j0 = 0; j0 < n; ++j0)
      for (std::int64_t i0 = 0; i0 < n; ++i0) {
        if (!touches(i0, j0) || patch_of_[number(i0, j0)] >= 0) continue;
        const auto patch = static_cast<std::int32_t>(edge_.size());
        PatchEdge edge;
        std::array<std::int64_t, 2> least{i0, j0}, greatest{i0, j0};
        open.push_back({i0, j0});
        patch_of_[number(i0, j0)] = patch;
        while (!open.empty()) {
          const auto [i, j] = open.back();
          open.pop_back();
          least = {std::min(least[0], i), std::min(least[1], j)};
          greatest = {std::max(greatest[0], i), std::max(greatest[1], j)};
          edge.load.push_back(
              {lattice_.point(static_cast<double>(i), static_cast<double>(j)).y, pressure_[number(i, j)]});
          for (std::int64_t dj = -1 - bridge; dj <= 1 + bridge; ++dj)
            for (std::int64_t di = -1 - bridge; di <= 1 + bridge; ++di)
              if (touches(i + di, j + dj) && patch_of_[number(i + di, j + dj)] < 0) {
                patch_of_[number(i + di, j + dj)] = patch;
                open.push_back({i + di, j + dj});
              }
        }
        edge.least_nodes_across = 1 + std::min(greatest[0] - least[0], greatest[1] - least[1]);
        edge_.push_back(std::move(edge));
      }
  }

  // Adds the end between node (i, j) in contact and its open neighbour.
  void add_end(std::int64_t i, std::int64_t j, int di, int dj) {
    const EdgePoint inside = lattice_.point(static_cast<double>(i), static_cast<double>(j));
    const EdgePoint outside = lattice_.point(static_cast<double>(i + di), static_cast<double>(j + dj));
    const auto between = [&](double part) {
      return EdgePoint{inside.x + part * (outside.x - inside.x), inside.y + part * (outside.y - inside.y)};
    };
    EdgePoint end;
    if (!std::isfinite(undeformed_(outside.x, outside.y))) {
      double low = 0, high = 1;
      constexpr int halvings = 40;
      for (int step = 0; step < halvings; ++step) {
        const double part = 0.5 * (low + high);
        const EdgePoint p = between(part);
        (std::isfinite(undeformed_(p.x, p.y)) ? low : high) = part;
      }
      end = between(low);
      end.ends_body = true;
    } else {
      double part = 0.5;
      if (within(i + di, j + dj) && touches(i - di, j - dj)) {
        const double spacing = di != 0 ? lattice_.spacing_along() : lattice_.spacing_across();
        part = end_of_contact(pressure_[number(i - di, j - dj)], std::max(gap_[number(i + di, j + dj)], 0.0), spacing,
                              modulus_);
      }
      end = between(part);
    }
    edge_[at(patch_of_[number(i, j)])].point.push_back(end);
  }

  const SearchGrid& lattice_;
  std::span<const double> pressure_, gap_;
  double modulus_;
  const GapBetween& undeformed_;
  std::vector<std::int32_t> patch_of_;
  std::vector<PatchEdge> edge_;
};

}  // namespace

EdgePoint SearchGrid::cell() const {
  const double c = std::abs(std::cos(angle)), s = std::abs(std::sin(angle));
  return {std::max(c * spacing_along(), s * spacing_across()), std::max(s * spacing_along(), c * spacing_across())};
}

EdgePoint SearchGrid::point(double i, double j) const {
  const double u = (2 * i / static_cast<double>(intervals) - 1) * half_length,
               v = (2 * j / static_cast<double>(intervals) - 1) * half_width;
  const double c = std::cos(angle), s = std::sin(angle);
  return {x + c * u - s * v, y + s * u + c * v};
}

std::vector<PatchEdge> contact_edges(const SearchGrid& lattice, std::span<const double> pressure,
                                     std::span<const double> gap, double modulus, const GapBetween& undeformed) {
  return Edges(lattice, pressure, gap, modulus, undeformed).find();
}

}  // namespace rollcon
