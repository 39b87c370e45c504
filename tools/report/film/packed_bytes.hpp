#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace parison::tools {

/// Values as one byte each: 0 is the lowest, 255 the highest.
struct ByteValues {
  std::size_t at;  ///< place in the bytes
  double low, high;
};

/// A number from 0 to the highest as the nearest word; 0 where it is not finite.
inline constexpr double highest_word = 65535;
inline std::uint16_t word_of(double value) {
  return static_cast<std::uint16_t>(std::isfinite(value) ? std::clamp(value + 0.5, 0.0, highest_word) : 0);
}

/// The numbers of a page, one after another; each list begins at a multiple of four bytes, little-endian.
class PackedBytes {
 public:
  /// Single precision; what that cannot represent, NaN. Returns the place of the first.
  std::size_t add_numbers(const std::vector<double>& values);
  std::size_t add_words(const std::vector<std::uint16_t>& values);
  /// A value that is not finite becomes the lowest.
  ByteValues add_bytes(const std::vector<float>& values);

  std::size_t size() const { return bytes_.size(); }
  /// Compressed (zlib, RFC 1950) and written in base64.
  std::string text() const;

 private:
  std::size_t begin();

  std::vector<unsigned char> bytes_;
};

}  // namespace parison::tools
