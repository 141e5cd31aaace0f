package robotran.ui.program

import androidx.compose.foundation.ScrollState
import androidx.compose.foundation.background
import androidx.compose.foundation.gestures.Orientation
import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.selection.selectableGroup
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.runtime.withFrameNanos
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.layout.onPlaced
import androidx.compose.ui.layout.positionInParent
import androidx.compose.ui.platform.LocalDensity
import robotran.languagesupport.SourceFile
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.EditorTexts
import robotran.uikit.*
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.ProgramsState
import kotlin.math.roundToInt

/**
 * The tabs of the pupil's programs, and a button for a new one. If there are several, each has its number on the
 * brick's display and can be closed while it is shown.
 *
 * @param onRename called to rename the current program.
 */
@Composable
internal fun ProgramTabs(
    state: ProgramsState,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier = Modifier,
    onRename: () -> Unit = {},
) {
    val pane = LocalRobotranColours.current.pane
    Row(
        modifier.fillMaxWidth().background(pane).height(Dimensions.TARGET),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        val scroll = rememberScrollState()
        Row(
            Modifier
                .weight(1f)
                .scrollHint(scroll, Orientation.Horizontal)
                .horizontalScroll(scroll)
                .selectableGroup(),
            verticalAlignment = Alignment.CenterVertically,
        ) {
            val several = state.programs.size > 1
            state.programs.forEachIndexed { slot, program ->
                val shown = slot == state.shownProgram
                val title = if (several) EditorTexts.programTab(spoken, slot, program.name) else program.name
                Row(Modifier.keptInSight(shown, state.programs.size, scroll)) {
                    val rename = onRename.takeIf { shown && state.shownFile == 0 }
                    FileTab(title, shown, ProgramTags.program(slot), {
                        onEvent(ProgramEvent.ProgramChosen(slot))
                    }, rename)
                    if (several && shown) {
                        val close = EditorTexts.programClose(spoken, program.name)
                        IconButton(
                            ThinIcons.CROSS,
                            close,
                            ProgramTags.CLOSE_PROGRAM,
                            IconButtonKind.SMALL,
                        ) { onEvent(ProgramEvent.ProgramClosed(slot)) }
                    }
                }
            }
        }
        AddProgram(state, onEvent)
    }
}

/**
 * Scrolls to this tab when it becomes [shown], or the number of its [neighbours] or the room for all of them changes:
 * the pane is narrower for text than for blocks.
 */
@Composable
private fun Modifier.keptInSight(shown: Boolean, neighbours: Int, scroll: ScrollState): Modifier {
    var span by remember { mutableStateOf(0..0) }
    val room = scroll.viewportSize
    val margin = with(LocalDensity.current) { SCROLL_HINT_DEPTH.roundToPx() }
    LaunchedEffect(shown, neighbours, room, span) {
        if (!shown || room == 0) return@LaunchedEffect
        // The whole row has its new width only after layout.
        withFrameNanos { }
        val min = span.last + margin - room
        val place = scroll.value.coerceIn(min, maxOf(min, span.first - margin)).coerceIn(0, scroll.maxValue)
        // A touch while tabs scroll stops them, and is none on a tab.
        if (place != scroll.value) scroll.animateScrollTo(place)
    }
    return onPlaced { tab ->
        val left = tab.positionInParent().x.roundToInt()
        span = left..left + tab.size.width
    }
}

/** The files of one program, if it has several. [onRename] is called to rename or remove the current one. */
@Composable
internal fun FileTabs(
    files: List<SourceFile>,
    shown: Int,
    onChoose: (Int) -> Unit,
    onRename: () -> Unit,
    modifier: Modifier = Modifier,
) {
    val scroll = rememberScrollState()
    Row(
        modifier
            .fillMaxWidth()
            .height(Dimensions.TARGET)
            .scrollHint(scroll, Orientation.Horizontal)
            .horizontalScroll(scroll)
            .selectableGroup(),
    ) {
        files.forEachIndexed { place, file ->
            val isShown = place == shown
            Row(Modifier.keptInSight(isShown, files.size, scroll)) {
                FileTab(file.name, isShown, ProgramTags.file(place), { onChoose(place) }, onRename.takeIf { isShown })
            }
        }
    }
}
