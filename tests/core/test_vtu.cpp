// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <limits>

#include "core/io/files.hpp"
#include "core/io/vtu.hpp"
#include "core/io/written_files.hpp"
#include "core/mesh/element.hpp"
#include "core/process/child_work.hpp"
#include "structured.hpp"
#include "test_folder.hpp"

namespace parison::core {
namespace {

using tests::new_folder;

Mesh bent_mesh() {
  return tests::structured(5, 3, [](double s, double t) { return Point(0.01 + 0.02 * s + 0.004 * t * t, 0.03 * t); });
}

TEST(Vtu, a_file_read_back_has_the_quadratic_cells_and_the_points_and_fields_in_single_precision) {
  const Mesh mesh = bent_mesh();
  VtuFields fields;
  fields.time = 0.375;
  fields.displacement = Point(0, 0.125);
  fields.nodal.push_back({"temperature_degC", Eigen::VectorXd::LinSpaced(mesh.node_count(), 400, 1100 / 3.0)});
  fields.nodal.push_back({"velocity", Eigen::VectorXd::LinSpaced(dim * mesh.node_count(), -1 / 3.0, 1)});
  fields.cell.push_back({"active", 1});
  const std::string path = new_folder() + "/glass_0000.vtu";
  write_vtu(path, mesh, fields);

  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkUnstructuredGrid& grid = *reader->GetOutput();
  ASSERT_EQ(grid.GetNumberOfPoints(), mesh.node_count());
  ASSERT_EQ(grid.GetNumberOfCells(), mesh.cell_count());
  for (Index i = 0; i < mesh.node_count(); ++i) {
    EXPECT_EQ(grid.GetPoint(i)[0], static_cast<float>(1e3 * mesh.nodes[i][0]));
    EXPECT_EQ(grid.GetPoint(i)[1], static_cast<float>(1e3 * (mesh.nodes[i][1] + 0.125)));
    EXPECT_EQ(grid.GetPoint(i)[2], 0);
    EXPECT_EQ(grid.GetPointData()->GetArray("temperature_degC")->GetTuple1(i),
              static_cast<float>(fields.nodal[0].values[i]));
    const double* v = grid.GetPointData()->GetArray("velocity")->GetTuple3(i);
    EXPECT_EQ(v[0], static_cast<float>(fields.nodal[1].values[2 * i]));
    EXPECT_EQ(v[1], static_cast<float>(fields.nodal[1].values[2 * i + 1]));
    EXPECT_EQ(v[2], 0);
  }
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    ASSERT_EQ(grid.GetCellType(c), VTK_QUADRATIC_TRIANGLE);
    for (int k = 0; k < 6; ++k) EXPECT_EQ(grid.GetCell(c)->GetPointId(k), mesh.cells()[c][k]);
    EXPECT_EQ(grid.GetCellData()->GetArray("active")->GetTuple1(c), 1);
  }
  EXPECT_EQ(grid.GetFieldData()->GetArray("TimeValue")->GetTuple1(0), 0.375);
  EXPECT_EQ(grid.GetFieldData()->GetAbstractArray("LengthUnit")->GetVariantValue(0).ToString(), "mm");
}

TEST(Vtu, the_middle_of_an_edge_in_the_file_is_where_the_quadratic_edge_runs) {
  const Mesh mesh = bent_mesh();
  const std::string path = new_folder() + "/glass.vtu";
  write_vtu(path, mesh, {});
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  double where[3] = {0.25, 0.25, 0}, x[3], weights[6];
  int sub = 0;
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    reader->GetOutput()->GetCell(c)->EvaluateLocation(sub, where, x, weights);
    const auto shape = triangle_shape(0.25, 0.25);
    Point expected = Point::Zero();
    for (int k = 0; k < 6; ++k) expected += shape[k] * mesh.nodes[mesh.cells()[c][k]];
    EXPECT_NEAR(x[0], 1e3 * expected[0], 1e-5);
    EXPECT_NEAR(x[1], 1e3 * expected[1], 1e-5);
  }
}

TEST(Vtu, values_beyond_single_precision_are_its_largest) {
  const Mesh mesh = bent_mesh();
  VtuFields fields;
  fields.nodal.push_back({"viscosity_Pa_s", Eigen::VectorXd::Constant(mesh.node_count(), 1e200)});
  fields.nodal.push_back(
      {"lowest", Eigen::VectorXd::Constant(mesh.node_count(), -std::numeric_limits<double>::infinity())});
  fields.nodal.push_back({"none", Eigen::VectorXd::Constant(mesh.node_count(), std::nan(""))});
  const std::string path = new_folder() + "/glass.vtu";
  write_vtu(path, mesh, fields);
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkPointData& read = *reader->GetOutput()->GetPointData();
  EXPECT_EQ(read.GetArray("viscosity_Pa_s")->GetTuple1(3), std::numeric_limits<float>::max());
  EXPECT_EQ(read.GetArray("lowest")->GetTuple1(3), std::numeric_limits<float>::lowest());
  EXPECT_TRUE(std::isnan(read.GetArray("none")->GetTuple1(3)));
}

TEST(Vtu, a_full_disk_and_a_missing_folder_are_told_with_the_path) {
  const std::string folder = new_folder();
  const auto complaint = [](const std::string& path) -> std::string {
    try {
      write_vtu(path, bent_mesh(), {});
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  const std::string absent = folder + "/absent/glass.vtu", full = folder + "/glass.vtu";
  EXPECT_EQ(complaint(absent), absent + ": cannot be written: No such file or directory");
  const ChildWork work = in_child([&] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit room{100, 100};
    ::setrlimit(RLIMIT_FSIZE, &room);
    return complaint(full);
  });
  EXPECT_EQ(work.text, full + ": cannot be written: File too large");
}

TEST(Pvd, the_collection_is_complete_after_every_addition) {
  const std::string path = new_folder() + "/glass.pvd";
  PvdCollection collection(path);
  for (int i = 0; i < 3; ++i) {
    collection.add(0.1 * i, "vtu/glass_" + std::to_string(i) + ".vtu");
    const std::string text = read_text(path);
    EXPECT_NE(text.find("timestep=\"" + std::string(i == 0 ? "0" : i == 1 ? "0.1" : "0.2")), text.npos);
    EXPECT_NE(text.find("file=\"vtu/glass_" + std::to_string(i) + ".vtu\""), text.npos);
    EXPECT_EQ(text.substr(text.size() - 11), "</VTKFile>\n");
    EXPECT_FALSE(std::filesystem::exists(unfinished_name(path)));
  }
}

}  // namespace
}  // namespace parison::core
