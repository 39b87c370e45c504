// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "core/io/files.hpp"
#include "core/io/hdf5.hpp"
#include "core/io/input_file.hpp"
#include "test_folder.hpp"

namespace parison::core {
namespace {

TEST(InputFile, a_regular_file_is_read_whole) {
  const std::string path = tests::new_folder() + "/text";
  const std::string text = std::string(200'000, 'x') + '\0' + "end";
  write_text(path, text);
  const InputFile file = read_input_file(path);
  EXPECT_EQ(file.problem, "");
  EXPECT_EQ(file.content, text);
  EXPECT_EQ(read_input_file(path, text.size()).content, text);
}

TEST(InputFile, what_is_no_regular_file_or_too_large_is_refused_without_waiting) {
  const std::string folder = tests::new_folder(), pipe = folder + "/pipe", large = folder + "/large";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0666), 0);
  write_text(large, "x");
  std::filesystem::resize_file(large, 3'000'000'000);
  const std::string no_file = "is not a file with a content, allowed is a regular file";
  for (const std::string& path : {pipe, folder, std::string("/dev/zero")})
    EXPECT_EQ(read_input_file(path).problem, no_file) << path;
  EXPECT_EQ(read_input_file(large).problem, "is too large, allowed are files of up to 100 MB");
  EXPECT_EQ(read_input_file(folder + "/absent").problem, "cannot be read: No such file or directory");
}

TEST(Digest, every_flipped_bit_and_every_cut_is_found) {
  const std::string content = std::string("some\0bytes\xff", 11), sealed = with_digest(content);
  EXPECT_EQ(without_digest(sealed), content);
  EXPECT_EQ(without_digest(with_digest("")), "");
  for (std::size_t bit = 0; bit < 8 * sealed.size(); ++bit) {
    std::string flipped = sealed;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << bit % 8));
    EXPECT_FALSE(without_digest(flipped)) << bit;
  }
  for (std::size_t size = 0; size < sealed.size(); ++size) EXPECT_FALSE(without_digest(sealed.substr(0, size))) << size;
  EXPECT_FALSE(without_digest(sealed + "\n"));
}

}  // namespace
}  // namespace parison::core
