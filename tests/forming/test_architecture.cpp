// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// Layer that a source file belongs to: its top folder, in forming and tools the folder below that.
std::string layer_of(const std::string& path) {
  const auto first = path.find('/');
  const std::string top = path.substr(0, first);
  return top == "forming" || top == "tools" ? path.substr(0, path.find('/', first + 1)) : top;
}

TEST(Architecture, every_include_points_down_the_layers) {
  const std::map<std::string, std::set<std::string>> may_see{
      {"core", {"core"}},
      {"thermal", {"thermal", "core"}},
      {"contact", {"contact", "core"}},
      {"remesh", {"remesh", "core"}},
      {"forming/flow", {"forming/flow", "core"}},
      {"forming/cooling", {"forming/cooling", "forming/flow", "core"}},
      {"forming/scene", {"forming/scene", "forming/cooling", "forming/flow", "thermal", "contact", "core"}},
      {"forming/state",
       {"forming/state", "forming/scene", "forming/cooling", "forming/flow", "thermal", "contact", "remesh", "core"}},
      {"forming/step",
       {"forming/step", "forming/state", "forming/scene", "forming/cooling", "forming/flow", "thermal", "contact",
        "remesh", "core"}},
      {"forming/solid",
       {"forming/solid", "forming/step", "forming/state", "forming/scene", "forming/cooling", "forming/flow", "thermal",
        "contact", "remesh", "core"}},
      {"forming/remeshing",
       {"forming/remeshing", "forming/step", "forming/state", "forming/scene", "contact", "remesh", "core"}},
      {"forming/diagnostics",
       {"forming/diagnostics", "forming/step", "forming/state", "forming/scene", "contact", "remesh", "core"}},
      {"forming/report",
       {"forming/report", "forming/diagnostics", "forming/solid", "forming/step", "forming/state", "forming/scene",
        "forming/cooling", "contact", "thermal", "remesh", "core"}},
      {"forming/run",
       {"forming/run", "forming/report", "forming/diagnostics", "forming/solid", "forming/remeshing", "forming/step",
        "forming/state", "forming/scene", "core"}},
      {"forming/study",
       {"forming/study", "forming/run", "forming/report", "forming/step", "forming/state", "forming/scene", "contact",
        "core"}},
      {"tools/program", {"tools/program", "core"}},
      {"tools/tradeoff",
       {"tools/tradeoff", "tools/program", "forming/study", "forming/run", "forming/report", "forming/scene", "core"}},
      {"tools/pictures", {"tools/pictures", "forming/scene", "core"}},
      {"tools/server", {"tools/server", "tools/program", "core"}},
      {"tools/report",
       {"tools/report", "tools/server", "tools/program", "forming/study", "forming/report", "forming/scene", "core"}},
      {"tools/new_container", {"tools/new_container", "tools/program", "forming/scene", "core"}},
      {"tools/workbench",
       {"tools/workbench", "tools/server", "tools/report", "tools/new_container", "tools/program", "forming/study",
        "forming/run", "forming/scene", "core"}},
      {"tools/camera", {"tools/camera", "tools/report", "forming/scene", "thermal", "core"}},
      {"tools/materials", {"tools/materials", "forming/scene", "core"}},
      {"tools/comparison",
       {"tools/comparison", "tools/program", "forming/study", "forming/run", "forming/scene", "core"}},
      {"tools/sweep", {"tools/sweep", "tools/program", "forming/study", "forming/scene", "core"}},
      {"tools/search",
       {"tools/search", "tools/report", "tools/sweep", "tools/program", "forming/study", "forming/scene", "core"}},
      {"tools/uncertainty",
       {"tools/uncertainty", "tools/sweep", "tools/program", "forming/study", "forming/scene", "core"}},
      {"tools/commands",
       {"tools/commands", "tools/camera", "tools/comparison", "tools/search", "tools/sweep", "tools/uncertainty",
        "tools/report", "tools/materials", "tools/new_container", "tools/pictures", "tools/tradeoff", "tools/workbench",
        "tools/program", "forming/study", "forming/run", "forming/report", "forming/solid", "forming/scene", "core"}}};
  const fs::path root = PARISON_SOURCE_DIR;
  const std::regex quoted("^\\s*#include \"([^\"]+)\"");
  int read = 0;
  for (const auto* folder :
       {"core", "thermal", "contact", "remesh", "forming", "tools/program", "tools/camera", "tools/materials",
        "tools/pictures", "tools/tradeoff", "tools/comparison", "tools/search", "tools/sweep", "tools/uncertainty",
        "tools/report", "tools/server", "tools/new_container", "tools/workbench", "tools/commands"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const auto extension = entry.path().extension();
      if (extension != ".cpp" && extension != ".hpp") continue;
      const std::string layer = layer_of(fs::relative(entry.path(), root).generic_string());
      std::ifstream file(entry.path());
      for (std::string line; std::getline(file, line);) {
        std::smatch match;
        if (!std::regex_search(line, match, quoted)) continue;
        ++read;
        EXPECT_EQ(may_see.at(layer).count(layer_of(match[1])), 1u) << entry.path() << " includes " << match[1];
      }
    }
  EXPECT_GT(read, 200);
}

TEST(Architecture, heavy_headers_stay_out_of_headers) {
  const fs::path root = PARISON_SOURCE_DIR;
  const std::regex heavy("#include <(Eigen/Sparse|CGAL/|gmsh|vtk|CLI/|toml|nlohmann/json\\.hpp)");
  for (const auto* folder : {"core", "thermal", "contact", "remesh", "forming"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (entry.path().extension() != ".hpp") continue;
      std::ifstream file(entry.path());
      for (std::string line; std::getline(file, line);)
        EXPECT_FALSE(std::regex_search(line, heavy)) << entry.path() << ": " << line;
    }
}

/// Lines of the libraries' sources that match, as "file: line"; comments and strings count.
std::vector<std::string> lines_with(const std::regex& pattern, const std::set<std::string>& except = {},
                                    std::vector<std::string> folders = {"core", "thermal", "contact", "remesh",
                                                                        "forming"}) {
  const fs::path root = PARISON_SOURCE_DIR;
  std::vector<std::string> found;
  for (const std::string& folder : folders)
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const auto extension = entry.path().extension();
      const std::string name = fs::relative(entry.path(), root).generic_string();
      if ((extension != ".cpp" && extension != ".hpp") || except.count(name) > 0) continue;
      std::ifstream file(entry.path());
      for (std::string line; std::getline(file, line);)
        if (std::regex_search(line, pattern)) found.push_back(name + ": " + line);
    }
  return found;
}

TEST(Architecture, no_library_prints) {
  const std::regex prints(R"(fmt::print\b|std::(cout|cerr|clog)\b|\bf?printf\s*\(|\bputs\s*\(|\bfputs\s*\()");
  ASSERT_TRUE(std::regex_search(std::string("  fmt::print(\"x\");"), prints));
  EXPECT_EQ(lines_with(prints), std::vector<std::string>{});
}

TEST(Architecture, files_are_written_and_removed_where_those_of_the_user_are_known) {
  const std::regex writes(R"(std::ofstream|\bfopen\s*\(|write_text\(|(fs|filesystem)::(remove|rename|resize_file))");
  const std::set<std::string> core{"core/io/files.cpp", "core/io/files.hpp", "core/io/written_files.cpp"};
  std::set<std::string> except = core;
  except.insert("tools/new_container/new_case.cpp");       // into a new folder, which is the user's then
  except.insert("tools/workbench/edit/open_case.cpp");     // the user's case, as he says, where it is what he has seen
  except.insert("tools/workbench/edit/text_history.cpp");  // its own file beside the case, which begins as such
  except.insert("tools/workbench/answers/export_answer.cpp");  // a folder of its own, made anew by the system
  except.insert("tools/workbench/folder/left_files.cpp");      // under a name with the number of a process that is gone
  except.insert("tools/workbench/runs/sketch.cpp");            // likewise
  except.insert("forming/study/comparison/what_if/branch.cpp");         // a folder made under an unfinished name
  except.insert("forming/study/comparison/what_if/finished_base.cpp");  // likewise
  for (const char* bench : {"mesher_bench", "step_bench"})
    except.insert(std::string("tools/benchmarks/programs/") + bench + ".cpp");
  EXPECT_EQ(lines_with(writes, except, {"core", "thermal", "contact", "remesh", "forming", "tools"}),
            std::vector<std::string>{});
  EXPECT_FALSE(lines_with(writes).empty());
}

TEST(Architecture, what_the_whole_process_shares_has_one_owner_in_core) {
  const std::set<std::string> clock{"core/process/clock.cpp"}, gmsh{"core/process/gmsh_session.cpp"};
  const std::regex clocks(R"(steady_clock|system_clock|std::clock\b|clock_gettime|getrusage|std::time\s*\()");
  EXPECT_EQ(lines_with(clocks, clock), std::vector<std::string>{});
  EXPECT_EQ(lines_with(clocks).size(), 2u);
  const std::regex whole_gmsh(
      R"(gmsh::(initialize|finalize|clear|option::|model::(add|remove|setCurrent)\b)|\b(srand|rand|initstate|setstate)\s*\()");
  EXPECT_EQ(lines_with(whole_gmsh, gmsh), std::vector<std::string>{});
  EXPECT_GE(lines_with(whole_gmsh).size(), 8u);
  const std::regex signals(R"(\b(signal|sigaction|raise|setenv|openblas_set_num_threads)\s*\()");
  const std::set<std::string> child{"core/process/child_work.cpp"};  // its signals are those of the process it has made
  EXPECT_EQ(lines_with(signals, child), std::vector<std::string>{});
  EXPECT_EQ(lines_with(signals).size(), 1u);
}

TEST(Architecture, gmsh_is_called_by_its_module_alone) {
  const std::set<std::string> module{"core/process/gmsh_session.cpp", "remesh/mesher/gmsh_triangulation.cpp",
                                     "forming/report/solid/step_solid.cpp"};
  const std::regex header("#include <gmsh");
  EXPECT_EQ(lines_with(header, module), std::vector<std::string>{});
  EXPECT_EQ(lines_with(header).size(), module.size());
  const std::string step = "forming/scene/read/drawing/step/";
  const std::regex cad_kernel("#include <.*\\.hxx>");
  EXPECT_EQ(lines_with(cad_kernel, {step + "step_curves.cpp", step + "solid_section.cpp", step + "solid_section.hpp",
                                    "forming/report/solid/sewn_solid.cpp"}),
            std::vector<std::string>{});
  EXPECT_GE(lines_with(cad_kernel).size(), 3u);
}

}  // namespace
