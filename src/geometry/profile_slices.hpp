#pragma once
/// Represents a profile that varies along a rail or round a wheel: a surface through profiles at some places, bicubic
/// between lines that correspond from one to the next.

#include <cstddef>
#include <memory>
#include <vector>

#include "geometry/profile_curve.hpp"

namespace rollcon {

/// Holds a profile at one place u, which is a length along a rail or an angle round a wheel.
struct ProfileSlice {
  double u = 0;
  std::shared_ptr<const ProfileCurve> curve;
  /// Arc lengths of points that correspond from slice to slice, ascending; negative: missing. Empty: both ends.
  std::vector<double> feature;
};

/// Adds amplitude sin(2 pi u / length + phase) to z.
struct ProfileWave {
  double amplitude = 0, length = 0, phase = 0;
  bool operator==(const ProfileWave&) const = default;
};

/// Holds a point of a section and its derivatives by place u and column v.
struct SlicePoint {
  Vec2 x{}, u{}, v{}, uu{}, uv{}, vv{};
};

/// Between two features that some slices in a row have, the surface is a sheet: each slice's part is divided into
/// columns at common fractions of its arc length, which are equal but where a curvature jumps, and cubic splines in u
/// lead through the slices. Beyond the outermost slices a profile stays as it is there, unless it is periodic.
class ProfileSlices {
 public:
  /// Takes slices, and a period of u or 0. smooth: splines only come near to the slices, with a third of each slice's
  /// distance from the chord of its neighbours left out. Throws err_argument.
  ProfileSlices(std::vector<ProfileSlice> slice, std::vector<ProfileWave> wave, bool smooth, double period);

  /// Holds a point and its derivatives by u and by the fraction of arc length.
  struct Node {
    Vec2 x{}, u{}, f{}, uf{};
  };
  struct Sheet {
    std::vector<double> u;              ///< places of its rows, ascending
    std::size_t columns = 0;            ///< v runs from 0 to columns - 1, evenly from one to the next
    std::vector<double> fraction;       ///< place of each column in the part of each slice, 0 to 1
    std::vector<Node> node;             ///< row by row
    bool begins = false, ends = false;  ///< the profile goes on beyond the first or last row as it is there
    double last() const { return static_cast<double>(columns - 1); }
    bool has(double place) const { return (begins || place >= u.front()) && (ends || place <= u.back()); }
  };
  const std::vector<Sheet>& sheets() const { return sheet_; }
  const std::vector<ProfileSlice>& slices() const { return slice_; }
  const std::vector<ProfileWave>& waves() const { return wave_; }
  double period() const { return period_; }
  bool smooth() const { return smooth_; }
  /// Returns u within the period that the sheets cover.
  double within(double u) const;
  /// Returns a point of a sheet that has this u, which is within(); v between its ends.
  SlicePoint at(std::size_t sheet, double u, double v) const;
  /// Returns the greatest distance that waves shift a point.
  double most_wave() const;

 private:
  void add_sheets(const std::vector<ProfileSlice>& all, std::size_t first_feature, std::size_t next_feature);
  void add_sheet(const std::vector<ProfileSlice>& rows, std::size_t from, std::size_t to, bool begins, bool ends);

  std::vector<ProfileSlice> slice_;
  std::vector<ProfileWave> wave_;
  bool smooth_;
  double period_, spacing_ = 0;
  std::vector<Sheet> sheet_;
};

}  // namespace rollcon
