#pragma once
// Encodes pictures of a window as a video of a steady rate, on a thread of its own.
// Thread contract: the user interface's thread, except that `done` is called on the writer's.

#include <QColor>
#include <QImage>
#include <atomic>
#include <functional>
#include <string>
#include <thread>

#include "render/output/bounded_queue.h"
#include "render/output/image.h"

namespace netpocket {

// What became of a video.
struct FilmEnd {
  double seconds = 0;   // length of the video
  std::string problem;  // one sentence; empty: the file is whole
};

struct FilmFormat {
  int width = 0;          // pixels, even
  int height = 0;         // pixels, even
  int rate = 25;          // pictures a second
  QColor ground{"#888"};  // beside pictures of another shape
};

class FilmWriter {
 public:
  // The file appears at `path` when it is whole. `done` is called once: after finish(), or as soon as nothing more can
  // be written.
  FilmWriter(const std::string& path, const FilmFormat& format, std::function<void(const FilmEnd&)> done);
  ~FilmWriter();  // finishes, and waits for it

  // The window from picture number `index` of the video on; indices grow. Those between are filled with the one
  // before. Never waits: false when encoding is behind, and the picture is left out.
  bool add(const QImage& picture, int index);
  // The video is `count` pictures long.
  void finish(int count);

 private:
  struct Frame {
    QImage picture;
    int index;
  };

  void run();
  double encode();

  std::string path_;
  FilmFormat format_;
  std::function<void(const FilmEnd&)> done_;
  BoundedQueue<Frame> frames_;
  std::atomic<int> count_ = 0;
  std::thread thread_;  // last: it uses the rest
};

// A picture of any size in the middle of one of the format's: made smaller or larger where it does not fit, and left
// as it is where it differs by less than two pixels.
QImage fit_picture(const QImage& picture, const FilmFormat& format);

// Device pixels without alpha.
Image to_image(const QImage& picture);

}  // namespace netpocket
