#include "bodies/model/response_cache.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "bodies/model/body_mesh.hpp"

namespace rollcon {
namespace {

bool same_mesh(const SurfaceMesh& a, const SurfaceMesh& b) {
  return a.node == b.node && a.type == b.type && a.connectivity == b.connectivity;
}

bool same_rows(std::span<const std::int32_t> row, const SurfaceOutline& outline) {
  return std::equal(row.begin(), row.end(), outline.row.begin(), outline.row.end());
}

void outline_layer(const SurfaceMesh& layer, std::span<const std::int32_t> row,
                   SurfaceOutline& outline) {
  outline.row.assign(row.begin(), row.end());
  outline.column.resize(static_cast<std::size_t>(layer.nodes()));
  std::iota(outline.column.begin(), outline.column.end(), 0);
}

}  // namespace

void ResponseCache::outline_faces(const std::vector<std::int64_t>& face,
                                  SurfaceOutline& outline) const {
  outline.row = nodes_around(surface_, face);
  outline.column = nodes_of(surface_, face);
}

std::size_t ResponseCache::Kept::bytes() const {
  return rows->u.bytes() + rows->seen.bytes() + face.capacity() * sizeof(std::int64_t) +
         layer.node.capacity() * sizeof(Vec3) +
         layer.connectivity.capacity() * sizeof(std::int32_t);
}

std::shared_ptr<const SurfaceRows> ResponseCache::touch(std::list<Kept>::iterator entry) {
  kept_.splice(kept_.begin(), kept_, entry);
  return kept_.front().rows;
}

std::shared_ptr<const SurfaceRows> ResponseCache::find(std::span<const std::int64_t> face) {
  const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& entry) {
    return entry.layer.type.empty() &&
           std::equal(face.begin(), face.end(), entry.face.begin(), entry.face.end());
  });
  return found == kept_.end() ? nullptr : touch(found);
}

std::shared_ptr<const SurfaceRows> ResponseCache::find(const SurfaceMesh& layer,
                                                       std::span<const std::int32_t> row) {
  const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& entry) {
    return !entry.layer.type.empty() && same_mesh(entry.layer, layer) &&
           same_rows(row, *entry.rows);
  });
  return found == kept_.end() ? nullptr : touch(found);
}

void ResponseCache::keep(Kept&& entry) {
  kept_.push_front(std::move(entry));
  drop();
}

void ResponseCache::drop() {
  for (std::size_t bytes = kept_bytes(); bytes > most_bytes_ && kept_.size() > 1; ++dropped_) {
    bytes -= kept_.back().bytes();
    kept_.pop_back();
  }
}

std::shared_ptr<const SurfaceRows> ResponseCache::faces(std::span<const std::int64_t> face,
                                                        int threads) {
  const std::lock_guard lock(mutex_);
  if (auto known = find(face)) return known;
  Kept entry{{face.begin(), face.end()}, {}, {}};
  auto rows = std::make_shared<SurfaceRows>();
  outline_faces(entry.face, *rows);
  respond(face, *rows, threads);
  entry.rows = rows;
  keep(std::move(entry));
  return rows;
}

std::shared_ptr<const SurfaceRows> ResponseCache::layer(const SurfaceMesh& layer,
                                                        std::span<const std::int32_t> row,
                                                        int threads) {
  const std::lock_guard lock(mutex_);
  if (auto known = find(layer, row)) return known;
  auto rows = std::make_shared<SurfaceRows>();
  outline_layer(layer, row, *rows);
  respond(layer, *rows, threads);
  keep({{}, layer, rows});
  return rows;
}

std::shared_ptr<const SurfaceLoads> ResponseCache::loads_of_faces(
    std::span<const std::int64_t> face, int threads) {
  const std::lock_guard lock(mutex_);
  std::vector<std::int64_t> key(face.begin(), face.end());
  std::erase_if(loads_, [](const auto& entry) { return entry.second.expired(); });
  std::weak_ptr<const SurfaceLoads>& kept = loads_[key];
  if (auto loads = kept.lock()) return loads;
  auto loads = std::make_shared<SurfaceLoads>();
  outline_faces(key, *loads);
  load(face, *loads, threads);
  kept = loads;
  return loads;
}

std::shared_ptr<const SurfaceLoads> ResponseCache::loads_of_layer(const SurfaceMesh& layer,
                                                                  std::span<const std::int32_t> row,
                                                                  int threads) {
  const std::lock_guard lock(mutex_);
  if (auto loads = last_layer_loads_.lock();
      loads && same_mesh(last_loads_layer_, layer) && same_rows(row, *loads))
    return loads;
  auto loads = std::make_shared<SurfaceLoads>();
  outline_layer(layer, row, *loads);
  load(layer, *loads, threads);
  last_layer_loads_.reset();
  last_loads_layer_ = layer;
  last_layer_loads_ = loads;
  return loads;
}

std::size_t ResponseCache::kept_bytes() const {
  std::size_t bytes = 0;
  for (const Kept& entry : kept_) bytes += entry.bytes();
  return bytes;
}

void ResponseCache::count_kept(BodyStatistics& statistics) const {
  statistics.responses_kept = static_cast<std::int64_t>(kept_.size());
  statistics.responses_dropped = dropped_;
}

}  // namespace rollcon
