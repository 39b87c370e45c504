// SPDX-License-Identifier: GPL-3.0-or-later
// replay FOLDER [COUNT]: gives a fuzz target each file of a folder, and COUNT (200) copies of each with some bytes
// changed, always the same ones.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "core/io/files.hpp"
#include "fuzz_input.hpp"

namespace {

void try_text(const std::string& text) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
}

/// Changes, cuts out or doubles a few bytes.
std::string changed(std::string text, std::mt19937_64& draw) {
  const std::string signs = "0123456789.,-+e()[]{}=\"'#\n \t_";
  const std::size_t changes = 1 + draw() % 4;
  for (std::size_t i = 0; i < changes && !text.empty(); ++i) {
    const std::size_t at = draw() % text.size(), length = std::min<std::size_t>(1 + draw() % 20, text.size() - at);
    switch (draw() % 4) {
      case 0:
        text[at] = signs[draw() % signs.size()];
        break;
      case 1:
        text[at] = static_cast<char>(draw() % 256);
        break;
      case 2:
        text.erase(at, length);
        break;
      default:
        text.insert(at, text.substr(at, length));
    }
  }
  return text;
}

}  // namespace

int main(int count, char** arguments) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(arguments[1])) files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  const int copies = count > 2 ? std::atoi(arguments[2]) : 200;
  std::mt19937_64 draw(1);
  for (const std::string& file : files) {
    const std::string text = parison::core::read_text(file);
    try_text(text);
    for (int i = 0; i < copies; ++i) try_text(changed(text, draw));
  }
  std::printf("%zu files, %d changed copies of each\n", files.size(), copies);
  return files.empty() ? 1 : 0;
}
