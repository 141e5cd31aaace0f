package robotran.ui.worldedit

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import robotran.editing.WorldEditorTexts
import robotran.ui.editing.EditorHints
import robotran.ui.editing.HintAction
import robotran.ui.editing.MAX_HINTS
import robotran.ui.world.tags.WorldTags
import robotran.uikit.*
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.state.WorldEditState
import robotran.world.World
import robotran.worldediting.ElementRef
import robotran.worldediting.WorldEdit
import robotran.worldediting.allGoals

/** Why an edit was rejected, or the world's errors; with none, what may surprise once it runs. */
@Composable
internal fun EditHints(state: WorldEditState, editor: EditorScope, modifier: Modifier = Modifier) {
    val editing = state.editing
    val sentences = listOfNotNull(
        editing.error?.let { editErrorText(it) },
        WorldEditorTexts.mendFirst(spoken).takeIf { state.hasFailedToClose },
    ) + editing.errors.take(MAX_HINTS).map { validationErrorText(editing.world, it) }
    if (!state.hintsShown) return
    val met = state.metAtStart.takeIf { sentences.isEmpty() }.orEmpty()
    if (sentences.isEmpty() && met.isEmpty()) return
    val first = editing.errors.firstOrNull()?.thing ?: met.firstOrNull()
    val thing = first?.takeIf { it !in editing.selection }
    val colours = LocalRobotranColours.current
    EditorHints(
        WorldTags.EDIT_HINTS,
        sentences + met.take(1).map { WorldEditorTexts.metAtStart(spoken, blockOf(editing.world, it)) },
        if (sentences.isEmpty()) colours.invite else colours.errorPane,
        thing?.let { HintAction(WorldTags.SHOW_TROUBLE) { editor.make(WorldEdit.Select(it)) } },
        { editor.perform(WorldEditEvent.HintsClosed) },
        modifier,
    )
}

/** The block that is to reach the goal; null for a robot. */
private fun blockOf(world: World, goal: ElementRef): String? =
    allGoals(world.goals).getOrNull(goal.number)?.goal?.who?.takeIf { name -> world.robots.none { it.name == name } }
