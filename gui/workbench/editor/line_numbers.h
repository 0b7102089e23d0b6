#pragma once

#include <QWidget>

#include "gui/workbench/editor/toml_edit_view.h"

namespace netpocket {

// The strip with line numbers beside a text; the text paints it.
class LineNumbers : public QWidget {
 public:
  explicit LineNumbers(TomlEditView* text) : QWidget(text), text_(text) {}

 protected:
  void paintEvent(QPaintEvent* event) override { text_->paint_numbers(event); }

 private:
  TomlEditView* text_;
};

}  // namespace netpocket
