// Every mistake of the design's section 6: where it is said to be, what is said, and the remedy.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "controle/scene/scene.hpp"

namespace animado::controle {
namespace {

using testing::HasSubstr;

struct Mistake {
  std::string name;  // of the test
  std::string text;  // the scene
  Code code;
  std::string place;         // line:column
  std::string says, remedy;  // phrases
};

void PrintTo(const Mistake& mistake, std::ostream* out) {
  *out << mistake.name;
}

// The mistake lies in line 1, 2, … of `lines`; what follows makes the rest of the scene right.
std::string with_time(const std::string& lines) {
  return lines + "\ntime\n end 1\n step 0.1\n";
}
std::string ball(const std::string& line) {
  return with_time("object ball\n mass 1\n" + line);
}  // the line is line 3
std::string world(const std::string& line) {
  return "world\n" + line + "\n" + ball("");
}  // line 2
std::string times(const std::string& lines) {
  return "object ball\n mass 1\ntime\n" + lines;
}  // line 4

const std::vector<Mistake> kMistakes = {
    // the file
    {"EmptyFile", "", Code::refused, "1:1", "empty", "begins with `object NAME`"},
    {"BlankFile", " \n\t\n", Code::refused, "1:1", "empty", "begins with `object NAME`"},
    {"NoObject", "time\n end 1\n step 0.1\n", Code::refused, "1:1", "no object", "`object NAME`"},
    {"NotUtf8", "object bola\n# acelera\xE7\xE3o\n", Code::syntax, "2:10", "0xE7 is not UTF-8",
     "save the scene as UTF-8"},
    {"ControlCharacter", std::string("object ball\n mass \0 1\n", 21), Code::syntax, "2:7",
     "control character", "plain text"},

    // words
    {"UnknownProperty", ball(" masa 2"), Code::unknown_name, "3:2", "unknown property `masa`", "`mass`"},
    {"UnknownPropertyOfManyWords", ball(" coeficiente de elasticidad 0.5"), Code::unknown_name, "3:2",
     "coeficiente de elasticidad", "`coeficiente de elasticidade`"},
    {"UnknownPropertyWithoutRelative", ball(" flavour 3"), Code::unknown_name, "3:2",
     "unknown property `flavour`", "lists the properties"},
    {"PropertyBesideItsBlock", "world: gravity (0, -9.8, 0)\n", Code::syntax, "1:8",
     "expected nothing after `world`, found `gravity`", "a line of its own"},
    {"BracesAroundABlock", "time { end 2 }\n", Code::syntax, "1:6",
     "expected nothing after `time`, found `{`", "a line of its own"},
    {"PropertyThatBeginsLikeABlock", "tempo\n tempo inicail 2\n", Code::unknown_name, "2:2",
     "unknown property `tempo inicail`", "`tempo inicial`"},
    {"NoPropertyAtAll", ball(" 3.5"), Code::syntax, "3:2", "expected a property, found `3`",
     "`property value`"},
    {"PropertyInNoBlock", "mass 2\n", Code::syntax, "1:1", "stands in no block", "`object NAME`"},
    {"PropertyOfTheWorldInAnObject", ball(" gravity (0, -9.81, 0)"), Code::conflict, "3:2",
     "belongs to `world`", "under a line `world`"},
    {"PropertyOfAnObjectInTheWorld", world(" mass 3"), Code::conflict, "2:2", "belongs to `object`",
     "under `object NAME`"},
    {"GivenTwice", ball(" massa = 2"), Code::conflict, "3:2", "given twice, first in line 2, column 2",
     "take one of them away"},
    {"GivenTwiceInAReopenedBlock", "object a\n mass 1\n shape sphere(radius=1)\nworld\nobject A\n mass 1\n",
     Code::conflict, "6:2", "first in line 2", "take one"},
    {"NoValue", ball(" friction ="), Code::syntax, "3:12", "`friction` has no value", "≥ 0"},
    {"NameOfAnotherObject", with_time("object cubo\n massa da esfera 2"), Code::unknown_name, "2:11",
     "expected `cubo`", "leave the name out"},
    {"ObjectWithoutName", "object\n", Code::syntax, "1:7", "expected the name of an object", "a letter"},
    {"ObjectNamedByANumber", "object 7up\n", Code::syntax, "1:8", "found `7up`", "a letter"},
    {"ObjectNamedByAWordOfTheLanguage", "object t\n", Code::conflict, "1:8", "word of the language",
     "another name"},
    {"TwoNamesInOneOpening", "object ball red\n", Code::syntax, "1:13", "found `red`", "a line of its own"},
    {"UninvolvedObject", "##### OBJETOS ENVOLVIDOS: esfera e cubo\n##### CARACTERISTICAS DA ESFRA\n",
     Code::unknown_name, "2:26", "`esfra` is not among", "`esfera`"},
    {"HeadingWithoutNames", "##### OBJETOS ENVOLVIDOS:\n", Code::syntax, "1:26", "expected the name",
     "a letter"},

    // expressions
    {"ExpressionThatEnds", ball(" friction 2 *"), Code::syntax, "3:14", "expected a value", "a value is"},
    {"ParenthesisNeverClosed", ball(" position (1, 2"), Code::syntax, "3:16", "expected `)`", "never closed"},
    {"UnknownName", ball(" friction bal.mass"), Code::unknown_name, "3:11", "unknown name `bal.mass`",
     "`ball.mass`"},
    {"UnknownFunction", ball(" friction sine(1)"), Code::unknown_name, "3:11", "unknown function `sine`",
     "`sin`"},
    {"NumberForAVector", ball(" position 3"), Code::type, "3:11", "a vector is needed", "(x, y, z)"},
    {"VectorForANumber", ball(" friction (1, 2, 3)"), Code::type, "3:11", "a scalar is needed",
     "docs/expressions.md"},
    {"BooleanForANumber", ball(" friction 1 < 2"), Code::type, "3:11", "a scalar is needed",
     "docs/expressions.md"},
    {"TypeOfAForce", ball(" force 3 * t"), Code::type, "3:8", "a vector is needed", "(x, y, z)"},
    {"UnknownNameInAForce", ball(" force (0, -9.81 * mas, 0)"), Code::unknown_name, "3:20", "`mas`",
     "`mass`"},
    {"TimeInAConstant", ball(" position (t, 0, 0)"), Code::refused, "3:11",
     "has to be constant, it changes with `t`", "may depend on t"},
    {"StateInAConstant", ball(" friction position.x"), Code::refused, "3:11", "changes with `ball.position`",
     "may depend on t"},
    {"DivisionByZero", ball(" friction 1 / 0"), Code::not_finite, "3:11", "is inf", "division by zero"},
    {"RootOfANegativeNumber", ball(" position (sqrt(-1), 0, 0)"), Code::not_finite, "3:11", "nan", "root"},
    {"NumberThatDoesNotFit", ball(" friction 1e999"), Code::syntax, "3:11", "does not fit", ""},
    {"ForceWithoutEndAtTheStart", ball(" force -position / norm(position)^3"), Code::not_finite, "3:8",
     "at the start", "division by zero"},
    {"AccentsKeepColumns", ball(" posição inicial (1, 2, bóla.x)"), Code::unknown_name, "3:25", "bola.x", ""},

    // names
    {"CycleOfNames", "a.x = b.x\nb.x = c.x + 1\nc.x = a.x\n" + ball(""), Code::cycle, "3:7",
     "a.x → b.x → c.x → a.x", "does not need the others"},
    {"CycleOfMasses",
     with_time(
         "object a\n shape cube(edge=1)\n mass 2 * b.mass\nobject b\n shape cube(edge=1)\n mass a.mass"),
     Code::cycle, "6:7", "a.mass → b.mass → a.mass", "does not need"},
    {"CycleOfNamesAndMasses", with_time("spring.k = ball.mass\nobject ball\n mass 3 * spring.k"), Code::cycle,
     "3:7", "spring.k → ball.mass → spring.k", "does not need"},
    {"ForceThatNeedsItself", ball(" force 0.5 * ball.force"), Code::cycle, "3:14", "ball.force",
     "does not need"},
    {"PathsThatNeedEachOther",
     with_time("object a\n shape cube(edge=1)\n motion path\n path position b.position\nobject b\n shape "
               "cube(edge=1)\n motion path\n path position "
               "-a.position"),
     Code::cycle, "8:16", "a → b → a", "on t and on other bodies"},
    {"NameDefinedTwice", "a.x = 1\na.x = 2\n" + ball(""), Code::conflict, "2:1",
     "defined twice, first in line 1", "take one"},
    {"NameInAnObjectsNamespace", "ball.k = 3\n" + ball(""), Code::conflict, "1:1", "`ball` is an object",
     "begin the name differently"},
    {"ComponentOfAProperty", ball(" position.x = 3"), Code::conflict, "3:2", "`position` is a property",
     "position (x, y, z)"},
    {"MistakeInADefinition", "spring.k = 4 * pii\n" + ball(""), Code::unknown_name, "1:16", "pii", "`pi`"},

    // mass
    {"NoMass", with_time("object ball"), Code::refused, "1:8", "`ball` has no mass", "`mass` or `density`"},
    {"MassAndDensity", ball(" density 3"), Code::conflict, "3:2", "and, in line 2, a mass", "take one"},
    {"MassOfZero", with_time("object ball\n mass 0"), Code::refused, "2:7", "a mass of 0", "greater than 0"},
    {"NegativeDensity", with_time("object ball\n density -2"), Code::refused, "2:10", "a density of -2",
     "greater than 0"},
    {"InertiaNotPositive", ball(" moments of inertia (0, 1, 1)"), Code::refused, "3:21",
     "not positive definite", "moments are > 0"},
    {"InertiaMadeNegativeByProducts", ball(" moments of inertia (1, 1, 1)\n products of inertia (2, 0, 0)"),
     Code::refused, "3:21", "not positive definite", "Ixy = −∫ xy dm"},
    {"InertiaBreaksTheTriangle", ball(" momento de inercia (1, 1, 3)"), Code::refused, "3:21",
     "exceeds the sum", "at most the sum"},
    {"MassOfABodyWithoutOne",
     with_time("object floor\n shape plane(normal=(0,1,0))\n motion static\nobject ball\n mass floor.mass"),
     Code::refused, "5:7", "`floor` has no mass", "in the block of `floor`"},

    // shape
    {"NoShape", with_time("object thing\n mass 1"), Code::refused, "1:8", "`thing` has no shape",
     "shape sphere(radius=0.5)"},
    {"UnknownShape", ball(" shape spere(radius=1)"), Code::unknown_name, "3:8", "unknown shape `spere`",
     "`sphere`"},
    {"ShapeWithoutItsSize", ball(" shape sphere"), Code::syntax, "3:8", "needs its radius",
     "sphere(radius=0.5)"},
    {"UnknownParameter", ball(" shape sphere(diameter=1)"), Code::unknown_name, "3:15",
     "`diameter` of a sphere", "sphere(radius=0.5)"},
    {"ParameterTwice", ball(" shape sphere(radius=1, radius=2)"), Code::conflict, "3:25", "given twice",
     "sphere(radius=0.5)"},
    {"ZeroRadius", ball(" shape sphere(radius=0)"), Code::refused, "3:22", "a radius of 0 m",
     "sphere(radius=0.5)"},
    {"NegativeSize", ball(" shape box(size=(1, -2, 3))"), Code::refused, "3:17", "(1, -2, 3)",
     "box(size=(1, 2, 3))"},
    {"SizeNotAVector", ball(" shape box(size=2)"), Code::type, "3:17", "a vector is needed", "(x, y, z)"},
    {"ShapeNeverClosed", ball(" shape sphere(radius=1"), Code::syntax, "3:14", "never closed", "sphere"},
    {"Mesh", ball(" shape mesh(\"a.obj\")"), Code::refused, "3:8", "`mesh`", "hull(\"file.obj\")"},
    {"HullThatIsNotThere", ball(" shape hull(\"nowhere.obj\")"), Code::unavailable, "3:13", "not there",
     "relative to its folder"},
    {"HullWithoutQuotes", ball(" shape hull(top)"), Code::type, "3:13", "between quotes",
     "hull(\"rock.obj\")"},
    {"NormalWithoutDirection", with_time("object floor\n motion static\n shape plane(normal=(0, 0, 0))"),
     Code::refused, "3:21", "without a direction", "plane(normal=(0, 1, 0)"},
    {"PlaneThatMoves", with_time("object floor\n mass 1\n shape plane(normal=(0, 1, 0))"), Code::refused,
     "1:8", "plane without end", "motion static"},

    // surface, motion, look
    {"FasterThanLight", ball(" velocity (0, -3e8 m/s, 0)"), Code::refused, "3:11",
     "300000000 m/s is more than can be", "the most is 299792458 m/s"},
    {"OutOfTheUniverse", ball(" position (0, 0, 2e27)"), Code::refused, "3:11", "2e+27 m is more than can be",
     "the most is 1e+27 m"},
    {"FasterThanAnythingTurns", ball(" angular velocity (1e24, 0, 0)"), Code::refused, "3:19",
     "1e+24 rad/s is more than can be", "look at the units"},
    {"RestitutionAboveOne", ball(" restitution 1.5"), Code::refused, "3:14", "a restitution of 1.5",
     "between 0"},
    {"RestitutionBelowZero", ball(" coeficiente de elasticidade -0.1"), Code::refused, "3:30", "-0.1",
     "between 0"},
    {"NegativeFriction", ball(" friction -1"), Code::refused, "3:11", "a friction of -1", "at least 0"},
    {"NegativeDamping", ball(" linear damping -1"), Code::refused, "3:17", "a linear damping of -1",
     "at least 0"},
    {"UnknownMotion", ball(" motion statik"), Code::unknown_name, "3:9", "unknown motion `statik`",
     "`static`"},
    {"PathWithoutOne", ball(" motion path"), Code::refused, "3:2", "`motion path` and no path",
     "path position"},
    {"PathOfADynamicBody", ball(" path position (t, 0, 0)"), Code::conflict, "3:2", "`motion dynamic`",
     "write `motion path`"},
    {"ScriptThatIsNotThere", ball(" motion script(\"no.csv\")"), Code::unavailable, "3:16", "not there",
     "relative to its folder"},
    {"ForceOnAStaticBody", ball(" motion static\n force (1, 0, 0)"), Code::refused, "4:2", "is not dynamic",
     "leave it out"},
    {"VelocityOfAStaticBody", ball(" motion static\n velocity (1, 0, 0)"), Code::refused, "4:2",
     "is not dynamic", "motion path"},
    {"RotationOrder", ball(" rotation order xyx"), Code::syntax, "3:17", "no order of rotations",
     "each axis once"},
    {"UnknownColor", ball(" color tomatoe"), Code::unknown_name, "3:8", "unknown color `tomatoe`",
     "`tomato`"},
    {"ColorOutOfBounds", ball(" color (255, 0, 0)"), Code::refused, "3:8", "a color of (255, 0, 0)",
     "between 0 and 1"},
    {"UnknownGroup", ball(" group planets\n collides with planet"), Code::unknown_name, "4:2",
     "no object is of the group `planet`", "`planets`"},

    // world and time
    {"UnknownMethod", world(" method rk5"), Code::unknown_name, "2:9", "unknown method `rk5`", "`rk4`"},
    {"SymplecticMethod", world(" method Verlet"), Code::refused, "2:9", "`verlet` is for separable systems",
     "use dop853"},
    {"ImplicitMethod", world(" method radau5"), Code::refused, "2:9", "`radau5` is implicit", "use dopri5"},
    {"UnknownResponse", world(" response impulze"), Code::unknown_name, "2:11", "unknown response `impulze`",
     "`impulse`"},
    {"UnknownRule", world(" restitution rule average"), Code::unknown_name, "2:19",
     "unknown restitution rule", "product, min, max or mean"},
    {"SpringWithoutStiffness", world(" response spring"), Code::refused, "2:2", "without its stiffness",
     "spring k"},
    {"ZeroSubstep", world(" substep 0"), Code::refused, "2:10", "a substep of 0", "greater than 0"},
    {"NegativeThreshold", world(" contact threshold -1"), Code::refused, "2:20", "a contact threshold of -1",
     "at least 0"},
    {"NoTime", "object ball\n mass 1\n", Code::refused, "1:1", "does not say its `end`",
     "under a line `time`"},
    {"NoStep", times(" end 1\n"), Code::refused, "3:1", "does not say its `step`", "under a line `time`"},
    {"ZeroStep", times(" end 1\n step 0\n"), Code::refused, "5:7", "a step of 0", "greater than 0"},
    {"NegativeStep", times(" end 1\n step -0.1\n"), Code::refused, "5:7", "a step of -0.1", "greater than 0"},
    {"EndBeforeStart", times(" start 2\n end 1\n step 0.1\n"), Code::refused, "5:6", "before the start",
     "go forward"},
    {"TooManyFrames", times(" end 1\n step 1e-12\n"), Code::limit, "5:7", "frames", "substep"},

    // what is measured
    {"MassInMetres", with_time("object ball\n mass 2 m"), Code::type, "2:7",
     "`mass` measures a mass (kg), this is a length (m)", "without one, in SI"},
    {"VelocityInMetres", ball(" velocity (1 m, 0, 0)"), Code::type, "3:11", "this is a length (m)", "SI"},
    {"ForceInTorque", ball(" force (0, 5 Nm, t)"), Code::type, "3:8", "`force` measures a force", "SI"},
    {"PathInSeconds", with_time("object ball\n motion path\n path position (2 s, t, 0)"), Code::type, "3:16",
     "this is a time (s)", "SI"},
    {"RotationInMetres", ball(" rotation (1 cm, 0, 0)"), Code::type, "3:11", "a number or an angle", "SI"},
    {"DefinitionOfAnotherDimension",
     with_time("arm.reach = 3 m\nobject ball\n mass 1\n angular velocity (0, arm.reach, 0)"), Code::type,
     "4:19", "this is a length (m)", "SI"},
    {"DensityOfAnotherPower", with_time("object ball\n shape sphere(radius=1)\n density 5 kg/m^2"),
     Code::type, "3:10", "`density` measures", "SI"},
    {"GravityAsVelocity", world(" gravity (0, -9.81 m/s, 0)"), Code::type, "2:10", "this is", "SI"},
    {"StiffnessAsForce", world(" spring k 5 N"), Code::type, "2:11", "`spring k` measures", "SI"},
    {"StepInMetres", times(" end 1\n step 10 cm\n"), Code::type, "5:7", "`step` measures a time (s)", "SI"},
};

class Mistakes : public testing::TestWithParam<Mistake> {};

TEST_P(Mistakes, AreRefusedWithPlaceAndRemedy) {
  const Mistake& mistake = GetParam();
  try {
    parse_scene(mistake.text, "s.animado");
    FAIL() << "accepted:\n" << mistake.text;
  } catch (const Error& error) {
    EXPECT_EQ(name_of(error.code()), name_of(mistake.code)) << error.what();
    EXPECT_EQ(error.where(), "s.animado:" + mistake.place) << error.what();
    EXPECT_THAT(error.message(), HasSubstr(mistake.says));
    EXPECT_THAT(error.remedy(), HasSubstr(mistake.remedy));
    EXPECT_FALSE(error.remedy().empty());
  }
}

TEST(Units, ThatMeasureWhatThePropertyDoesAreTaken) {
  const Scene scene = parse_scene(
      "world\n gravity (0, -981 cm/s^2, 0)\n spring k 2 kN/m\n contact threshold 1 cm/s\n"
      "object ball\n shape sphere(radius=1)\n density 5 g/m^3\n position (1, 20 cm, 0)\n rotation (90 deg, "
      "1, 0)\n"
      " velocity (36 km/h, 1, 0)\n angular velocity (60 rpm, 1 Hz, 2)\n force (1 kN, 5 kg*m/s^2 * t, 0)\n"
      " torque (1 Nm, 1 J, 0)\n linear damping 3 Hz\n restitution 0.5\n"
      "object cube\n mass 500 g\n moments of inertia (1 kg*m^2, 1, 1)\n"
      "time\n end 1 min\n step 100 ms\n",
      "s.animado");
  EXPECT_EQ(scene.bodies[0].velocity_m_s.x(), 10);
  EXPECT_EQ(scene.bodies[1].mass_kg, 0.5);
}

INSTANTIATE_TEST_SUITE_P(Scene, Mistakes, testing::ValuesIn(kMistakes),
                         [](const auto& mistake) { return mistake.param.name; });

}  // namespace
}  // namespace animado::controle
