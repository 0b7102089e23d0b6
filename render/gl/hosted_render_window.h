#pragma once
// A VTK render window that draws in a GlHost's context instead of making one.
// Thread contract: the host's thread.

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <memory>

#include "render/gl/gl_host.h"

namespace netpocket {

class HostedRenderWindow : public vtkGenericOpenGLRenderWindow {
 public:
  // clang-format off
  vtkTypeMacro(HostedRenderWindow, vtkGenericOpenGLRenderWindow)
      // clang-format on
      static HostedRenderWindow* New();
  HostedRenderWindow(const HostedRenderWindow&) = delete;
  HostedRenderWindow& operator=(const HostedRenderWindow&) = delete;

  // A window without multisampling (VTK's FXAA draws black with it) whose finished picture stays in its own
  // framebuffer, for ReadPixels or BlitDisplayFramebuffer. Sizes are in pixels.
  static vtkSmartPointer<HostedRenderWindow> make(std::shared_ptr<GlHost> host, int width, int height);

  // For windows that are only read: pictures stay where they are drawn. Nothing is copied for a display, which takes a
  // third of the time of drawing, and no memory is kept for copies, which is five times that of a picture.
  void keep_where_drawn();

  // The finished picture, 4 bytes a pixel, rows from the bottom; `rgba` holds as many.
  void read_rgba(std::uint8_t* rgba);

  // Frees the window's OpenGL objects and lets go of the host; a new host may be given later.
  void release_host();
  void set_host(std::shared_ptr<GlHost> host);

  void MakeCurrent() override;
  void Frame() override;
  bool IsCurrent() override;
  int SupportsOpenGL() override { return 1; }
  vtkTypeBool IsDirect() override { return 1; }

 protected:
  HostedRenderWindow() = default;
  ~HostedRenderWindow() override;

 private:
  std::shared_ptr<GlHost> host_;
  bool shown_ = true;
};

}  // namespace netpocket
