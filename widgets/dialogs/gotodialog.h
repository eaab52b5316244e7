// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QPoint>

#include <cstdint>
#include <optional>
#include <variant>

class QDialogButtonBox;
class QLabel;
class QLineEdit;

namespace pixelplumb {

class Playhead;

/// Where to go: a pixel to pick; a column, a row or a step of the method to enter, whichever it
/// walks; a step of the run to stand after.
struct GoToSpan {
    std::int64_t coordinate = 0;
    friend bool operator==(const GoToSpan &, const GoToSpan &) = default;
};
struct GoToStep {
    std::size_t position = 0;
    friend bool operator==(const GoToStep &, const GoToStep &) = default;
};
using GoToTarget = std::variant<QPoint, GoToSpan, GoToStep>;

/// "27 19", "27, 19" or "(27, 19)" is a pixel, "27" a span, "#611" a step.
std::optional<GoToTarget> parseGoTo(const QString &text);

/// One line to type in; what it means is said below while it is typed.
class GoToDialog : public QDialog {
    Q_OBJECT

public:
    explicit GoToDialog(Playhead *playhead, QWidget *parent = nullptr);

private:
    void judge();
    void go();
    /// What is wrong with the target in the run at hand; empty when it can be reached.
    QString objectionTo(const GoToTarget &target) const;
    /// Of a run that walks columns and rows, as lines do, such as the span in hand come first.
    std::optional<std::size_t> spanAt(std::int64_t coordinate) const;
    QString verdictOn(const GoToTarget &target) const;

    Playhead *m_playhead;
    QLineEdit *m_line;
    QLabel *m_verdict;
    QDialogButtonBox *m_buttons;
};

} // namespace pixelplumb
