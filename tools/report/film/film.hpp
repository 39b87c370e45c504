#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "tools/report/data/result_folder.hpp"
#include "tools/report/film/packed_bytes.hpp"
#include "tools/report/film/vtu_file.hpp"

namespace parison::tools {

/// VTU files that have been read, so that a page that grows with a run reads each once.
class VtuCache {
 public:
  /// Null where the file is missing or broken; `problems` then gets a sentence.
  std::shared_ptr<const VtuFile> read(const std::string& path, std::vector<std::string>& problems);

 private:
  struct Entry {
    std::string stamp;  ///< size and time of the file
    std::shared_ptr<const VtuFile> file;
  };
  std::map<std::string, Entry> entries_;
};

/// The sections of glass and active tools at the outputs of a run, quantised into `bytes`: places to a 65535th of the
/// body's size, fields to a 255th of their range at that time. Outputs are left out, evenly but for the ends of
/// stages, where all would take more than `budget` bytes.
nlohmann::ordered_json pack_film(const ResultFolder& folder, VtuCache& cache, std::size_t budget, PackedBytes& bytes,
                                 std::vector<std::string>& problems);

}  // namespace parison::tools
