#include "holdfast/window/window/remembered.h"

#include <QSettings>
#include <utility>

namespace holdfast {

void Remembered::add(const QString& key, Read read, Write write)
{
  values_.push_back({"window/" + key, std::move(read), std::move(write), {}});
  Value& value = values_.back();
  value.atFirst = value.read();
  if (const QVariant last = QSettings().value(value.key); last.isValid()) value.write(last);
}

void Remembered::save() const
{
  QSettings settings;
  for (const Value& value : values_) settings.setValue(value.key, value.read());
}

void Remembered::reset()
{
  for (const Value& value : values_) value.write(value.atFirst);
  save();
}

}  // namespace holdfast
