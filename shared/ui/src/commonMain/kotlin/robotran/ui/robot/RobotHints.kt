package robotran.ui.robot

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.gestures.Orientation
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import robotran.robotediting.RobotEdit
import robotran.robotediting.RobotEditing
import robotran.robotediting.RobotElement
import robotran.robotediting.elementOf
import robotran.robotediting.portsOf
import robotran.ui.texts.RobotTexts
import robotran.ui.texts.ScreenTexts
import robotran.ui.texts.WorldEditorTexts
import robotran.ui.worldedit.validationErrorText
import robotran.uikit.*
import robotran.workshop.event.RobotEditEvent
import robotran.workshop.state.RobotEditState
import robotran.workshop.state.WorldEditState
import robotran.world.messages.sentence
import robotran.world.robot.things
import robotran.worldediting.ElementKind
import robotran.worldediting.ElementRef

/**
 * Why an edit was refused, what is impossible about the robot, whether it has no room where it stands, and what is not
 * plugged in. It covers the plan, which does not move, until it is closed or replaced.
 */
@Composable
internal fun RobotHints(
    state: RobotEditState,
    world: WorldEditState,
    scope: RobotScope,
    modifier: Modifier = Modifier,
) {
    val colours = LocalRobotranColours.current
    val language = LocalLanguage.current
    val editing = state.editing
    val here = ElementRef(ElementKind.ROBOT, state.robot)
    val sentences = listOfNotNull(
        state.fileError,
        editing.error?.let { robotEditErrorText(it)(spoken) },
        RobotTexts.saveRefused(spoken).takeIf { state.isSavingRefused },
    ) + editing.errors.take(MAX_ERRORS).map { it.sentence(language) } +
        world.editing.errors.filter { it.thing == here }.take(1).map { validationErrorText(world.world, it) }
    val warnings = listOfNotNull(unpluggedHint(editing))
    if ((sentences.isEmpty() && warnings.isEmpty()) || !state.hintsShown || editing.gesture != null) return
    val pane = if (sentences.isEmpty()) colours.pane else colours.errorPane
    val scroll = rememberScrollState()
    Row(
        modifier
            .widthIn(max = MAX_WIDTH)
            .background(pane, Shapes.MEDIUM)
            .border(1.dp, colours.line, Shapes.MEDIUM)
            // Blocks touches on the content below.
            .pointerInput(Unit) { },
    ) {
        Column(
            Modifier
                .weight(1f, fill = false)
                .testTag("robot-hints")
                .announced()
                .scrollHint(scroll)
                .verticalScroll(scroll)
                .padding(start = 16.dp, top = 12.dp, bottom = 12.dp),
            Arrangement.spacedBy(4.dp),
        ) {
            for (sentence in sentences + warnings) Text(sentence, style = TextStyles.compact)
            val element = editing.errors.firstOrNull()?.let(editing.robot::elementOf)
            if (element != null && element != editing.chosen) {
                WordButton(WorldEditorTexts.showTrouble(spoken), "robot-show-trouble", {
                    scope.make(RobotEdit.Choose(element))
                })
            }
        }
        IconButton(Icon.CLOSE, ScreenTexts.noticeClose(spoken), "robot-hints-close") {
            scope.perform(RobotEditEvent.HintsClosed)
        }
    }
}

/** What is chosen and has no cable; null if it has one, or needs none. */
@Composable
private fun unpluggedHint(editing: RobotEditing): String? {
    val part = (editing.chosen as? RobotElement.Part) ?: return null
    if (editing.robot.portsOf(part.number).isNotEmpty()) return null
    val name = editing.robot.things.getOrNull(part.number)?.let { partWord(it)(spoken) } ?: return null
    return RobotTexts.hintUnplugged(spoken, name)
}

private val MAX_WIDTH = 560.dp
private const val MAX_ERRORS = 2
