/// Tests files of meshes: what Gmsh itself wrote (tests/data/meshes), what people write, what is said of files that are
/// none.

#include "io/mesh_file.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>

#include "mesh/volume_shape.hpp"
#include "support/error.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

namespace fs = std::filesystem;

std::string from_gmsh(const std::string& name) {
  return std::string(ROLLCON_TEST_DATA) + "/meshes/" + name;
}

std::string content(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

const MeshGroup& group(const MeshFile& file, const std::string& name) {
  for (const MeshGroup& g : file.group)
    if (g.name == name) return g;
  static const MeshGroup none{.name = "none"};
  ADD_FAILURE() << "no group " << name << " among " << names_of(file.group);
  return none;
}

using Ids = std::vector<std::int32_t>;

class MeshFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "rollcon-mesh-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    directory_ = pattern;
  }
  void TearDown() override { fs::remove_all(directory_); }

  MeshFile read(const std::string& name, const std::string& text) {
    const std::string path = (directory_ / name).string();
    std::ofstream(path, std::ios::binary) << text;
    return read_mesh_file(path);
  }
  void expect_refused(const std::string& name, const std::string& text, const std::string& said) {
    try {
      read(name, text);
      ADD_FAILURE() << "read: " << text;
    } catch (const Error& e) {
      EXPECT_EQ(e.status(), Status::err_io) << e.what();
      EXPECT_NE(std::string(e.what()).find(name + ", "), std::string::npos) << e.what();
      EXPECT_NE(std::string(e.what()).find(said), std::string::npos) << e.what() << "\nwanted: " << said;
    }
  }
  fs::path directory_;
};

struct Written {
  const char* name;
  VolumeType type;
  std::int64_t volumes;
};
const Written written[] = {
    {"tet4_22.msh", VolumeType::tet4, 12},      {"tet4.msh", VolumeType::tet4, 12},
    {"tet10.msh", VolumeType::tet10, 12},       {"tet10.inp", VolumeType::tet10, 12},
    {"wedge6.msh", VolumeType::wedge6, 4},      {"wedge15.msh", VolumeType::wedge15, 4},
    {"wedge18_22.msh", VolumeType::wedge15, 4}, {"hex8_22.msh", VolumeType::hex8, 2},
    {"hex8.inp", VolumeType::hex8, 2},          {"hex20.msh", VolumeType::hex20, 2},
    {"hex20.inp", VolumeType::hex20, 2},        {"hex27.msh", VolumeType::hex20, 2},
};

TEST_F(MeshFiles, of_gmsh_have_their_midside_nodes_between_their_corners) {
  for (const Written& w : written) {
    SCOPED_TRACE(w.name);
    const MeshFile file = part_of(read_mesh_file(from_gmsh(w.name)), w.name, "BAR", true);
    std::int64_t volumes = 0, midsides = 0;
    double off = 0;
    for (std::int64_t e = 0; e < file.elements(); ++e) {
      const auto i = static_cast<std::size_t>(e);
      if (!is_volume_type(file.type[i])) continue;
      const auto type = static_cast<VolumeType>(file.type[i]);
      ASSERT_EQ(type, w.type);
      ASSERT_EQ(file.offset[i + 1] - file.offset[i], node_count(type));
      ++volumes;
      const std::int32_t* nodes = file.connectivity.data() + file.offset[i];
      const auto at = [&](int k) { return file.node[static_cast<std::size_t>(nodes[k])]; };
      for (int k = corner_count(type); k < node_count(type); ++k) {
        const auto [a, b] = edges_of(type)[static_cast<std::size_t>(k - corner_count(type))];
        const Vec3 d = at(k) - 0.5 * (at(a) + at(b));
        off = std::max(off, std::sqrt(dot(d, d)));
        ++midsides;
      }
    }
    EXPECT_EQ(volumes, w.volumes);
    EXPECT_LT(off, 1e-11) << midsides << " midside nodes";
    // Every node is used, and the groups have what stands where they say.
    std::set<std::int32_t> used(file.connectivity.begin(), file.connectivity.end());
    EXPECT_EQ(static_cast<std::int64_t>(used.size()), file.nodes());
    for (const auto& [name, height] : {std::pair{"low_end", 0.0}, std::pair{"High_End", 2.0}}) {
      for (const std::int32_t e : group(file, name).element)
        for (std::int64_t k = file.offset[static_cast<std::size_t>(e)];
             k < file.offset[static_cast<std::size_t>(e) + 1]; ++k)
          EXPECT_NEAR(file.node[static_cast<std::size_t>(file.connectivity[static_cast<std::size_t>(k)])][2], height,
                      1e-12);
      EXPECT_FALSE(group(file, name).element.empty());
    }
  }
}

TEST_F(MeshFiles, of_gmsh_say_the_same_as_text_and_in_binary_in_both_versions) {
  const MeshFile two = read_mesh_file(from_gmsh("tet4_22.msh")), four = read_mesh_file(from_gmsh("tet4.msh"));
  EXPECT_EQ(two.node, four.node);
  EXPECT_EQ(two.type, four.type);
  EXPECT_EQ(two.tag, four.tag);
  EXPECT_EQ(two.connectivity, four.connectivity);
  EXPECT_EQ(group(two, "bar").element, group(four, "bar").element);
  EXPECT_EQ(group(four, "origin").element.size(), 1U);
  EXPECT_EQ(four.tag[static_cast<std::size_t>(group(four, "High_End").element.front())], 13);
}

const std::string abaqus =
    "** two hexahedra on top of each other, numbers with gaps\n*Heading\nanything, 1, x\n*NODE, NSET=all\n"
    " 100, 0, 0, 0\n 2,1.,0.,0.\n3, 1,1\n4, 0,1,0\n5,0,0,1\n6,1,0,1\n7,1,1,1\n8,0,1,1\n"
    "*Node\n11,0,0,2\n12,1,0,2\n13,1,1,2\n14,0,1,2\n99, 5, 5, 5\n"
    "*Element, type=C3D8R,\n  elset=Low\n1, 100,2,3,4,5,\n 6,7,8\n*ELEMENT, TYPE=C3D8I\n1000,5,6,7,8,11,12,13,14\n"
    "*element, type=MASS, elset=m\n77, 2\n*Element, TYPE=S4R, ELSET=\"Outer Skin\"\n50, 11, 12, 13, 14\n"
    "*Nset, nset=Foot, generate\n2, 4, 1\n*NSET, NSET=Foot\n100,\n*nset, nset=of_low, elset=low\n"
    "*Elset, elset=Both\nLOW, 1000\n*Surface, name=Crown, type=ELEMENT\n1000, S2\n*SURFACE, NAME=side\nBoth, s3\n"
    "*Boundary\nFoot, 1, 3\n*Step\n*Static\n1., 1.\n*End Step\n"
    "*Elset, elset=every, generate\n0, 2000, 500\n*Elset, elset=every\n1\n";

TEST_F(MeshFiles, of_abaqus_have_sets_ranges_surfaces_and_lines_that_go_on) {
  const MeshFile whole = read("two.inp", abaqus), file = part_of(whole, "two.inp", "", true);
  EXPECT_EQ(whole.nodes(), 13);
  ASSERT_EQ(file.nodes(), 12);  // nobody has node 99
  ASSERT_EQ(file.type, (Ids{338, 338, 214}));
  EXPECT_EQ(Ids(file.connectivity.begin(), file.connectivity.begin() + 8), (Ids{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(file.node[2], (Vec3{1, 1, 0}));  // a coordinate that is missing is 0
  EXPECT_EQ(group(file, "Foot").node, (Ids{0, 1, 2, 3}));
  EXPECT_EQ(group(file, "of_low").node, (Ids{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_TRUE(group(file, "of_low").element.empty());
  EXPECT_EQ(group(file, "Low").element, (Ids{0}));
  EXPECT_EQ(group(file, "Both").element, (Ids{0, 1}));
  EXPECT_EQ(group(file, "Outer Skin").element, (Ids{2}));
  EXPECT_EQ(group(file, "Crown").face, (std::vector<MeshGroup::Face>{{1, 1}}));
  EXPECT_EQ(group(file, "side").face, (std::vector<MeshGroup::Face>{{0, 2}, {1, 2}}));
  EXPECT_EQ(group(file, "every").element, (Ids{0, 1}));
  const MeshFile low = part_of(whole, "two.inp", "lOw", true);
  EXPECT_EQ(low.nodes(), 8);
  EXPECT_EQ(low.elements(), 1);
  EXPECT_EQ(group(low, "side").face, (std::vector<MeshGroup::Face>{{0, 2}}));
  const MeshFile skin = part_of(whole, "two.inp", "", false);
  EXPECT_EQ(skin.type, (Ids{214}));
  EXPECT_EQ(skin.nodes(), 4);
}

const std::string gmsh =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Comments\nfor a test\n$EndComments\n$PhysicalNames\n2\n2 7 \"a b\"\n"
    "3 7 \"solid\"\n$EndPhysicalNames\n$Nodes\n6\n10 0 0 0\n20 1 0 0\n30 0 1 0\n40 0 0 1\n50 9 9 9\n60 1 1 "
    "1e-400\n$EndNodes\n"
    "$Elements\n5\n1 15 2 3 1 20\n2 2 2 -7 1 10 30 20\n3 4 2 7 1 10 20 30 40\n4 2 0 20 60 30\n5 1 2 5 1 10 20\n"
    "$EndElements\n";

TEST_F(MeshFiles, of_gmsh_keep_names_dimensions_and_tags) {
  const MeshFile file = part_of(read("two.msh", gmsh), "two.msh", "", true);
  EXPECT_EQ(file.nodes(), 4);
  EXPECT_EQ(file.type, (Ids{304, 203}));  // a surface without name or tag says nothing of a volume
  EXPECT_EQ(file.tag, (Ids{7, 7}));
  EXPECT_EQ(group(file, "a b").element, (Ids{1}));
  EXPECT_EQ(group(file, "solid").element, (Ids{0}));
  EXPECT_EQ(group(file, "point 3").node, (Ids{1}));
  EXPECT_EQ(group(file, "curve 5").node, (Ids{0, 1}));
  EXPECT_EQ(part_of(read("two.msh", gmsh), "two.msh", "", false).type, (Ids{203, 203}));
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST_F(MeshFiles, of_gmsh_that_are_none_are_refused_by_line) {
  const std::string name = "bad.msh";
  for (const auto& [from, to, said] : std::vector<std::array<std::string, 3>>{
           {"$MeshFormat", "$NOD", "line 1: it does not begin with $MeshFormat"},
           {"2.2 0 8", "3 0 8", "line 2: it is of version '3'; allowed: 2 to 2.2 and 4.1"},
           {"2.2 0 8", "2.2 0 4", "line 2: it counts on numbers of 4 bytes"},
           {"30 0 1 0", "30 0 x 0", "line 16: 'x' is no number"},
           {"30 0 1 0", "30 0 inf 0", "line 16: a coordinate of node 30 is not finite"},
           {"30 0 1 0", "20 0 1 0", "line 16: a node with a number that another has, too"},
           {"$Nodes\n6", "$Nodes\n-6", "line 13: the number of nodes is -6"},
           {"$Nodes\n6", "$Nodes\n1000000000", "line 13: the number of nodes is 1000000000; the file has room for "},
           {"$Nodes\n6", "$Nodes\n5", "$EndNodes is missing"},
           {"$Elements\n5", "$Elements\n99999999999", "line 22: the number of elements is 99999999999"},
           {"3 4 2 7 1 10 20 30 40", "3 7 2 7 1 10 20 30 40 60", "line 25: element 3 is of Gmsh's type 7; allowed: "},
           {"3 4 2 7 1 10 20 30 40", "3 4 2 7 1 10 20 30 41", "line 25: an element has node 41, which the file lacks"},
           {"4 2 0 20", "4 2 -2 20", "line 26: the number of an element's tags is -2"},
           {"3 4 2 7", "2 4 2 7", "line 25: an element with a number that another has, too"},
           {"\"solid\"", "solid", "line 10: no name in quotation marks"},
           {"$EndComments", "$EndComment", "$EndComments' is missing: truncated"},
           {"$Nodes", "$Nodos", "'$EndNodos' is missing"}}) {
    SCOPED_TRACE(to);
    expect_refused(name, with(gmsh, from, to), said);
  }
  const std::string four = content(from_gmsh("tet4.msh"));
  expect_refused(name, with(four, "4.1 0 8", "4 0 8"), "line 2: it is of version '4'");
  expect_refused(name, with(four, "$Entities", "$PartitionedEntities"), "the mesh is partitioned");
  const std::string binary = content(from_gmsh("tet10.msh"));
  std::string swapped = binary;
  std::swap(swapped[swapped.find("4.1 1 8\n") + 8], swapped[swapped.find("4.1 1 8\n") + 11]);
  expect_refused(name, swapped, "byte 24: it was written with another byte order");
}

TEST_F(MeshFiles, of_abaqus_that_are_none_are_refused_by_line) {
  const std::string name = "bad.inp";
  for (const auto& [from, to, said] : std::vector<std::array<std::string, 3>>{
           {"** two", "two", "line 1: no keyword"},
           {"2,1.,0.,0.", "2,1.,zero,0.", "line 6: 'zero' is no number"},
           {"2,1.,0.,0.", "2.5,1.,0.,0.", "line 6: '2.5' is no integer"},
           {"type=C3D8R,\n", "type=C3D5,\n", "line 20: elements of type C3D5; allowed: "},
           {" 6,7,8\n", " 6,7,8,9\n", "line 21: an element of 9 nodes; its type has 8"},
           {" 6,7,8\n", " 6,7\n", "line 21: an element of 7 nodes"},
           {"1000,5,6,7,8", "1000,5,6,7,80", "line 24: an element has node 80"},
           {"1000,5,6", "1,5,6", "line 24: an element with a number that another has, too"},
           {"2, 4, 1\n", "4, 2, 1\n", "a range that goes nowhere"},
           {"2, 4, 1\n", "2, 4, 0\n", "a range that goes nowhere"},
           {"LOW, 1000", "nowhere, 1000", "line 35: no set 'nowhere' before this line"},
           {"1000, S2", "1000, S7", "line 37: face 'S7'; allowed: S1 to S6, SPOS, SNEG"},
           {"1000, S2", "1000", "line 37: face missing of an element; allowed for its type: S1 to S6"},
           {"1000, S2", "1001, S2", "line 37: there is no element 1001"},
           {"*Boundary", "*Include, input=other.inp", "line 40: *INCLUDE is not followed"},
           {"*Boundary", "*NGEN", "line 40: *NGEN is not read"},
           {"*Boundary", "*Part, name=a\n*Part, name=b", "line 41: a second *PART"},
           {"*Boundary", "*Symmetric Model Generation", "line 40: *SYMMETRICMODELGENERATION is not read"},
           {"*Boundary", "*Cyclic Symmetry Model, n=12", "line 40: *CYCLICSYMMETRYMODEL is not read"},
           {"*Boundary", "*Node, input=n.txt", "line 40: *NODE with INPUT is not followed: put the mesh into one file"},
           {"*Boundary", "*Element, type=C3D8, input=e.txt", "line 40: *ELEMENT with INPUT is not followed"},
           {"*Boundary", "*Nset, nset=n, input=n.txt", "line 40: *NSET with INPUT is not followed"},
           {"*Boundary", "*Elset, elset=n, input=n.txt", "line 40: *ELSET with INPUT is not followed"},
           {"*Boundary", "*Surface, name=n, input=n.txt", "line 40: *SURFACE with INPUT is not followed"},
           {"*Boundary", "*System", "line 40: *SYSTEM is not read"},
           {"*Node\n", "*Node, system=C\n", "line 13: *NODE with SYSTEM=C"},
           {"*Nset, nset=Foot, generate", "*Nset, generate", "*NSET without NSET"}}) {
    SCOPED_TRACE(to);
    expect_refused(name, with(abaqus, from, to), said);
  }
  try {
    read("empty.inp", "*Heading\n");
    ADD_FAILURE();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("it has no *ELEMENT of a surface or a volume"), std::string::npos);
  }
}

// Keywords that make or name mesh are read, or told by kind and number.
TEST_F(MeshFiles, of_abaqus_tell_what_they_pass_over) {
  const std::string cube =
      "*NODE\n1\n2, 1.\n3,1,1,\n4,0,1,0\n5,0,0,1\n6,1,0,1\n7,1,1,1\n8,0,1,1\n9,0,0,2\n10,1,0,2\n11,1,1,2\n12,0,1,2\n"
      "13,0,0,3\n*ELEMENT, TYPE=C3D8, ELSET=cube\n1, 1,2,3,4,5,6,7,8\n";
  const auto whole = [&](const std::string& more) {
    return part_of(read("told.inp", cube + more), "told.inp", "", true);
  };
  EXPECT_EQ(whole("").told, "");
  EXPECT_EQ(whole("").node[1], (Vec3{1, 0, 0})) << "coordinates left out are 0";
  const MeshFile shell = whole("*ELEMENT, TYPE=SC8R\n2, 5,6,7,8,9,10,11,12\n*NSET, NSET=Top\n9,10,11,12\n");
  EXPECT_EQ(shell.elements(), 2) << "a continuum shell is a hexahedron";
  EXPECT_EQ(group(shell, "Top").node.size(), 4U);
  EXPECT_EQ(shell.told, "");
  const std::string others =
      "*ELEMENT, TYPE=COH3D8\n2, 5,6,7,8,\n9,10,11,12\n3, 5,6,7,8,9,10,11,12\n*ELEMENT, TYPE=B31\n4, 7,13\n";
  EXPECT_EQ(whole(others).told, "passed over: elements of type B31 (1), elements of type COH3D8 (2)");
  EXPECT_EQ(
      whole(others + "*NSET, NSET=Far\n13\n").told,
      "passed over: elements of type B31 (1), elements of type COH3D8 (2); group without anything of the mesh: Far");
  EXPECT_EQ(whole("*NSET, NSET=Some\n5, 98, 99\n*ELSET, ELSET=None\n77\n*MODEL CHANGE, REMOVE\nNone\n").told,
            "passed over: *MODELCHANGE (1), elements of sets, not in the file (1), nodes of sets, not in "
            "the file (2)");
  const MeshFile surfaces =
      whole(others +
            "*SURFACE, NAME=top\ncube, S2\n*SURFACE, NAME=side\n1, S3\n4, END1\n4, S1\n"
            "*SURFACE, NAME=both, COMBINE=UNION\ntop, side\n*SURFACE, NAME=less, COMBINE=DIFFERENCE\n"
            "top, side\n*SURFACE, NAME=plane, TYPE=CYLINDER\nSTART, 0, 0\n");
  EXPECT_EQ(group(surfaces, "side").face.size(), 1U);
  EXPECT_EQ(group(surfaces, "both").face.size(), 2U);
  for (const char* word : {"edges and ends in surfaces (1)", "faces of elements that are passed over (1)",
                           "surfaces of type CYLINDER (1)", "surfaces combined by DIFFERENCE (1)"})
    EXPECT_NE(surfaces.told.find(word), std::string::npos) << surfaces.told;
}

TEST_F(MeshFiles, of_gmsh_may_name_groups_without_their_dimension) {
  const MeshFile file =
      read("names.msh",
           "$MeshFormat\n2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n7 \"block\"\n2 9 \"top\"\n"
           "$EndPhysicalNames\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n$Elements\n2\n"
           "1 4 2 7 1 1 2 3 4\n2 2 2 9 1 1 2 3\n$EndElements\n");
  EXPECT_EQ(group(file, "block").element, Ids{0});
  EXPECT_EQ(group(file, "top").element, Ids{1});
}

TEST_F(MeshFiles, cannot_make_the_library_ask_for_more_memory_than_they_have_bytes) {
  // Sets of sets hold twice as many members in each as in the last one.
  std::string chain = abaqus + "*Elset, elset=s0\n1, 1000\n";
  for (int i = 1; i < 60; ++i)
    chain +=
        "*Elset, elset=s" + std::to_string(i) + "\ns" + std::to_string(i - 1) + ",s" + std::to_string(i - 1) + "\n";
  expect_refused("chain.inp", chain, "the groups have too many members for a file of this size");
  expect_refused("range.inp", with(abaqus, "2, 4, 1\n", "-9223372036854775808, 9223372036854775807, 1\n2, 4, 0\n"),
                 "a range that goes nowhere");
  EXPECT_EQ(
      group(read("range.inp", with(abaqus, "2, 4, 1\n", "-9223372036854775808, 9223372036854775807, 1\n")), "Foot")
          .node.size(),
      13U);
}

TEST_F(MeshFiles, may_number_by_all_that_64_bits_hold) {
  constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();
  for (const std::int64_t other : {std::int64_t{1} << 30, std::int64_t{1} << 36, std::int64_t{1} << 62,
                                   std::numeric_limits<std::int64_t>::max()}) {
    const std::string a = std::to_string(least), b = std::to_string(other);
    const MeshFile in =
        read("ends.inp", "*Node\n" + a + ",0,0,0\n1,1,0,0\n2,0,1,0\n" + b + ",0,0,1\n" + "*Element, type=C3D4\n" + a +
                             "," + a + ",1,2," + b + "\n" + "*Nset, nset=ends\n" + a + "," + b + "\n");
    const MeshFile ms = read(
        "ends.msh", "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 4 " + a + " " + b + "\n3 1 0 4\n" + a +
                        "\n1\n2\n" + b + "\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n$EndNodes\n$Elements\n1 1 1 1\n3 1 4 1\n1 " +
                        a + " 1 2 " + b + "\n$EndElements\n");
    for (const MeshFile* file : {&in, &ms}) {
      const std::vector<std::int32_t> wanted{0, 1, 2, 3};
      EXPECT_EQ(file->connectivity, wanted) << other;
    }
    EXPECT_EQ(group(in, "ends").node.size(), 2U);
  }
}

TEST_F(MeshFiles, cut_off_anywhere_or_spoilt_are_refused_or_read) {
  int refused = 0, read_well = 0;
  const auto attempt = [&](const std::string& name, const std::string& text) {
    try {
      part_of(read(name, text), name, "", true);
      ++read_well;
    } catch (const Error& e) {
      EXPECT_TRUE(e.status() == Status::err_io || e.status() == Status::err_mesh) << e.what();
      ++refused;
    }
  };
  for (const char* name : {"hex20.inp", "hex20.msh", "wedge18_22.msh"}) {
    const std::string text = content(from_gmsh(name));
    for (std::size_t n = 0; n < text.size(); n += 24) attempt(name, text.substr(0, n));
    for (std::size_t n = 0; n < text.size(); n += 40) {
      std::string spoilt = text;
      spoilt[n] = static_cast<char>(spoilt[n] ^ 0x55);
      attempt(name, spoilt);
    }
  }
  EXPECT_GT(refused, 200);
  EXPECT_GT(read_well, 20);
  std::printf("%d refused, %d read\n", refused, read_well);
}

}  // namespace
}  // namespace rollcon
