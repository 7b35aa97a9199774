/// A file has all of its new text or stays unchanged, and no temporary file remains in its folder.

#include "base/whole_file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <iterator>
#include <string>

#include "base/option_checks.hpp"

namespace trivium {
namespace {

namespace fs = std::filesystem;

/// An empty folder for each test.
class WholeFile : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  long files() const { return std::distance(fs::directory_iterator(folder_), fs::directory_iterator()); }

  fs::path folder_ =
      fs::path(::testing::TempDir()) / ::testing::UnitTest::GetInstance()->current_test_info()->name();
  fs::path file_ = folder_ / "file", link_ = folder_ / "link";
};

TEST_F(WholeFile, IsReadAsItWasWritten) {
  const std::string text("a\r\nb\0c", 6);
  write_whole(file_, text);
  EXPECT_EQ(read_whole(file_), text);
}

TEST_F(WholeFile, GrowsUnseenUntilItIsKept) {
  write_whole(file_, "old");
  {
    GrowingFile dropped(file_);
    dropped.write("new");
  }
  EXPECT_EQ(read_whole(file_), "old");
  GrowingFile kept(file_);
  kept.write("ne");
  kept.write("w");
  EXPECT_EQ(read_whole(file_), "old");
  EXPECT_FALSE(kept.keep());
  EXPECT_EQ(read_whole(file_), "new");
  EXPECT_EQ(files(), 1);
}

/// Files of this process cannot grow beyond `bytes`, as on a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit now{bytes, before_.rlim_max};
    std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &now);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, SIG_DFL);
  }
  FullDisk(const FullDisk&) = delete;

 private:
  rlimit before_{};
};

TEST_F(WholeFile, ThatCannotGrowFurtherStaysWithItsWholeLinesUnderAnotherName) {
  write_whole(file_, "old");
  std::error_code reason;
  fs::path left;
  {
    const FullDisk full(100'000);
    GrowingFile growing(file_);
    const std::string line = std::string(999, 'x') + "\n";
    bool is_written = true;
    for (int k = 0; k < 200 && is_written; ++k) is_written = growing.write(line);
    EXPECT_FALSE(is_written);
    reason = growing.keep();
    left = growing.incomplete();
  }
  EXPECT_EQ(reason, std::errc::file_too_large);
  EXPECT_EQ(read_whole(file_), "old");
  EXPECT_EQ(left.string(), file_.string() + ".incomplete-" + std::to_string(getpid()));
  const std::string written = read_whole(left);
  EXPECT_GE(written.size(), 90'000u);
  EXPECT_EQ(written.size() % 1000, 0u);
}

TEST_F(WholeFile, LeavesNothingOfATextThatDoesNotFit) {
  {
    const FullDisk full(1000);
    EXPECT_TRUE(replace_file(file_, std::string(5000, 'x')));
  }
  EXPECT_EQ(files(), 0);
}

TEST_F(WholeFile, IsWrittenWhereALinkPoints) {
  fs::create_symlink(file_.filename(), link_);
  write_whole(link_, "text");
  EXPECT_TRUE(fs::is_symlink(link_));
  EXPECT_EQ(read_whole(file_), "text");
}

TEST_F(WholeFile, NeverReplacesWhatIsNoRegularFile) {
  ASSERT_EQ(mkfifo(file_.c_str(), 0600), 0);
  fs::create_symlink(link_.filename(), link_);  // a link to itself: an endless chain of links
  for (const fs::path& path : {file_, link_, folder_}) {
    EXPECT_FALSE(file_to_write(path)) << path;
    EXPECT_THROW(write_whole(path, "text"), fs::filesystem_error) << path;
    EXPECT_NE(why_not_writable(path.string()), "") << path;
  }
  EXPECT_TRUE(fs::is_fifo(file_));
}

TEST_F(WholeFile, NeedsAFolderThatExists) {
  const fs::path path = folder_ / "none" / "file";
  EXPECT_THROW(write_whole(path, "text"), fs::filesystem_error);
  EXPECT_THROW(read_whole(path), fs::filesystem_error);
  EXPECT_NE(why_not_writable(path.string()).find("does not exist"), std::string::npos);
  EXPECT_EQ(why_not_writable(file_.string()), "");
}

}  // namespace
}  // namespace trivium
