#pragma once
/// Adds fields of places.

#include <algorithm>
#include <vector>

#include "framing/strips/strip_contact.hpp"

namespace rollcon::strips {

/// Gives the sum of multiples of two fields; one that is not there is 0.
struct FieldSum : PlaneField {
  const PlaneField* field[2] = {};
  double factor[2] = {1, 1};

  void at(std::span<const Vec2> point, double* value, Vec2* slope) const override {
    std::fill_n(value, point.size(), 0.0);
    if (slope) std::fill_n(slope, point.size(), Vec2{});
    one_.resize(point.size());
    one_slope_.resize(point.size());
    for (const int k : {0, 1}) {
      if (!field[k]) continue;
      field[k]->at(point, one_.data(), slope ? one_slope_.data() : nullptr);
      for (std::size_t i = 0; i < point.size(); ++i) {
        value[i] += factor[k] * one_[i];
        if (slope) slope[i] = slope[i] + factor[k] * one_slope_[i];
      }
    }
  }

 private:
  mutable std::vector<double> one_;
  mutable std::vector<Vec2> one_slope_;
};

}  // namespace rollcon::strips
