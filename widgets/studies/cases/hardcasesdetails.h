// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/casecheck.h"
#include "widgets/model/job.h"
#include "widgets/studies/cases/hardcasespicture.h"

#include <QtWidgets>

#include <map>

namespace pixelplumb {

class HardCasesVerdicts;

/// One hard case: its two pictures, what it stresses, why it goes wrong, and how every method does
/// on it. Methods are tested one by one in a worker thread; verdicts are cached.
class HardCasesDetails : public QWidget {
    Q_OBJECT

public:
    explicit HardCasesDetails(QWidget *parent = nullptr);

    /// `picture`: null while it is being drawn.
    void show(const GalleryCase &chosen, const Method &method, const ScanSettings &settings,
              const HardCasePicture *picture);
    void tell(const QString &text); ///< instead of a case
    void open(); ///< the shown case, at the first pixel that differs
    bool isChecking() const { return m_job.isRunning(); }
    /// The verdicts on the shown case known so far.
    const std::vector<ContenderVerdict> &verdicts() const;

signals:
    void openRequested(const pixelplumb::Scene &scene);
    void compareRequested(const std::vector<pixelplumb::Contender> &contenders);
    void precisionRequested();

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    /// The verdicts on one case, in the order of the table of methods.
    struct Verdicts {
        std::vector<ContenderVerdict> all;
        std::size_t methodsDone = 0;
    };

    void addReading();
    void addButtons();
    void showPicture();
    void checkNext();
    void showVerdicts();
    void compare();

    QScrollArea *m_reading = nullptr; ///< everything but the title and the buttons
    QLabel *m_title = nullptr;
    QPushButton *m_picture = nullptr;
    QLabel *m_caption = nullptr;
    QLabel *m_words = nullptr;
    QPushButton *m_open = nullptr;
    QPushButton *m_compare = nullptr;
    QPushButton *m_precision = nullptr;
    HardCasesVerdicts *m_table = nullptr;
    QProgressBar *m_progress = nullptr;
    QPushButton *m_cancel = nullptr;
    std::optional<GalleryCase> m_case;
    const Method *m_method = nullptr;
    ScanSettings m_settings;
    HardCasePicture m_shown;
    bool m_isCancelled = false;
    QString m_checking; ///< the running job's case
    std::map<QString, Verdicts> m_verdicts; ///< by case
    Job m_job;
};

} // namespace pixelplumb
