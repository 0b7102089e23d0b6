#include "render/gl/hosted_render_window.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>

namespace netpocket {

vtkStandardNewMacro(HostedRenderWindow)

    vtkSmartPointer<HostedRenderWindow> HostedRenderWindow::make(std::shared_ptr<GlHost> host, int width, int height) {
  auto window = vtkSmartPointer<HostedRenderWindow>::New();
  window->SetMultiSamples(0);
  window->SetFrameBlitModeToNoBlit();
  window->SetSize(width, height);
  window->set_host(std::move(host));
  return window;
}

HostedRenderWindow::~HostedRenderWindow() { release_host(); }

void HostedRenderWindow::set_host(std::shared_ptr<GlHost> host) {
  release_host();
  host_ = std::move(host);
  SetOwnContext(host_->exclusive());
  SetReadyForRendering(true);
}

void HostedRenderWindow::release_host() {
  if (!host_) return;
  MakeCurrent();
  Finalize();
  SetReadyForRendering(false);
  host_.reset();
}

void HostedRenderWindow::MakeCurrent() {
  if (host_) host_->make_current();
}

void HostedRenderWindow::keep_where_drawn() {
  shown_ = false;
  // The window makes all its framebuffers when it is first drawn in. Those it draws in grow with it; of the one for a
  // display, the parts are taken away before.
  const int width = GetSize()[0], height = GetSize()[1];
  SetSize(1, 1);
  MakeCurrent();
  OpenGLInit();
  Start();
  End();
  for (const unsigned side : {0U, 1U}) GetDisplayFramebuffer()->RemoveColorAttachment(side);
  GetDisplayFramebuffer()->RemoveDepthAttachment();
  SetSize(width, height);
}

void HostedRenderWindow::Frame() {
  if (shown_) Superclass::Frame();
}

void HostedRenderWindow::read_rgba(std::uint8_t* rgba) {
  MakeCurrent();
  auto& drawn = *(shown_ ? GetDisplayFramebuffer() : GetRenderFramebuffer());
  drawn.Bind(GL_READ_FRAMEBUFFER);
  drawn.ActivateReadBuffer(0);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  const int* size = GetSize();
  glReadPixels(0, 0, size[0], size[1], GL_RGBA, GL_UNSIGNED_BYTE, rgba);
}

bool HostedRenderWindow::IsCurrent() { return host_ && host_->is_current(); }

}  // namespace netpocket
