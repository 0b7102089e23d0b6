#pragma once
// Which library the process gets its OpenGL functions from. VTK binds them once, so this is decided once: either the
// system's libGL (for windows and EGL) or the library a host has loaded itself (OSMesa).

namespace netpocket {

using GlLookup = void* (*)(const char* name);

// The chosen host's own lookup; null while OpenGL is the system's.
GlLookup gl_lookup();

// Decide for a lookup of one's own, or (null) for the system's libGL. Throws RenderError when it was decided otherwise
// before, or when the program was linked without netpocket_use_rendering.
void choose_gl_lookup(GlLookup lookup);

// Called when a function of the system's libGL has been bound: from then on a lookup of one's own comes too late.
void note_system_gl_in_use();

}  // namespace netpocket
