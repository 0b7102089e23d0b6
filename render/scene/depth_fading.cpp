#include "render/scene/depth_fading.h"

#include <fmt/format.h>
#include <vtkShaderProperty.h>
#include <vtkUniforms.h>

namespace netpocket {

void add_depth_fading(vtkActor& actor, const Color& distance_color, double nearer) {
  // depth: the distance along the line of sight as a fraction of that between the clipping planes; in perspective the
  // depth buffer z holds it as z = f d / (n + (f - n) d), here with the ratio f / n.
  std::string fade = fmt::format(
      "//VTK::Light::Impl\n"
      "  float z = gl_FragCoord.z;\n"
      "  float depth = z / (fade_far_to_near - (fade_far_to_near - 1.0) * z);\n"
      "  gl_FragData[0].rgb = mix(gl_FragData[0].rgb, vec3({:.4f}, {:.4f}, {:.4f}), fade_strength * depth);\n",
      distance_color[0], distance_color[1], distance_color[2]);
  if (nearer != 0) fade += fmt::format("  gl_FragDepth = gl_FragCoord.z - {:.5f};\n", nearer);
  actor.GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", false, fade, false);
}

void set_depth_fading(vtkActor& actor, vtkCamera& camera, double strength) {
  const double* range = camera.GetClippingRange();
  const bool parallel = camera.GetParallelProjection() != 0;
  auto* uniforms = actor.GetShaderProperty()->GetFragmentCustomUniforms();
  uniforms->SetUniformf("fade_far_to_near", parallel ? 1.0F : static_cast<float>(range[1] / range[0]));
  uniforms->SetUniformf("fade_strength", static_cast<float>(strength));
}

}  // namespace netpocket
