#include "bodies/bem/boundary_integrals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

#include "bodies/bem/far_field.hpp"
#include "bodies/bem/kelvin.hpp"
#include "bodies/bem/near_field.hpp"
#include "bodies/bem/rule_tables.hpp"
#include "mesh/shape.hpp"
#include "support/error.hpp"

namespace rollcon::bem {
namespace {

static_assert(lanes == pack_points);

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Share of the tolerance given to one element; the rest is for the sum over elements.
constexpr double element_share = 0.2;
/// The double layer's largest entry is about the free term of a smooth point.
constexpr double free_term = 0.5;

}  // namespace

struct BoundaryIntegrals::Data {
  const SurfaceMesh& mesh;
  double size;
  double tolerance;
  KelvinConstants constants;
  const Kernels& kernels;
  std::vector<ElementGeometry> element;
  FarField far;
  mutable std::atomic<std::int64_t> evaluations{0};

  Data(const SurfaceMesh& surface, double poisson, double relative)
      : mesh(surface),
        size(size_near(surface)),
        tolerance(element_share * relative),
        constants(poisson),
        kernels(kelvin_kernels(instruction_set())),
        element(geometries(surface, 1 / size)),
        far(element, tolerance * free_term) {
    constants.iso *= size;  // lengths are in units of `size`, the single layer's result is not
    constants.single *= size;
  }
};

/// Computes rows at one pack of points.
class BoundaryIntegrals::Rows {
 public:
  /// columns: if it names no element, all are taken; if it has no h, each node has a column of its own.
  Rows(const Data& data, std::span<const CollocationPoint> points, const Columns& columns, double* h, double* g)
      : data_(data), points_(points), columns_(columns), h_(h), g_(g) {
    Vec3 centre{};
    for (std::size_t p = 0; p < points.size(); ++p) {
      x_[p] = 1 / data.size * points[p].x;
      if (points[p].node >= 0) x_[p] = 1 / data.size * data.mesh.node[static_cast<std::size_t>(points[p].node)];
      centre = centre + 1.0 / static_cast<double>(points.size()) * x_[p];
    }
    for (std::size_t p = 0; p < points.size(); ++p) radius_ = std::max(radius_, length(x_[p] - centre));
    centre_ = centre;
    tolerance_ = {h ? data.tolerance * free_term : infinity, g ? data.tolerance * single_layer_scale() : infinity};
  }

  /// Sums all blocks into the one at h.
  void run_sums() {
    summed_ = true;
    run();
  }

  void run_whole() {
    run();
    if (h_) rigid_motion();
  }

  void run() {
    const FarField::PackFactors factors(tolerance_.u);
    fill_pack((1u << points_.size()) - 1u);
    for_elements([&](std::size_t e) {
      const int terms = (h_wanted(e) ? double_layer : 0) | (wanted(e) ? single_layer : 0);
      if (terms == 0) return;
      const ElementGeometry& element = data_.element[e];
      const double distance = length(element.shape.centre - centre_) - radius_;
      const FarRule rule = data_.far.rule(e, distance, terms, factors);
      if (rule.first > 0)
        far(e, rule, terms);
      else
        near(e, terms);
    });
    data_.evaluations.fetch_add(evaluations_ + workspace_.evaluations, std::memory_order_relaxed);
  }

 private:
  const std::int32_t* connectivity(std::size_t e) const {
    return data_.mesh.connectivity.data() + data_.mesh.offset[e];
  }

  template <class Work>
  void for_elements(Work work) const {
    for (const std::int32_t e : columns_.element) work(static_cast<std::size_t>(e));
    for (std::size_t e = 0; columns_.element.empty() && e < data_.element.size(); ++e) work(e);
  }

  bool h_wanted(std::size_t e) const {
    if (!h_ || !columns_.h) return h_ != nullptr;
    const std::int32_t* node = connectivity(e);
    return std::any_of(node, node + data_.element[e].nodes, [&](std::int32_t k) { return columns_.h[k] >= 0; });
  }

  bool wanted(std::size_t e) const {
    if (!g_) return false;
    const std::int32_t* column = columns_.g + data_.mesh.offset[e];
    return std::any_of(column, column + data_.element[e].nodes, [](auto c) { return c >= 0; });
  }

  /// Returns the smallest over the points of the largest area over distance among the wanted elements.
  double single_layer_scale() const {
    std::array<double, lanes> largest{};
    for_elements([&](std::size_t e) {
      if (!wanted(e)) return;
      const CellShape& s = data_.element[e].shape;
      for (std::size_t p = 0; p < points_.size(); ++p) {
        const Vec3 r = s.centre - x_[p];
        largest[p] = std::max(largest[p], s.area * s.area / (dot(r, r) + s.half_length * s.half_length));
      }
    });
    const double least = *std::min_element(largest.begin(), largest.begin() + static_cast<long>(points_.size()));
    return std::sqrt(least) / (4 * std::numbers::pi);
  }

  /// Lanes whose bit is set; the others are kept out of harm's way at the place of one of them.
  void fill_pack(unsigned lane_set) {
    std::size_t any = 0;
    while ((lane_set >> any & 1u) == 0) ++any;
    for (std::size_t p = 0; p < lanes; ++p) {
      const bool on = (lane_set >> p & 1u) != 0;
      for (std::size_t j = 0; j < 3; ++j) pack_.x[j][p] = x_[on ? p : any][j];
      pack_.mask[p] = on ? 1 : 0;
    }
  }

  void blocks(std::size_t e, double** h, double** g) {
    const std::int32_t* node = connectivity(e);
    for (int k = 0; k < data_.element[e].nodes; ++k) {
      const auto place = [this](double* first, std::int32_t column) {
        return column >= 0 ? first + std::ptrdiff_t{block} * column : unwanted_;
      };
      h[k] = h_ ? place(h_, summed_ ? 0 : columns_.h ? columns_.h[node[k]] : node[k]) : nullptr;
      if (g_) g[k] = place(g_, columns_.g[data_.mesh.offset[e] + k]);
    }
  }

  void far(std::size_t e, FarRule rule, int terms) {
    const ElementGeometry& element = data_.element[e];
    const RuleTable& table = rule_table(element.type, rule.first, rule.second);
    double *h[max_element_nodes], *g[max_element_nodes];
    blocks(e, h, g);
    data_.kernels.place(table, element.nodes, element.node, far_points_);
    if (summed_) {
      const RuleTable constant{table.n, far_capacity, one_function(), nullptr, nullptr, nullptr};
      double* sum[] = {h_, unwanted_, unwanted_};
      data_.kernels.far(far_points_, constant, 3, pack_, data_.constants, terms, sum, g);
    } else {
      data_.kernels.far(far_points_, table, element.nodes, pack_, data_.constants, terms, h, g);
    }
    evaluations_ += static_cast<std::int64_t>(points_.size()) * table.n;
  }

  /// Points that a moderate Gauss rule on the whole element serves share one; the others get rules of their own.
  void near(std::size_t e, int terms) {
    const ElementGeometry& element = data_.element[e];
    const Tolerance tolerance{(terms & double_layer) != 0 ? tolerance_.t : infinity,
                              (terms & single_layer) != 0 ? tolerance_.u : infinity};
    unsigned shared = 0;
    FarRule rule{1, 1};
    for (std::size_t p = 0; p < points_.size(); ++p) {
      const OnElement on = locate(e, p);
      if (!on.known) {
        const Selection s = select_rule(element, seen_from(element.shape, x_[p]), tolerance);
        if (s.gauss && (element.corners == 3 || std::max(s.first, s.second) <= most_far_points)) {
          shared |= 1u << p;
          rule = {std::max(rule.first, s.first), std::max(rule.second, s.second)};
          continue;
        }
      }
      if (on.known && summed_) continue;
      near_integrals(element, x_[p], on, tolerance, terms, data_.constants, data_.kernels, workspace_, integrals_);
      if (on.known && !columns_.element.empty()) rigid_motion_of(element, on);
      scatter(e, p, terms);
    }
    if (shared == 0) return;
    fill_pack(shared);
    far(e, rule, terms);
    fill_pack((1u << points_.size()) - 1u);
  }

  /// Returns values of three functions at the points of a rule: one is 1, the others are zero.
  static const double* one_function() {
    static const auto values = [] {
      std::array<double, std::size_t{3} * far_capacity> v{};
      std::fill_n(v.begin(), far_capacity, 1.0);
      return v;
    }();
    return values.data();
  }

  OnElement locate(std::size_t e, std::size_t p) const {
    const CollocationPoint& point = points_[p];
    if (point.node < 0) return {point.element == static_cast<std::int32_t>(e), {point.xi, point.eta}};
    const ElementGeometry& element = data_.element[e];
    const std::int32_t* node = connectivity(e);
    for (int k = 0; k < element.nodes; ++k)
      if (node[k] == point.node) {
        const ReferencePoint at = reference_nodes(element.type)[static_cast<std::size_t>(k)];
        return {true, {at.xi, at.eta}};
      }
    return {};
  }

  void scatter(std::size_t e, std::size_t p, int terms) {
    static constexpr int u_entry[9] = {0, 1, 2, 1, 3, 4, 2, 4, 5};
    double *h[max_element_nodes], *g[max_element_nodes];
    blocks(e, h, g);
    for (int k = 0; k < data_.element[e].nodes; ++k)
      for (int i = 0; i < 9; ++i) {
        const std::size_t at = static_cast<std::size_t>(i) * lanes + p;
        if ((terms & double_layer) != 0) h[k][at] += integrals_.t[i][k];
        if ((terms & single_layer) != 0) g[k][at] += integrals_.u[u_entry[i]][k];
      }
  }

  /// Subtracts, as rigid_motion() does for all elements, the sum of the integrals of one element that has the point.
  /// The integrals depend on the quadrature rule until this is done.
  void rigid_motion_of(const ElementGeometry& element, const OnElement& on) {
    Shape shape;
    evaluate_shape(element.type, on.reference.x, on.reference.y, shape);
    for (auto& t : integrals_.t) {
      const double sum = std::accumulate(t, t + element.nodes, 0.0);
      for (int k = 0; k < element.nodes; ++k) t[k] -= shape.value[static_cast<std::size_t>(k)] * sum;
    }
  }

  /// Subtracts N_j(x) times the sum of all blocks from block j, as u(x) = sum of N_j(x) u_j. This gives free term and
  /// strongly singular integral in one.
  void rigid_motion() {
    alignas(64) double total[block] = {};
    const std::int64_t nodes = data_.mesh.nodes();
    for (std::int64_t n = 0; n < nodes; ++n)
      for (int i = 0; i < block; ++i) total[i] += h_[n * block + i];
    for (std::size_t p = 0; p < points_.size(); ++p) {
      auto take = [&](std::int64_t node, double share) {
        for (std::size_t i = p; i < std::size_t{block}; i += lanes)
          h_[static_cast<std::size_t>(node * block) + i] -= share * total[i];
      };
      const CollocationPoint& point = points_[p];
      if (point.node >= 0) {
        take(point.node, 1);
        continue;
      }
      const auto e = static_cast<std::size_t>(point.element);
      Shape s;
      evaluate_shape(data_.element[e].type, point.xi, point.eta, s);
      for (int k = 0; k < data_.element[e].nodes; ++k) take(connectivity(e)[k], s.value[static_cast<std::size_t>(k)]);
    }
  }

  static constexpr int block = 9 * lanes;

  const Data& data_;
  const std::span<const CollocationPoint> points_;
  const Columns columns_;
  double* const h_;
  bool summed_ = false;
  double* const g_;
  std::array<Vec3, lanes> x_{};  ///< points in units of the mesh's size
  Vec3 centre_{};
  double radius_ = 0;
  Tolerance tolerance_{};
  PointPack pack_{};
  FarPoints far_points_;
  NearWorkspace workspace_;
  NearIntegrals integrals_;
  alignas(64) double unwanted_[block] = {};
  std::int64_t evaluations_ = 0;
};

BoundaryIntegrals::BoundaryIntegrals(const SurfaceMesh& mesh, double poisson, double tolerance)
    : data_(std::make_unique<Data>(mesh, poisson, tolerance)) {}

BoundaryIntegrals::~BoundaryIntegrals() = default;

void BoundaryIntegrals::rows(std::span<const CollocationPoint> points, double* h, const std::int32_t* g_column,
                             std::int64_t g_columns, double* g) const {
  constexpr std::int64_t block = 9 * lanes;
  if (points.size() > lanes) fail(Status::err_internal, "%zu collocation points, at most %d", points.size(), lanes);
  if (h) std::fill_n(h, block * data_->mesh.nodes(), 0.0);
  if (g) std::fill_n(g, block * g_columns, 0.0);
  if (points.empty()) return;
  for (const CollocationPoint& point : points)
    if (h && point.node < 0 && point.element < 0)
      fail(Status::err_internal, "double layer at a point that is not on the mesh");
  Rows(*data_, points, {{}, nullptr, 0, g_column, g_columns}, h, g).run_whole();
}

void BoundaryIntegrals::rows_over(std::span<const CollocationPoint> points, const Columns& columns, double* h,
                                  double* g) const {
  constexpr std::int64_t block = 9 * lanes;
  if (h) std::fill_n(h, block * columns.h_count, 0.0);
  if (g) std::fill_n(g, block * columns.g_count, 0.0);
  if (!points.empty() && !columns.element.empty()) Rows(*data_, points, columns, h, g).run();
}

void BoundaryIntegrals::sums(std::span<const CollocationPoint> points, double* total) const {
  std::fill_n(total, std::size_t{9} * lanes, 0.0);
  if (!points.empty()) Rows(*data_, points, {}, total, nullptr).run_sums();
}

std::int64_t BoundaryIntegrals::kernel_evaluations() const {
  return data_->evaluations.load(std::memory_order_relaxed);
}

std::size_t BoundaryIntegrals::bytes() const {
  return sizeof(Data) + data_->element.capacity() * sizeof(ElementGeometry) + data_->far.bytes();
}

}  // namespace rollcon::bem
