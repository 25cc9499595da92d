#include "bodies/model/response_cache.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "bodies/model/body_mesh.hpp"
#include "support/error.hpp"

namespace rollcon {

bool LoadedSurface::operator==(const LoadedSurface& other) const {
  return rate == other.rate && slope == other.slope && face == other.face && row == other.row &&
         layer.node == other.layer.node && layer.type == other.layer.type &&
         layer.connectivity == other.layer.connectivity;
}

void ResponseCache::set_outline(const LoadedSurface& surface, SurfaceOutline& outline) const {
  if (surface.of_faces()) {
    outline.row = nodes_around(surface_, surface.face);
    outline.column = nodes_of(surface_, surface.face);
    return;
  }
  outline.row = surface.row;
  outline.column.resize(surface.layer.node.size());
  std::iota(outline.column.begin(), outline.column.end(), 0);
}

std::size_t ResponseCache::Kept::bytes() const {
  return rows->u.bytes() + rows->seen.bytes() + surface.face.capacity() * sizeof(std::int64_t) +
         surface.layer.node.capacity() * sizeof(Vec3) + surface.layer.connectivity.capacity() * sizeof(std::int32_t);
}

std::shared_ptr<const SurfaceRows> ResponseCache::find(const LoadedSurface& surface) {
  const auto found =
      std::find_if(kept_.begin(), kept_.end(), [&](const Kept& entry) { return entry.surface == surface; });
  if (found == kept_.end()) return nullptr;
  kept_.splice(kept_.begin(), kept_, found);
  return kept_.front().rows;
}

void ResponseCache::drop() {
  for (std::size_t bytes = kept_bytes(); bytes > most_bytes_ && kept_.size() > 1; ++dropped_) {
    bytes -= kept_.back().bytes();
    kept_.pop_back();
  }
}

std::shared_ptr<const SurfaceRows> ResponseCache::rows(const LoadedSurface& surface, int threads) {
  const std::lock_guard lock(mutex_);
  if (auto known = find(surface)) return known;
  auto rows = std::make_shared<SurfaceRows>();
  set_outline(surface, *rows);
  respond(surface, *rows, threads);
  kept_.push_front({surface, rows});
  drop();
  return rows;
}

std::shared_ptr<const SurfaceLoads> ResponseCache::loads(const LoadedSurface& surface, int threads) {
  const std::lock_guard lock(mutex_);
  std::erase_if(lent_, [](const Lent& entry) { return entry.loads.expired(); });
  for (const Lent& entry : lent_)
    if (entry.surface == surface)
      if (auto loads = entry.loads.lock()) return loads;
  auto loads = std::make_shared<SurfaceLoads>();
  set_outline(surface, *loads);
  load(surface, *loads, threads);
  lent_.push_back({surface, loads});
  return loads;
}

std::size_t ResponseCache::kept_bytes() const {
  std::size_t bytes = 0;
  for (const Kept& entry : kept_) bytes += entry.bytes();
  return bytes;
}

BodyStatistics ResponseCache::statistics_with(std::size_t bytes) const {
  BodyStatistics s = statistics_;
  s.bytes = bytes + kept_bytes();
  if (const auto equations = equations_.lock()) s.bytes += equations->bytes();
  s.responses_kept = static_cast<std::int64_t>(kept_.size());
  s.responses_dropped = dropped_;
  return s;
}

void ResponseCache::require_no_overflow(std::span<const double> u) {
  if (!std::all_of(u.begin(), u.end(), [](double v) { return std::isfinite(v); }))
    fail(Status::err_argument, "the body's loads are too large for its elastic constants: its displacements overflow");
}

void ResponseCache::count_peak(std::size_t bytes) {
  statistics_.peak_bytes = std::max(statistics_.peak_bytes, bytes);
}

}  // namespace rollcon
