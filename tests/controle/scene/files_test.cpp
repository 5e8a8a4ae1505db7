// src/controle/scene/{obj_file,script_file,text_file}.cpp: the files that a scene names.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "controle/scene/obj_file.hpp"
#include "controle/scene/scene.hpp"
#include "controle/scene/script_file.hpp"
#include "tests/temporary_directory.hpp"

namespace animado::controle {
namespace {

using testing::HasSubstr;

class Files : public testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) const {
    const std::string path = (folder_ / name).string();
    std::ofstream(path) << text;
    return path;
  }
  // What the reader says of a file with this text.
  template <class Reader>
  std::string refusal(Reader read, const std::string& text) const {
    try {
      read(write("file", text));
    } catch (const Error& error) {
      return std::string(error.what()).substr(folder_.path().string().size() + 1);
    }
    return "accepted";
  }

  TemporaryDirectory folder_;
};

constexpr const char* kTetrahedron =
    "# a corner\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 9 9 9\nvn 0 0 1\nf 1//1 3//1 2//1\nf 1 2/1 4\nf 1 4 "
    "3\nf -4 -3 -2\n";

TEST_F(Files, ObjGivesTheVerticesOfItsFaces) {
  const std::vector<Vec3> points = read_obj(write("a.obj", kTetrahedron));
  ASSERT_EQ(points.size(), 4u);  // not the fifth, which no face mentions
  EXPECT_EQ(points[3], Vec3(0, 0, 1));
  EXPECT_EQ(read_obj(write("b.obj", "v 1 2 3\r\nv 4 5 6\r\n")).size(), 2u);
}

TEST_F(Files, ObjThatMakesNoSenseIsRefusedByLine) {
  EXPECT_THAT(refusal(read_obj, "v 1 2\n"), HasSubstr("file:1: a vertex has three coordinates"));
  EXPECT_THAT(refusal(read_obj, "v 1 2 3\nv 1 2 x\n"), HasSubstr("file:2: expected a number, found `x`"));
  EXPECT_THAT(refusal(read_obj, "v 1 2 nan\n"), HasSubstr("file:1: `nan` is not a finite number"));
  EXPECT_THAT(refusal(read_obj, "v 1 2 3\nf 1 2 3\n"),
              HasSubstr("file:2: a face names vertex `2`, there are 1"));
  EXPECT_THAT(refusal(read_obj, "v 1 2 3\nf 0 1 1\n"), HasSubstr("`0`"));
}

TEST_F(Files, HullsLieBesideTheirScene) {
  write("rock.obj", kTetrahedron);
  const Scene scene =
      parse_scene("object rock\n shape hull(\"rock.obj\")\n density 6\ntime\n end 1\n step 1\n",
                  (folder_ / "s.animado").string());
  const Body& rock = scene.bodies[0];
  EXPECT_EQ(std::get<Hull>(rock.shape).vertices_m.size(), 4u);
  EXPECT_NEAR(rock.mass_kg, 1, 1e-15);
  EXPECT_NEAR((rock.center_of_mass_m - Vec3::Constant(0.25)).norm(), 0, 1e-15);
  EXPECT_NEAR(rock.inertia_kg_m2(0, 0), 2 * 6 * (1.0 / 60 - 1.0 / 96),
              1e-15);  // ∫ y² + z² about the centroid
}

TEST_F(Files, HullsWithoutVolumeAreRefusedInTheScene) {
  write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n");
  try {
    parse_scene("object rock\n mass 1\n shape hull(\"flat.obj\")\n", (folder_ / "s.animado").string());
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), (folder_ / "s.animado").string() + ":3:13");
    EXPECT_EQ(error.code(), Code::refused);
    EXPECT_THAT(error.message(), HasSubstr("flat.obj"));
  }
}

TEST_F(Files, ScriptsAreTablesByTime) {
  const std::vector<ScriptRow> rows = read_script(write(
      "a.csv", "# camera\nt,x,y,z,qw,qx,qy,qz\n0, 1, 2, 3, 1, 0, 0, 0\n\n0.5,4,5,6,-0.999,0,0,-0.01\n"));
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].pose.position_m, Vec3(1, 2, 3));
  EXPECT_EQ(rows[1].time_s, 0.5);
  EXPECT_NEAR(rows[1].pose.orientation.norm(), 1, 1e-15);
  EXPECT_GT(rows[1].pose.orientation.w(), 0);  // the same turn, by the sign that is nearer
}

TEST_F(Files, ScriptsThatMakeNoSenseAreRefusedByLine) {
  EXPECT_THAT(refusal(read_script, ""), HasSubstr("no rows"));
  EXPECT_THAT(refusal(read_script, "0,0,0,0\n"), HasSubstr("file:1: 4 values in a row of eight"));
  EXPECT_THAT(refusal(read_script, "0,0,0,0,2,0,0,0\n"), HasSubstr("a quaternion of length 2"));
  EXPECT_THAT(refusal(read_script, "1,0,0,0,1,0,0,0\n1,0,0,0,1,0,0,0\n"),
              HasSubstr("file:2: time 1 s does not come after 1 s"));
  EXPECT_THAT(refusal(read_script, "0,0,0,zero,1,0,0,0\n"), HasSubstr("found `zero`"));
}

TEST_F(Files, SceneThatIsNotThereIsRefused) {
  try {
    read_scene((folder_ / "nothing.animado").string());
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::unavailable);
    EXPECT_THAT(error.where(), HasSubstr("nothing.animado"));
  }
  EXPECT_THROW(read_scene(folder_.path().string()), Error);
}

}  // namespace
}  // namespace animado::controle
