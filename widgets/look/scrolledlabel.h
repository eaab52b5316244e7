// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>

class QLabel;

namespace pixelplumb {

/// A text in as many lines as it takes where there is room; in a small window, which it must not
/// make higher, two are in sight and the others are scrolled to. It can be selected.
class ScrolledLabel : public QScrollArea {
    Q_OBJECT

public:
    /// The name and the accessible name are the label's own.
    ScrolledLabel(const QString &name, const QString &accessibleName, QWidget *parent = nullptr);

    void setText(const QString &text);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void fit();

    QLabel *m_label;
};

} // namespace pixelplumb
