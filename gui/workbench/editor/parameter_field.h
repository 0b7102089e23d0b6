#pragma once
// The control for one parameter's value. The kinds differ by type of parameter.

#include <QWidget>

#include "engine/scenario/parameters.h"

namespace netpocket {

class ParameterField : public QWidget {
  Q_OBJECT
 public:
  // The control that suits the parameter's type.
  static ParameterField* create(const Parameter& parameter, QWidget* parent);

  // Shows a value, without signals. What is being typed is replaced.
  virtual void show_value(const ParameterValue& value) = 0;
  virtual void set_read_only(bool read_only) = 0;
  // Whether something is typed that is not the parameter's value (yet).
  virtual bool has_pending_text() const { return false; }

 signals:
  void edited(const ParameterValue& value, bool stepped);  // allowed; stepped: one of a row of small changes
  void tried(const ParameterValue& value);                 // allowed, while still typing
  void refused(const QString& reason);                     // what stands there is not allowed; empty: it is again

 protected:
  ParameterField(const Parameter& parameter, QWidget* parent);
  const Parameter& parameter() const { return parameter_; }

  enum class Step { typing, typed, stepped };
  // Checks the value against the limits and sends the signal that fits.
  void offer(const ParameterValue& value, Step step);

 private:
  const Parameter& parameter_;
};

}  // namespace netpocket
