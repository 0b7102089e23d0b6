#pragma once
// The OpenGL 1.x functions that Debian's VTK binds at link time, as X(result, name, parameters, arguments).
// Source: nm -D --undefined-only libvtkRenderingOpenGL2-9.1.so libvtkIOExportGL2PS-9.1.so ...

#include <GL/gl.h>

#define NETPOCKET_GL_FUNCTIONS(X)                                                                                    \
  X(void, glBindTexture, (GLenum target, GLuint texture), (target, texture))                                         \
  X(void, glClear, (GLbitfield mask), (mask))                                                                        \
  X(void, glClearColor, (GLclampf red, GLclampf green, GLclampf blue, GLclampf alpha), (red, green, blue, alpha))    \
  X(void, glClearDepth, (GLclampd depth), (depth))                                                                   \
  X(void, glClearStencil, (GLint value), (value))                                                                    \
  X(void, glColorMask, (GLboolean red, GLboolean green, GLboolean blue, GLboolean alpha), (red, green, blue, alpha)) \
  X(void, glCopyTexImage2D,                                                                                          \
    (GLenum target, GLint level, GLenum format, GLint x, GLint y, GLsizei width, GLsizei height, GLint border),      \
    (target, level, format, x, y, width, height, border))                                                            \
  X(void, glCullFace, (GLenum mode), (mode))                                                                         \
  X(void, glDeleteTextures, (GLsizei count, const GLuint* textures), (count, textures))                              \
  X(void, glDepthFunc, (GLenum function), (function))                                                                \
  X(void, glDepthMask, (GLboolean flag), (flag))                                                                     \
  X(void, glDisable, (GLenum capability), (capability))                                                              \
  X(void, glDrawArrays, (GLenum mode, GLint first, GLsizei count), (mode, first, count))                             \
  X(void, glDrawElements, (GLenum mode, GLsizei count, GLenum type, const GLvoid* indices),                          \
    (mode, count, type, indices))                                                                                    \
  X(void, glEnable, (GLenum capability), (capability))                                                               \
  X(void, glFinish, (), ())                                                                                          \
  X(void, glFlush, (), ())                                                                                           \
  X(void, glGenTextures, (GLsizei count, GLuint * textures), (count, textures))                                      \
  X(void, glGetBooleanv, (GLenum name, GLboolean * values), (name, values))                                          \
  X(void, glGetDoublev, (GLenum name, GLdouble * values), (name, values))                                            \
  X(GLenum, glGetError, (), ())                                                                                      \
  X(void, glGetFloatv, (GLenum name, GLfloat * values), (name, values))                                              \
  X(void, glGetIntegerv, (GLenum name, GLint * values), (name, values))                                              \
  X(const GLubyte*, glGetString, (GLenum name), (name))                                                              \
  X(void, glGetTexImage, (GLenum target, GLint level, GLenum format, GLenum type, GLvoid * pixels),                  \
    (target, level, format, type, pixels))                                                                           \
  X(void, glGetTexLevelParameteriv, (GLenum target, GLint level, GLenum name, GLint * values),                       \
    (target, level, name, values))                                                                                   \
  X(GLboolean, glIsEnabled, (GLenum capability), (capability))                                                       \
  X(void, glLineWidth, (GLfloat width), (width))                                                                     \
  X(void, glPixelStorei, (GLenum name, GLint value), (name, value))                                                  \
  X(void, glPointSize, (GLfloat size), (size))                                                                       \
  X(void, glReadBuffer, (GLenum mode), (mode))                                                                       \
  X(void, glReadPixels,                                                                                              \
    (GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type, GLvoid * pixels),                  \
    (x, y, width, height, format, type, pixels))                                                                     \
  X(void, glScissor, (GLint x, GLint y, GLsizei width, GLsizei height), (x, y, width, height))                       \
  X(void, glTexEnvi, (GLenum target, GLenum name, GLint value), (target, name, value))                               \
  X(void, glTexImage1D,                                                                                              \
    (GLenum target, GLint level, GLint internal_format, GLsizei width, GLint border, GLenum format, GLenum type,     \
     const GLvoid* pixels),                                                                                          \
    (target, level, internal_format, width, border, format, type, pixels))                                           \
  X(void, glTexImage2D,                                                                                              \
    (GLenum target, GLint level, GLint internal_format, GLsizei width, GLsizei height, GLint border, GLenum format,  \
     GLenum type, const GLvoid* pixels),                                                                             \
    (target, level, internal_format, width, height, border, format, type, pixels))                                   \
  X(void, glTexParameterf, (GLenum target, GLenum name, GLfloat value), (target, name, value))                       \
  X(void, glTexParameterfv, (GLenum target, GLenum name, const GLfloat* values), (target, name, values))             \
  X(void, glTexParameteri, (GLenum target, GLenum name, GLint value), (target, name, value))                         \
  X(void, glViewport, (GLint x, GLint y, GLsizei width, GLsizei height), (x, y, width, height))
