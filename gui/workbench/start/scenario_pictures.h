#pragma once
// Draws pictures of the scenarios that come with the program, one after the other in the background.
// Thread contract: the user interface's thread.

#include <QImage>
#include <QObject>
#include <thread>

#include "render/scene/scene_options.h"

namespace netpocket {

class ScenarioPictures : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;
  ~ScenarioPictures() override;  // waits for the picture being drawn

  // Draws all of them, in the order of presets(). What is being drawn is given up.
  void draw(const QSize& pixels, Background background);

 signals:
  // A scenario that cannot be drawn gives no picture.
  void drawn(int preset, const QImage& picture);

 private:
  std::jthread thread_;
};

}  // namespace netpocket
