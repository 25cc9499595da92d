#pragma once
/// Reads a file into memory, and writes one.

#include <cstdint>
#include <string>

namespace rollcon {

/// Throws err_io naming the path if there is none, it is no regular file, has more than `most` bytes, or cannot be
/// read. Memory is asked for by the file's size.
std::string whole_file(const std::string& path, std::uintmax_t most);

/// Writes the text beside the file and renames it when it is whole. Throws err_io naming the path.
void write_whole_file(const std::string& path, const std::string& text);

}  // namespace rollcon
