#pragma once
/// Finds the height of a profile that varies, as it is seen along z, by its place along or round the body and by y.

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/profile_slices.hpp"
#include "wheelrail/visible_profile.hpp"

namespace rollcon {

/// Holds z and its derivatives by place u and by y.
struct SliceHeight {
  double z = 0, u = 0, y = 0, uu = 0, uy = 0, yy = 0;
};

class SliceHeights {
 public:
  /// Maps the profiles' plane as VisibleProfile does. Throws err_argument where nothing is to be seen.
  SliceHeights(std::shared_ptr<const ProfileSlices> slices, const ProfilePlane& map, VisibleProfile::Seen seen);

  /// Returns nullopt where there is no profile, or it is steeper than can be seen.
  std::optional<SliceHeight> at(double u, double y) const;
  /// Returns z nearly, within slack(); infinite where there is no profile.
  double rough(double u, double y) const;
  double slack() const { return slack_; }
  const ProfileSlices& slices() const { return *slices_; }

 private:
  struct Entry {
    int sheet = -1;
    float v = 0, z = 0;
  };
  /// Holds four entries about a place, and where the place is between them.
  struct Cell {
    std::array<const Entry*, 4> entry;  ///< u and y: low low, low high, high low, high high
    double t_u, t_y;
  };
  void see(std::size_t row, std::size_t sheet, double u);
  std::optional<Cell> cell(double u, double y) const;
  Vec2 mapped(const Vec2& x) const { return x[0] * map_.e_y + x[1] * map_.e_z; }
  std::optional<SliceHeight> on_sheet(std::size_t sheet, double u, double y, double v) const;

  std::shared_ptr<const ProfileSlices> slices_;
  ProfilePlane map_;
  double outward_;  ///< -1: lesser z is seen
  double low_ = 0, step_ = 0, slack_ = 0;
  std::vector<double> row_;  ///< places of rows
  std::vector<Entry> entry_;
};

}  // namespace rollcon
