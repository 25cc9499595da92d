#include "io/mesh_builder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/profile_lines.hpp"

namespace rollcon {
namespace {

template <class T>
void make_set(std::vector<T>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  list.shrink_to_fit();
}

constexpr std::int64_t most_entries = std::numeric_limits<std::int32_t>::max();

}  // namespace

std::int64_t Numbering::sort() {
  sorted_.reserve(given_.size());
  for (std::size_t i = 0; i < given_.size(); ++i) sorted_.emplace_back(given_[i], static_cast<std::int64_t>(i));
  if (!std::is_sorted(given_.begin(), given_.end())) std::sort(sorted_.begin(), sorted_.end());
  for (std::size_t i = 1; i < sorted_.size(); ++i)
    if (sorted_[i].first == sorted_[i - 1].first) return sorted_[i].second;
  return -1;
}

std::int64_t Numbering::find(std::int64_t number) const {
  if (sorted_.empty() || number < sorted_.front().first || number > sorted_.back().first) return -1;
  // Most files number without gaps, so the place is guessed first. Unsigned arithmetic holds the difference of any two
  // numbers.
  const auto guess = static_cast<std::uint64_t>(number) - static_cast<std::uint64_t>(sorted_.front().first);
  if (guess < sorted_.size() && sorted_[guess].first == number) return sorted_[guess].second;
  const auto found = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair{number, std::int64_t{-1}});
  return found != sorted_.end() && found->first == number ? found->second : -1;
}

void Numbering::each_between(std::int64_t first, std::int64_t last, std::int64_t step,
                             const std::function<void(std::int64_t)>& visit) const {
  for (auto i = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair{first, std::int64_t{-1}});
       i != sorted_.end() && i->first <= last; ++i) {
    const auto apart = static_cast<std::uint64_t>(i->first) - static_cast<std::uint64_t>(first);
    if (apart % static_cast<std::uint64_t>(step) == 0) visit(i->second);
  }
}

void MeshBuilder::add_node(std::int64_t number, const Vec3& x, std::int64_t at) {
  if (file_.nodes() >= most_entries) fail_(at, "more than 2147483647 nodes");
  for (const double c : x)
    if (!std::isfinite(c)) fail_(at, "a coordinate of node " + std::to_string(number) + " is not finite");
  nodes_.add(number);
  file_.number.push_back(number);
  node_at_.push_back(at);
  file_.node.push_back(x);
}

void MeshBuilder::add_element(std::int64_t number, const ForeignType& type, const std::int64_t* nodes, std::int32_t tag,
                              std::int64_t at) {
  if (file_.elements() >= most_entries) fail_(at, "more than 2147483647 elements");
  elements_.add(number);
  element_at_.push_back(at);
  file_.type.push_back(type.type);
  file_.tag.push_back(tag);
  for (int i = 0; i < type.kept; ++i) numbers_.push_back(nodes[type.order ? type.order[i] : i]);
  file_.offset.push_back(static_cast<std::int64_t>(numbers_.size()));
}

std::size_t MeshBuilder::group(const std::string& name) {
  const auto [entry, made] = by_name_.try_emplace(in_lower_case(name), file_.group.size());
  if (made) file_.group.push_back({.name = name});
  return entry->second;
}

std::int64_t MeshBuilder::find_group(const std::string& name) const {
  const auto found = by_name_.find(in_lower_case(name));
  return found == by_name_.end() ? -1 : static_cast<std::int64_t>(found->second);
}

void MeshBuilder::finish_mesh() {
  if (const std::int64_t twice = nodes_.sort(); twice >= 0)
    fail_(node_at_[static_cast<std::size_t>(twice)], "a node with a number that another has, too");
  if (const std::int64_t twice = elements_.sort(); twice >= 0)
    fail_(element_at_[static_cast<std::size_t>(twice)], "an element with a number that another has, too");
  file_.connectivity.reserve(numbers_.size());
  for (std::size_t e = 0; e < file_.type.size(); ++e) {
    for (std::int64_t k = file_.offset[e]; k < file_.offset[e + 1]; ++k) {
      const std::int64_t number = numbers_[static_cast<std::size_t>(k)], node = nodes_.find(number);
      if (node < 0) fail_(element_at_[e], "an element has node " + std::to_string(number) + ", which the file lacks");
      file_.connectivity.push_back(static_cast<std::int32_t>(node));
    }
  }
  numbers_ = {};
  node_at_ = {};
  element_at_ = {};
}

void MeshBuilder::count(std::size_t more, std::int64_t at) {
  members_ += static_cast<std::int64_t>(more);
  if (members_ > most_members_) fail_(at, "the groups have too many members for a file of this size");
}

void MeshBuilder::put_element(std::size_t group, std::int64_t element, std::int64_t at) {
  count(1, at);
  file_.group[group].element.push_back(static_cast<std::int32_t>(element));
}

void MeshBuilder::put_node(std::size_t group, std::int64_t node, std::int64_t at) {
  count(1, at);
  file_.group[group].node.push_back(static_cast<std::int32_t>(node));
}

void MeshBuilder::put_nodes_of(std::size_t group, std::int64_t element, std::int64_t at) {
  const auto e = static_cast<std::size_t>(element);
  for (std::int64_t k = file_.offset[e]; k < file_.offset[e + 1]; ++k)
    put_node(group, file_.connectivity[static_cast<std::size_t>(k)], at);
}

void MeshBuilder::put_face(std::size_t group, std::int64_t element, std::int32_t side, std::int64_t at) {
  count(1, at);
  file_.group[group].face.push_back({static_cast<std::int32_t>(element), side});
}

void MeshBuilder::put_group(std::size_t into, std::size_t from, std::int64_t at) {
  if (into == from) return;
  MeshGroup& to = file_.group[into];
  const MeshGroup& source = file_.group[from];
  count(source.element.size() + source.node.size() + source.face.size(), at);
  to.element.insert(to.element.end(), source.element.begin(), source.element.end());
  to.node.insert(to.node.end(), source.node.begin(), source.node.end());
  to.face.insert(to.face.end(), source.face.begin(), source.face.end());
}

MeshFile MeshBuilder::take() {
  for (MeshGroup& g : file_.group) {
    make_set(g.element);
    make_set(g.node);
    make_set(g.face);
  }
  std::erase_if(file_.group, [](const MeshGroup& g) { return g.element.empty() && g.node.empty() && g.face.empty(); });
  return std::move(file_);
}

}  // namespace rollcon
