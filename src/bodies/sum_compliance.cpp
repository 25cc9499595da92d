#include "bodies/sum_compliance.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace rollcon {

SumCompliance::SumCompliance(std::vector<std::unique_ptr<Compliance>> parts)
    : parts_(std::move(parts)) {}

std::int64_t SumCompliance::nodes() const {
  return parts_.front()->nodes();
}

bool SumCompliance::couples() const {
  return std::any_of(parts_.begin(), parts_.end(),
                     [](const auto& part) { return part->couples(); });
}

void SumCompliance::block(Points points, const ComplianceBlock& out) const {
  parts_.front()->block(points, out);
  const auto n = static_cast<std::size_t>(nodes());
  std::vector<double> buffer[3][3];
  ComplianceBlock term;
  term.stride = static_cast<std::ptrdiff_t>(n);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (out.a[i][j]) {
        buffer[i][j].resize(points.size() * n);
        term.a[i][j] = buffer[i][j].data();
      }
  for (std::size_t part = 1; part < parts_.size(); ++part) {
    parts_[part]->block(points, term);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        if (!out.a[i][j]) continue;
        for (std::size_t p = 0; p < points.size(); ++p) {
          double* to = out.a[i][j] + static_cast<std::ptrdiff_t>(p) * out.stride;
          const double* from = term.a[i][j] + p * n;
          for (std::size_t k = 0; k < n; ++k) to[k] += from[k];
        }
      }
  }
}

void SumCompliance::apply(Points points, const double* traction, double* displacement) const {
  parts_.front()->apply(points, traction, displacement);
  std::vector<double> term(3 * points.size());
  for (std::size_t part = 1; part < parts_.size(); ++part) {
    parts_[part]->apply(points, traction, term.data());
    for (std::size_t i = 0; i < term.size(); ++i) displacement[i] += term[i];
  }
}

bool SumCompliance::offset(Points points, double* u) const {
  std::fill(u, u + 3 * points.size(), 0.0);
  std::vector<double> term(3 * points.size());
  bool any = false;
  for (const auto& part : parts_) {
    if (!part->offset(points, term.data())) continue;
    any = true;
    for (std::size_t i = 0; i < term.size(); ++i) u[i] += term[i];
  }
  return any;
}

bool SumCompliance::expand(Points points, ExpandedCompliance& out) const {
  return std::all_of(parts_.begin(), parts_.end(),
                     [&](const auto& part) { return part->expand(points, out); });
}

std::string SumCompliance::description() const {
  std::string text;
  for (const auto& part : parts_) {
    if (!text.empty()) text += "; ";
    text += part->description();
  }
  return text;
}

void SumCompliance::set_threads(int threads) {
  for (const auto& part : parts_) part->set_threads(threads);
}

std::int64_t SumCompliance::kernel_evaluations() const {
  std::int64_t sum = 0;
  for (const auto& part : parts_) sum += part->kernel_evaluations();
  return sum;
}

std::size_t SumCompliance::bytes() const {
  std::size_t sum = 0;
  for (const auto& part : parts_) sum += part->bytes();
  return sum;
}

}  // namespace rollcon
