#include "contact/laws/wear_law.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "support/error.hpp"

namespace rollcon {
namespace {

void require_rates(std::span<const double> value) {
  if (value.size() < 4 || value.size() % 2 != 0)
    fail(Status::err_argument,
         "n is %lld; allowed for \"t_gamma\": an even number of 4 or more, pairs of energy and rate",
         static_cast<long long>(value.size()));
  for (std::size_t k = 0; k < value.size(); k += 2) {
    if (value[k] < 0 || value[k + 1] < 0)
      fail(Status::err_argument, "pair %lld (counting from 0) is %g, %g; allowed: 0 or more",
           static_cast<long long>(k / 2), value[k], value[k + 1]);
    if (k > 0 && !(value[k] > value[k - 2]))
      fail(Status::err_argument, "energy %lld (counting from 0) is %g; allowed: above that before it, %g",
           static_cast<long long>(k / 2), value[k], value[k - 2]);
  }
  const std::size_t last = value.size() - 2;
  if (value[last + 1] < value[last - 1])
    fail(Status::err_argument,
         "the last rate is %g; allowed: %g or more, that before it: beyond, rates go on as between them",
         value[last + 1], value[last - 1]);
}

}  // namespace

WearLaw::WearLaw(const char* name, std::span<const double> parameters) : value_(parameters.begin(), parameters.end()) {
  const bool archard = std::strcmp(name, "archard") == 0;
  if (!archard && std::strcmp(name, "t_gamma") != 0)
    fail(Status::err_option, "unknown law of wear '%.60s'; known: archard, t_gamma", name);
  kind_ = archard ? Kind::archard : Kind::t_gamma;
  for (std::size_t k = 0; k < value_.size(); ++k)
    if (!std::isfinite(value_[k]))
      fail(Status::err_nonfinite, "parameter %lld (counting from 0) is %g", static_cast<long long>(k), value_[k]);
  if (!archard) {
    require_rates(value_);
    return;
  }
  if (value_.size() != 1 && value_.size() != 3)
    fail(Status::err_argument, "n is %lld; allowed for \"archard\": 1, or 3 (i1, i2, angle)",
         static_cast<long long>(value_.size()));
  for (std::size_t k = 0; k < std::min<std::size_t>(value_.size(), 2); ++k)
    if (value_[k] < 0)
      fail(Status::err_argument, "coefficient %lld (counting from 0) is %g; allowed: 0 or more",
           static_cast<long long>(k), value_[k]);
  if (value_.size() == 3) cosine_ = std::cos(value_[2]), sine_ = std::sin(value_[2]);
}

double WearLaw::rate(double pressure, const double (&traction)[2], const double (&slip)[2]) const {
  if (kind_ == Kind::archard) {
    if (value_.size() == 1) return value_[0] * pressure * std::hypot(slip[0], slip[1]);
    const double s1 = cosine_ * slip[0] + sine_ * slip[1], s2 = cosine_ * slip[1] - sine_ * slip[0];
    return pressure * std::hypot(value_[0] * s1, value_[1] * s2);
  }
  const double energy = std::max(0.0, -(traction[0] * slip[0] + traction[1] * slip[1]));
  if (energy <= value_[0]) return value_[0] > 0 ? value_[1] * energy / value_[0] : value_[1] * (energy > 0);
  std::size_t k = 2;
  while (k + 2 < value_.size() && energy > value_[k]) k += 2;
  const double slope = (value_[k + 1] - value_[k - 1]) / (value_[k] - value_[k - 2]);
  return value_[k + 1] + slope * (energy - value_[k]);
}

}  // namespace rollcon
