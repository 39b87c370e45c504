#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <string>
#include <vector>

#include "forming/study/comparison/study_folder.hpp"
#include "tools/report/data/scene_text.hpp"
#include "tools/report/film/film.hpp"
#include "tools/report/film/space_film.hpp"

namespace parison::tools {

/// What was read of result folders and does not change while a run goes on.
struct ReportCache {
  FileCache<VtuFile> files{read_vtu};
  FileCache<SolidSurface> surfaces{read_solid_surface};
  std::map<std::string, std::pair<std::string, SceneOfRun>> scenes;  ///< by folder, with the stamp of the case
};

/// A sentence where runs are of different cases, by the copies of the cases in their folders; empty where they are of
/// one up to settings.
std::string mixed_cases(const std::vector<std::string>& folders, ReportCache& cache);

/// The data of a page on some result folders as a JSON text without any character that ends or opens a tag; `live`
/// says that the page is to ask for more; `search` is the course of a search as JSON, or empty; `failed` are variants
/// of the first run that did not settle. Throws core::CaseError where one of the folders is no result folder.
std::string report_data(const std::vector<std::string>& folders, bool live, ReportCache& cache,
                        const std::string& search = {}, const std::vector<forming::FailedVariant>& failed = {});

}  // namespace parison::tools
