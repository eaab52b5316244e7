// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measure/effecttiming.h"
#include "core/shade/effectplan.h"
#include "widgets/look/rowsmodel.h"
#include "widgets/studies/studypanel.h"

#include <QtWidgets>

#include <memory>
#include <optional>

namespace pixelplumb {

class EffectSwitches;
class SceneDocument;

/// Which effects the document's scene calls for, why, and what each costs; a switch forces one on
/// or off in the picture (objectName "effectsPanel", its table "effectsTable"). Plans and measures
/// in a worker thread, and only while visible.
class EffectsPanel : public StudyPanel {
    Q_OBJECT

public:
    EffectsPanel(SceneDocument *document, EffectSwitches *switches, QWidget *parent = nullptr);
    ~EffectsPanel() override;
    Q_DISABLE_COPY_MOVE(EffectsPanel)

    /// The current scene's plan; none while it is being made.
    const std::optional<EffectPlan> &plan() const { return m_plan; }
    /// None before the first measurement, after a cancelled one, and after a change.
    const std::optional<EffectTiming> &timing() const { return m_timing; }

    QSize sizeHint() const override { return {900, 400}; }

public slots:
    void measure();
    void cancel();

signals:
    void planned();
    void measured();

private:
    /// The findings for a scene.
    struct Finding {
        EffectPlan plan;
        QString objection; ///< why its method cannot draw it, after the method's name
        std::shared_ptr<const DifferenceMap> changes; ///< null where nothing is forced
    };
    static Finding findingOf(const Scene &scene);

    QBoxLayout *controls();
    void addSamples(QBoxLayout *row);
    void makeTable();
    std::vector<RowsColumn<Effect>> columns() const;
    void addSwitch(int row, Effect effect);
    std::shared_ptr<const Scene> drawnScene() const;
    void forget();
    bool beginStudy() override;
    void take(const std::optional<Finding> &finding);
    void showTiming();
    void showSwitches();

    SceneDocument *m_document;
    EffectSwitches *m_switches;
    QComboBox *m_samples = nullptr;
    QPushButton *m_measure = nullptr;
    QTableView *m_table;
    RowsModel<Effect> *m_rows = nullptr;
    PerEffect<QComboBox *> m_boxes = {};
    std::optional<EffectPlan> m_plan;
    std::optional<EffectTiming> m_timing;
    QString m_objection;
    Job m_measureJob;
};

} // namespace pixelplumb
