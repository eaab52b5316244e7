// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtWidgets>

#include <cstdint>
#include <optional>
#include <variant>

namespace pixelplumb {

class Playhead;

/// Where to go: a pixel to pick; a column, row or step of the method to enter, whichever it walks;
/// or a step of the run after which to stand.
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

/// One line to type in; below it is shown what the input means.
class GoToDialog : public QDialog {
    Q_OBJECT

public:
    explicit GoToDialog(Playhead *playhead, QWidget *parent = nullptr);

private:
    void judge();
    void go();
    /// Why the target cannot be reached in the current run; empty when it can.
    QString objectionTo(const GoToTarget &target) const;
    /// The first step in a span. In a run that walks columns and rows, as lines do, spans of the
    /// current kind come first.
    std::optional<std::size_t> spanAt(std::int64_t coordinate) const;
    QString verdictOn(const GoToTarget &target) const;

    Playhead *m_playhead;
    QLineEdit *m_line;
    QLabel *m_verdict;
    QDialogButtonBox *m_buttons;
};

} // namespace pixelplumb
