// Runs without libFuzzer every file of the folders given, then inputs made from them by a fixed sequence of random
// changes: replay [-changes=N] FOLDER...

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes changed(const std::vector<Bytes>& corpus, std::mt19937_64& random) {
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  Bytes input = corpus[below(corpus.size())];
  const Bytes& other = corpus[below(corpus.size())];
  if (!other.empty() && random() % 4 == 0) {  // goes on like another
    input.resize(below(input.size() + 1));
    input.insert(input.end(), other.begin() + static_cast<std::ptrdiff_t>(below(other.size())), other.end());
  }
  for (std::size_t edits = 1 + below(6); edits > 0; --edits) {
    const std::size_t at = below(input.size() + 1);
    const auto place = input.begin() + static_cast<std::ptrdiff_t>(at);
    const auto byte = static_cast<std::uint8_t>(random());
    if (at == input.size() || random() % 4 == 0)
      input.insert(place, byte);
    else if (random() % 4 == 0)
      input.erase(place);
    else
      *place = byte;
  }
  return input;
}

void run(const Bytes& input) {
  // The copy has the exact length, so that reading beyond it is seen.
  const Bytes exact(input);
  LLVMFuzzerTestOneInput(exact.data(), exact.size());
}

}  // namespace

int main(int argc, char** argv) {
  namespace fs = std::filesystem;
  std::vector<fs::path> file;
  int changes = 0;
  for (int i = 1; i < argc; ++i) {
    if (std::strncmp(argv[i], "-changes=", 9) == 0) {
      changes = std::atoi(argv[i] + 9);
    } else if (fs::is_directory(argv[i])) {
      for (const auto& entry : fs::directory_iterator(argv[i])) file.push_back(entry.path());
    } else {
      file.emplace_back(argv[i]);
    }
  }
  std::sort(file.begin(), file.end());
  std::vector<Bytes> corpus;
  for (const fs::path& path : file) {
    std::ifstream in(path, std::ios::binary);
    corpus.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    std::fprintf(stderr, "%s\n", path.filename().c_str());
    run(corpus.back());
  }
  if (corpus.empty()) {
    std::fprintf(stderr, "no inputs\n");
    return 1;
  }
  std::mt19937_64 random(20240229);
  for (int i = 0; i < changes; ++i) {
    const Bytes input = changed(corpus, random);
    std::ofstream("last_input", std::ios::binary)
        .write(reinterpret_cast<const char*>(input.data()), static_cast<std::streamsize>(input.size()));
    run(input);
  }
  std::printf("%zu inputs of the corpus and %d changed ones\n", corpus.size(), changes);
  return 0;
}
