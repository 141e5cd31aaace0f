package robotran.ui.worldedit

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
import robotran.ui.texts.ScreenTexts
import robotran.ui.texts.WorldEditorTexts
import robotran.uikit.*
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.state.WorldEditState
import robotran.worldediting.WorldEdit

/**
 * Why an edit was rejected, or the world's errors. It covers the sheet, which does not move, until it is closed or
 * replaced.
 */
@Composable
internal fun EditHints(state: WorldEditState, editor: EditorScope, modifier: Modifier = Modifier) {
    val colours = LocalRobotranColours.current
    val editing = state.editing
    val sentences = listOfNotNull(
        editing.error?.let { editErrorText(it) },
        WorldEditorTexts.mendFirst(spoken).takeIf { state.hasFailedToClose },
    ) + editing.errors.take(MAX_ERRORS).map { validationErrorText(editing.world, it) }
    if (sentences.isEmpty() || !state.hintsShown) return
    val scroll = rememberScrollState()
    Row(
        modifier
            .widthIn(max = MAX_WIDTH)
            .background(colours.errorPane, SHAPE)
            .border(1.dp, colours.line, SHAPE)
            // Blocks touches on the content below.
            .pointerInput(Unit) { },
    ) {
        Column(
            Modifier
                .weight(1f, fill = false)
                .testTag("edit-hints")
                .announced()
                .scrollHint(scroll, ground = colours.errorPane)
                .verticalScroll(scroll)
                .padding(start = 16.dp, top = 12.dp, bottom = 12.dp),
            Arrangement.spacedBy(4.dp),
        ) {
            for (sentence in sentences) Text(sentence, style = TextStyles.compact)
            val thing = editing.errors.firstOrNull()?.thing
            if (thing != null && thing !in editing.selection) {
                WordButton(WorldEditorTexts.showTrouble(spoken), "show-trouble", {
                    editor.make(WorldEdit.Select(thing))
                })
            }
        }
        IconButton(Icon.CLOSE, ScreenTexts.noticeClose(spoken), "edit-hints-close") {
            editor.perform(WorldEditEvent.HintsClosed)
        }
    }
}

private val SHAPE = Shapes.MEDIUM
private val MAX_WIDTH = 560.dp
private const val MAX_ERRORS = 2
