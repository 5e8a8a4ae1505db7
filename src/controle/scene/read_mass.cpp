#include "controle/mass/mass_properties.hpp"
#include "controle/scene/read_body.hpp"
#include "controle/scene/refusal.hpp"

namespace animado::controle {
namespace {

// Of the shape at the given mass; nothing for a plane, which has none.
MassProperties shape_properties(const Shape& shape, double mass_kg) {
  if (std::holds_alternative<HalfSpace>(shape)) return {mass_kg, Vec3::Zero(), Mat3::Zero()};
  return mass_properties(shape, mass_kg / volume_m3(shape));
}

// Given moments come with products of 0, unless those are given too: three moments alone mean a diagonal
// tensor.
Mat3 tensor(const Section& object, const Constants& constants, const Mat3& of_shape) {
  Mat3 inertia = of_shape;
  if (const Entry* moments = object.find("moments of inertia"))
    inertia = constants.vector(moments->value).asDiagonal();
  if (const Entry* products = object.find("products of inertia")) {
    const Vec3 p = constants.vector(products->value);
    inertia(0, 1) = inertia(1, 0) = p[0];
    inertia(0, 2) = inertia(2, 0) = p[1];
    inertia(1, 2) = inertia(2, 1) = p[2];
  }
  return inertia;
}

}  // namespace

void read_mass(const Outline& outline, size_t index, const Constants& constants, Body& body) {
  const Section& object = outline.objects[index];
  const bool given = object.find("mass") || object.find("density");
  if (!given && body.motion == Motion::dynamic) {
    refuse(outline.path, object.place, Code::refused, fmt::format("`{}` has no mass", object.name),
           "give `mass` or `density`, or `motion static`");
  }
  if (given) body.mass_kg = constants.mass_kg(index);
  // Without a mass the shape alone says where its centre is: the tensor of a unit mass is computed beside it
  // and not kept.
  const MassProperties properties = shape_properties(body.shape, given ? body.mass_kg : 1);
  const Entry* center = object.find("center of mass");
  body.center_of_mass_m = center ? constants.vector(center->value) : properties.center_of_mass_m;
  const Mat3 inertia = tensor(object, constants, properties.inertia_kg_m2);
  if (given) body.inertia_kg_m2 = inertia;

  const Entry* line = object.find("moments of inertia") ? object.find("moments of inertia")
                                                        : object.find("products of inertia");
  std::string why;
  if (line && !is_inertia(inertia, &why)) {
    refuse(outline.path, line->value.place, Code::refused,
           fmt::format("the inertia tensor of `{}` makes no sense: {}", object.name, why),
           "moments are > 0, each at most the sum of the others; products are the tensor's elements, Ixy = "
           "−∫ xy dm; or leave both out");
  }
}

}  // namespace animado::controle
