#include "bodies/halfspace/halfspace.hpp"

#include <algorithm>
#include <atomic>
#include <limits>
#include <map>
#include <mutex>
#include <numbers>
#include <vector>

#include "bodies/halfspace/far_field.hpp"
#include "bodies/halfspace/halfspace_kernel.hpp"
#include "bodies/halfspace/kernels.hpp"
#include "bodies/halfspace/near_halfspaces.hpp"
#include "bodies/halfspace/strip_compliance.hpp"
#include "bodies/halfspace/unrolled.hpp"
#include "quadrature/near_field.hpp"
#include "quadrature/rules.hpp"
#include "support/parallel.hpp"

namespace rollcon {

HalfspaceConstants halfspace_constants(double young, double poisson, int sign) {
  const double g = young / (2 * (1 + poisson)), unit = 1 / (2 * std::numbers::pi * g);
  return {unit * (1 - poisson), unit * poisson, sign * unit * (0.5 - poisson)};
}

namespace {

using namespace halfspace;

/// Holds what one thread needs for one observer.
struct Workspace {
  std::vector<double> row;          ///< integrals of the row: integral_count times nodes
  std::vector<std::uint8_t> level;  ///< rule's level by element of a group
  NearWorkspace near;
  std::int64_t far_evaluations = 0;
};

/// Computes integrals for an observer on the element or near it, each off by about `tolerance` (a length).
void near_integrals(const ElementGeometry& element, double px, double py, double tolerance, int terms,
                    const Kernels& kernels, NearWorkspace& workspace, double* integral) {
  std::fill_n(integral, integral_count * max_shape_stride, 0.0);
  NearElement relative;
  relative.type = element.type;
  for (int k = 0; k < element.nodes; ++k) {
    relative.x[k] = element.node[0][k] - px;
    relative.y[k] = element.node[1][k] - py;
  }
  // The rules are those of Kelvin's single layer, 1/(4 pi r).
  const Tolerance length{std::numeric_limits<double>::infinity(), tolerance / (4 * std::numbers::pi)};
  near_field(element, {px, py, 0}, {}, length, false, workspace,
             [&] { kernels.near(relative, workspace.points, terms, integral); });
}

class HalfspaceCompliance final : public Compliance {
 public:
  HalfspaceCompliance(const Frame& frame, HalfspaceConstants c, double tolerance, int threads)
      : frame_(frame),
        nodes_(frame.nodes()),
        c_(c),
        kernel_(make_halfspace_kernel(c)),
        tolerance_(tolerance),
        threads_(std::max(1, threads)) {}

  void set_threads(int threads) override { threads_ = std::max(1, threads); }
  std::int64_t nodes() const override { return nodes_; }
  bool couples() const override { return c_.ck != 0; }
  std::shared_ptr<const TranslationKernel> translation() const override { return kernel_; }
  bool near_halfspaces(Points /*points*/, NearHalfspaces& out) const override {
    out.constants = {out.constants.cn + c_.cn, out.constants.cv + c_.cv, out.constants.ck + c_.ck};
    return true;
  }
  std::unique_ptr<Compliance> on_part(const Frame& part) const override {
    return std::make_unique<HalfspaceCompliance>(part, c_, tolerance_, 1);
  }
  bool follow_frame() override {
    grouped_.store(false);
    return true;
  }
  std::int64_t kernel_evaluations() const override { return evaluations_.load(); }
  std::size_t bytes() const override {
    std::size_t sum = sizeof *this;
    if (!grouped_.load()) return sum;
    for (const FarGroup& group : groups_) sum += group.bytes();
    return sum;
  }

  void block(Points points, const ComplianceBlock& out) const override;
  void apply(Points points, const double* traction, double* displacement) const override;
  bool expand(Points points, ExpandedCompliance& out) const override {
    add_direct(*this, points, out);
    return true;
  }

 private:
  /// Runs work(point, workspace) for every point, each by one thread.
  template <class Work>
  void for_each(std::size_t points, std::size_t row_size, const Work& work) const;
  void integrate_row(double px, double py, int terms, const Kernels& kernels, Workspace& w) const;
  void add_near(const double* integral, int terms, const std::int32_t* node, int nodes, const double* traction,
                double* u) const;
  void write_row(std::size_t p, int terms, const double* row, const ComplianceBlock& out) const;
  void require_groups() const;
  bool rigid() const { return c_.cn == 0 && c_.cv == 0 && c_.ck == 0; }
  /// Returns the tolerance of one element's integrals, a length.
  double element_tolerance(double px, double py) const {
    double scale = 0;
    for (const FarGroup& group : groups_) scale = std::max(scale, group.scale(px, py));
    return element_share * tolerance_ * scale;
  }

  const Frame& frame_;
  std::int64_t nodes_;
  HalfspaceConstants c_;
  std::shared_ptr<const TranslationKernel> kernel_;
  double tolerance_;
  int threads_;
  mutable std::mutex grouping_;
  mutable std::atomic<bool> grouped_{false};
  mutable std::vector<FarGroup> groups_;
  mutable std::int64_t largest_group_ = 0;
  mutable std::atomic<std::int64_t> evaluations_{0};
};

// Makes groups on demand: they take kilobytes per element, and regular frames never ask for them.
void HalfspaceCompliance::require_groups() const {
  if (grouped_.load()) return;
  const std::lock_guard lock(grouping_);
  if (grouped_.load()) return;
  groups_.clear();  // an attempt ran out of memory, or the frame has moved
  largest_group_ = 0;
  std::map<std::pair<ElementType, MapKind>, std::vector<std::int64_t>> kinds;
  for (std::int64_t e = 0; e < frame_.elements(); ++e) {
    const ElementGeometry shape = plane_geometry(frame_, e);
    kinds[{shape.type, shape.map}].push_back(e);
  }
  for (auto& [kind, elements] : kinds) {
    groups_.emplace_back(frame_, std::move(elements), kind.first, kind.second);
    largest_group_ = std::max(largest_group_, groups_.back().size());
  }
  grouped_.store(true);
}

template <class Work>
void HalfspaceCompliance::for_each(std::size_t points, std::size_t row_size, const Work& work) const {
  require_groups();
  const int threads = static_cast<int>(std::clamp<std::size_t>(points, 1, static_cast<std::size_t>(threads_)));
  std::vector<Workspace> workspaces(static_cast<std::size_t>(threads));
  for (Workspace& w : workspaces) {
    w.row.resize(row_size);
    w.level.resize(static_cast<std::size_t>(largest_group_));
  }
  line_rule(1);  // tables are made before the threads start
  symmetric_triangle_rules();
  parallel_for(static_cast<std::int64_t>(points), 4, threads, [&](std::int64_t p, int thread) {
    work(static_cast<std::size_t>(p), workspaces[static_cast<std::size_t>(thread)]);
  });
  std::int64_t sum = 0;
  for (const Workspace& w : workspaces) sum += w.far_evaluations + w.near.evaluations;
  evaluations_ += sum;
}

void HalfspaceCompliance::integrate_row(double px, double py, int terms, const Kernels& kernels, Workspace& w) const {
  const auto n = static_cast<std::size_t>(nodes_);
  const int count = 1 + 2 * (terms & with_shear) + (terms & with_coupling);
  std::fill(w.row.begin(), w.row.end(), 0.0);
  if (rigid()) return;
  const double tolerance = element_tolerance(px, py);
  alignas(64) double integral[integral_count * max_shape_stride];
  for (const FarGroup& group : groups_) {
    group.select(px, py, tolerance, w.level.data());
    for (std::int64_t e = 0; e < group.size(); ++e) {
      const int level = w.level[static_cast<std::size_t>(e)];
      if (level < group.levels()) {
        const FarSources sources = group.sources(level);
        kernels.far(sources, e, px, py, terms, integral);
        w.far_evaluations += sources.n;
      } else {
        near_integrals(group.shape(e), px, py, tolerance, terms, kernels, w.near, integral);
      }
      const std::int32_t* node = group.connectivity(e);
      for (int k = 0; k < count; ++k) {
        double* row = w.row.data() + static_cast<std::size_t>(k) * n;
        for (int i = 0; i < group.nodes(); ++i) row[node[i]] += integral[k * max_shape_stride + i];
      }
    }
  }
}

/// Writes Cerruti's and Boussinesq's combinations of the integrals, see halfspace.hpp.
void HalfspaceCompliance::write_row(std::size_t p, int terms, const double* row, const ComplianceBlock& out) const {
  const auto n = static_cast<std::size_t>(nodes_);
  const bool shear = (terms & with_shear) != 0, coupling = (terms & with_coupling) != 0;
  const double *i0 = row, *ixx = i0 + n, *ixy = ixx + n, *jx = shear ? ixy + n : i0 + n, *jy = jx + n;
  const auto entry = [&](int i, int j, auto value) {
    if (out.a[i][j] == nullptr) return;
    double* a = out.a[i][j] + static_cast<std::ptrdiff_t>(p) * out.stride;
    for (std::size_t k = 0; k < n; ++k) a[k] = value(k);
  };
  const double cn = c_.cn, cv = c_.cv, ck = c_.ck;
  entry(2, 2, [=](std::size_t k) { return cn * i0[k]; });
  for (int t = 0; t < 2; ++t) {
    const double* j = t == 0 ? jx : jy;
    entry(t, t,
          [=](std::size_t k) { return shear ? cn * i0[k] + cv * (t == 0 ? ixx[k] : i0[k] - ixx[k]) : cn * i0[k]; });
    entry(t, 1 - t, [=](std::size_t k) { return shear ? cv * ixy[k] : 0; });
    entry(t, 2, [=](std::size_t k) { return coupling ? ck * j[k] : 0; });
    entry(2, t, [=](std::size_t k) { return coupling ? -ck * j[k] : 0; });
  }
}

void HalfspaceCompliance::block(Points points, const ComplianceBlock& out) const {
  const bool tangential = out.a[0][0] || out.a[0][1] || out.a[1][0] || out.a[1][1];
  const bool mixed = out.a[0][2] || out.a[1][2] || out.a[2][0] || out.a[2][1];
  const int terms = (tangential && c_.cv != 0 ? with_shear : 0) + (mixed && c_.ck != 0 ? with_coupling : 0);
  const Kernels& set = kernels(instruction_set());
  const auto n = static_cast<std::size_t>(nodes_);
  const auto count = static_cast<std::size_t>(1 + 2 * (terms & with_shear) + (terms & with_coupling));
  for_each(points.size(), count * n, [&](std::size_t p, Workspace& w) {
    integrate_row(points.x[p], points.y[p], terms, set, w);
    write_row(p, terms, w.row.data(), out);
  });
}

/// Adds the contribution of one element to u, from its integrals and nodal tractions.
void HalfspaceCompliance::add_near(const double* integral, int terms, const std::int32_t* node, int nodes,
                                   const double* traction, double* u) const {
  const double* shear = integral + max_shape_stride;
  const double* coupling = shear + ((terms & with_shear) != 0 ? 2 * max_shape_stride : 0);
  for (int i = 0; i < nodes; ++i) {
    const double* t = traction + 3 * static_cast<std::ptrdiff_t>(node[i]);
    const double normal = c_.cn * integral[i];
    for (int j = 0; j < 3; ++j) u[j] += normal * t[j];
    if ((terms & with_shear) != 0) {
      const double xx = c_.cv * shear[i], xy = c_.cv * shear[max_shape_stride + i];
      u[0] += xx * t[0] + xy * t[1];
      u[1] += xy * t[0] + (c_.cv * integral[i] - xx) * t[1];
    }
    if ((terms & with_coupling) != 0) {
      const double x = c_.ck * coupling[i], y = c_.ck * coupling[max_shape_stride + i];
      u[0] += x * t[2];
      u[1] += y * t[2];
      u[2] -= x * t[0] + y * t[1];
    }
  }
}

void HalfspaceCompliance::apply(Points points, const double* traction, double* displacement) const {
  const int terms = (c_.cv != 0 ? with_shear : 0) + (c_.ck != 0 ? with_coupling : 0);
  const Kernels& set = kernels(instruction_set());
  const double constants[3] = {c_.cn, c_.cv, c_.ck};
  if (rigid()) {
    std::fill_n(displacement, 3 * points.size(), 0.0);
    return;
  }
  require_groups();
  std::vector<FarGroup::Forces> forces;
  std::vector<std::vector<std::uint8_t>> loaded;
  for (const FarGroup& group : groups_) {
    forces.push_back(group.forces(traction));
    loaded.push_back(group.loaded(traction));
  }
  for_each(points.size(), 0, [&](std::size_t p, Workspace& w) {
    const double px = points.x[p], py = points.y[p];
    const double tolerance = element_tolerance(px, py);
    double u[3] = {0, 0, 0};
    alignas(64) double integral[integral_count * max_shape_stride];
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      const FarGroup& group = groups_[g];
      group.select(px, py, tolerance, w.level.data());
      for (std::int64_t e = 0; e < group.size(); ++e) {
        if (loaded[g][static_cast<std::size_t>(e)] == 0) continue;
        const int level = w.level[static_cast<std::size_t>(e)];
        if (level < group.levels()) {
          const FarForces sources = group.sources(level, forces[g]);
          set.push(sources, e, px, py, constants, terms, u);
          w.far_evaluations += sources.n;
        } else {
          near_integrals(group.shape(e), px, py, tolerance, terms, set, w.near, integral);
          add_near(integral, terms, group.connectivity(e), group.nodes(), traction, u);
        }
      }
    }
    for (std::size_t i = 0; i < 3; ++i) displacement[3 * p + i] = u[i];
  });
}

}  // namespace

std::unique_ptr<Compliance> make_halfspace_compliance(const Frame& frame, HalfspaceConstants c, double tolerance,
                                                      int threads) {
  if (frame.strips) return make_strip_compliance(frame, c);
  if (frame.section) return make_unrolled_compliance(frame, c, tolerance, threads);
  return std::make_unique<HalfspaceCompliance>(frame, c, tolerance, threads);
}

}  // namespace rollcon
