#include "bodies/halfspace/interior_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>

#include "bodies/halfspace/hat_rules.hpp"
#include "linalg/plane_fft.hpp"
#include "support/index.hpp"

namespace rollcon {

using namespace halfspace;

namespace {

constexpr std::int64_t most_offsets = 1 << 20;  ///< limits the memory of a slice
/// Number of offsets that convolutions take in the time of one point by itself.
constexpr double offsets_per_point = 20;
constexpr std::size_t least_points = 256;
/// Error of a hat's n x n rule over rho^-2n times the hat's force over R^2.
constexpr double hat_constant = 10;
constexpr double hat_share = 1.0 / 15;
constexpr double near_share = 0.2;  ///< part of the accuracy for the hats right above a point

/// Counts kinds of influence; outputs o of traction c that have one value are one kind. All outputs but the stresses
/// along the surface are symmetric in all their axes, or free of kappa.
constexpr int kinds = 27;
constexpr int kind_of(int output, int c) {
  if (output == 4 && c == 2) return 2 * 3 + 0;
  if (output == 5 && c == 2) return 2 * 3 + 1;
  if (output == 5 && c == 0) return 4 * 3 + 1;
  if (output == 7 && c == 0) return 6 * 3 + 1;
  return 3 * output + c;
}
/// Returns the sign of the influence when x, or y, changes its sign.
constexpr bool odd_x(int output, int c) {
  return (output == 3 || output == 4 || output == 6) != (c == 0);
}
constexpr bool odd_y(int output, int c) {
  return (output == 3 || output == 5 || output == 7) != (c == 1);
}

bool half_integer(double shift) {
  return 2 * shift == std::round(2 * shift);
}

using Complex = std::complex<double>;

/// Adds a b to sum without the checks for infinities that std::complex makes.
void add_product(std::int64_t n, const Complex* a, const Complex* b, Complex* sum) {
  for (std::int64_t k = 0; k < n; ++k) {
    const double ar = a[k].real(), ai = a[k].imag(), br = b[k].real(), bi = b[k].imag();
    sum[k] = {sum[k].real() + (ar * br - ai * bi), sum[k].imag() + (ar * bi + ai * br)};
  }
}

}  // namespace

/// Holds influences by kind and offset; offset (i, j) is at [j * nx + i].
struct InteriorGrid::Table {
  std::int64_t nx, ny;
  std::int64_t low_x, low_y;  ///< least offsets
  std::array<std::vector<double>, kinds> value;
  std::vector<std::uint8_t> near;  ///< 1 for offsets too near for rules

  void set(std::int64_t at, const double (&v)[3][9]) {
    for (int c = 0; c < 3; ++c)
      for (int o = 0; o < interior_count; ++o)
        if (kind_of(o, c) == 3 * o + c) value[rollcon::at(3 * o + c)][rollcon::at(at)] = v[c][o];
  }
};

InteriorGrid::InteriorGrid(const Lattice& lattice, const double* traction, HalfspaceInterior::Material material,
                           double accuracy)
    : lattice_(lattice), material_(material), accuracy_(accuracy) {
  std::int64_t low_x = lattice.nx, low_y = lattice.ny, high_x = -1, high_y = -1;
  for (std::int64_t j = 0; j < lattice.ny; ++j)
    for (std::int64_t i = 0; i < lattice.nx; ++i) {
      const std::size_t place = at(j * lattice.nx + i);
      if (lattice.node[place] < 0) continue;
      const double* t = traction + 3 * std::ptrdiff_t{lattice.node[place]};
      if (t[0] == 0 && t[1] == 0 && t[2] == 0) continue;
      if (lattice.cells[place] != Lattice::all) usable_ = false;
      low_x = std::min(low_x, i), high_x = std::max(high_x, i);
      low_y = std::min(low_y, j), high_y = std::max(high_y, j);
    }
  // Nodes beside their places change results by about as much.
  if (!has_fft() || high_x < 0 || lattice.misfit > 0.1 * accuracy) usable_ = false;
  if (!usable_) return;
  first_x_ = low_x, first_y_ = low_y, nx_ = high_x - low_x + 1, ny_ = high_y - low_y + 1;
  for (auto& t : traction_) t.assign(at(nx_ * ny_), 0.0);
  for (std::int64_t j = 0; j < ny_; ++j)
    for (std::int64_t i = 0; i < nx_; ++i) {
      const std::int32_t node = lattice.node[at((first_y_ + j) * lattice.nx + first_x_ + i)];
      if (node < 0) continue;
      const double* t = traction + 3 * std::ptrdiff_t{node};
      const std::size_t place = at(j * nx_ + i);
      traction_[0][place] = lattice.ex * t[0] + lattice.ey * t[1];
      traction_[1][place] = lattice.ex * t[1] - lattice.ey * t[0];
      traction_[2][place] = t[2];
    }
  for (int n = 2; n <= max_hat_points; ++n) {
    const LineRule line = hat_rule(Hat::whole, n);
    const double rho = std::pow(hat_constant / (hat_share * accuracy), 0.5 / n), axis = 0.5 * (rho + 1 / rho);
    HatRule rule{axis * axis, n * n, {}, {}, {}, {}};
    const int padded = (rule.n + point_padding - 1) / point_padding * point_padding;
    for (int k = 0; k < padded; ++k) {
      const std::size_t i = at(std::min(k, rule.n - 1) % n), j = at(std::min(k, rule.n - 1) / n);
      rule.x.push_back(line.x[i] * lattice.dx);
      rule.y.push_back(line.x[j] * lattice.dy);
      rule.w.push_back(k < rule.n ? line.w[i] * line.w[j] * lattice.dx * lattice.dy : 0.0);
    }
    rule.zero.assign(rule.w.size(), 0.0);
    rules_.push_back(rule);
  }
}

bool InteriorGrid::worthwhile(const InteriorSlice& slice) const {
  const auto offsets = static_cast<double>(extent_x(slice)) * static_cast<double>(extent_y(slice));
  const auto points = static_cast<double>(slice.point.size());
  return slice.point.size() >= least_points && offsets <= most_offsets && offsets <= offsets_per_point * points;
}

std::vector<InteriorSlice> InteriorGrid::slices(std::int64_t points, const double* xyz) const {
  struct Place {
    std::int64_t point, x, y;
  };
  struct Group {
    double shift_x, shift_y;
    std::vector<Place> places;
  };
  std::map<std::array<double, 3>, Group> groups;
  const double same = 0.01 * accuracy_;  // distance in cells
  constexpr double steps = 1e6;
  for (std::int64_t p = 0; p < points; ++p) {
    const double x = xyz[3 * p] - lattice_.x0, y = xyz[3 * p + 1] - lattice_.y0;
    const double u = (x * lattice_.ex + y * lattice_.ey) / lattice_.dx;
    const double v = (y * lattice_.ex - x * lattice_.ey) / lattice_.dy;
    if (!(std::abs(u) < 1e6 && std::abs(v) < 1e6)) continue;  // far off, on no slice that pays
    const double i = std::floor(u + same), j = std::floor(v + same);
    const double shift_x =
        std::abs(2 * (u - i) - std::round(2 * (u - i))) < 2 * same ? std::round(2 * (u - i)) / 2 : u - i;
    const double shift_y =
        std::abs(2 * (v - j) - std::round(2 * (v - j))) < 2 * same ? std::round(2 * (v - j)) / 2 : v - j;
    Group& group = groups[{xyz[3 * p + 2], std::round(steps * shift_x), std::round(steps * shift_y)}];
    if (group.places.empty()) group.shift_x = shift_x, group.shift_y = shift_y;
    if (std::abs(shift_x - group.shift_x) > same || std::abs(shift_y - group.shift_y) > same) continue;
    group.places.push_back({p, static_cast<std::int64_t>(i), static_cast<std::int64_t>(j)});
  }
  std::vector<InteriorSlice> found;
  for (const auto& [key, group] : groups) {
    InteriorSlice slice{key[0], group.shift_x, group.shift_y, 0, 0, 0, 0, {}, {}};
    const auto [low_x, high_x] = std::minmax_element(group.places.begin(), group.places.end(),
                                                     [](const Place& a, const Place& b) { return a.x < b.x; });
    const auto [low_y, high_y] = std::minmax_element(group.places.begin(), group.places.end(),
                                                     [](const Place& a, const Place& b) { return a.y < b.y; });
    slice.first_x = low_x->x, slice.nx = high_x->x - low_x->x + 1;
    slice.first_y = low_y->y, slice.ny = high_y->y - low_y->y + 1;
    for (const Place& p : group.places) {
      slice.point.push_back(p.point);
      slice.place.push_back((p.y - slice.first_y) * slice.nx + p.x - slice.first_x);
    }
    if (worthwhile(slice)) found.push_back(std::move(slice));
  }
  return found;
}

/// Computes the influence of a hat at the origin, by unit tractions; false: too near for a rule.
bool InteriorGrid::far_influence(double x, double y, double z, double (&value)[3][9]) const {
  const double least =
      std::min(ellipse_axis2(x, y, z, lattice_.dx, lattice_.dy), ellipse_axis2(y, x, z, lattice_.dy, lattice_.dx));
  const InteriorKernels& kernels = interior_kernels(instruction_set());
  const double of_stress = 1 / (2 * std::numbers::pi), of_motion = 1 / (4 * std::numbers::pi * material_.shear);
  for (const HatRule& rule : rules_) {
    if (least < rule.least_axis2) continue;
    for (int c = 0; c < 3; ++c) {
      InteriorForces forces{rule.n, rule.x.data(), rule.y.data(), {}};
      for (int k = 0; k < 3; ++k) forces.force[k] = k == c ? rule.w.data() : rule.zero.data();
      std::fill_n(value[c], interior_count, 0.0);
      kernels.push(forces, {x, y, z}, 1 - 2 * material_.poisson, value[c]);
      for (int o = 0; o < interior_count; ++o) value[c][o] *= o < 6 ? of_stress : of_motion;
    }
    return true;
  }
  return false;
}

void InteriorGrid::influence(const InteriorSlice& slice, Table& table) const {
  table.nx = extent_x(slice), table.ny = extent_y(slice);
  table.low_x = slice.first_x - first_x_ - nx_ + 1;
  table.low_y = slice.first_y - first_y_ - ny_ + 1;
  for (int k = 0; k < kinds; ++k)
    if (kind_of(k / 3, k % 3) == k) table.value[at(k)].assign(at(table.nx * table.ny), 0.0);
  table.near.assign(at(table.nx * table.ny), 0);
  // Offsets that mirror others take their values.
  const bool mirror_x = half_integer(slice.shift_x), mirror_y = half_integer(slice.shift_y);
  const auto partner = [](bool mirror, double shift, std::int64_t low, std::int64_t n, std::int64_t i) {
    const std::int64_t other = mirror ? -(low + i) - to_index(std::round(2 * shift)) - low : i;
    return other > i && other < n ? other : i;
  };
  double value[3][9];
  for (std::int64_t j = table.ny - 1; j >= 0; --j) {
    const std::int64_t from_j = partner(mirror_y, slice.shift_y, table.low_y, table.ny, j);
    for (std::int64_t i = table.nx - 1; i >= 0; --i) {
      const std::int64_t from_i = partner(mirror_x, slice.shift_x, table.low_x, table.nx, i);
      const std::int64_t here = j * table.nx + i, from = from_j * table.nx + from_i;
      if (from == here) {
        const double x = (static_cast<double>(table.low_x + i) + slice.shift_x) * lattice_.dx;
        const double y = (static_cast<double>(table.low_y + j) + slice.shift_y) * lattice_.dy;
        if (far_influence(x, y, slice.z, value))
          table.set(here, value);
        else
          table.near[at(here)] = 1;
        continue;
      }
      table.near[at(here)] = table.near[at(from)];
      for (int k = 0; k < kinds; ++k) {
        if (kind_of(k / 3, k % 3) != k) continue;
        const bool odd = (from_i != i && odd_x(k / 3, k % 3)) != (from_j != j && odd_y(k / 3, k % 3));
        const double v = table.value[at(k)][at(from)];
        table.value[at(k)][at(here)] = odd ? -v : v;
      }
    }
  }
}

void InteriorGrid::near_influence(const InteriorSlice& slice, Table& table) const {
  std::vector<double> xyz;
  std::vector<std::int64_t> offset;
  for (std::int64_t k = 0; k < table.nx * table.ny; ++k) {
    if (table.near[at(k)] == 0) continue;
    offset.push_back(k);
    const std::int64_t column = table.low_x + k % table.nx, line = table.low_y + k / table.nx;
    xyz.insert(xyz.end(), {(static_cast<double>(column) + slice.shift_x) * lattice_.dx,
                           (static_cast<double>(line) + slice.shift_y) * lattice_.dy, slice.z});
  }
  if (offset.empty()) return;
  SurfaceMesh mesh;
  mesh.offset.push_back(0);
  for (int j = -1; j <= 1; ++j)
    for (int i = -1; i <= 1; ++i) mesh.node.push_back({i * lattice_.dx, j * lattice_.dy, 0});
  for (const std::int32_t corner : {0, 1, 3, 4}) {
    mesh.connectivity.insert(mesh.connectivity.end(), {corner, corner + 1, corner + 4, corner + 3});
    mesh.type.push_back(ElementType::quad4);
    mesh.tag.push_back(0);
    mesh.offset.push_back(static_cast<std::int64_t>(mesh.connectivity.size()));
  }
  const Frame hat = build_frame(std::move(mesh), Axes{});
  std::vector<double> stress[3], motion[3];
  for (std::size_t c = 0; c < 3; ++c) {
    double traction[27] = {};
    traction[3 * 4 + c] = 1;
    stress[c].resize(6 * offset.size());
    motion[c].resize(3 * offset.size());
    HalfspaceInterior(hat, traction, material_, near_share * accuracy_)
        .evaluate(static_cast<std::int64_t>(offset.size()), xyz.data(), stress[c].data(), motion[c].data(), 1);
  }
  for (std::size_t k = 0; k < offset.size(); ++k) {
    double value[3][interior_count];
    for (std::size_t c = 0; c < 3; ++c) {
      std::copy_n(stress[c].data() + 6 * k, 6, value[c]);
      std::copy_n(motion[c].data() + 3 * k, 3, value[c] + 6);
    }
    table.set(offset[k], value);
  }
}

void InteriorGrid::evaluate(const InteriorSlice& slice, double* stress, double* displacement) const {
  Table table;
  influence(slice, table);
  near_influence(slice, table);
  const std::int64_t nx = table.nx, ny = table.ny;
  PlaneFft<double> fft(nx, ny, nx, ny);
  const std::int64_t size = fft.waves_x() * fft.stride();
  std::vector<double> field(at(nx * ny));
  AlignedArray<Complex> source[3], kernel = fft.make_spectrum(), sum = fft.make_spectrum();
  const double scale = 1 / (static_cast<double>(fft.period_x()) * static_cast<double>(fft.period_y()));
  for (std::size_t c = 0; c < 3; ++c) {
    std::fill(field.begin(), field.end(), 0.0);
    for (std::int64_t j = 0; j < ny_; ++j)
      for (std::int64_t i = 0; i < nx_; ++i) field[at(j * nx + i)] = scale * traction_[c][at(j * nx_ + i)];
    source[c] = fft.make_spectrum();
    fft.forward(field.data(), source[c].data());
  }
  AlignedArray<Complex> kept[kinds];  // spectra that serve twice
  for (int o = 0; o < interior_count; ++o) {
    if (o < 6 ? !stress : !displacement) continue;
    std::fill_n(sum.data(), size, Complex{});
    for (int c = 0; c < 3; ++c) {
      const std::size_t kind = at(kind_of(o, c));
      const bool twice = kind == 6 || kind == 7 || kind == 13 || kind == 19;
      if (twice && kept[kind].size() == 0) {
        kept[kind] = fft.make_spectrum();
        fft.forward(table.value[kind].data(), kept[kind].data());
      }
      if (!twice) fft.forward(table.value[kind].data(), kernel.data());
      add_product(size, twice ? kept[kind].data() : kernel.data(), source[c].data(), sum.data());
    }
    fft.backward(sum.data(), field.data());
    write(slice, o, field.data(), stress, displacement);
  }
  turn(slice, stress, displacement);
}

/// Influences begin at their least offset: place (0, 0) of the slice is at (nx_ - 1, ny_ - 1).
void InteriorGrid::write(const InteriorSlice& slice, int output, const double* field, double* stress,
                         double* displacement) const {
  const std::int64_t stride = extent_x(slice);
  for (std::size_t k = 0; k < slice.point.size(); ++k) {
    const std::int64_t i = slice.place[k] % slice.nx, j = slice.place[k] / slice.nx;
    const double value = field[(j + ny_ - 1) * stride + i + nx_ - 1];
    (output < 6 ? stress[6 * slice.point[k] + output] : displacement[3 * slice.point[k] + output - 6]) = value;
  }
}

/// Turns from the lattice's axes to the frame's.
void InteriorGrid::turn(const InteriorSlice& slice, double* stress, double* displacement) const {
  const double c = lattice_.ex, s = lattice_.ey;
  for (const std::int64_t p : slice.point) {
    if (displacement) {
      double* u = displacement + 3 * p;
      const double x = u[0], y = u[1];
      u[0] = c * x - s * y, u[1] = s * x + c * y;
    }
    if (stress) {
      double* t = stress + 6 * p;
      const double xx = t[0], yy = t[1], xy = t[3], xz = t[4], yz = t[5];
      t[0] = c * c * xx - 2 * c * s * xy + s * s * yy;
      t[1] = s * s * xx + 2 * c * s * xy + c * c * yy;
      t[3] = c * s * (xx - yy) + (c * c - s * s) * xy;
      t[4] = c * xz - s * yz, t[5] = s * xz + c * yz;
    }
  }
}

}  // namespace rollcon
