// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/report/film/packed_bytes.hpp"

#include <vtkNew.h>
#include <vtkZLibDataCompressor.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace parison::tools {
namespace {

constexpr std::size_t alignment = 4;

std::string base64(const unsigned char* bytes, std::size_t count) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve(4 * (count / 3 + 1));
  for (std::size_t i = 0; i < count; i += 3) {
    const auto byte = [&](std::size_t k) { return i + k < count ? static_cast<unsigned>(bytes[i + k]) : 0U; };
    const unsigned three = byte(0) << 16U | byte(1) << 8U | byte(2);
    text += digits[three >> 18U];
    text += digits[three >> 12U & 63U];
    text += i + 1 < count ? digits[three >> 6U & 63U] : '=';
    text += i + 2 < count ? digits[three & 63U] : '=';
  }
  return text;
}

}  // namespace

std::size_t PackedBytes::begin() {
  bytes_.resize((bytes_.size() + alignment - 1) / alignment * alignment, 0);
  return bytes_.size();
}

std::size_t PackedBytes::add_numbers(const std::vector<double>& values) {
  const std::size_t at = begin();
  bytes_.resize(at + values.size() * sizeof(float));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool fits = std::abs(values[i]) <= std::numeric_limits<float>::max();
    const float value = fits ? static_cast<float>(values[i]) : std::numeric_limits<float>::quiet_NaN();
    std::memcpy(bytes_.data() + at + i * sizeof(float), &value, sizeof(float));
  }
  return at;
}

std::size_t PackedBytes::add_words(const std::vector<std::uint16_t>& values) {
  const std::size_t at = begin();
  for (const std::uint16_t value : values) {
    bytes_.push_back(static_cast<unsigned char>(value & 255U));
    bytes_.push_back(static_cast<unsigned char>(value >> 8U));
  }
  return at;
}

ByteValues PackedBytes::add_bytes(const std::vector<float>& values) {
  ByteValues packed{begin(), 0, 0};
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const float value : values)
    if (std::isfinite(value)) low = std::fmin(low, value), high = std::fmax(high, value);
  if (low > high) low = high = 0;
  const double scale = high > low ? 255 / (high - low) : 0;
  for (const float value : values)
    bytes_.push_back(std::isfinite(value) ? static_cast<unsigned char>(std::lround((value - low) * scale)) : 0);
  packed.low = low;
  packed.high = high;
  return packed;
}

std::string PackedBytes::text() const {
  vtkNew<vtkZLibDataCompressor> compressor;
  compressor->SetCompressionLevel(6);
  std::vector<unsigned char> compressed(compressor->GetMaximumCompressionSpace(bytes_.size()));
  const std::size_t size = compressor->Compress(bytes_.data(), bytes_.size(), compressed.data(), compressed.size());
  return base64(compressed.data(), size);
}

}  // namespace parison::tools
