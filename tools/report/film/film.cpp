// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/report/film/film.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "tools/report/film/kept_outputs.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Bytes of a page for each byte of a file: of the glass, whose places and fields are packed, and of a tool, whose
/// temperatures are.
constexpr double glass_share = 0.14, tool_share = 0.04;
/// The range of places that words are spread over, mm.
struct Box {
  float low[2], size;
};

Box box_of(const std::vector<std::array<float, 2>>& points, const Box* other = nullptr) {
  constexpr float far = std::numeric_limits<float>::max();
  float low[2] = {far, far}, high[2] = {-far, -far};
  const auto include = [&](float x, float y) {
    low[0] = std::min(low[0], x), low[1] = std::min(low[1], y);
    high[0] = std::max(high[0], x), high[1] = std::max(high[1], y);
  };
  for (const auto& point : points)
    if (std::isfinite(point[0]) && std::isfinite(point[1])) include(point[0], point[1]);
  if (other) include(other->low[0], other->low[1]), include(other->low[0] + other->size, other->low[1] + other->size);
  return {{low[0], low[1]}, std::max({high[0] - low[0], high[1] - low[1], 1e-6F})};
}

Json json_of(const Box& box) {
  return {box.low[0], box.low[1], box.size / highest_word};
}

std::size_t pack_points(const std::vector<std::array<float, 2>>& points, const Box& box, PackedBytes& bytes) {
  std::vector<std::uint16_t> words;
  for (const int k : {0, 1})  // all of one direction together: neighbours in the list compress better
    for (const auto& point : points) {
      const double share = highest_word * (point[static_cast<std::size_t>(k)] - box.low[k]) / box.size;
      words.push_back(word_of(share));
    }
  return bytes.add_words(words);
}

/// A field as its place in the bytes and its range; null where the body has none. Viscosities and what else spans
/// decades go by their logarithm.
Json pack_field(const VtuFile& body, const std::string& name, bool logarithm, PackedBytes& bytes) {
  const auto found = body.nodal.find(name);
  if (found == body.nodal.end()) return nullptr;
  std::vector<float> values = found->second;
  if (logarithm)
    for (float& value : values) value = std::log10(std::max(value, 1e-30F));
  const ByteValues packed = bytes.add_bytes(values);
  return {packed.at, packed.low, packed.high};
}

/// Meshes by their cells: most outputs share one with the output before.
class Topologies {
 public:
  explicit Topologies(PackedBytes& bytes) : bytes_(bytes) {}
  std::size_t index_of(const VtuFile& body) {
    if (list_.empty() || body.cells != last_ || body.points.size() != nodes_) {
      last_ = body.cells;
      nodes_ = body.points.size();
      list_.push_back({nodes_, last_.size() / 6, bytes_.add_words(last_)});
    }
    return list_.size() - 1;
  }
  const Json& list() const { return list_; }

 private:
  PackedBytes& bytes_;
  std::vector<std::uint16_t> last_;
  std::size_t nodes_ = 0;
  Json list_ = Json::array();
};

double size_of(const std::string& path) {
  std::error_code missing;
  const auto size = fs::file_size(path, missing);
  return missing ? 0 : static_cast<double>(size);
}

/// A tool of the film: drawn once, then moved along the axis.
struct ToolFilm {
  std::string name;
  std::vector<PvdEntry> entries;
  std::shared_ptr<const VtuFile> drawn;
};

/// The tools that have files, in the order of the columns of the history.
std::vector<ToolFilm> tools_of(const ResultFolder& folder) {
  std::vector<std::pair<int, ToolFilm>> found;
  for (const auto& entry : fs::directory_iterator(folder.path)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() != ".pvd" || name == "glass") continue;
    ToolFilm tool{name, read_pvd(entry.path().string()), nullptr};
    if (!tool.entries.empty()) found.emplace_back(folder.history.find(name + "_force_N"), std::move(tool));
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return std::pair(a.first, a.second.name) < std::pair(b.first, b.second.name);
  });
  std::vector<ToolFilm> tools;
  tools.reserve(found.size());
  for (auto& [column, tool] : found) tools.push_back(std::move(tool));
  return tools;
}

/// The outputs to show: all, or every so many and the ends of the stages.
std::vector<std::size_t> chosen(const ResultFolder& folder, const std::vector<PvdEntry>& glass,
                                const std::vector<ToolFilm>& tools, std::size_t budget) {
  double whole = 0;
  for (const PvdEntry& entry : glass) whole += glass_share * size_of(entry.path);
  for (const ToolFilm& tool : tools)
    whole += tool_share * static_cast<double>(glass.size()) * size_of(tool.entries[0].path);
  return kept_outputs(folder, glass, whole, budget);
}

Json pack_tools(std::vector<ToolFilm>& tools, double time, FileCache<VtuFile>& cache, PackedBytes& bytes,
                std::vector<std::string>& problems) {
  Json packed = Json::array();
  for (std::size_t i = 0; i < tools.size(); ++i) {
    ToolFilm& tool = tools[i];
    const PvdEntry& entry = tool.entries[nearest(tool.entries, time)];
    if (std::abs(entry.time - time) > 1e-9 * std::max(1.0, time)) continue;
    const auto body = cache.read(entry.path, problems);
    if (!body || !body->active) continue;
    if (!tool.drawn) tool.drawn = body;
    if (body->cells != tool.drawn->cells || body->points.size() != tool.drawn->points.size()) continue;
    packed.push_back(
        {i, body->points[0][1] - tool.drawn->points[0][1], pack_field(*body, "temperature_degC", false, bytes)});
  }
  return packed;
}

Json pack_frame(double time, const VtuFile& glass, const Box& box, Topologies& meshes, PackedBytes& bytes) {
  return {{"t", time},
          {"mesh", meshes.index_of(glass)},
          {"points", pack_points(glass.points, box, bytes)},
          {"temperature", pack_field(glass, "temperature_degC", false, bytes)},
          {"viscosity", pack_field(glass, "viscosity_Pa_s", true, bytes)},
          {"pressure", pack_field(glass, "contact_pressure_Pa", false, bytes)}};
}

Json describe_tools(const std::vector<ToolFilm>& tools, Topologies& meshes, PackedBytes& bytes) {
  Json described = Json::array();
  for (const ToolFilm& tool : tools) {
    Json one{{"name", tool.name}};
    if (tool.drawn) {
      const Box box = box_of(tool.drawn->points);
      one["box"] = json_of(box);
      one["mesh"] = meshes.index_of(*tool.drawn);
      one["points"] = pack_points(tool.drawn->points, box, bytes);
    }
    described.push_back(std::move(one));
  }
  return described;
}

}  // namespace

nlohmann::ordered_json pack_film(const ResultFolder& folder, FileCache<VtuFile>& cache, std::size_t budget,
                                 PackedBytes& bytes, std::vector<std::string>& problems) {
  const auto entries = read_pvd(folder.path + "/glass.pvd");
  if (entries.empty()) return nullptr;
  std::vector<ToolFilm> tools = tools_of(folder);
  std::vector<std::pair<double, std::shared_ptr<const VtuFile>>> outputs;
  std::optional<Box> box;
  for (const std::size_t i : chosen(folder, entries, tools, budget))
    if (const auto glass = cache.read(entries[i].path, problems)) {
      outputs.emplace_back(entries[i].time, glass);
      box = box_of(glass->points, box ? &*box : nullptr);
    }
  if (!box) return nullptr;
  Topologies meshes(bytes);
  Json frames = Json::array();
  for (const auto& [time, glass] : outputs) {
    Json frame = pack_frame(time, *glass, *box, meshes, bytes);
    frame["tools"] = pack_tools(tools, time, cache, bytes, problems);
    frames.push_back(std::move(frame));
  }
  Json described = describe_tools(tools, meshes, bytes);
  return {{"box", json_of(*box)},
          {"frames", std::move(frames)},
          {"tools", std::move(described)},
          {"meshes", meshes.list()},
          {"outputs", entries.size()}};
}

}  // namespace parison::tools
