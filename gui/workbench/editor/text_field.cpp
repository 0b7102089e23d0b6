#include "gui/workbench/editor/text_field.h"

#include <QHBoxLayout>
#include <QLineEdit>

#include "gui/workbench/editor/parameter_words.h"

namespace netpocket {

TextField::TextField(const Parameter& parameter, QWidget* parent)
    : ParameterField(parameter, parent), edit_(new QLineEdit(this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(edit_);
  edit_->setAccessibleName(label(parameter));
  connect(edit_, &QLineEdit::textEdited, this,
          [this](const QString& text) { offer(text.toStdString(), Step::typing); });
  connect(edit_, &QLineEdit::editingFinished, this, [this] {
    if (has_pending_text()) offer(edit_->text().toStdString(), Step::typed);
  });
  setFocusProxy(edit_);
}

// The line loses the focus while it is destroyed, when its field is no longer one.
TextField::~TextField() { edit_->disconnect(this); }

void TextField::show_value(const ParameterValue& value) {
  value_ = QString::fromStdString(std::get<std::string>(value));
  edit_->setText(value_);
  edit_->setCursorPosition(0);
}

void TextField::set_read_only(bool read_only) { edit_->setReadOnly(read_only); }

// A text may have line breaks, which one line cannot show.
bool TextField::has_pending_text() const { return edit_->isModified() && edit_->text() != value_; }

}  // namespace netpocket
