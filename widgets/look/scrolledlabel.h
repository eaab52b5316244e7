// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>

class QLabel;

namespace pixelplumb {

/// A text that wraps to as many lines as it needs; a small window, whose height it must not
/// increase, shows two and scrolls the rest. It can be selected.
class ScrolledLabel : public QScrollArea {
    Q_OBJECT

public:
    /// Both names are also the label's own.
    ScrolledLabel(const QString &name, const QString &accessibleName, QWidget *parent = nullptr);

    void setText(const QString &text);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void fit();

    QLabel *m_label;
};

} // namespace pixelplumb
