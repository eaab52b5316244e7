// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/casecheck.h"
#include "widgets/model/job.h"
#include "widgets/studies/hardcasespicture.h"

#include <QWidget>

#include <map>

class QLabel;
class QProgressBar;
class QPushButton;
class QScrollArea;

namespace pixelplumb {

class HardCasesVerdicts;

/// One hard case: its two pictures, what it stresses, why it goes wrong, and how every method does
/// at it. The methods are put to the test one by one beside the GUI thread; verdicts are kept.
class HardCasesDetails : public QWidget {
    Q_OBJECT

public:
    explicit HardCasesDetails(QWidget *parent = nullptr);
    ~HardCasesDetails() override;

    /// picture: null while it is being drawn.
    void show(const GalleryCase &chosen, const Method &method, const ScanSettings &settings,
              const HardCasePicture *picture);
    void tell(const QString &text); ///< instead of a case
    void open(); ///< the case that is shown, at the first pixel that differs
    bool isChecking() const { return m_job.isRunning(); }
    /// Of the case that is shown; as many as are known.
    const std::vector<ContenderVerdict> &verdicts() const;

signals:
    void openRequested(const pixelplumb::Scene &scene);
    void compareRequested(const std::vector<pixelplumb::Contender> &contenders);
    void precisionRequested();

protected:
    void changeEvent(QEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    /// Verdicts of one case, method by method in the order of the table of methods.
    struct Verdicts {
        std::vector<ContenderVerdict> all;
        std::size_t methodsDone = 0;
    };

    QLabel *makeText(const char *name);
    QPushButton *makeButton(const char *name, const QString &text, const QString &toolTip);
    void addReading();
    void addButtons();
    void showPicture();
    void checkNext();
    void showVerdicts();
    void compare();

    QScrollArea *m_reading = nullptr; ///< all but the title and the buttons
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
    QString m_checking; ///< the case of the job under way
    std::map<QString, Verdicts> m_verdicts; ///< by case
    Job m_job;
};

} // namespace pixelplumb
