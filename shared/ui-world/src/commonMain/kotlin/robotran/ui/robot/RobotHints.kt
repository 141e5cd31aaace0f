package robotran.ui.robot

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import robotran.editing.RobotTexts
import robotran.robotediting.RobotEdit
import robotran.robotediting.RobotEditing
import robotran.robotediting.RobotElement
import robotran.robotediting.elementOf
import robotran.robotediting.partWord
import robotran.robotediting.portsOf
import robotran.ui.editing.EditorHints
import robotran.ui.editing.HintAction
import robotran.ui.editing.MAX_HINTS
import robotran.ui.world.tags.WorldTags
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
 * plugged in.
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
    ) + editing.errors.take(MAX_HINTS).map { it.sentence(language) } +
        world.editing.errors.filter { it.thing == here }.take(1).map { validationErrorText(world.world, it) }
    val warnings = listOfNotNull(unpluggedHint(editing))
    if ((sentences.isEmpty() && warnings.isEmpty()) || !state.hintsShown || editing.gesture != null) return
    val element = editing.errors.firstOrNull()?.let(editing.robot::elementOf)?.takeIf { it != editing.chosen }
    EditorHints(
        WorldTags.ROBOT_HINTS,
        sentences + warnings,
        if (sentences.isEmpty()) colours.pane else colours.errorPane,
        element?.let { HintAction(WorldTags.ROBOT_SHOW_TROUBLE) { scope.make(RobotEdit.Choose(it)) } },
        { scope.perform(RobotEditEvent.HintsClosed) },
        modifier,
    )
}

/** What is chosen and has no cable; null if it has one, or needs none. */
@Composable
private fun unpluggedHint(editing: RobotEditing): String? {
    val part = (editing.chosen as? RobotElement.Part) ?: return null
    if (editing.robot.portsOf(part.number).isNotEmpty()) return null
    val name = editing.robot.things.getOrNull(part.number)?.let { partWord(it)(spoken) } ?: return null
    return RobotTexts.hintUnplugged(spoken, name)
}
