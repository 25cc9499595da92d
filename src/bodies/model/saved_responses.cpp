/// Writes responses that a body keeps to a file, and reads them.

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

template <class Archive>
void own_content(Archive& ar, auto& statistics, auto& own) {
  ar(statistics.condition);
  ar(statistics.nonzeros);
  ar(own.displacement);
  ar(own.traction);
  ar(own.reaction.force);
  ar(own.reaction.moment);
}

// Rows and columns of faces follow from the mesh.
template <class Archive>
void kept_content(Archive& ar, auto& surface, auto& rows) {
  ar(surface.face);
  ar(surface.rate);
  ar(surface.slope);
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

}  // namespace

std::int64_t ResponseCache::solvable() const {
  const std::lock_guard lock(mutex_);
  return factored();
}

void ResponseCache::save(SectionWriter& file, const OwnLoads& own) const {
  const std::lock_guard lock(mutex_);
  OutArchive ar(file);
  file.begin("response");
  ar(factored());
  ar(numbering());
  own_content(ar, statistics_, own);
  if (factored() > 0) {
    file.begin("factors");
    write_factors(file);
  }
  file.begin("kept");
  ar.count(kept_.size());
  for (const Kept& entry : kept_) kept_content(ar, entry.surface, *entry.rows);
}

void ResponseCache::restore(SectionReader& file, std::size_t displacements, std::size_t tractions) {
  InArchive ar(file);
  file.begin("response");
  std::int64_t solvable = 0;
  std::uint64_t numbers = 0;
  ar(solvable);
  ar(numbers);
  own_content(ar, statistics_, own_);
  file.end();
  if (numbers != numbering())
    file.fail_here("this library numbers the unknowns of the body differently: save it again");
  const std::size_t u = own_.displacement.size(), t = own_.traction.size();
  if ((u != 0 || t != 0) && (u != displacements || t != tractions))
    file.fail_here("the displacements under loads do not fit the mesh");
  if (solvable > 0) {
    file.begin("factors");
    read_factors(file);
    file.end();
  }
  add_kept(file);
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
  for (Read& entry : all) kept_content(ar, entry.surface, *entry.rows);
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
