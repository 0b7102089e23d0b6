#include "gui/workbench/export/export_tray.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>

namespace netpocket {

ExportTray::ExportTray(QWidget* parent) : QWidget(parent), label_(new QLabel), progress_(new QProgressBar) {
  progress_->setMaximumWidth(120);
  progress_->setMaximumHeight(14);
  progress_->setTextVisible(false);
  auto* cancel_button = new QToolButton;
  cancel_button->setText(QString::fromUtf8("×"));
  cancel_button->setAutoRaise(true);
  cancel_button->setToolTip(tr("Cancel this export"));
  cancel_button->setAccessibleName(tr("Cancel this export"));
  connect(cancel_button, &QToolButton::clicked, this, &ExportTray::cancel);
  setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(label_);
  layout->addWidget(progress_);
  layout->addWidget(cancel_button);
  hide();
}

void ExportTray::add(std::unique_ptr<ExportJob> job) {
  waiting_.push_back(std::move(job));
  if (!job_) start_next();
}

void ExportTray::cancel() {
  if (job_) job_->cancel();
}

bool ExportTray::may_close() {
  if (!is_busy()) return true;
  QMessageBox box(QMessageBox::Question, tr("Export"), tr("\"%1\" is still being exported.").arg(job_->label()),
                  QMessageBox::Discard | QMessageBox::Cancel, window());
  box.setInformativeText(tr("Closing the window cancels it."));
  box.button(QMessageBox::Discard)->setText(tr("Close"));
  box.button(QMessageBox::Cancel)->setText(tr("Wait"));
  box.setDefaultButton(QMessageBox::Cancel);
  // It may end while the question stands.
  connect(this, &ExportTray::finished, &box, [&box] { box.done(QMessageBox::Discard); });
  return box.exec() == QMessageBox::Discard;
}

void ExportTray::start_next() {
  if (waiting_.empty()) {
    hide();
    return;
  }
  job_ = std::move(waiting_.front());
  waiting_.erase(waiting_.begin());
  connect(job_.get(), &ExportJob::progressed, progress_, &QProgressBar::setValue);
  connect(job_.get(), &ExportJob::succeeded, this, [this] {
    emit finished(job_->result());
    end();
  });
  connect(job_.get(), &ExportJob::cancelled, this, [this] {
    emit cancelled(job_->label());
    end();
  });
  connect(job_.get(), &ExportJob::failed, this, [this](const QString& reason) {
    emit failed(reason);
    end();
  });
  label_->setText(tr("Exporting: %1").arg(job_->label()));
  label_->setToolTip(job_->result());
  progress_->setValue(0);
  show();
  job_->start();
}

void ExportTray::end() {
  // Its signal is being handled: it must outlive that.
  job_.release()->deleteLater();
  start_next();
}

}  // namespace netpocket
