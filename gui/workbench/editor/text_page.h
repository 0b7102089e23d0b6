#pragma once
// The scenario as text, in step with the document: a pause in typing makes it an edit; what cannot be read is marked
// and stays here until it can. So does the text of a file that cannot be opened for its faults.

#include <QTimer>
#include <QWidget>

#include "gui/workbench/editor/scenario_document.h"

class QLabel;

namespace netpocket {

class TomlEditView;

class TextPage : public QWidget {
  Q_OBJECT
 public:
  explicit TextPage(ScenarioDocument* document, QWidget* parent = nullptr);

  // Reads what was typed now, without waiting for the pause. Whether the text and the document agree.
  bool commit();
  // Goes back to the document's text.
  void discard();
  // Shows the text of a file that could not be opened. Once it can be read the document is that file, with changes.
  void mend(const QString& path, const QString& text);
  // The file whose text it is; empty for the document's.
  const QString& mended_path() const { return mended_path_; }
  // Whether the text has something that cannot be read.
  bool has_problem() const { return !problems_.ok(); }
  const Diagnostics& problems() const { return problems_; }
  void go_to_problem();

  void set_read_only(bool read_only);
  TomlEditView* view() const { return view_; }

 signals:
  void problem_changed();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void colour_status();
  void show_document();
  void set_problems(Diagnostics problems);
  bool has_dos_lines() const;

  ScenarioDocument* document_;
  TomlEditView* view_;
  QLabel* status_;
  QTimer pause_;
  Diagnostics problems_;
  bool committing_ = false;
  QString mended_path_;
  bool mended_has_dos_lines_ = false;
};

}  // namespace netpocket
