#pragma once
#include <string>

namespace cntc {

/// Returns the first `length` characters, 256 at most, up to a NUL and without blanks at both ends.
std::string text_of(const char* text, int length);

/// Puts a folder before a relative name; an empty folder changes nothing.
std::string in_folder(const std::string& folder, const std::string& name);
std::string folder_of(const std::string& path);
std::string lower(std::string text);
bool ends_with(const std::string& text, const char* end);

}  // namespace cntc
