// src/visao/film.cpp and encoder.cpp, with a program in ffmpeg's place that keeps what it is given: its last
// argument is the film's name.
#include "visao/film.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "base/error.hpp"
#include "recorded.hpp"
#include "tests/temporary_directory.hpp"

namespace animado::visao {
namespace {

namespace fs = std::filesystem;

class Film : public testing::Test {
 protected:
  Film() {
    fs::create_directory(directory_ / "bin");
    fs::create_directory(directory_ / "out");
    setenv("PATH", (directory_ / "bin").c_str(), 1);
    request_.file = directory_ / "out" / "film.mp4";
    request_.begin_s = 0;
    request_.end_s = 0.2;
    request_.size = {64, 36};
  }
  ~Film() override { setenv("PATH", path_.c_str(), 1); }

  void install(const std::string& script) {
    const fs::path file = write_text(directory_ / "bin" / "ffmpeg", "#!/bin/sh\n" + script);
    fs::permissions(file, fs::perms::owner_all);
  }
  std::vector<std::string> left_behind() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(directory_ / "out"))
      names.push_back(entry.path().filename());
    return names;
  }

  const std::string path_ = getenv("PATH");
  TemporaryDirectory directory_;
  FilmRequest request_;
  controle::RecordedRun run_ =
      recorded({{.name = "ball", .shape = Sphere{1}}}, {{Vec3(0, 0, 0)}, {Vec3(1, 0, 0)}, {Vec3(2, 0, 0)}});
};

constexpr auto kKeep = "for word; do last=$word; done\nexec /bin/cat > \"$last\"\n";

TEST_F(Film, HasThirtyPicturesASecondAndBothEnds) {
  install(kKeep);
  std::vector<int64_t> done;
  request_.on_picture = [&](int64_t k, int64_t all) {
    done.push_back(k);
    EXPECT_EQ(all, 7);
  };
  EXPECT_TRUE(film(run_, request_));
  EXPECT_THAT(done, testing::ElementsAre(1, 2, 3, 4, 5, 6, 7));
  EXPECT_EQ(fs::file_size(request_.file), 7u * 64 * 36 * 3);
  EXPECT_THAT(left_behind(), testing::ElementsAre("film.mp4"));
}

TEST_F(Film, ShowsTheMotionBetweenFrames) {
  install(kKeep);
  ASSERT_TRUE(film(run_, request_));
  const std::string bytes = text_of(request_.file);
  const size_t a_picture = 64 * 36 * 3;
  for (size_t k = 1; k < 7; ++k) {
    EXPECT_NE(bytes.substr(k * a_picture, a_picture), bytes.substr((k - 1) * a_picture, a_picture)) << k;
  }
}

TEST_F(Film, ThatIsStoppedLeavesNothing) {
  install(kKeep);
  int left = 3;
  request_.stop = [&] { return left-- == 0; };
  EXPECT_FALSE(film(run_, request_));
  EXPECT_THAT(left_behind(), testing::IsEmpty());
}

TEST_F(Film, WithoutFfmpegIsAnErrorThatSaysHowToInstallIt) {
  try {
    film(run_, request_);
    FAIL() << "a film without ffmpeg";
  } catch (const Error& error) {
    EXPECT_THAT(error.remedy(), testing::HasSubstr("apt-get install ffmpeg"));
  }
  EXPECT_THAT(left_behind(), testing::IsEmpty());
}

TEST_F(Film, ThatFfmpegRefusesIsAnErrorAndLeavesNothing) {
  install("for word; do last=$word; done\n/bin/cat > \"$last\"\nexit 3\n");
  try {
    film(run_, request_);
    FAIL() << "a film from a failure";
  } catch (const Error& error) {
    EXPECT_THAT(error.message(), testing::HasSubstr("status 3"));
  }
  EXPECT_THAT(left_behind(), testing::IsEmpty());
}

}  // namespace
}  // namespace animado::visao
