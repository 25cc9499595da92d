#include "bodies/response_cache.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "bodies/body_mesh.hpp"

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

std::shared_ptr<const SurfaceRows> ResponseCache::faces(std::span<const std::int64_t> face,
                                                        int threads) {
  const std::lock_guard lock(mutex_);
  std::vector<std::int64_t> key(face.begin(), face.end());
  if (const auto kept = kept_.find(key); kept != kept_.end()) return kept->second;
  auto rows = std::make_shared<SurfaceRows>();
  outline_faces(key, *rows);
  respond(face, *rows, threads);
  return kept_.emplace(std::move(key), std::move(rows)).first->second;
}

std::shared_ptr<const SurfaceRows> ResponseCache::layer(const SurfaceMesh& layer,
                                                        std::span<const std::int32_t> row,
                                                        int threads) {
  const std::lock_guard lock(mutex_);
  // Both the pair's compliance and that of the body alone ask for it.
  if (last_layer_rows_ && same_mesh(last_layer_, layer) && same_rows(row, *last_layer_rows_))
    return last_layer_rows_;
  auto rows = std::make_shared<SurfaceRows>();
  outline_layer(layer, row, *rows);
  respond(layer, *rows, threads);
  last_layer_rows_.reset();
  last_layer_ = layer;
  last_layer_rows_ = rows;
  return rows;
}

std::shared_ptr<const SurfaceLoads> ResponseCache::loads_of_faces(
    std::span<const std::int64_t> face, int threads) {
  const std::lock_guard lock(mutex_);
  std::vector<std::int64_t> key(face.begin(), face.end());
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
  std::size_t bytes =
      last_layer_rows_ ? last_layer_rows_->u.bytes() + last_layer_rows_->seen.bytes() : 0;
  for (const auto& [face, rows] : kept_) bytes += rows->u.bytes();
  return bytes;
}

}  // namespace rollcon
