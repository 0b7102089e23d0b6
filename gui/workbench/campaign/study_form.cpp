#include "gui/workbench/campaign/study_form.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QCompleter>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <thread>

#include "engine/study/read_study.h"
#include "gui/workbench/campaign/scatter_row.h"
#include "gui/workbench/editor/group_box.h"
#include "gui/workbench/editor/number_edit.h"

namespace netpocket {
namespace {

constexpr double kUsualHalfWidth = 0.02;
constexpr Limits kHalfWidths{1e-4, 0.5};

// What can be estimated besides the probability of capture: columns of a study's table.
constexpr const char* kEstimable[] = {"smallest_gap",     "escape_depth", "closed_time",    "first_contact_time",
                                      "utilisation_peak", "load_body",    "modified_index", "covered_share"};

// Scrolls its content up and down, never sideways.
class FormColumn : public QScrollArea {
 public:
  explicit FormColumn(QWidget* content) {
    setWidget(content);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  }
  QSize minimumSizeHint() const override {
    return {widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width(), 120};
  }
};

QSpinBox* make_count(int least, int most, int value, const QString& help) {
  auto* box = new QSpinBox;
  box->setRange(least, most);
  box->setValue(value);
  box->setToolTip(help);
  return box;
}

int usual_jobs() { return static_cast<int>(std::max(1u, std::thread::hardware_concurrency() - 1)); }

}  // namespace

StudyForm::StudyForm(ScenarioDocument& document, QWidget* parent) : QWidget(parent), document_(document) {
  auto* content = new QWidget;
  auto* intro = new QLabel(tr("How often does this scenario catch its target when its inputs are uncertain?"));
  intro->setWordWrap(true);
  intro->setContentsMargins(12, 8, 8, 4);
  auto* inputs = new GroupBox(tr("Uncertain inputs"), tr("Each scatters about the scenario's value"), content);
  inputs->add(make_inputs());
  auto* size = new GroupBox(tr("Captures"), tr("How many, and what is estimated from them"), content);
  size->add(make_size());
  for (GroupBox* box : {inputs, size}) box->set_expanded(true);
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, 0, 0, 8);
  column->setSpacing(0);
  column->addWidget(intro);
  column->addWidget(inputs);
  column->addWidget(size);
  column->addStretch();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(new FormColumn(content), 1);
  layout->addWidget(make_buttons());
  connect(&document_, &ScenarioDocument::changed, this, &StudyForm::show_scenario);
  show_scenario();
}

QWidget* StudyForm::make_inputs() {
  auto* inputs = new QWidget;
  rows_layout_ = new QVBoxLayout;
  rows_layout_->setSpacing(2);
  keys_ = new QComboBox;
  keys_->setEditable(true);
  keys_->setInsertPolicy(QComboBox::NoInsert);
  keys_->lineEdit()->setPlaceholderText(tr("Add an input: type a part of its name"));
  keys_->setAccessibleName(tr("Input to add"));
  keys_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  keys_->completer()->setFilterMode(Qt::MatchContains);
  keys_->completer()->setCompletionMode(QCompleter::PopupCompletion);
  connect(keys_, &QComboBox::activated, this, &StudyForm::add_chosen_key);
  auto* adder = new QHBoxLayout;
  adder->setContentsMargins(12, 4, 6, 4);
  adder->addWidget(keys_);
  auto* layout = new QVBoxLayout(inputs);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(rows_layout_);
  layout->addLayout(adder);
  return inputs;
}

QWidget* StudyForm::make_size() {
  auto* size = new QWidget;
  samples_ = make_count(1, static_cast<int>(kMostStudyPoints), 400, tr("How many captures to run"));
  seed_ = make_count(0, INT32_MAX, 1, tr("Another seed draws other values"));
  jobs_ = make_count(1, 256, usual_jobs(), tr("Captures at a time; each takes one processor core"));
  sampling_ = new QComboBox;
  sampling_->addItem(tr("Sobol (even)"), "sobol");
  sampling_->addItem(tr("Latin hypercube"), "latin_hypercube");
  sampling_->addItem(tr("Monte Carlo"), "monte_carlo");
  sampling_->setToolTip(tr("How the values are drawn; with Sobol points and Monte Carlo more can be added later"));
  estimate_ = new QToolButton;
  estimate_->setPopupMode(QToolButton::InstantPopup);
  estimate_->setToolTip(tr("What is estimated besides the probability of capture: 5 %, 50 % and 95 % quantiles"));
  estimate_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  auto* menu = new QMenu(estimate_);
  for (const char* column : kEstimable) {
    auto* action = menu->addAction(column);
    action->setCheckable(true);
    connect(action, &QAction::toggled, this, &StudyForm::show_estimate);
  }
  estimate_->setMenu(menu);
  ends_early_ = new QCheckBox(tr("End early at ±"));
  ends_early_->setToolTip(tr("End when the 95 % interval of the probability of capture is no wider than this"));
  half_width_ = new NumberEdit(kHalfWidths, false);
  half_width_->set_value(kUsualHalfWidth);
  half_width_->setEnabled(false);
  half_width_->setAccessibleName(tr("Half width of the interval"));
  connect(half_width_, &NumberEdit::finished, this, [this] {
    const auto value = half_width_->typed_value();
    half_width_->set_value(value && kHalfWidths.contain(*value) ? *value : half_width_->value());
  });
  connect(ends_early_, &QCheckBox::toggled, half_width_, &QWidget::setEnabled);
  auto* layout = new QFormLayout(size);
  layout->setContentsMargins(12, 4, 8, 4);
  layout->setVerticalSpacing(4);
  layout->addRow(tr("Points"), samples_);
  layout->addRow(tr("Drawn by"), sampling_);
  layout->addRow(tr("Seed"), seed_);
  layout->addRow(tr("Estimate"), estimate_);
  layout->addRow(ends_early_, half_width_);
  layout->addRow(tr("At a time"), jobs_);
  show_estimate();
  return size;
}

QWidget* StudyForm::make_buttons() {
  auto* buttons = new QWidget;
  run_ = new QPushButton(tr("Run campaign…"));
  run_->setToolTip(tr("Save this as a study and run it in the background"));
  save_ = new QPushButton(tr("Save study…"));
  save_->setToolTip(tr("Save this as a study (TOML) for \"netpocket study\""));
  open_study_ = new QPushButton(tr("Run a study file…"));
  open_study_->setToolTip(tr("Run a study that is a file already"));
  open_folder_ = new QPushButton(tr("Open folder…"));
  open_folder_->setToolTip(tr("Look at the folder of a study that runs, was interrupted or is done"));
  auto* layout = new QGridLayout(buttons);
  layout->setContentsMargins(8, 6, 8, 8);
  layout->setSpacing(6);
  layout->addWidget(run_, 0, 0);
  layout->addWidget(save_, 0, 1);
  layout->addWidget(open_study_, 1, 0);
  layout->addWidget(open_folder_, 1, 1);
  return buttons;
}

StudyDraft StudyForm::draft() const {
  StudyDraft draft;
  for (const ScatterRow* row : rows_) draft.inputs.push_back(row->input());
  draft.sampling = sampling_->currentData().toString().toStdString();
  draft.samples = samples_->value();
  draft.seed = seed_->value();
  for (const QAction* action : estimate_->menu()->actions()) {
    if (action->isChecked()) draft.estimate.push_back(action->text().toStdString());
  }
  if (ends_early_->isChecked()) draft.half_width = half_width_->typed_value().value_or(half_width_->value());
  return draft;
}

void StudyForm::set_draft(const StudyDraft& draft) {
  for (ScatterRow* row : rows_) row->deleteLater();
  rows_.clear();
  for (const DraftInput& input : draft.inputs) add_input(input);
  sampling_->setCurrentIndex(std::max(0, sampling_->findData(QString::fromStdString(draft.sampling))));
  samples_->setValue(draft.samples);
  seed_->setValue(draft.seed);
  for (QAction* action : estimate_->menu()->actions()) {
    action->setChecked(std::ranges::count(draft.estimate, action->text().toStdString()) > 0);
  }
  ends_early_->setChecked(draft.half_width.has_value());
  half_width_->set_value(draft.half_width.value_or(kUsualHalfWidth));
}

int StudyForm::jobs() const { return jobs_->value(); }

void StudyForm::set_jobs(int jobs) { jobs_->setValue(jobs); }

void StudyForm::add_input(const DraftInput& input) {
  auto* row = new ScatterRow(input, document_.scenario());
  connect(row, &ScatterRow::remove_requested, this, [this, row] {
    std::erase(rows_, row);
    row->deleteLater();
  });
  rows_.push_back(row);
  rows_layout_->addWidget(row);
}

void StudyForm::fill_keys() {
  keys_->clear();
  for (const std::string& key : scatter_keys(document_.scenario())) {
    keys_->addItem(scatter_label(document_.scenario(), key), QString::fromStdString(key));
  }
  keys_->setCurrentIndex(-1);
}

void StudyForm::add_chosen_key() {
  const std::string key = keys_->currentData().toString().toStdString();
  const auto is_there = [&](const ScatterRow* row) { return row->input().key == key; };
  if (!key.empty() && std::ranges::none_of(rows_, is_there)) {
    const Scatter scatter = possible_scatters(document_.scenario(), key).front();
    add_input({key, scatter, usual_spread(document_.scenario(), key)});
  }
  keys_->setCurrentIndex(-1);
  keys_->clearEditText();
}

// Another system has other inputs.
void StudyForm::show_scenario() {
  const Scenario& scenario = document_.scenario();
  if (system_ != scenario.system || keys_->count() != static_cast<int>(scatter_keys(scenario).size())) fill_keys();
  if (system_ != scenario.system) set_draft(usual_draft(scenario));
  system_ = scenario.system;
  for (ScatterRow* row : rows_) row->show_scenario(scenario);
}

void StudyForm::show_estimate() {
  QStringList names;
  for (const QAction* action : estimate_->menu()->actions()) {
    if (action->isChecked()) names << action->text();
  }
  estimate_->setText(names.isEmpty()     ? tr("Probability only")
                     : names.size() == 1 ? names.front()
                                         : tr("%1 and %2 more").arg(names.front()).arg(names.size() - 1));
}

}  // namespace netpocket
