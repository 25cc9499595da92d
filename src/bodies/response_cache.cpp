#include "bodies/response_cache.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "bodies/body_mesh.hpp"

namespace rollcon {

std::shared_ptr<const SurfaceRows> ResponseCache::faces(std::span<const std::int64_t> face,
                                                        int threads) {
  const std::lock_guard lock(mutex_);
  std::vector<std::int64_t> key(face.begin(), face.end());
  if (const auto kept = kept_.find(key); kept != kept_.end()) return kept->second;
  auto rows = std::make_shared<SurfaceRows>();
  rows->row = nodes_around(surface_, key);
  std::vector<std::uint8_t> loaded(static_cast<std::size_t>(surface_.nodes()), 0);
  for (const std::int64_t e : face)
    for (const std::int32_t k : surface_.element(e)) loaded[static_cast<std::size_t>(k)] = 1;
  for (std::size_t k = 0; k < loaded.size(); ++k)
    if (loaded[k]) rows->column.push_back(static_cast<std::int32_t>(k));
  respond(face, *rows, threads);
  return kept_.emplace(std::move(key), std::move(rows)).first->second;
}

std::shared_ptr<const SurfaceRows> ResponseCache::layer(const SurfaceMesh& layer,
                                                        std::span<const std::int32_t> row,
                                                        int threads) {
  const std::lock_guard lock(mutex_);
  // Both the pair's compliance and that of the body alone ask for it.
  if (last_layer_rows_ && last_layer_.node == layer.node && last_layer_.type == layer.type &&
      last_layer_.connectivity == layer.connectivity &&
      std::equal(row.begin(), row.end(), last_layer_rows_->row.begin(),
                 last_layer_rows_->row.end()))
    return last_layer_rows_;
  auto rows = std::make_shared<SurfaceRows>();
  rows->row.assign(row.begin(), row.end());
  rows->column.resize(static_cast<std::size_t>(layer.nodes()));
  std::iota(rows->column.begin(), rows->column.end(), 0);
  respond(layer, *rows, threads);
  last_layer_rows_.reset();
  last_layer_ = layer;
  last_layer_rows_ = rows;
  return rows;
}

std::size_t ResponseCache::kept_bytes() const {
  std::size_t bytes =
      last_layer_rows_ ? last_layer_rows_->u.bytes() + last_layer_rows_->seen.bytes() : 0;
  for (const auto& [face, rows] : kept_) bytes += rows->u.bytes();
  return bytes;
}

}  // namespace rollcon
