// SPDX-License-Identifier: GPL-3.0-or-later
// mesher_bench CASE ACCURACY FOLDER REPEATS MESHER [KEY=VALUE ...]: runs a case with its glass meshed by MESHER and at
// each new glass mesh gives the same outline and size field REPEATS times to every mesher; FOLDER.meshes.csv has a row
// for each.
#include <gmsh.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>

#include "core/linear/blas_threads.hpp"
#include "forming/report/summary.hpp"
#include "forming/run/run.hpp"
#include "remesh/remesh_glass.hpp"
#include "tools/benchmarks/bare_flow.hpp"
#include "tools/benchmarks/cgal_mesher.hpp"
#include "tools/benchmarks/mesh_figures.hpp"

namespace parison::remesh {

#define TRIANGULATE "_ZN7parison6remesh11triangulateERKNS0_7OutlineERKNS0_9SizeFieldE"
#define REMESH_GLASS "_ZN7parison6remesh12remesh_glassERKNS_4core4MeshERKNS0_8CriteriaE"
Triangulation real_triangulate(const Outline&, const SizeField&) __asm__("__real_" TRIANGULATE);
Triangulation chosen_triangulate(const Outline&, const SizeField&) __asm__("__wrap_" TRIANGULATE);
Remeshed real_remesh_glass(const core::Mesh&, const Criteria&) __asm__("__real_" REMESH_GLASS);
Remeshed watched_remesh_glass(const core::Mesh&, const Criteria&) __asm__("__wrap_" REMESH_GLASS);

}  // namespace parison::remesh

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

struct Bench {
  std::ofstream table;
  int repeats = 0, seen = 0;
  const Mesher *in_run = nullptr, *now = &meshers[0];
  std::optional<remesh::Triangulation> ready;  ///< what the mesher of the comparison has made
} record;

struct Made {
  remesh::MeshedOutline meshed;
  core::Index added = 0;
  double seconds;
};

/// One mesh, with the program's own finish.
Made make(const Mesher& mesher, const remesh::Outline& outline, const std::vector<std::string>& boundary_names,
          const remesh::SizeField& size) {
  Made result;
  record.now = &mesher;
  const double start = bench::cpu_seconds();
  if (mesher.gmsh_algorithm) {
    result.meshed = remesh::mesh_outline(outline, boundary_names, size);
  } else {
    bench::CgalMesh made = bench::cgal_mesh(outline, size, mesher.cgal);
    record.ready = std::move(made.triangles);
    result.added = made.added;
    result.meshed = remesh::mesh_outline(made.outline, boundary_names, size);
  }
  result.seconds = bench::cpu_seconds() - start;
  return result;
}

void compare(const core::Mesh& old, const remesh::Criteria& criteria) {
  const remesh::SizeField size = remesh::size_field(old, criteria);
  const remesh::Outline outline = remesh::resample(old, criteria, size).outline;
  for (const Mesher& mesher : meshers) {
    std::vector<double> seconds;
    std::uint64_t bits = 0;
    bool same = true;
    for (int i = 0; i < record.repeats; ++i) {
      const remesh::SizeField own = size;  // it remembers what was asked
      const Made made = make(mesher, outline, old.boundaries(), own);
      seconds.push_back(made.seconds);
      if (!made.meshed.reason.empty()) {
        record.table << record.seen << ',' << mesher.name << ",nan,nan,nan,nan,nan,nan,nan,nan,nan,1,0\n";
        break;
      }
      const auto figures = bench::mesh_figures(made.meshed.mesh, size);
      if (i == 0) bits = figures.bits;
      same = same && figures.bits == bits;
      if (i + 1 < record.repeats) continue;
      std::nth_element(seconds.begin(), seconds.begin() + seconds.size() / 2, seconds.end());
      record.table << record.seen << ',' << mesher.name << ',' << made.meshed.mesh.cell_count() << ','
                   << seconds[seconds.size() / 2] << ',' << figures.min << ',' << figures.median << ','
                   << figures.min_angle << ',' << figures.size_mean << ',' << figures.size_max << ','
                   << figures.max_jump << ',' << made.added << ',' << same << ',' << bits << std::endl;
    }
  }
  ++record.seen;
}

}  // namespace

remesh::Triangulation remesh::chosen_triangulate(const Outline& outline, const SizeField& size) {
  if (record.ready) {
    Triangulation made = std::move(*record.ready);
    record.ready.reset();
    return made;
  }
  if (!record.now->gmsh_algorithm) return bench::cgal_mesh(outline, size, record.now->cgal).triangles;
  const bool other = record.now->gmsh_algorithm != frontal_delaunay;
  if (other) gmsh::option::setNumber("Mesh.Algorithm", record.now->gmsh_algorithm);
  Triangulation made = real_triangulate(outline, size);
  if (other) gmsh::option::setNumber("Mesh.Algorithm", frontal_delaunay);
  return made;
}

remesh::Remeshed remesh::watched_remesh_glass(const core::Mesh& old, const Criteria& criteria) {
  if (record.repeats > 0) compare(old, criteria);
  record.now = record.in_run;
  Remeshed result = real_remesh_glass(old, criteria);
  record.now = &meshers[0];
  return result;
}

int main(int argc, char** argv) {
  if (argc < 6) {
    std::fprintf(stderr, "mesher_bench: CASE ACCURACY FOLDER REPEATS MESHER [KEY=VALUE ...]\n");
    return 2;
  }
  core::use_one_blas_thread();
  record.repeats = std::atoi(argv[4]);
  record.in_run =
      std::find_if(meshers.begin(), meshers.end(), [&](const Mesher& m) { return std::string(argv[5]) == m.name; });
  if (record.in_run == meshers.end() || !(record.in_run->gmsh_algorithm || record.in_run->cgal.keep_edges))
    return std::fprintf(stderr, "mesher_bench: no mesher \"%s\" that keeps the outline\n", argv[5]), 2;
  record.table.open(std::string(argv[3]) + ".meshes.csv");
  record.table << "remesh,mesher,triangles,seconds,min_quality,median,angle,size_mean,size_max,jump,added,same,bits\n";
  const auto scene = forming::read_scene(argv[1], argv[2], {argv + 6, argv + argc});
  const auto outcome = forming::run(scene, argv[3]);
  forming::write_summary(argv[3], scene, outcome.state, outcome.facts);
  if (!outcome.facts.completed) std::fprintf(stderr, "mesher_bench: %s\n", outcome.facts.reason.c_str());
  return outcome.facts.completed ? 0 : 1;
}
