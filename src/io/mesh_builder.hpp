#pragma once
/// Builds a MeshFile while its file is read: numbers of the file become places, groups get their names.

#include <cstdint>
#include <functional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "io/mesh_file.hpp"
#include "io/mesh_types.hpp"

namespace rollcon {

/// Maps the numbers that a file gives, which may be any, to places from 0.
class Numbering {
 public:
  void add(std::int64_t number) { given_.push_back(number); }
  /// Sorts the numbers once all are added. Returns the place of one that was added before, -1 if all differ.
  std::int64_t sort();
  /// Returns -1 if the number is not there.
  std::int64_t find(std::int64_t number) const;
  /// Calls visit(place) for the numbers first, first + step, ... up to last that are there.
  void each_between(std::int64_t first, std::int64_t last, std::int64_t step,
                    const std::function<void(std::int64_t)>& visit) const;

 private:
  std::vector<std::int64_t> given_;
  std::vector<std::pair<std::int64_t, std::int64_t>> sorted_;  ///< number, place
};

class MeshBuilder {
 public:
  /// Throws an error that names the file and the place, an offset in it.
  using Fail = std::function<void(std::int64_t at, const std::string& what)>;
  /// Takes the size of the file in bytes, which bounds what its groups may hold together.
  MeshBuilder(std::int64_t bytes, Fail fail) : most_members_(2 * bytes + 1000), fail_(std::move(fail)) {}

  void add_node(std::int64_t number, const Vec3& x, std::int64_t at);
  /// Adds an element; `nodes` has as many numbers as the type has nodes in the file.
  void add_element(std::int64_t number, const ForeignType& type, const std::int64_t* nodes, std::int32_t tag,
                   std::int64_t at);
  /// Returns the next element's place.
  std::int64_t elements() const { return file_.elements(); }
  /// Returns the group with this name, which is made if there is none.
  std::size_t group(const std::string& name);
  /// Returns -1 if there is no such group.
  std::int64_t find_group(const std::string& name) const;

  /// Turns numbers into places after the last node and element. Fails where two are alike or a node is missing.
  void finish_mesh();
  const Numbering& node_numbers() const { return nodes_; }
  const Numbering& element_numbers() const { return elements_; }

  // Adds members to groups; all are counted against the bound.
  void put_element(std::size_t group, std::int64_t element, std::int64_t at);
  void put_node(std::size_t group, std::int64_t node, std::int64_t at);
  void put_face(std::size_t group, std::int64_t element, std::int32_t side, std::int64_t at);
  void put_nodes_of(std::size_t group, std::int64_t element, std::int64_t at);
  /// Adds all members of one group to another.
  void put_group(std::size_t into, std::size_t from, std::int64_t at);
  const MeshGroup& members(std::size_t group) const { return file_.group[group]; }
  std::int32_t type_of(std::int64_t element) const { return file_.type[static_cast<std::size_t>(element)]; }

  MeshFile take();

 private:
  void count(std::size_t more, std::int64_t at);

  MeshFile file_;
  Numbering nodes_, elements_;
  std::vector<std::int64_t> numbers_;                     ///< the nodes of all elements, until finish_mesh
  std::vector<std::int64_t> node_at_, element_at_;        ///< where the file has them
  std::unordered_map<std::string, std::size_t> by_name_;  ///< names in lower case
  std::int64_t members_ = 0, most_members_;
  Fail fail_;
};

}  // namespace rollcon
