/// Responses that a body keeps, to and from a file.

#include <algorithm>
#include <numeric>
#include <utility>

#include "bodies/model/archive.hpp"
#include "bodies/model/response_cache.hpp"

namespace rollcon {
namespace {

bool within(const auto& ids, std::int64_t count) {
  return std::all_of(ids.begin(), ids.end(), [&](auto k) { return k >= 0 && k < count; });
}

}  // namespace

// Of faces, rows and columns follow from the mesh.
template <class Archive, class Rows>
void ResponseCache::content(Archive& ar, auto& surface, Rows& rows) const {
  ar(surface.face);
  ar(surface.layer.node);
  ar(surface.layer.type);
  ar(surface.layer.connectivity);
  ar(rows.row);
  ar(rows.seen_face);
  ar(rows.seen_node);
  ar(rows.seen);
  ar(rows.young);
  ar(rows.poisson);
  ar(rows.u);
}

void ResponseCache::save_kept(SectionWriter& file) const {
  file.begin("kept");
  OutArchive ar(file);
  ar.count(kept_.size());
  for (const Kept& entry : kept_) content(ar, entry.surface, *entry.rows);
}

void ResponseCache::add_kept(SectionReader& file) {
  struct Read {
    LoadedSurface surface;
    std::shared_ptr<SurfaceRows> rows = std::make_shared<SurfaceRows>();
  };
  constexpr std::size_t least = 100;
  file.begin("kept");
  InArchive ar(file);
  std::vector<Read> all(ar.count(least));
  for (Read& entry : all) content(ar, entry.surface, *entry.rows);
  file.end();
  const std::lock_guard lock(mutex_);
  std::list<Kept> more;
  for (auto& [surface, read] : all) {
    SurfaceRows& rows = *read;
    const std::vector<std::int32_t> given = rows.row;
    if (surface.layer.type.empty()) {
      if (!within(surface.face, surface_.elements()) || !std::is_sorted(surface.face.begin(), surface.face.end()))
        file.fail_here("a kept response is of other faces");
    } else {
      surface.face.clear();
      surface.row = given;
    }
    set_outline(surface, rows);
    if (given != rows.row) file.fail_here("a kept response is of other faces");
    const auto columns = static_cast<std::int64_t>(rows.column.size());
    const auto seen = static_cast<std::int64_t>(rows.seen_node.size());
    if (!within(rows.row, surface_.nodes()) || !within(rows.seen_node, surface_.nodes()) ||
        !within(rows.seen_face, surface_.elements()) ||
        rows.u.rows() != 3 * static_cast<std::int64_t>(rows.row.size()) || rows.u.columns() != 3 * columns ||
        rows.seen.rows() != seen || (seen > 0 && rows.seen.columns() != columns))
      file.fail_here("a kept response does not fit the body");
    if (!find(surface)) more.push_back({std::move(surface), std::move(read)});
  }
  kept_.splice(kept_.end(), more);
  drop();
}

}  // namespace rollcon
