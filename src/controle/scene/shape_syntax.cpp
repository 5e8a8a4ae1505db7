#include "controle/scene/shape_syntax.hpp"

#include <filesystem>

#include "base/convex_hull.hpp"
#include "controle/scene/call.hpp"
#include "controle/scene/obj_file.hpp"
#include "controle/scene/refusal.hpp"

namespace animado::controle {
namespace {

using Kind = ShapeParameter::Kind;

const std::vector<ShapeForm>& forms() {
  static const ShapeParameter radius{"radius", "raio", Kind::length},
      height{"height", "altura", Kind::length};
  static const std::vector<ShapeForm> all = {
      {{"sphere", {"esfera"}}, {radius}, "sphere(radius=0.5)", "a ball"},
      {{"box", {"caixa"}},
       {{"size", "tamanho", Kind::lengths}},
       "box(size=(1, 2, 3))",
       "edges along x, y, z"},
      {{"cube", {"cubo"}}, {{"edge", "aresta", Kind::length}}, "cube(edge=1)", "a box with equal edges"},
      {{"capsule", {"capsula"}},
       {radius, height},
       "capsule(radius=0.2, height=1)",
       "all points within the radius of a segment along y, `height` long"},
      {{"cylinder", {"cilindro"}}, {radius, height}, "cylinder(radius=0.5, height=1)", "axis along y"},
      {{"cone", {}},
       {radius, height},
       "cone(radius=0.5, height=1)",
       "axis along y, apex up, base a quarter of the height below the origin"},
      {{"hull", {"casco"}},
       {{"file", "arquivo", Kind::file}},
       "hull(\"rock.obj\")",
       "the convex hull of the vertices of a Wavefront OBJ file"},
      {{"mesh", {"malha"}},
       {{"file", "arquivo", Kind::file}},
       "mesh(\"rock.obj\")",
       "refused: what exists is `hull`"},
      {{"plane", {"plano"}},
       {{"normal", "", Kind::vector}, {"offset", "deslocamento", Kind::number, false}},
       "plane(normal=(0, 1, 0), offset=0)",
       "normal·x = offset, solid below, without end; for `motion static`"},
  };
  return all;
}

std::vector<std::string> form_names() {
  std::vector<std::string> names;
  for (const ShapeForm& form : forms()) {
    names.emplace_back(form.word.canonical);
    names.insert(names.end(), form.word.synonyms.begin(), form.word.synonyms.end());
  }
  return names;
}

const ShapeForm* find_form(std::string_view folded) {
  for (const ShapeForm& form : forms()) {
    if (!canonical_word(std::span(&form.word, 1), folded).empty()) return &form;
  }
  return nullptr;
}

class ShapeReader {
 public:
  ShapeReader(const Outline& outline, const Constants& constants, const Entry& entry)
      : outline_(outline),
        constants_(constants),
        call_(parse_call(entry.value, outline.path, "a shape, as sphere(radius=0.5)")) {
    form_ = find_form(call_.name);
    if (!form_) {
      const std::vector<std::string> known = form_names();
      refuse(outline.path, call_.place, Code::unknown_name, fmt::format("unknown shape `{}`", call_.name),
             suggestion(call_.name, known, "the shapes are " + list_of(known)));
    }
    for (size_t i = 0; i < call_.arguments.size(); ++i) assign(call_.arguments[i], i);
    for (const ShapeParameter& parameter : form_->parameters) {
      if (parameter.needed && !given(parameter.canonical)) {
        fail(call_.place, Code::syntax,
             fmt::format("`{}` needs its {}", form_->word.canonical, parameter.canonical));
      }
    }
  }

  Shape run() const {
    const std::string_view name = form_->word.canonical;
    if (name == "sphere") return Sphere{length("radius")};
    if (name == "box") return Box{lengths("size") / 2};
    if (name == "cube") return Box{Vec3::Constant(length("edge") / 2)};
    if (name == "capsule") return Capsule{length("radius"), length("height") / 2};
    if (name == "cylinder") return Cylinder{length("radius"), length("height") / 2};
    if (name == "cone") return Cone{length("radius"), length("height")};
    if (name == "plane") return plane();
    if (name == "hull") return hull();
    refuse(
        outline_.path, call_.place, Code::refused, "a `mesh` that may be concave is not simulated",
        "write hull(\"file.obj\") for the convex hull of the file, or compose the body of several objects");
  }

 private:
  void assign(const Argument& argument, size_t position) {
    const auto& parameters = form_->parameters;
    const ShapeParameter* parameter = nullptr;
    for (const ShapeParameter& p : parameters) {
      if (!argument.name.empty() && (argument.name == p.canonical || argument.name == p.synonym))
        parameter = &p;
    }
    if (argument.name.empty() && position < parameters.size()) parameter = &parameters[position];
    if (!parameter) {
      const std::string what = argument.name.empty() ? argument.value.text : argument.name;
      fail(argument.place, Code::unknown_name,
           fmt::format("`{}` of a {} is not known", what, form_->word.canonical));
    }
    if (given(parameter->canonical)) {
      fail(argument.place, Code::conflict, fmt::format("`{}` is given twice", parameter->canonical));
    }
    if (argument.text.has_value() != (parameter->kind == Kind::file)) {
      fail(argument.value.place, Code::type,
           parameter->kind == Kind::file ? "a file's name between quotes is needed"
                                         : "a value is needed, not a text");
    }
    arguments_[parameter->canonical] = &argument;
  }

  const Argument* given(std::string_view parameter) const {
    const auto found = arguments_.find(parameter);
    return found == arguments_.end() ? nullptr : found->second;
  }

  double length(std::string_view parameter) const {
    const Expression& value = given(parameter)->value;
    const double x = constants_.number(value);
    if (x <= 0)
      fail(value.place, Code::refused,
           fmt::format("a {} of {:g} m: lengths are greater than 0", parameter, x));
    return x;
  }

  Vec3 lengths(std::string_view parameter) const {
    const Expression& value = given(parameter)->value;
    const Vec3 v = constants_.vector(value);
    if (v.minCoeff() <= 0) {
      fail(value.place, Code::refused,
           fmt::format("a {} of ({:g}, {:g}, {:g}) m: lengths are greater than 0", parameter, v.x(), v.y(),
                       v.z()));
    }
    return v;
  }

  HalfSpace plane() const {
    const Expression& value = given("normal")->value;
    const Vec3 normal = constants_.vector(value);
    const double offset = given("offset") ? constants_.number(given("offset")->value) : 0;
    const double norm = normal.norm();
    if (!(norm > 1e-150)) fail(value.place, Code::refused, "a normal without a direction");
    return {normal / norm, offset / norm};
  }

  Hull hull() const {
    const Argument& file = *given("file");
    const auto path = std::filesystem::path(outline_.path).parent_path() / *file.text;
    try {
      return convex_hull(read_obj(path.string()));
    } catch (const Error& error) {
      const std::string inside = error.where().starts_with(path.string()) ? error.where() : path.string();
      refuse(outline_.path, file.place, error.code(), fmt::format("{}: {}", inside, error.message()),
             error.remedy());
    }
  }

  [[noreturn]] void fail(Place place, Code code, std::string message) const {
    refuse(outline_.path, place, code, std::move(message), fmt::format("write {}", form_->example));
  }

  const Outline& outline_;
  const Constants& constants_;
  Call call_;
  const ShapeForm* form_ = nullptr;
  std::map<std::string_view, const Argument*> arguments_;
};

}  // namespace

std::span<const ShapeForm> shape_forms() {
  return forms();
}

Shape read_shape(const Outline& outline, size_t object, const Constants& constants) {
  const Section& section = outline.objects[object];
  if (const Entry* entry = section.find("shape")) return ShapeReader(outline, constants, *entry).run();
  const std::string& name = section.folded_name;
  if (name == "esfera" || name == "sphere" || name == "ball") return Sphere{1};
  if (name == "cubo" || name == "cube") return Box{Vec3::Constant(0.5)};
  refuse(outline.path, section.place, Code::refused, fmt::format("`{}` has no shape", section.name),
         "give one, as `shape sphere(radius=0.5)`; only objects named esfera, sphere, ball, cubo or cube "
         "have one by their name");
}

}  // namespace animado::controle
