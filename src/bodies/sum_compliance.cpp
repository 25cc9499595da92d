#include "bodies/sum_compliance.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "linalg/dense.hpp"

namespace rollcon {
namespace {

class SumCompliance final : public Compliance {
 public:
  explicit SumCompliance(std::vector<std::unique_ptr<Compliance>> parts) : parts_(std::move(parts)) {}
  std::int64_t nodes() const override { return parts_.front()->nodes(); }
  bool couples() const override {
    return std::any_of(parts_.begin(), parts_.end(), [](const auto& part) { return part->couples(); });
  }
  void block(Points points, const ComplianceBlock& out) const override;
  void apply(Points points, const double* traction, double* displacement) const override {
    add(points, displacement, [&](const Compliance& part, double* u) {
      part.apply(points, traction, u);
      return true;
    });
  }
  bool offset(Points points, double* displacement) const override {
    return add(points, displacement, [&](const Compliance& part, double* u) { return part.offset(points, u); });
  }
  bool expand(Points points, ExpandedCompliance& out) const override {
    return std::all_of(parts_.begin(), parts_.end(), [&](const auto& part) { return part->expand(points, out); });
  }
  bool near_halfspaces(Points points, NearHalfspaces& out) const override {
    return std::all_of(parts_.begin(), parts_.end(),
                       [&](const auto& part) { return part->near_halfspaces(points, out); });
  }
  void find_meshes(std::array<MeshOnFrame, 2>& found) const override {
    for (const auto& part : parts_) part->find_meshes(found);
  }
  std::string description() const override {
    std::string text;
    for (const auto& part : parts_) {
      if (!text.empty()) text += "; ";
      text += part->description();
    }
    return text;
  }
  void set_threads(int threads) override {
    for (const auto& part : parts_) part->set_threads(threads);
  }
  std::int64_t kernel_evaluations() const override {
    return total<std::int64_t>([](const Compliance& part) { return part.kernel_evaluations(); });
  }
  std::size_t bytes() const override {
    return total<std::size_t>([](const Compliance& part) { return part.bytes(); });
  }

 private:
  template <class T, class Of>
  T total(Of of) const {
    T sum = 0;
    for (const auto& part : parts_) sum += of(*part);
    return sum;
  }
  /// Sums what of(part, u) writes for the parts that have something; false where none has.
  template <class Of>
  bool add(Points points, double* sum, Of of) const {
    std::fill(sum, sum + 3 * points.size(), 0.0);
    std::vector<double> u(3 * points.size());
    bool any = false;
    for (const auto& part : parts_) {
      if (!of(*part, u.data())) continue;
      any = true;
      axpy(1, u.data(), sum, static_cast<std::int64_t>(u.size()));
    }
    return any;
  }

  std::vector<std::unique_ptr<Compliance>> parts_;
};

void SumCompliance::block(Points points, const ComplianceBlock& out) const {
  parts_.front()->block(points, out);
  const BlockBuffer term(out, parts_.size() > 1 ? points.size() : 0, nodes());
  for (std::size_t part = 1; part < parts_.size(); ++part) {
    parts_[part]->block(points, term.block());
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t p = 0; out.a[i][j] && p < points.size(); ++p)
          axpy(1, term.row(i, j, p), out.a[i][j] + static_cast<std::ptrdiff_t>(p) * out.stride, nodes());
  }
}

}  // namespace

std::unique_ptr<Compliance> make_sum(std::vector<std::unique_ptr<Compliance>> parts) {
  if (parts.size() == 1) return std::move(parts.front());
  return std::make_unique<SumCompliance>(std::move(parts));
}

}  // namespace rollcon
