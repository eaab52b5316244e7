// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QLabel;

namespace pixelplumb {

/// What went wrong or is worth knowing, told in the window instead of in its way. Stays until it is
/// closed or replaced.
class MessageBar : public QFrame {
    Q_OBJECT

public:
    enum class Kind { Information, Error };

    explicit MessageBar(QWidget *parent = nullptr);

    QString text() const;

public slots:
    void tell(const QString &text);
    void complain(const QString &text);

private:
    void show(Kind kind, const QString &text);

    QLabel *m_glyph;
    QLabel *m_text;
};

} // namespace pixelplumb
