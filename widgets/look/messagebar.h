// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QLabel;

namespace pixelplumb {

/// What went wrong or is worth knowing, told over the lower part of a widget without moving it.
/// Stays until it is closed, replaced or hidden.
class MessageBar : public QFrame {
    Q_OBJECT

public:
    enum class Kind { Information, Error };

    explicit MessageBar(QWidget *covered);

    QString text() const;

public slots:
    void tell(const QString &text);
    void complain(const QString &text);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void show(Kind kind, const QString &text);
    void place();

    QLabel *m_glyph;
    QLabel *m_text;
};

} // namespace pixelplumb
