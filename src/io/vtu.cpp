#include "io/vtu.hpp"

#include <charconv>
#include <cmath>

#include "io/whole_file.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

/// Returns VTK's cell type, whose node order is that of ElementType.
int vtk_type(ElementType type) {
  if (type == ElementType::quad9) return 28;
  const bool triangle = corner_count(type) == 3;
  return is_quadratic(type) ? (triangle ? 22 : 23) : (triangle ? 5 : 9);
}

int vtk_type(VolumeType type) {
  const int corners = corner_count(type);
  return is_quadratic(type) ? (corners == 4   ? 24
                               : corners == 6 ? 26
                                              : 25)
                            : (corners == 4   ? 10
                               : corners == 6 ? 13
                                              : 12);
}

class Text {
 public:
  Text& operator<<(const char* s) {
    text_ += s;
    return *this;
  }
  template <class Number>
  void number(Number value, char separator) {
    char digits[40];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    text_.append(digits, end);
    text_ += separator;
  }
  /// Writes an attribute's value with the characters that XML reserves replaced.
  Text& quoted(const std::string& value) {
    text_ += '"';
    for (char c : value) {
      switch (c) {
        case '&':
          text_ += "&amp;";
          break;
        case '<':
          text_ += "&lt;";
          break;
        case '>':
          text_ += "&gt;";
          break;
        case '"':
          text_ += "&quot;";
          break;
        default:
          text_ += c;
      }
    }
    text_ += '"';
    return *this;
  }
  const std::string& str() const { return text_; }

 private:
  std::string text_;
};

void open_array(Text& out, const char* type, const std::string& name, int components) {
  out << "<DataArray type=\"" << type << "\" Name=";
  out.quoted(name) << " NumberOfComponents=\"";
  out.number(components, '"');
  out << " format=\"ascii\">\n";
}

template <class Number>
void write_rows(Text& out, const Number* values, std::int64_t rows, int components) {
  for (std::int64_t k = 0; k < rows; ++k)
    for (int i = 0; i < components; ++i) out.number(values[k * components + i], i + 1 == components ? '\n' : ' ');
  out << "</DataArray>\n";
}

void check_finite(const PointArray& array, const SurfaceMesh& mesh) {
  for (std::int64_t k = 0; k < mesh.nodes() * array.components; ++k)
    if (!std::isfinite(array.real[k]))
      fail(Status::err_nonfinite, "array '%s' is not finite at node %lld (counting from %d)", array.name.c_str(),
           static_cast<long long>(k / array.components + mesh.index_base), mesh.index_base);
}

template <class Cells>
void write_cells(Text& out, const Cells& mesh) {
  out << "<Cells>\n";
  open_array(out, "Int32", "connectivity", 1);
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const auto nodes = mesh.element(e);
    for (std::size_t i = 0; i < nodes.size(); ++i) out.number(nodes[i], i + 1 == nodes.size() ? '\n' : ' ');
  }
  out << "</DataArray>\n";
  open_array(out, "Int64", "offsets", 1);
  std::int64_t end = 0;
  for (const auto type : mesh.type) out.number(end += node_count(type), '\n');
  out << "</DataArray>\n";
  open_array(out, "UInt8", "types", 1);
  for (const auto type : mesh.type) out.number(vtk_type(type), '\n');
  out << "</DataArray>\n</Cells>\n";
}

/// Takes as `cells` the mesh itself, or volume elements with its nodes.
template <class Cells>
std::string file_text(const SurfaceMesh& mesh, const Cells& cells, std::span<const PointArray> arrays) {
  Text out;
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
         "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"";
  out.number(mesh.nodes(), '"');
  out << " NumberOfCells=\"";
  out.number(cells.elements(), '"');
  out << ">\n<Points>\n";
  open_array(out, "Float64", "points", 3);
  for (const Vec3& x : mesh.node) {
    out.number(x[0], ' ');
    out.number(x[1], ' ');
    out.number(x[2], '\n');
  }
  out << "</DataArray>\n</Points>\n";
  write_cells(out, cells);
  out << "<PointData>\n";
  for (const PointArray& array : arrays) {
    open_array(out, array.real ? "Float64" : "Int32", array.name, array.components);
    if (array.real)
      write_rows(out, array.real, mesh.nodes(), array.components);
    else
      write_rows(out, array.integer, mesh.nodes(), array.components);
  }
  out << "</PointData>\n<CellData>\n";
  open_array(out, "Int32", "tag", 1);
  write_rows(out, cells.tag.data(), cells.elements(), 1);
  out << "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  return out.str();
}

void check_finite(std::span<const PointArray> arrays, const SurfaceMesh& mesh) {
  for (const PointArray& array : arrays)
    if (array.real) check_finite(array, mesh);
}

}  // namespace

void write_vtu(const std::string& path, const SurfaceMesh& mesh, std::span<const PointArray> arrays) {
  check_finite(arrays, mesh);
  write_whole_file(path, file_text(mesh, mesh, arrays));
}

void write_vtu(const std::string& path, const SurfaceMesh& surface, const VolumeElements& volume,
               std::span<const PointArray> arrays) {
  check_finite(arrays, surface);
  write_whole_file(path, file_text(surface, volume, arrays));
}

}  // namespace rollcon
