// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <limits>

#include "core/io/files.hpp"
#include "core/io/hdf5.hpp"
#include "core/io/written_files.hpp"
#include "core/process/child_work.hpp"
#include "core/process/run_error.hpp"
#include "test_folder.hpp"

namespace parison::core {
namespace {

using tests::new_folder;

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
  EXPECT_TRUE(is_own(path));
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
  replace_file(path, "one\n");
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
    const rlimit room{1000, 1000};  // the manifest needs some of it
    ::setrlimit(RLIMIT_FSIZE, &room);
    GrowingFile file(path, 0);
    file.append("one\n");
    try {
      file.append(std::string(2000, '1') + '\n');
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
  replace_file(path, "old");
  const ChildWork work = in_child([&] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit room{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &room);
    try {
      replace_file(path, std::string(2000, 'x'));
    } catch (const SystemError& error) {
      return std::to_string(error.code);
    }
    return std::string();
  });
  EXPECT_EQ(work.text, std::to_string(EFBIG));
  EXPECT_EQ(read_text(path), "old");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 2);  // with the manifest
  EXPECT_THROW(replace_file(folder + "/absent/a.txt", "x"), SystemError);
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
