#pragma once
// Walks through a window as somebody does who uses keys only, hears instead of seeing, or sees little. Every fault is a
// sentence.

#include <QColor>
#include <QImage>
#include <QStringList>

class QWidget;

namespace netpocket {

// Of what can be operated: a name for screen readers; a way to it with Tab, unless a menu does the same; Tab leads on
// from it; and one sees that it has the focus.
QStringList keyboard_faults(QWidget& window);

// Texts of ordinary widgets that stand out too little from their ground, by their palettes.
QStringList contrast_faults(QWidget& window);

// As WCAG 2.1 defines it: 1 (none) to 21.
double contrast(const QColor& a, const QColor& b);

// The contrast of what is written in a part of a widget with its ground, from the pixels of both.
double written_contrast(QWidget& widget, const QRect& part);
double written_contrast(const QImage& picture);

}  // namespace netpocket
