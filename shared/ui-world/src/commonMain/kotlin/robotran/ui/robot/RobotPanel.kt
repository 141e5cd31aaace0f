package robotran.ui.robot

import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.key
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.editing.RobotTexts
import robotran.robotediting.RobotEdit
import robotran.robotediting.RobotElement
import robotran.robotediting.elementOf
import robotran.robotediting.elements
import robotran.robotediting.fieldsOf
import robotran.robotediting.measuredFields
import robotran.robotediting.wholeFields
import robotran.ui.editing.ChoosingRow
import robotran.ui.editing.ChosenName
import robotran.ui.editing.EditorActions
import robotran.ui.editing.EditorTab
import robotran.ui.editing.FieldPanel
import robotran.ui.editing.Form
import robotran.ui.editing.HelpText
import robotran.ui.editing.RowHeading
import robotran.ui.parts.readyRobotWithBrick
import robotran.ui.world.tags.WorldTags
import robotran.uikit.*
import robotran.workshop.event.RobotEditEvent
import robotran.world.ReadyRobots
import robotran.world.messages.sentence

/** The tabs of the workbench's panel. */
internal enum class RobotTab(override val title: Label) : EditorTab {
    CHOSEN(RobotTexts::tabChosen),
    PARTS(RobotTexts::tabParts),
    ROBOT(RobotTexts::tabRobot),
    ;

    override val tag get() = WorldTags.robotTab(this)
}

@Composable
internal fun RobotPanel(scope: RobotScope, tab: RobotTab, onTab: (RobotTab) -> Unit, modifier: Modifier = Modifier) {
    val chosen = scope.editing.chosen
    val language = LocalLanguage.current
    val errors = scope.editing.errors.filter { tab == RobotTab.CHOSEN && scope.robot.elementOf(it) == chosen }
    key(tab, if (tab == RobotTab.CHOSEN) chosen else null) {
        FieldPanel(
            WorldTags.ROBOT_PANEL,
            errors.map {
                it.sentence(language)
            },
            WorldTags.ROBOT_CHOSEN_TROUBLE,
            modifier,
        ) {
            when (tab) {
                RobotTab.CHOSEN -> if (chosen == null) {
                    HelpText(RobotTexts.chooseFirst(spoken))
                } else {
                    ChosenElement(scope, chosen)
                }

                RobotTab.PARTS -> PartsPanel(scope) { onTab(RobotTab.CHOSEN) }
                RobotTab.ROBOT -> WholeRobotPanel(scope)
            }
        }
    }
}

@Composable
private fun ChosenElement(scope: RobotScope, chosen: RobotElement) {
    ChosenName(robotElementText(scope.robot, chosen), WorldTags.ROBOT_CHOSEN_NAME)
    EditorActions(scope, actionsOf(scope.robot, chosen))
    HorizontalDivider()
    Form(scope.robot.fieldsOf(chosen) + scope.editing.measuredFields(), scope)
}

/** A list of all elements. */
@Composable
private fun PartsPanel(scope: RobotScope, onChosen: () -> Unit) {
    HelpText(RobotTexts.partsHelp(spoken))
    scope.robot.elements().forEachIndexed { row, element ->
        ChoosingRow(
            robotElementText(scope.robot, element),
            WorldTags.robotElement(row),
            isChosen = element == scope.editing.chosen,
            isWrong = scope.editing.errors.any { scope.robot.elementOf(it) == element },
        ) {
            scope.make(RobotEdit.Choose(element))
            onChosen()
        }
    }
}

/** The name, the brick, other robots, and files. */
@Composable
private fun WholeRobotPanel(scope: RobotScope) {
    Form(scope.robot.wholeFields(), scope)
    RowHeading(RobotTexts.ready(spoken))
    HelpText(RobotTexts.readyHelp(spoken))
    for ((name, ready) in ReadyRobots.all) {
        Button(readyRobotWithBrick(name), WorldTags.robotReady(name), ButtonKind.EDITOR, Modifier.fillMaxWidth()) {
            scope.make(RobotEdit.Replace(ready))
        }
    }
    HorizontalDivider(Modifier.padding(vertical = 8.dp))
    Button(RobotTexts.open(spoken), WorldTags.ROBOT_OPEN, ButtonKind.EDITOR, Modifier.fillMaxWidth()) {
        scope.perform(RobotEditEvent.OpenRequested)
    }
    Button(RobotTexts.save(spoken), WorldTags.ROBOT_SAVE, ButtonKind.EDITOR, Modifier.fillMaxWidth()) {
        scope.perform(RobotEditEvent.SaveRequested)
    }
}
