// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtWidgets>

namespace pixelplumb {

/// Shows errors and notes over the lower part of a widget without moving it. The bar stays until it
/// is closed, replaced or hidden, or until the person presses a key, or the mouse elsewhere. What
/// lies under it can still be clicked.
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
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void show(Kind kind, const QString &text);
    void place();
    bool isNextChoice(const QObject &watched, const QEvent &event) const;

    bool m_isFresh = false; ///< shown by the event that is being delivered
    QLabel *m_glyph;
    QLabel *m_text;
};

} // namespace pixelplumb
