#include "text.hpp"

#include <algorithm>
#include <cctype>
#include <cstring>

namespace cntc {

std::string text_of(const char* text, int length) {
  if (!text || length <= 0) return {};
  const size_t limit = size_t(std::min(length, 256));
  size_t end = 0;
  while (end < limit && text[end]) ++end;
  std::string result(text, end);
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
  while (!result.empty() && blank(result.back())) result.pop_back();
  size_t begin = 0;
  while (begin < result.size() && blank(result[begin])) ++begin;
  return result.substr(begin);
}

std::string in_folder(const std::string& folder, const std::string& name) {
  if (folder.empty() || name.empty() || name[0] == '/' || name[0] == '\\' || (name.size() > 1 && name[1] == ':'))
    return name;
  const char last = folder.back();
  return last == '/' || last == '\\' ? folder + name : folder + "/" + name;
}

std::string folder_of(const std::string& path) {
  const size_t at = path.find_last_of("/\\");
  return at == std::string::npos ? std::string() : path.substr(0, at);
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

bool ends_with(const std::string& text, const char* end) {
  const size_t n = std::strlen(end);
  return text.size() >= n && lower(text).compare(text.size() - n, n, end) == 0;
}

}  // namespace cntc
