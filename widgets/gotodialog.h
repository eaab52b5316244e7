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

/// Where to go: a pixel to pick, a column to enter, a step to stand after.
struct GoToColumn {
    std::int64_t x = 0;
    friend bool operator==(const GoToColumn &, const GoToColumn &) = default;
};
struct GoToStep {
    std::size_t position = 0;
    friend bool operator==(const GoToStep &, const GoToStep &) = default;
};
using GoToTarget = std::variant<QPoint, GoToColumn, GoToStep>;

/// "27 19", "27, 19" or "(27, 19)" is a pixel, "27" a column, "#611" a step.
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
    std::optional<std::size_t> columnAt(std::int64_t x) const;

    Playhead *m_playhead;
    QLineEdit *m_line;
    QLabel *m_verdict;
    QDialogButtonBox *m_buttons;
};

} // namespace pixelplumb
