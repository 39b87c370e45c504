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
#include <cstring>
#include <filesystem>
#include <limits>

#include "core/io/files.hpp"
#include "core/io/hdf5.hpp"
#include "core/io/json.hpp"
#include "core/io/json_read.hpp"
#include "core/io/vtu.hpp"
#include "core/mesh/element.hpp"
#include "core/process/child_work.hpp"
#include "core/process/run_error.hpp"
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
  for (const auto& [path, reason] : {std::pair<std::string, std::string>{"/dev/full", "No space left on device"},
                                     {folder + "/absent/glass.vtu", "No such file or directory"}})
    try {
      write_vtu(path, bent_mesh(), {});
      FAIL() << "nothing was thrown for " << path;
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string(error.what()), path + ": cannot be written: " + reason);
    }
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
    EXPECT_EQ(std::filesystem::exists(path + ".part"), false);
  }
}

TEST(Hdf5, values_come_back_to_the_bit) {
  const std::string path = new_folder() + "/values.h5";
  const std::vector<double> doubles{0.1, -0.0, 5e-324, std::numeric_limits<double>::infinity(), 1 / 3.0, 1e300};
  const std::vector<int> integers{-1, 0, std::numeric_limits<int>::max()};
  const Eigen::VectorXd vector = Eigen::VectorXd::LinSpaced(7, 0, 1 / 7.0);
  const std::int64_t large = std::numeric_limits<std::int64_t>::min() + 3;
  write_hdf5(path, [&](Hdf5Group& file) {
    file.write("doubles", doubles, 2);
    file.write("none", std::vector<double>{});
    Hdf5Group group = file.create("inner").create("most");
    group.write("integers", integers);
    group.write("vector", vector);
    group.write("large", large);
    group.write("small", 5e-324);
    group.write("text", std::string("Glas, 1150 \xc2\xb0"
                                    "C"));
    group.write("no_text", std::string());
  });
  const Hdf5Group file = open_hdf5(path);
  const std::vector<double> read = file.read_doubles("doubles");
  ASSERT_EQ(read.size(), doubles.size());
  EXPECT_EQ(std::memcmp(read.data(), doubles.data(), sizeof(double) * doubles.size()), 0);
  EXPECT_TRUE(file.read_doubles("none").empty());
  const Hdf5Group group = file.open("inner").open("most");
  EXPECT_EQ(group.read_integers("integers"), integers);
  EXPECT_EQ(group.read_vector("vector"), vector);
  EXPECT_EQ(group.read_integer("large"), large);
  EXPECT_EQ(group.read_double("small"), 5e-324);
  EXPECT_EQ(group.read_string("text"),
            "Glas, 1150 \xc2\xb0"
            "C");
  EXPECT_EQ(group.read_string("no_text"), "");
  EXPECT_TRUE(group.has("text"));
  EXPECT_FALSE(group.has("texts"));
}

TEST(Hdf5, what_is_missing_is_named) {
  const std::string path = new_folder() + "/values.h5";
  write_hdf5(path, [](Hdf5Group& file) { file.write("a", 1.0); });
  const Hdf5Group file = open_hdf5(path);
  try {
    file.read_double("b");
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()), path + ": \"b\" is missing");
  }
  write_text(path + ".txt", "not HDF5");
  EXPECT_THROW(open_hdf5(path + ".txt"), std::runtime_error);
  EXPECT_THROW(open_hdf5(path + ".absent"), std::runtime_error);
}

TEST(Hdf5, an_incomplete_file_is_refused_and_the_same_content_makes_the_same_file) {
  const std::string path = new_folder() + "/values.h5";
  const auto fill = [](Hdf5Group& file) { file.create("inner").write("a", std::vector<double>(1000, 0.1)); };
  write_hdf5(path, fill);
  const std::string bytes = read_text(path);
  EXPECT_EQ(read_hdf5(path).problem, "");
  write_hdf5(path, fill);
  EXPECT_EQ(read_text(path), bytes);
  write_text(path, bytes.substr(0, bytes.size() / 2));
  EXPECT_NE(read_hdf5(path).problem, "");
  EXPECT_NE(read_hdf5(path + ".absent").problem, "");
}

TEST(GrowingFile, it_goes_on_where_it_was_and_cuts_off_the_rest) {
  const std::string path = new_folder() + "/rows.csv";
  {
    GrowingFile file(path, 0);
    file.append("one\n");
    EXPECT_EQ(file.size(), 4);
    file.append("two\nthr");
    EXPECT_EQ(read_text(path), "one\ntwo\nthr");
  }
  GrowingFile(path, 4).append("2\n");
  EXPECT_EQ(read_text(path), "one\n2\n");
}

std::string complaint_of_opening(const std::string& path, std::int64_t size) {
  try {
    const GrowingFile file(path, size);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(GrowingFile, a_shorter_file_and_a_second_writer_are_refused) {
  const std::string path = new_folder() + "/rows.csv";
  write_text(path, "one\n");
  EXPECT_EQ(complaint_of_opening(path, 5), path + ": 4 bytes were found, it once had 5");
  EXPECT_EQ(complaint_of_opening(path + ".absent", 5), path + ".absent: cannot be opened: No such file or directory");
  const GrowingFile file(path, 4);
  EXPECT_EQ(complaint_of_opening(path, 0), path + ": another process is writing to it");
  EXPECT_EQ(read_text(path), "one\n");
}

TEST(GrowingFile, on_a_full_disk_no_part_of_a_row_is_left) {
  const std::string path = new_folder() + "/rows.csv";
  const ChildWork work = in_child([&] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit room{10, 10};
    ::setrlimit(RLIMIT_FSIZE, &room);
    GrowingFile file(path, 0);
    file.append("one\n");
    try {
      file.append("0.123456789\n");
    } catch (const RunError& error) {
      return std::string(error.what()) + ", " + std::to_string(file.size());
    }
    return std::string();
  });
  EXPECT_EQ(work.text, path + ": cannot be written: File too large, 4");
  EXPECT_EQ(read_text(path), "one\n");
}

TEST(ReplaceFile, a_failed_write_leaves_the_old_file_and_nothing_beside) {
  const std::string folder = new_folder(), path = folder + "/text";
  write_text(path, "old");
  const auto write = [](const std::string& temporary) {
    write_text(temporary, "half");
    throw std::runtime_error("full");
  };
  EXPECT_THROW(replace_file(path, write), std::runtime_error);
  EXPECT_EQ(read_text(path), "old");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
}

TEST(Json, text_is_escaped_numbers_keep_their_digits_and_nan_is_null) {
  JsonWriter json;
  json.add("quote \" and \\", std::string("line\nbreak \x01"));
  json.add("third", 1 / 3.0);
  json.add("nan", std::nan(""));
  json.add("infinity", -std::numeric_limits<double>::infinity());
  json.add("whole", 12345678901L);
  json.open_object("empty");
  json.close();
  json.open_list("list");
  json.add("", true);
  json.open_object("");
  json.add("a", 1e-300);
  EXPECT_EQ(json.finish(), R"({
  "quote \" and \\": "line\nbreak \u0001",
  "third": 0.3333333333333333,
  "nan": null,
  "infinity": null,
  "whole": 12345678901,
  "empty": {},
  "list": [
    true,
    {
      "a": 1e-300
    }
  ]
}
)");
}

TEST(Json, what_was_written_is_read_back_in_its_order_and_a_torn_text_is_refused) {
  JsonWriter json;
  json.add("third", 1 / 3.0);
  json.add("nan", std::nan(""));
  json.add("two", 2.0);
  json.add("text", std::string("a \"b\"\n\xc2\xb0"
                               "C \xff"));
  json.add("flag", true);
  json.open_list("list");
  json.add("", 5e-324);
  const std::string text = json.finish();
  const JsonValue read = read_json(text, "summary.json");
  ASSERT_EQ(read.items.size(), 6u);
  EXPECT_EQ(read.items[1].name, "nan");
  EXPECT_EQ(read.number_of("third"), 1 / 3.0);
  EXPECT_TRUE(std::isnan(read.number_of("nan")));
  EXPECT_TRUE(std::isnan(read.number_of("absent")));
  EXPECT_EQ(read.number_of("two"), 2);
  EXPECT_EQ(read.text_of("text"),
            "a \"b\"\n\xc2\xb0"
            "C \xef\xbf\xbd");
  EXPECT_TRUE(read.flag_of("flag"));
  EXPECT_EQ(read.find("list")->items.at(0).number, 5e-324);
  try {
    read_json(text.substr(0, text.size() / 2), "summary.json");
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()), "summary.json: no JSON");
  }
}

TEST(Files, a_replaced_file_is_the_old_one_until_the_new_one_is_complete) {
  const std::string path = new_folder() + "/a.txt";
  replace_file(path, "old");
  replace_file(path, [&](const std::string& temporary) {
    write_text(temporary, "new");
    sync_to_disk(temporary);
    EXPECT_EQ(read_text(path), "old");
  });
  EXPECT_EQ(read_text(path), "new");
  EXPECT_THROW(replace_file(path, [](const std::string&) { throw std::runtime_error("disk full"); }),
               std::runtime_error);
  EXPECT_EQ(read_text(path), "new");
  EXPECT_THROW(write_text(new_folder() + "/absent/a.txt", "x"), std::runtime_error);
}

TEST(Files, csv_fields_are_quoted_where_they_need_it) {
  EXPECT_EQ(csv_text("press"), "press");
  EXPECT_EQ(csv_text("press, then \"blow\""), "\"press, then \"\"blow\"\"\"");
}

TEST(Files, the_fingerprint_is_fnv1a) {
  EXPECT_EQ(fingerprint(""), 0xcbf29ce484222325u);
  EXPECT_EQ(fingerprint("a"), 0xaf63dc4c8601ec8cu);
  EXPECT_EQ(fingerprint("foobar"), 0x85944171f73967e8u);
}

}  // namespace
}  // namespace parison::core
