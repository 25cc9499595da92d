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
template <class Archive, class Entry>
void ResponseCache::content(Archive& ar, Entry& entry) const {
  ar(entry.face);
  ar(entry.layer.node);
  ar(entry.layer.type);
  ar(entry.layer.connectivity);
  auto& rows = *entry.rows;
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
  for (const Kept& entry : kept_) content(ar, entry);
}

void ResponseCache::add_kept(SectionReader& file) {
  struct Read {
    std::vector<std::int64_t> face;
    SurfaceMesh layer;
    std::shared_ptr<SurfaceRows> rows = std::make_shared<SurfaceRows>();
  };
  constexpr std::size_t least = 100;
  file.begin("kept");
  InArchive ar(file);
  std::vector<Read> all(ar.count(least));
  for (Read& entry : all) content(ar, entry);
  file.end();

  const std::lock_guard lock(mutex_);
  std::list<Kept> more;
  for (Read& entry : all) {
    SurfaceRows& rows = *entry.rows;
    const bool of_faces = entry.layer.type.empty();
    if (of_faces) {
      const std::vector<std::int32_t> given = rows.row;
      bool good = within(entry.face, surface_.elements()) &&
                  std::is_sorted(entry.face.begin(), entry.face.end());
      if (good) outline_faces(entry.face, rows);
      if (!good || given != rows.row) file.fail_here("a kept response is of other faces");
    } else {
      rows.column.resize(entry.layer.node.size());
      std::iota(rows.column.begin(), rows.column.end(), 0);
    }
    const auto columns = static_cast<std::int64_t>(rows.column.size());
    const auto seen = static_cast<std::int64_t>(rows.seen_node.size());
    if (!within(rows.row, surface_.nodes()) || !within(rows.seen_node, surface_.nodes()) ||
        !within(rows.seen_face, surface_.elements()) ||
        rows.u.rows() != 3 * static_cast<std::int64_t>(rows.row.size()) ||
        rows.u.columns() != 3 * columns || rows.seen.rows() != seen ||
        (seen > 0 && rows.seen.columns() != columns))
      file.fail_here("a kept response does not fit the body");
    if (of_faces ? find(entry.face) : find(entry.layer, rows.row)) continue;
    more.push_back({std::move(entry.face), std::move(entry.layer), std::move(entry.rows)});
  }
  kept_.splice(kept_.end(), more);
  drop();
}

}  // namespace rollcon
