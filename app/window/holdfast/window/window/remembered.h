#pragma once
/// Keeps what the window remembers from start to start.

#include <QString>
#include <QVariant>
#include <functional>
#include <vector>

namespace holdfast {

/// Holds values that are kept in the user's settings. Each can go back to what it was before the settings were read.
class Remembered {
 public:
  using Read = std::function<QVariant()>;
  using Write = std::function<void(const QVariant&)>;

  /// Adds a value, and calls `write` with what the last start has left, if anything.
  void add(const QString& key, Read read, Write write);
  void save() const;
  void reset();

 private:
  struct Value {
    QString key;
    Read read;
    Write write;
    QVariant atFirst;
  };

  std::vector<Value> values_;
};

}  // namespace holdfast
