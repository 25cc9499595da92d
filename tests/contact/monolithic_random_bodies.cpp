#include <algorithm>
#include <cmath>

#include "contact/monolithic_case.hpp"
#include "linalg/factored_matrix.hpp"
#include "support/frames.hpp"

namespace rollcon::monolithic_test {
namespace {

std::size_t at(std::int64_t i) {
  return static_cast<std::size_t>(i);
}

/// Stands for two elastic bodies: unknowns near every node, equations at random, and displacements interpolated with
/// bell-shaped weights.
class RandomBodies final : public Compliance {
 public:
  RandomBodies(const Frame& frame, bool direct) : frame_(frame), direct_(direct) {
    frames::Random random(11);
    for (int b = 0; b < 2; ++b) {
      auto e = std::make_shared<BodyEquations>();
      const std::int64_t n = 3 * nodes() + 5;
      e->unknowns = n;
      e->symmetric = b == 0;
      std::vector<double> k(at(n * n));
      for (std::int64_t j = 0; j < n; ++j)
        for (std::int64_t i = 0; i <= j; ++i) {
          const bool entry = b == 1 || j - i < 5 || (i * 7 + j) % 23 == 0;
          double v = entry ? 0.1 * random() : 0, w = b == 0 ? v : 0.1 * random();
          if (i == j) v = w = b == 0 ? 8 : 3;
          k[at(i + j * n)] = v;
          k[at(j + i * n)] = w;
        }
      dense_[b] = k;
      if (b == 1) {
        e->dense = k;
      } else {
        e->matrix.rows = e->matrix.columns = n;
        e->matrix.start.push_back(0);
        for (std::int64_t j = 0; j < n; ++j) {
          for (std::int64_t i = 0; i < n; ++i)
            if (const double v = k[at(i + j * n)]; v != 0) {
              e->matrix.row.push_back(i);
              e->matrix.value.push_back(v);
            }
          e->matrix.start.push_back(static_cast<std::int64_t>(e->matrix.row.size()));
        }
      }
      equations_[b] = e;
    }
  }
  std::int64_t nodes() const override { return frame_.nodes(); }
  bool couples() const override { return true; }

  double weight(double x, double y, std::int64_t k) const {
    const double dx = x - frame_.x[at(k)], dy = y - frame_.y[at(k)];
    const double h = (frame_.x[1] - frame_.x[0]);
    const double r = (dx * dx + dy * dy) / (h * h);
    return r < 2.5 ? std::exp(-2 * r) : 0;
  }
  bool expand(Points points, ExpandedCompliance& out) const override {
    const auto p = static_cast<std::int64_t>(points.size());
    for (int b = 0; b < 2; ++b) {
      ExpandedBody body;
      body.equations = equations_[b];
      body.load.rows = body.displacement.rows = equations_[b]->unknowns;
      body.load.columns = 3 * nodes();
      body.displacement.columns = 3 * p;
      body.load.start.push_back(0);
      body.displacement.start.push_back(0);
      for (std::int64_t j = 0; j < 3 * nodes(); ++j) {
        body.load.row.push_back(j);
        body.load.value.push_back(2);
        body.load.row.push_back(j + 4);
        body.load.value.push_back(0.3);
        body.load.start.push_back(static_cast<std::int64_t>(body.load.row.size()));
      }
      for (std::int64_t j = 0; j < p; ++j)
        for (std::int64_t c = 0; c < 3; ++c) {
          for (std::int64_t k = 0; k < nodes(); ++k)
            if (const double w = weight(points.x[at(j)], points.y[at(j)], k); w != 0) {
              body.displacement.row.push_back(3 * k + c);
              body.displacement.value.push_back(w);
            }
          body.displacement.start.push_back(static_cast<std::int64_t>(body.displacement.row.size()));
        }
      out.body.push_back(std::move(body));
    }
    if (!direct_) return true;
    if (out.direct.empty()) {
      out.direct.resize(3 * p, 3 * nodes());
      std::fill_n(out.direct.data(), at(9 * p * nodes()), 0.0);
    }
    for (std::int64_t j = 0; j < p; ++j)
      for (std::int64_t k = 0; k < nodes(); ++k)
        for (std::int64_t c = 0; c < 3; ++c)
          out.direct.row(3 * j + c)[3 * k + c] += 0.5 * weight(points.x[at(j)], points.y[at(j)], k);
    return true;
  }
  void block(Points points, const ComplianceBlock& out) const override {
    ExpandedCompliance e;
    expand(points, e);
    const auto p = static_cast<std::int64_t>(points.size());
    const std::int64_t n = nodes();
    std::vector<double> a(at(9 * p * n));
    for (int b = 0; b < 2; ++b) {
      const std::int64_t m = equations_[b]->unknowns;
      FactoredMatrix k;
      std::copy(dense_[b].begin(), dense_[b].end(), k.prepare(m));
      k.factor();
      std::vector<double> x(at(m * 3 * n));
      const SparseMatrix& load = e.body[at(b)].load;
      for (std::int64_t j = 0; j < 3 * n; ++j)
        for (std::int64_t i = load.start[at(j)]; i < load.start[at(j + 1)]; ++i)
          x[at(load.row[at(i)] + j * m)] += load.value[at(i)];
      k.solve(x.data(), 3 * n);
      const SparseMatrix& d = e.body[at(b)].displacement;
      for (std::int64_t r = 0; r < 3 * p; ++r)
        for (std::int64_t i = d.start[at(r)]; i < d.start[at(r + 1)]; ++i)
          for (std::int64_t j = 0; j < 3 * n; ++j) a[at(r * 3 * n + j)] += d.value[at(i)] * x[at(d.row[at(i)] + j * m)];
    }
    for (std::int64_t r = 0; r < 3 * p; ++r)
      for (std::int64_t j = 0; j < 3 * n; ++j) {
        double v = a[at(r * 3 * n + j)];
        if (direct_) v += e.direct.row(r)[j];
        if (double* to = out.a[r % 3][j % 3]) to[(r / 3) * out.stride + j / 3] = v;
      }
  }
  void apply(Points, const double*, double*) const override {}
  void set_threads(int) override {}
  std::int64_t kernel_evaluations() const override { return 0; }
  std::size_t bytes() const override { return 0; }

 private:
  const Frame& frame_;
  bool direct_;
  std::shared_ptr<const BodyEquations> equations_[2];
  std::vector<double> dense_[2];
};

}  // namespace

Case random_bodies(int n, bool direct, Scheme scheme, const Motions& motions) {
  const auto frame = square_frame(n, 1);
  return make_case(direct ? "random bodies on a half-space" : "random bodies", frame,
                   std::make_shared<RandomBodies>(*frame, direct), scheme, motions, 1, 1);
}

}  // namespace rollcon::monolithic_test
