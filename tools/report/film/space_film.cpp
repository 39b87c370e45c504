// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/report/film/space_film.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "tools/report/film/kept_outputs.hpp"

namespace parison::tools {
namespace {

using Json = nlohmann::ordered_json;

/// Bytes of a node in a frame: three places and the wall as words, two fields as bytes.
constexpr double bytes_of_node = 10;

struct Range {
  float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
  void include(float value) {
    if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  }
  std::uint16_t word_of(float value) const {
    const double share = high > low ? highest_word * (value - low) / (double(high) - low) : 0;
    return tools::word_of(share);
  }
};

using Outputs = std::vector<std::pair<double, std::shared_ptr<const SolidSurface>>>;

/// The cube that all places of all outputs lie in: the same step in each direction.
std::array<Range, 3> box_of(const Outputs& outputs) {
  std::array<Range, 3> box;
  float size = std::numeric_limits<float>::min();
  for (const auto& [time, surface] : outputs)
    for (const auto& at : surface->points)
      for (std::size_t k = 0; k < 3; ++k) box[k].include(at[k]);
  for (const Range& range : box) size = std::max(size, range.high - range.low);
  for (Range& range : box) range.high = range.low + size;
  return box;
}

std::size_t pack_points(const SolidSurface& surface, const std::array<Range, 3>& box, PackedBytes& bytes) {
  std::vector<std::uint16_t> words;
  for (std::size_t k = 0; k < 3; ++k)  // all of one direction together: neighbours in the list compress better
    for (const auto& at : surface.points) words.push_back(box[k].word_of(at[k]));
  return bytes.add_words(words);
}

/// A field as its place in the bytes and its range; null where the glass has none.
Json pack_field(const SolidSurface& surface, const char* name, PackedBytes& bytes) {
  const auto found = surface.nodal.find(name);
  if (found == surface.nodal.end()) return nullptr;
  const ByteValues packed = bytes.add_bytes(found->second);
  return {packed.at, packed.low, packed.high};
}

/// The same as words: a value is read to a hundredth.
Json pack_fine_field(const SolidSurface& surface, const char* name, PackedBytes& bytes) {
  const auto found = surface.nodal.find(name);
  if (found == surface.nodal.end()) return nullptr;
  Range range;
  for (const float value : found->second) range.include(value);
  std::vector<std::uint16_t> words;
  for (const float value : found->second) words.push_back(range.word_of(value));
  return {bytes.add_words(words), range.low, range.high};
}

/// Meshes by their faces: nearly all outputs share one.
class Meshes {
 public:
  explicit Meshes(PackedBytes& bytes) : bytes_(bytes) {}
  std::size_t index_of(const std::shared_ptr<const SolidSurface>& surface) {
    if (!last_ || surface->faces != last_->faces || surface->points.size() != last_->points.size()) {
      last_ = surface;
      list_.push_back({{"nodes", surface->points.size()},
                       {"faces", surface->sides.size()},
                       {"at", bytes_.add_words(surface->faces)},
                       {"sides", bytes_.add_words(surface->sides)}});
    }
    return list_.size() - 1;
  }
  const Json& list() const { return list_; }

 private:
  PackedBytes& bytes_;
  std::shared_ptr<const SolidSurface> last_;
  Json list_ = Json::array();
};

Outputs read_outputs(const ResultFolder& folder, const std::vector<PvdEntry>& entries, FileCache<SolidSurface>& cache,
                     std::size_t budget, std::vector<std::string>& problems) {
  const auto last = cache.read(entries.back().path, problems);
  const double nodes = last ? static_cast<double>(last->points.size()) : 0;
  Outputs outputs;
  for (const std::size_t i : kept_outputs(folder, entries, bytes_of_node * nodes * double(entries.size()), budget))
    if (auto surface = cache.read(entries[i].path, problems)) outputs.emplace_back(entries[i].time, std::move(surface));
  return outputs;
}

}  // namespace

nlohmann::ordered_json pack_space_film(const ResultFolder& folder, FileCache<SolidSurface>& cache, std::size_t budget,
                                       PackedBytes& bytes, std::vector<std::string>& problems) {
  const auto entries = read_pvd(folder.path + "/solid/glass.pvd");
  if (entries.empty() || !starts_where_round_ended(folder, entries.front().time)) return nullptr;
  const Outputs outputs = read_outputs(folder, entries, cache, budget, problems);
  if (outputs.empty()) return nullptr;
  const std::array<Range, 3> box = box_of(outputs);
  Meshes meshes(bytes);
  Json frames = Json::array();
  for (const auto& [time, surface] : outputs)
    frames.push_back({{"t", time},
                      {"mesh", meshes.index_of(surface)},
                      {"points", pack_points(*surface, box, bytes)},
                      {"thickness", pack_fine_field(*surface, "wall_thickness_mm", bytes)},
                      {"temperature", pack_field(*surface, "temperature_degC", bytes)},
                      {"contact", pack_field(*surface, "share_in_contact", bytes)}});
  return {{"box", {box[0].low, box[1].low, box[2].low, (double(box[0].high) - box[0].low) / highest_word}},
          {"copies", outputs.back().second->copies},
          {"frames", std::move(frames)},
          {"meshes", meshes.list()},
          {"outputs", entries.size()}};
}

}  // namespace parison::tools
