// src/controle/results/output_file.cpp
#include "controle/results/output_file.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "tests/temporary_directory.hpp"

namespace animado::controle {
namespace {

TEST(OutputFile, HoldsWhatWasWritten) {
  const TemporaryDirectory directory;
  const std::string large(300'000, 'x');  // more than a buffer
  OutputFile file(directory.path() / "f");
  file.write("head\n");
  file.write(large);
  file.write(large);
  file.close();
  EXPECT_EQ(text_of(directory.path() / "f"), "head\n" + large + large);
}

TEST(OutputFile, AFlushIsSeenByOthers) {
  const TemporaryDirectory directory;
  OutputFile file(directory.path() / "f");
  file.write("a line\n");
  EXPECT_EQ(text_of(directory.path() / "f"), "");
  file.flush();
  EXPECT_EQ(text_of(directory.path() / "f"), "a line\n");
}

TEST(OutputFile, AWholeFileTakesThePlaceOfTheOld) {
  const TemporaryDirectory directory;
  write_text(directory.path() / "f", "old");
  write_whole(directory.path() / "f", "new");
  EXPECT_EQ(text_of(directory.path() / "f"), "new");
  EXPECT_FALSE(std::filesystem::exists(directory.path() / "f.part"));
}

TEST(OutputFile, WhatCannotBeWrittenWholeLeavesTheOld) {
  const TemporaryDirectory directory;
  write_text(directory.path() / "f", "old");
  std::filesystem::create_directory(directory.path() / "f.part");  // in the way
  EXPECT_THROW(write_whole(directory.path() / "f", "new"), Error);
  EXPECT_EQ(text_of(directory.path() / "f"), "old");
}

TEST(OutputFile, WhatIsNoFileIsWrittenInPlace) {
  EXPECT_NO_THROW(write_whole("/dev/null", "gone"));
  EXPECT_FALSE(std::filesystem::exists("/dev/null.part"));
}

TEST(OutputFile, EmptiesWhatWasThere) {
  const TemporaryDirectory directory;
  write_text(directory.path() / "f", "a long old text");
  OutputFile file(directory.path() / "f");
  file.write("new");
  file.close();
  EXPECT_EQ(text_of(directory.path() / "f"), "new");
}

TEST(OutputFile, AFullDiskIsAnErrorWithARemedy) {
  OutputFile file("/dev/full");
  file.write("anything");
  try {
    file.close();
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::unavailable);
    EXPECT_EQ(error.where(), "/dev/full");
    EXPECT_NE(error.remedy().find("free space"), std::string::npos);
  }
}

TEST(OutputFile, AMissingDirectoryIsAnError) {
  EXPECT_THROW(OutputFile("/no/such/directory/f"), Error);
}

}  // namespace
}  // namespace animado::controle
