// SPDX-License-Identifier: GPL-3.0-or-later
// mesher_bench CASE ACCURACY FOLDER REPEATS MESHER [KEY=VALUE ...]: runs a case with its glass meshed by MESHER and at
// each new glass mesh gives the same outline and size field REPEATS times to every mesher; FOLDER.meshes.csv has a row
// for each.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <string>

#include "forming/report/summary.hpp"
#include "forming/run/folder_run.hpp"
#include "remesh/mesher/mesh_outline.hpp"
#include "tools/benchmarks/programs/bare_flow.hpp"
#include "tools/benchmarks/programs/cgal_mesher.hpp"
#include "tools/benchmarks/programs/mesh_figures.hpp"
#include "tools/program/blas_threads.hpp"

namespace {

using namespace parison;

struct Mesher {
  const char* name;
  int gmsh_algorithm;  ///< 0: CGAL
  bench::CgalOptions cgal;
};
constexpr int frontal_delaunay = 6;
constexpr std::array<Mesher, 8> meshers{{{"gmsh", frontal_delaunay, {}},
                                         {"gmsh Delaunay", 5, {}},
                                         {"CGAL", 0, {false, 0, 0}},
                                         {"CGAL Lloyd", 0, {false, 5, 0}},
                                         {"CGAL kept", 0, {true, 0, 0}},
                                         {"CGAL kept Lloyd", 0, {true, 5, 0}},
                                         {"CGAL kept smoothed", 0, {true, 0, 0.7}},
                                         {"CGAL kept smoothed more", 0, {true, 0, 0.9}}}};

/// Triangles by a mesher that keeps the edges of the outline.
remesh::Triangulation triangulate(const Mesher& mesher, const remesh::Outline& outline, const remesh::SizeField& size) {
  if (mesher.gmsh_algorithm) return remesh::triangulate_by_gmsh(outline, size, mesher.gmsh_algorithm);
  return bench::cgal_mesh(outline, size, mesher.cgal).triangles;
}

struct Made {
  remesh::MeshedOutline meshed;
  core::Index added = 0;  ///< points on the outline
  double seconds;
};

/// One mesh by any of the meshers, with the program's own finish.
Made make(const Mesher& mesher, const remesh::Outline& outline, const remesh::SizeField& size) {
  const core::Index last = *std::max_element(outline.boundary_ids.begin(), outline.boundary_ids.end());
  const std::vector<core::MeshBoundary> boundaries(static_cast<std::size_t>(last) + 1, "");
  Made result;
  const double start = bench::cpu_seconds();
  if (mesher.gmsh_algorithm) {
    result.meshed = remesh::mesh_outline(outline, boundaries, size, [&](const auto& edges, const auto& sizes) {
      return triangulate(mesher, edges, sizes);
    });
  } else {
    const bench::CgalMesh made = bench::cgal_mesh(outline, size, mesher.cgal);
    result.added = made.added;
    result.meshed =
        remesh::mesh_outline(made.outline, boundaries, size, [&](const auto&, const auto&) { return made.triangles; });
  }
  result.seconds = bench::cpu_seconds() - start;
  return result;
}

/// Gives every outline that is meshed in a run to all meshers; a row for each of them.
class Comparison {
 public:
  Comparison(const std::string& path, int repeats) : table_(path), repeats_(repeats) {
    table_ << "remesh,mesher,triangles,seconds,min_quality,median,angle,size_mean,size_max,jump,added,same,bits\n";
  }
  void add(const remesh::Outline& outline, const remesh::SizeField& size) {
    if (repeats_ == 0) return;
    for (const Mesher& mesher : meshers) add_row(mesher, outline, size);
    ++seen_;
  }

 private:
  void add_row(const Mesher& mesher, const remesh::Outline& outline, const remesh::SizeField& size) {
    std::vector<double> seconds;
    bench::MeshFigures figures{};
    bool same = true;
    for (int i = 0; i < repeats_; ++i) {
      const Made made = make(mesher, outline, remesh::SizeField(size));  // a copy: it remembers what was asked
      seconds.push_back(made.seconds);
      if (!made.meshed.reason.empty()) {
        table_ << seen_ << ',' << mesher.name << ",nan,nan,nan,nan,nan,nan,nan,nan,nan,1,0\n";
        return;
      }
      const std::uint64_t bits = figures.bits;
      figures = bench::mesh_figures(made.meshed.mesh, size);
      same = same && (i == 0 || figures.bits == bits);
      if (i + 1 < repeats_) continue;
      std::nth_element(seconds.begin(), seconds.begin() + seconds.size() / 2, seconds.end());
      table_ << seen_ << ',' << mesher.name << ',' << made.meshed.mesh.cell_count() << ','
             << seconds[seconds.size() / 2] << ',' << figures.min << ',' << figures.median << ',' << figures.min_angle
             << ',' << figures.size_mean << ',' << figures.size_max << ',' << figures.max_jump << ',' << made.added
             << ',' << same << ',' << figures.bits << std::endl;
    }
  }

  std::ofstream table_;
  int repeats_, seen_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 6) {
    std::fprintf(stderr, "mesher_bench: CASE ACCURACY FOLDER REPEATS MESHER [KEY=VALUE ...]\n");
    return 2;
  }
  tools::use_one_blas_thread();
  const auto* in_run =
      std::find_if(meshers.begin(), meshers.end(), [&](const Mesher& m) { return std::string(argv[5]) == m.name; });
  if (in_run == meshers.end() || !(in_run->gmsh_algorithm || in_run->cgal.keep_edges))
    return std::fprintf(stderr, "mesher_bench: no mesher \"%s\" that keeps the outline\n", argv[5]), 2;
  Comparison comparison(std::string(argv[3]) + ".meshes.csv", std::atoi(argv[4]));
  const auto mesher = [&](const remesh::Outline& outline, const remesh::SizeField& size) {
    comparison.add(outline, size);
    return triangulate(*in_run, outline, size);
  };
  const auto scene = forming::read_scene(argv[1], argv[2], {argv + 6, argv + argc});
  const auto outcome = forming::run_in_folder(scene, argv[3], {}, {}, mesher);
  forming::write_summary(argv[3], scene, outcome);
  if (!outcome.facts.completed) std::fprintf(stderr, "mesher_bench: %s\n", outcome.facts.reason.c_str());
  return outcome.facts.completed ? 0 : 1;
}
