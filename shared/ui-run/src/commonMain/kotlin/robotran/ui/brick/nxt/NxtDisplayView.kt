package robotran.ui.brick.nxt

import androidx.compose.foundation.Canvas
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.setValue
import androidx.compose.runtime.snapshotFlow
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.Dp
import kotlinx.coroutines.delay
import robotran.nxt.display.DisplaySize
import robotran.nxt.state.NxtState
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.ui.texts.NxtTexts
import robotran.uikit.*

/**
 * The display, dot by dot. Screen readers announce the marked entry of a menu and its lines when they change, but not more often than every
 * [CALM_MILLISECONDS].
 *
 * @param rows the rows of text to show.
 * @param margin around the dots.
 */
@Composable
internal fun NxtDisplayView(
    state: NxtState,
    margin: Dp,
    modifier: Modifier = Modifier,
    rows: IntRange = 0..<DisplaySize.ROWS,
) {
    val dots = remember(state.display) { dotsOf(state.display) }
    val (words, marked) = rememberCalm(state.screen.texts to state.menu?.let { it.entries.getOrNull(it.selected) })
    val description = if (words.isEmpty()) {
        RunTexts.displayBlank(spoken)
    } else {
        val mark = marked?.let { NxtTexts.displayMarked(spoken, it) }
        val texts = words.filterNot(::isDrawing)
        val drawing = if (texts.size < words.size) RunTexts.displayDrawing(spoken) else null
        // What a key has changed comes first.
        RunTexts.display(spoken, (listOfNotNull(mark) + texts + listOfNotNull(drawing)).joinToString("\n"))
    }
    val contrast = state.contrast.toFloat() / NxtState.HIGHEST_CONTRAST
    Canvas(
        modifier.testTag(RunTags.LCD).semantics {
            contentDescription = description
            liveRegion = LiveRegionMode.Polite
        },
    ) {
        // A few rows look cut if the mark of an entry touches the next one.
        val gap = if (state.menu != null && rows.count() < DisplaySize.ROWS) 1 else 0
        val first = rows.first * DisplaySize.CELL_HEIGHT
        val count = (rows.last + 1 - rows.first) * DisplaySize.CELL_HEIGHT
        drawGlass(dots, first, count, contrast, margin.toPx(), state.poweredOn, gap)
    }
}

/** The latest [value], which changes at most every [CALM_MILLISECONDS]. */
@Composable
private fun <T> rememberCalm(value: T): T {
    val latest by rememberUpdatedState(value)
    var calm by remember { mutableStateOf(value) }
    LaunchedEffect(Unit) {
        snapshotFlow { latest }.collect {
            calm = it
            delay(CALM_MILLISECONDS)
        }
    }
    return calm
}

/** Whether a row of the display has dots, but no character that the font has. */
private fun isDrawing(row: String) = row.all { it == '?' || it == ' ' }

private const val CALM_MILLISECONDS = 500L
