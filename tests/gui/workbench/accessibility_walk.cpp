#include "tests/gui/workbench/accessibility_walk.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QGroupBox>
#include <QHash>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QSet>
#include <QTabBar>
#include <QTest>
#include <QTextDocumentFragment>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>
#include <cmath>

namespace netpocket {
namespace {

constexpr double kTextContrast = 4.5, kLargeTextContrast = 3;  // WCAG 2.1, 1.4.3
constexpr int kMostTabs = 400;

QString description(const QWidget& widget) {
  QString words = widget.metaObject()->className();
  if (!widget.objectName().isEmpty()) words += " " + widget.objectName();
  if (!widget.accessibleName().isEmpty()) words += " \"" + widget.accessibleName() + "\"";
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) words += " [" + button->text() + "]";
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) words += " [" + label->text().left(50) + "]";
  for (const QWidget* up = widget.parentWidget(); up != nullptr && !up->isWindow(); up = up->parentWidget()) {
    if (QString(up->metaObject()->className()).startsWith("netpocket::")) {
      return words + " in " + up->metaObject()->className();
    }
  }
  return words;
}

// What Qt's own widgets are made of is Qt's affair.
bool is_part_of_another(const QWidget& widget) {
  if (widget.objectName().startsWith("qt_") || qobject_cast<const QScrollBar*>(&widget)) return true;
  if (widget.focusProxy() != nullptr) return true;
  for (const QWidget* up = widget.parentWidget(); up != nullptr; up = up->parentWidget()) {
    const bool whole = qobject_cast<const QAbstractSpinBox*>(up) || qobject_cast<const QComboBox*>(up) ||
                       qobject_cast<const QLineEdit*>(up) || qobject_cast<const QTabBar*>(up) ||
                       qobject_cast<const QAbstractItemView*>(up);
    if (whole) return true;
    if (up->isWindow()) break;
  }
  return false;
}

// Not scrolled away. What its children cover counts, too.
bool is_in_sight(const QWidget& widget) {
  QRect seen = widget.rect();
  for (const QWidget* at = &widget; !at->isWindow(); at = at->parentWidget()) {
    seen = seen.translated(at->pos()) & at->parentWidget()->rect();
  }
  return !seen.isEmpty();
}

bool can_be_operated(const QWidget& widget) {
  const bool known = qobject_cast<const QAbstractButton*>(&widget) || qobject_cast<const QComboBox*>(&widget) ||
                     qobject_cast<const QLineEdit*>(&widget) || qobject_cast<const QAbstractSpinBox*>(&widget) ||
                     qobject_cast<const QAbstractItemView*>(&widget) || qobject_cast<const QPlainTextEdit*>(&widget) ||
                     qobject_cast<const QTabBar*>(&widget);
  return known || (widget.focusPolicy() & Qt::TabFocus) != 0;
}

QWidgetList operable(QWidget& window) {
  QWidgetList found;
  for (QWidget* widget : window.findChildren<QWidget*>()) {
    const bool shown = widget->window() == &window && widget->isVisible() && widget->isEnabled();
    if (shown && is_in_sight(*widget) && can_be_operated(*widget) && !is_part_of_another(*widget)) {
      found << widget;
    }
  }
  return found;
}

QString spoken_name(QWidget& widget) {
  QAccessibleInterface* interface = QAccessible::queryAccessibleInterface(&widget);
  return interface == nullptr ? QString() : interface->text(QAccessible::Name).trimmed();
}

// Menus do what the buttons of tool bars do.
bool has_a_menu_entry(const QWidget& widget) {
  const auto* button = qobject_cast<const QToolButton*>(&widget);
  return button != nullptr && qobject_cast<const QToolBar*>(button->parentWidget()) &&
         button->defaultAction() != nullptr && !button->defaultAction()->shortcut().isEmpty();
}

QSet<QWidget*> walk_with_tab(QWidget& window, QStringList& faults) {
  QSet<QWidget*> visited;
  if (window.focusWidget() == nullptr || !window.focusWidget()->hasFocus()) QTest::keyClick(&window, Qt::Key_Tab);
  QWidget* last = nullptr;
  for (int i = 0; i < kMostTabs; ++i) {
    QWidget* now = QApplication::focusWidget();
    if (now == nullptr) break;
    if (now == last) {
      if (visited.size() > 1) faults << "Tab stays at " + description(*now);
      break;
    }
    if (now->window() != &window) {
      faults << "Tab leaves the window at " + description(*now);
      break;
    }
    const bool round = visited.contains(now);
    visited << now;
    if (round && i > 2 * visited.size()) break;
    last = now;
    QTest::keyClick(now, Qt::Key_Tab);
  }
  return visited;
}

QImage picture_around(QWidget& window, const QWidget& widget) {
  constexpr int kFrame = 4;
  const QRect place(widget.mapTo(&window, QPoint()), widget.size());
  return window.grab(place.adjusted(-kFrame, -kFrame, kFrame, kFrame) & window.rect())
      .toImage()
      .convertToFormat(QImage::Format_RGB32);
}

// In how many pixels they differ by more than can be overlooked.
int clear_differences(const QImage& a, const QImage& b) {
  int count = 0;
  for (int y = 0; y < std::min(a.height(), b.height()); ++y) {
    for (int x = 0; x < std::min(a.width(), b.width()); ++x) {
      const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
      const int distance =
          std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) + std::abs(p.blue() - q.blue());
      count += distance > 40 ? 1 : 0;
    }
  }
  return count;
}

bool shows_focus(QWidget& window, QWidget& widget) {
  constexpr int kLeastPixels = 6;
  widget.setFocus(Qt::TabFocusReason);  // what scrolls has come into sight
  QApplication::processEvents();
  if (!is_in_sight(widget)) return true;
  widget.clearFocus();
  const QImage without = picture_around(window, widget);
  widget.setFocus(Qt::TabFocusReason);
  return clear_differences(without, picture_around(window, widget)) >= kLeastPixels;
}

QColor over(const QColor& letters, const QColor& ground) {
  const auto mix = [&](int front, int back) {
    return static_cast<int>(std::lround(back + (front - back) * letters.alphaF()));
  };
  return {mix(letters.red(), ground.red()), mix(letters.green(), ground.green()), mix(letters.blue(), ground.blue())};
}

double linear(double channel) {
  return channel <= 0.03928 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& colour) {
  return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

QColor ground_behind(const QWidget& widget) {
  for (const QWidget* up = &widget; up != nullptr; up = up->parentWidget()) {
    if (up->autoFillBackground() || up->isWindow()) return up->palette().color(up->backgroundRole());
  }
  return widget.palette().color(QPalette::Window);
}

struct Written {
  QString text;
  QColor letters;
  QColor ground;
};

Written written(const QWidget& widget) {
  const QPalette& palette = widget.palette();
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
    const QString text = QTextDocumentFragment::fromHtml(label->text()).toPlainText().trimmed();
    return {text, palette.color(label->foregroundRole()), ground_behind(widget)};
  }
  if (const auto* tool = qobject_cast<const QToolButton*>(&widget)) {
    const bool words = tool->icon().isNull() || tool->toolButtonStyle() != Qt::ToolButtonIconOnly;
    return {words ? tool->text() : QString(), palette.color(QPalette::ButtonText),
            tool->autoRaise() ? ground_behind(widget) : palette.color(QPalette::Button)};
  }
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
    const bool pushed = button->inherits("QPushButton");
    return {button->text(), palette.color(pushed ? QPalette::ButtonText : QPalette::WindowText),
            pushed ? palette.color(QPalette::Button) : ground_behind(widget)};
  }
  if (const auto* edit = qobject_cast<const QLineEdit*>(&widget)) {
    const bool empty = edit->text().isEmpty();
    return {empty ? edit->placeholderText() : edit->text(),
            palette.color(empty ? QPalette::PlaceholderText : QPalette::Text), palette.color(QPalette::Base)};
  }
  if (const auto* choice = qobject_cast<const QComboBox*>(&widget)) {
    return {choice->currentText(), palette.color(QPalette::ButtonText), palette.color(QPalette::Button)};
  }
  if (qobject_cast<const QAbstractItemView*>(&widget) || qobject_cast<const QPlainTextEdit*>(&widget)) {
    return {"content", palette.color(QPalette::Text), palette.color(QPalette::Base)};
  }
  return {};
}

bool is_large(const QFont& font) { return font.pointSizeF() >= 18 || (font.bold() && font.pointSizeF() >= 14); }

}  // namespace

QStringList keyboard_faults(QWidget& window) {
  QStringList faults;
  const QSet<QWidget*> visited = walk_with_tab(window, faults);
  for (QWidget* widget : operable(window)) {
    if (spoken_name(*widget).isEmpty()) faults << "no name: " + description(*widget);
    if (!visited.contains(widget) && !has_a_menu_entry(*widget)) faults << "not reached: " + description(*widget);
  }
  for (QWidget* widget : visited) {
    if (widget->isVisible() && !shows_focus(window, *widget)) faults << "focus not seen: " + description(*widget);
  }
  return faults;
}

QStringList contrast_faults(QWidget& window) {
  QStringList faults;
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    if (widget->window() != &window || !widget->isVisible() || !widget->isEnabled()) continue;
    const Written text = written(*widget);
    if (text.text.isEmpty()) continue;
    const double found = contrast(over(text.letters, text.ground), text.ground);
    if (found < (is_large(widget->font()) ? kLargeTextContrast : kTextContrast)) {
      faults << QString("contrast %1 (%2 on %3): %4")
                    .arg(found, 0, 'f', 2)
                    .arg(text.letters.name(QColor::HexArgb), text.ground.name(), description(*widget));
    }
  }
  return faults;
}

double contrast(const QColor& a, const QColor& b) {
  const double x = luminance(a), y = luminance(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

// Drawn four times as large, so that letters have an inside that no smoothing has touched.
double written_contrast(QWidget& widget, const QRect& part) {
  constexpr int kScale = 4;
  QImage image(part.size() * kScale, QImage::Format_RGB32);
  image.setDevicePixelRatio(kScale);
  image.fill(ground_behind(widget));
  QPainter painter(&image);
  widget.render(&painter, QPoint(), QRegion(part), QWidget::DrawWindowBackground | QWidget::DrawChildren);
  painter.end();
  return written_contrast(image);
}

double written_contrast(const QImage& picture) {
  QHash<QRgb, int> counts;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) ++counts[picture.pixel(x, y)];
  }
  QRgb ground = 0;
  for (auto it = counts.cbegin(); it != counts.cend(); ++it) {
    if (it.value() > counts.value(ground)) ground = it.key();
  }
  double best = 1;
  for (auto it = counts.cbegin(); it != counts.cend(); ++it) {
    if (it.value() >= 8) best = std::max(best, contrast(QColor(it.key()), QColor(ground)));
  }
  return best;
}

}  // namespace netpocket
