#include "gui/workbench/viewport/camera_names.h"

#include <QCoreApplication>

namespace netpocket {
namespace {

struct CameraWords {
  Q_DECLARE_TR_FUNCTIONS(CameraNames)
};

}  // namespace

QString camera_name(CameraPreset preset) {
  switch (preset) {
    case CameraPreset::iso:
      return CameraWords::tr("Oblique");
    case CameraPreset::side:
      return CameraWords::tr("Side");
    case CameraPreset::front:
      return CameraWords::tr("Front");
    case CameraPreset::mouth:
      return CameraWords::tr("Mouth");
    case CameraPreset::follow:
      break;
  }
  return CameraWords::tr("Follow");
}

QString camera_help(CameraPreset preset) {
  switch (preset) {
    case CameraPreset::iso:
      return CameraWords::tr("From the side and a little ahead");
    case CameraPreset::side:
      return CameraWords::tr("Square to the pocket's axis, without perspective");
    case CameraPreset::front:
      return CameraWords::tr("Along the axis into the mouth, without perspective");
    case CameraPreset::mouth:
      return CameraWords::tr("Obliquely into the mouth");
    case CameraPreset::follow:
      break;
  }
  return CameraWords::tr("Oblique, moving with the target");
}

}  // namespace netpocket
