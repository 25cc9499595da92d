#include "wheelrail/slice_heights.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "support/error.hpp"

namespace rollcon {
namespace {

constexpr std::size_t across = 1000;  // entries of a row
constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

SliceHeights::SliceHeights(std::shared_ptr<const ProfileSlices> slices, const ProfilePlane& map,
                           VisibleProfile::Seen seen)
    : slices_(std::move(slices)), map_(map), outward_(seen == VisibleProfile::Seen::from_lesser_z ? -1 : 1) {
  for (const ProfileSlice& s : slices_->slices()) row_.push_back(s.u);
  double low = infinite, high = -infinite;
  for (const ProfileSlices::Sheet& s : slices_->sheets())
    for (const ProfileSlices::Node& n : s.node) {
      const double y = map_.origin[0] + mapped(n.x)[0];
      low = std::min(low, y);
      high = std::max(high, y);
    }
  if (!(high > low))
    fail(Status::err_argument, "nothing of the slices can be seen along z; their y must rise somewhere");
  low_ = low;
  step_ = (high - low) / (across - 1);
  if (slices_->period() > 0) row_.push_back(row_.front() + slices_->period());
  entry_.resize(row_.size() * across);
  for (std::size_t k = 0; k < row_.size(); ++k)
    for (std::size_t i = 0; i < slices_->sheets().size(); ++i)
      if (slices_->sheets()[i].has(row_[k])) see(k, i, row_[k]);
  // Heights between rows are lines of the table: how far they are off is tried in the middle.
  constexpr std::size_t every = 20;
  for (std::size_t k = 0; k + 1 < row_.size(); ++k)
    for (std::size_t j = every / 2; j < across; j += every) {
      const double u = 0.5 * (row_[k] + row_[k + 1]), y = low_ + (static_cast<double>(j) + 0.5) * step_;
      const double z = rough(u, y);
      if (const auto h = at(u, y)) slack_ = std::max(slack_, std::isfinite(z) ? std::abs(h->z - z) : 0);
    }
  slack_ *= 2;
}

// Draws the section between columns into the row, over what is behind it.
void SliceHeights::see(std::size_t row, std::size_t sheet, double u) {
  const double last = slices_->sheets()[sheet].last(), part = 0.5;
  Vec2 before{};
  for (double v = 0; v <= last; v += part) {
    const Vec2 x = map_.origin + mapped(slices_->at(sheet, u, v).x);
    const double from = std::min(before[0], x[0]), to = std::max(before[0], x[0]);
    if (v > 0 && to > from) {
      const auto first = static_cast<std::size_t>(std::max(std::ceil((from - low_) / step_), 0.0));
      for (std::size_t j = first; j < across && low_ + step_ * static_cast<double>(j) <= to; ++j) {
        const double t = (low_ + step_ * static_cast<double>(j) - before[0]) / (x[0] - before[0]);
        const double z = before[1] + t * (x[1] - before[1]);
        Entry& e = entry_[row * across + j];
        if (e.sheet < 0 || outward_ * (z - static_cast<double>(e.z)) > 0)
          e = {static_cast<int>(sheet), static_cast<float>(v - part + part * t), static_cast<float>(z)};
      }
    }
    before = x;
  }
}

std::optional<SliceHeights::Cell> SliceHeights::cell(double u, double y) const {
  const double place = (y - low_) / step_;
  if (!(place >= -1 && place <= across)) return std::nullopt;
  const auto j = static_cast<std::size_t>(std::clamp(std::floor(place), 0.0, static_cast<double>(across - 2)));
  std::size_t k = 0, next = 0;
  double t = 0;
  if (row_.size() > 1 && u > row_.front()) {
    const auto after = std::upper_bound(row_.begin() + 1, row_.end() - 1, u);
    next = static_cast<std::size_t>(after - row_.begin());
    k = next - 1;
    t = std::min((u - row_[k]) / (row_[next] - row_[k]), 1.0);
  }
  const Entry *low = &entry_[k * across + j], *high = &entry_[next * across + j];
  return Cell{{low, low + 1, high, high + 1}, t, place - static_cast<double>(j)};
}

double SliceHeights::rough(double u, double y) const {
  const double here = slices_->within(u);
  const auto c = cell(here, y);
  if (!c) return infinite;
  const auto& e = c->entry;
  const int sheet = e[0]->sheet;
  if (sheet < 0 || e[1]->sheet != sheet || e[2]->sheet != sheet || e[3]->sheet != sheet) {
    const auto h = at(u, y);
    return h ? h->z : infinite;
  }
  const auto between = [&](const Entry* low, const Entry* high) {
    return static_cast<double>(low->z) + c->t_y * static_cast<double>(high->z - low->z);
  };
  const double low = between(e[0], e[1]), high = between(e[2], e[3]);
  double z = low + c->t_u * (high - low);
  if (row_.size() < 2 && !slices_->waves().empty()) {
    const double at_row = slices_->at(0, row_[0], 0).x[1];
    z += slices_->at(0, u, 0).x[1] - at_row;
  }
  return z;
}

std::optional<SliceHeight> SliceHeights::on_sheet(std::size_t sheet, double u, double y, double v) const {
  constexpr int most = 20;
  constexpr double square_is_rounding = 1e-7, steepest = 0.01, edge = 1e-6;
  const double last = slices_->sheets()[sheet].last();
  SlicePoint p;
  double step = infinite;
  int beyond = 0;
  for (int i = 0; i < most && std::abs(step) > square_is_rounding; ++i) {
    v = std::clamp(v, 0.0, last);
    p = slices_->at(sheet, u, v);
    const Vec2 d = mapped(p.v);
    if (!(std::abs(d[0]) > steepest * length(d))) return std::nullopt;
    step = (y - map_.origin[0] - mapped(p.x)[0]) / d[0];
    v += step;
    if ((v < -edge || v > last + edge) && ++beyond > 2) return std::nullopt;
  }
  if (!(std::abs(step) <= square_is_rounding)) return std::nullopt;
  const Vec2 x = mapped(p.x), xu = mapped(p.u), xv = mapped(p.v), uu = mapped(p.uu), uv = mapped(p.uv),
             vv = mapped(p.vv);
  SliceHeight h;
  h.y = xv[1] / xv[0];
  h.u = xu[1] - h.y * xu[0];
  const double y_v = (vv[1] - h.y * vv[0]) / xv[0], y_u = (uv[1] - h.y * uv[0]) / xv[0];
  const double u_u = uu[1] - y_u * xu[0] - h.y * uu[0], u_v = uv[1] - y_v * xu[0] - h.y * uv[0];
  h.yy = y_v / xv[0];
  h.uy = y_u - y_v * xu[0] / xv[0];
  h.uu = u_u - u_v * xu[0] / xv[0];
  const double off = y - map_.origin[0] - x[0];
  h.z = map_.origin[1] + x[1] + off * (h.y + off * h.yy / 2);
  h.y += off * h.yy;
  h.u += off * h.uy;
  return h;
}

std::optional<SliceHeight> SliceHeights::at(double u, double y) const {
  const double here = slices_->within(u);
  const auto c = cell(here, y);
  if (!c) return std::nullopt;
  std::optional<SliceHeight> best;
  int tried[4];
  std::size_t count = 0;
  for (const Entry* e : c->entry) {
    if (e->sheet < 0 || std::find(tried, tried + count, e->sheet) != tried + count) continue;
    tried[count++] = e->sheet;
    const auto sheet = static_cast<std::size_t>(e->sheet);
    if (!slices_->sheets()[sheet].has(here)) continue;
    // Starts between those of the four that lie on this sheet.
    double v = 0, weight = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      if (c->entry[i]->sheet != e->sheet) continue;
      const double t_y = std::clamp(c->t_y, 0.0, 1.0), least = 1e-6;
      const double w = (i < 2 ? 1 - c->t_u : c->t_u) * (i % 2 == 0 ? 1 - t_y : t_y) + least;
      v += w * static_cast<double>(c->entry[i]->v);
      weight += w;
    }
    const auto h = on_sheet(sheet, here, y, v / weight);
    if (h && (!best || outward_ * (h->z - best->z) > 0)) best = h;
  }
  return best;
}

}  // namespace rollcon
