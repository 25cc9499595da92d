#include "linalg/condensed_factor.hpp"

#include <algorithm>
#include <utility>

#include "linalg/lapack.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

/// The solution takes so many right sides at a time.
constexpr std::int64_t block = 512;

class KeptFactor final : public SparseFactor {
 public:
  KeptFactor(std::int64_t size, std::int64_t unknowns, std::vector<std::int64_t> place,
             std::unique_ptr<double[]> matrix, const SparseStatistics& statistics)
      : size_(size),
        unknowns_(unknowns),
        place_(std::move(place)),
        matrix_(std::move(matrix)),
        statistics_(statistics) {
    statistics_.bytes = sizeof(double) * at(unknowns_ * unknowns_) + sizeof(std::int64_t) * place_.size();
    statistics_.peak_bytes = statistics_.bytes;
    statistics_.seconds_order = statistics_.seconds_factor = 0;
  }
  std::int64_t size() const override { return size_; }
  void solve(double* /*b*/, std::int64_t /*count*/) override {
    fail(Status::err_internal, "only the condensed part of the factors is there");
  }
  void solve_condensed(double* b, std::int64_t count) override { rollcon::solve_condensed(condensed(), b, count); }
  void keep_condensed() override {}
  CondensedView condensed() const override { return {unknowns_, matrix_.get(), place_}; }
  SparseStatistics statistics() const override { return statistics_; }

 private:
  std::int64_t size_;
  std::int64_t unknowns_;
  std::vector<std::int64_t> place_;
  std::unique_ptr<double[]> matrix_;
  SparseStatistics statistics_;
};

}  // namespace

void solve_condensed(const CondensedView& view, double* b, std::int64_t count) {
  if (view.unknowns == 0) return;
  const auto n = static_cast<int>(view.unknowns);
  const double one = 1;
  std::vector<double> x(at(view.unknowns * std::min(count, block)));
  for (std::int64_t first = 0; first < count; first += block) {
    const auto columns = static_cast<int>(std::min(count - first, block));
    double* part = b + first * n;
    for (std::int64_t r = 0; r < columns; ++r)
      for (std::int64_t k = 0; k < n; ++k) x[at(r * n + view.place[at(k)])] = part[r * n + k];
    dtrsm_("L", "L", "N", "N", &n, &columns, &one, view.matrix, &n, x.data(), &n);
    dtrsm_("L", "L", "T", "N", &n, &columns, &one, view.matrix, &n, x.data(), &n);
    for (std::int64_t r = 0; r < columns; ++r)
      for (std::int64_t k = 0; k < n; ++k) part[r * n + k] = x[at(r * n + view.place[at(k)])];
  }
}

std::unique_ptr<SparseFactor> make_condensed_factor(std::int64_t size, std::int64_t unknowns,
                                                    std::vector<std::int64_t> place, std::unique_ptr<double[]> matrix,
                                                    const SparseStatistics& statistics) {
  return std::make_unique<KeptFactor>(size, unknowns, std::move(place), std::move(matrix), statistics);
}

}  // namespace rollcon
