// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "core/io/manifest.hpp"
#include "core/io/written_files.hpp"
#include "test_folder.hpp"

namespace parison::core {
namespace {

namespace fs = std::filesystem;
using tests::new_folder;

std::string complaint(const std::string& path) {
  try {
    require_own(path);
  } catch (const CaseError& error) {
    return error.what();
  }
  return {};
}

TEST(WrittenFiles, what_was_written_may_be_written_again_and_nothing_else) {
  const std::string folder = new_folder(), own = folder + "/own.csv", other = folder + "/other.csv";
  replace_file(own, "one");
  replace_file(own, "two");
  EXPECT_EQ(read_text(own), "two");
  write_text(own, "one");  // a content of before is lost to nobody
  EXPECT_TRUE(is_own(own));
  write_text(own, "my notes");
  write_text(other, "mine");
  for (const std::string& path : {own, other}) {
    EXPECT_EQ(complaint(path).rfind(path + ": this was not written by parison, or has changed since", 0), 0u);
    const std::string before = read_text(path);
    EXPECT_THROW(replace_file(path, "three"), CaseError);
    EXPECT_THROW(GrowingFile(path, 0), CaseError);
    EXPECT_THROW(remove_own(path), CaseError);
    EXPECT_EQ(read_text(path), before);
  }
}

TEST(WrittenFiles, a_link_is_nobodys_file_to_write_through) {
  const std::string folder = new_folder(), target = folder + "/precious.txt", link = folder + "/own.csv";
  write_text(target, "mine");
  fs::create_symlink(target, link);
  EXPECT_THROW(replace_file(link, "mine"), CaseError);
  EXPECT_THROW(GrowingFile(link, 0), CaseError);
  fs::remove(link);
  fs::create_symlink(folder, folder + "/round");
  EXPECT_THROW(remove_own(folder + "/round"), CaseError);
  EXPECT_EQ(read_text(target), "mine");
}

TEST(WrittenFiles, what_a_loss_of_power_has_cut_is_known_by_its_beginning) {
  const std::string folder = new_folder(), path = folder + "/summary.json";
  std::string content = "{\n  \"case\": \"jar\"";
  for (int i = 0; i < 500; ++i) content += std::to_string(i * i);
  replace_file(path, content);
  for (const std::size_t length : {std::size_t{0}, std::size_t{1}, std::size_t{100}, content.size() - 1}) {
    write_text(path, content.substr(0, length));
    EXPECT_TRUE(is_own(path)) << length;
  }
  write_text(path, content + "x");
  EXPECT_FALSE(is_own(path));
  write_text(path, "my notes");
  EXPECT_FALSE(is_own(path));
}

TEST(WrittenFiles, a_folder_goes_with_its_own_files_only_and_before_that_all_are_looked_at) {
  const std::string folder = new_folder() + "/run";
  fs::create_directories(folder + "/vtu/empty");
  replace_file(folder + "/a.csv", "a");
  replace_file(folder + "/vtu/b.vtu", "b");
  write_text(folder + "/vtu/notes.txt", "mine");
  EXPECT_NE(complaint(folder).find("/vtu/notes.txt: this was not written"), std::string::npos);
  EXPECT_THROW(remove_own(folder), CaseError);
  EXPECT_TRUE(fs::exists(folder + "/a.csv"));
  remove_own_files(folder);
  EXPECT_FALSE(fs::exists(folder + "/a.csv"));
  EXPECT_FALSE(fs::exists(folder + "/vtu/b.vtu"));
  EXPECT_EQ(read_text(folder + "/vtu/notes.txt"), "mine");
  fs::remove(folder + "/vtu/notes.txt");
  remove_own(folder);
  EXPECT_FALSE(fs::exists(folder));
}

TEST(WrittenFiles, they_stay_the_programs_own_under_another_name_and_in_a_copied_folder) {
  const std::string folder = new_folder(), one = folder + "/one", other = folder + "/other";
  fs::create_directories(one);
  replace_file(one + "/last.h5", "state");
  rename_own(one + "/last.h5", one + "/before.h5");
  link_own(one + "/before.h5", one + "/kept.h5");
  write_text(one + "/mine.h5", "mine");
  rename_own(one + "/before.h5", one + "/mine.h5");
  EXPECT_EQ(read_text(one + "/mine.h5.damaged"), "mine");
  fs::remove(one + "/mine.h5.damaged");
  fs::copy(one, other, fs::copy_options::recursive);
  remove_own(one);
  remove_own(other);
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST(WrittenFiles, a_manifest_that_was_cut_or_made_anew_is_read_as_it_is) {
  const std::string folder = new_folder(), path = folder + "/a\nb.csv";
  replace_file(path, "one");
  EXPECT_TRUE(is_own(path));
  const std::string manifest = folder + '/' + manifest_name, lines = read_text(manifest);
  write_text(manifest, lines.substr(0, lines.size() - 5));
  EXPECT_FALSE(is_own(path));
  fs::remove(path);
  replace_file(path, "two");
  EXPECT_TRUE(is_own(path));
  fs::remove(manifest);
  EXPECT_FALSE(is_own(path));
}

TEST(WrittenFiles, a_folder_belongs_to_one_command_and_names_what_is_in_its_way) {
  const std::string folder = new_folder();
  write_text(folder + "/notes.txt", "mine");
  claim_folder(folder, "sweep", {"results.csv", "run_*"});
  claim_folder(folder, "sweep", {"results.csv", "run_*"});
  EXPECT_THROW(claim_folder(folder, "optimise", {}), CaseError);
  fs::create_directories(folder + "/run_0002");
  claim_folder(folder, "sweep", {"run_*"});  // an empty folder is in nobody's way
  write_text(folder + "/run_0002/notes.txt", "mine");
  EXPECT_THROW(claim_folder(folder, "sweep", {"run_*"}), CaseError);
  claim_folder(folder, "sweep", {"results.csv"});
  EXPECT_THROW(claim_folder(folder + "/notes.txt", "sweep", {}), CaseError);
}

}  // namespace
}  // namespace parison::core
