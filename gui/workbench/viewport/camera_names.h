#pragma once
// The camera presets in the order in which people are offered them.

#include <QString>
#include <array>

#include "render/scene/camera.h"

namespace netpocket {

inline constexpr std::array kCameraPresets = {CameraPreset::iso, CameraPreset::side, CameraPreset::front,
                                              CameraPreset::mouth, CameraPreset::follow};

QString camera_name(CameraPreset preset);
// One short sentence.
QString camera_help(CameraPreset preset);

}  // namespace netpocket
