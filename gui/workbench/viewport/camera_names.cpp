#include "gui/workbench/viewport/camera_names.h"

#include <QCoreApplication>

namespace netpocket {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("CameraNames", text); }

}  // namespace

QString camera_name(CameraPreset preset) {
  switch (preset) {
    case CameraPreset::iso:
      return tr("Oblique");
    case CameraPreset::side:
      return tr("Side");
    case CameraPreset::front:
      return tr("Front");
    case CameraPreset::mouth:
      return tr("Mouth");
    case CameraPreset::follow:
      break;
  }
  return tr("Follow");
}

QString camera_help(CameraPreset preset) {
  switch (preset) {
    case CameraPreset::iso:
      return tr("From the side and a little ahead");
    case CameraPreset::side:
      return tr("Square to the pocket's axis, without perspective");
    case CameraPreset::front:
      return tr("Along the axis into the mouth, without perspective");
    case CameraPreset::mouth:
      return tr("Obliquely into the mouth");
    case CameraPreset::follow:
      break;
  }
  return tr("Oblique, moving with the target");
}

}  // namespace netpocket
