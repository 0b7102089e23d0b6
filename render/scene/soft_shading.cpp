#include "render/scene/soft_shading.h"

#include <fmt/format.h>
#include <vtkShaderProperty.h>

namespace netpocket {
namespace {

struct Shading {
  double shade;  // brightness of what faces away from the lamp
  double light;  // brightness of what faces the lamp
  double gloss;  // brightness of the lamp's reflection
};

constexpr Shading kWhite = {0.50, 1.06, 0.10};
constexpr Shading kSpace = {0.10, 1.15, 0.10};

}  // namespace

void add_soft_shading(vtkActor& actor, Background background) {
  const auto& shading = background == Background::space ? kSpace : kWhite;
  // In view coordinates: right, up, towards the viewer. The lamp's and the lamp-viewer half direction are unit vectors.
  const std::string light = fmt::format(
      "  float facing = 0.5 + 0.5 * dot(normalVCVSOutput, vec3(-0.40, 0.60, 0.693));\n"
      "  float mirror = max(0.0, dot(normalVCVSOutput, vec3(-0.217, 0.326, 0.920)));\n"
      "  mirror *= mirror; mirror *= mirror; mirror *= mirror; mirror *= mirror; mirror *= mirror;\n"
      "  gl_FragData[0] = vec4(diffuseColor * mix({:.3f}, {:.3f}, facing) + {:.3f} * mirror, opacity);\n",
      shading.shade, shading.light, shading.gloss);
  actor.GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true, light, false);
}

}  // namespace netpocket
