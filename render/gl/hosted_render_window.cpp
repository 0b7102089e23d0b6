#include "render/gl/hosted_render_window.h"

#include <vtkObjectFactory.h>

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

bool HostedRenderWindow::IsCurrent() { return host_ && host_->is_current(); }

}  // namespace netpocket
