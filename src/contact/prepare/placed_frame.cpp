#include "contact/prepare/placed_frame.hpp"

#include <algorithm>
#include <cmath>

namespace rollcon {

void UnitFrame::take_frame(const Frame& frame, const Problem& problem) {
  area_ = frame.area;
  x_ = frame.x;
  y_ = frame.y;
  weight_ = frame.weight;
  cell_area_ = frame.cell_area;
  moment_x_ = problem.moment_x;
  moment_y_ = problem.moment_y;
  find_mirror();
}

void UnitFrame::find_mirror() {
  constexpr double same = 1e-12;
  mirror_.clear();
  bool upper = false;
  for (std::size_t k = 0; k < x_.size(); ++k) {
    // Nodes come line by line: images of the first ones are among the last.
    std::size_t image = x_.size();
    for (std::size_t j = x_.size(); j-- > 0 && image == x_.size();)
      if (std::abs(y_[j] + y_[k]) < same && std::abs(x_[j] - x_[k]) < same) image = j;
    upper = upper || image < k;
    if (image == x_.size() || (upper && image > k)) return mirror_.clear();
    mirror_.push_back(static_cast<std::int32_t>(image));
  }
}

void UnitFrame::take_convection(const Frame& frame, const Convection& convection) {
  ahead_ = convection.ahead;
  slip_ = convection.slip_x;
  for (std::size_t k = 0; k < slip_.size(); ++k) slip_[k] -= frame.x[k];
}

void UnitFrame::put_frame(const FramePlace& place, const std::vector<Vec3>& node, Frame& frame) const {
  const double stretch = place.length * place.width;
  std::copy(node.begin(), node.end(), frame.mesh.node.begin());
  frame.area = area_ * stretch;
  for (std::size_t k = 0; k < x_.size(); ++k) {
    frame.x[k] = place.length * x_[k] + place.shear * y_[k];
    frame.y[k] = place.width * y_[k];
    frame.weight[k] = stretch * weight_[k];
    frame.cell_area[k] = stretch * cell_area_[k];
  }
}

void UnitFrame::put_problem(const FramePlace& place, Problem& problem) const {
  const double stretch = place.length * place.width;
  problem.length = std::sqrt(area_ * stretch);
  for (std::size_t k = 0; k < x_.size(); ++k) {
    problem.weight[k] = stretch * weight_[k];
    problem.cell_area[k] = stretch * cell_area_[k];
    problem.moment_x[k] = stretch * (place.length * moment_x_[k] + place.shear * moment_y_[k]);
    problem.moment_y[k] = stretch * place.width * moment_y_[k];
  }
}

void UnitFrame::put_convection(const FramePlace& place, const Frame& frame, Convection& convection) const {
  for (std::size_t k = 0; k < x_.size(); ++k) {
    const double ahead = place.length * ahead_[k];
    convection.ahead[k] = ahead;
    convection.factor[k] = ahead > 0 ? 1 / ahead : 0;
    convection.slip_x[k] = frame.x[k] + place.length * slip_[k];
    convection.slip_y[k] = frame.y[k];
  }
}

}  // namespace rollcon
