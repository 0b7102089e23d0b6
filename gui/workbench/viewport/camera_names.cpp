#include "gui/workbench/viewport/camera_names.h"

#include <QCoreApplication>

namespace netpocket {
namespace {

QString camera_words(const char* text) { return QCoreApplication::translate("CameraNames", text); }

}  // namespace

QString camera_name(CameraPreset preset) {
  switch (preset) {
    case CameraPreset::iso:
      return camera_words("Oblique");
    case CameraPreset::side:
      return camera_words("Side");
    case CameraPreset::front:
      return camera_words("Front");
    case CameraPreset::mouth:
      return camera_words("Mouth");
    case CameraPreset::follow:
      break;
  }
  return camera_words("Follow");
}

QString camera_help(CameraPreset preset) {
  switch (preset) {
    case CameraPreset::iso:
      return camera_words("From the side and a little ahead");
    case CameraPreset::side:
      return camera_words("Square to the pocket's axis, without perspective");
    case CameraPreset::front:
      return camera_words("Along the axis into the mouth, without perspective");
    case CameraPreset::mouth:
      return camera_words("Obliquely into the mouth");
    case CameraPreset::follow:
      break;
  }
  return camera_words("Oblique, moving with the target");
}

}  // namespace netpocket
