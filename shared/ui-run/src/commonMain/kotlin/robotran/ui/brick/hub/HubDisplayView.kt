package robotran.ui.brick.hub

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.text.BasicText
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.text.font.FontFamily
import androidx.compose.ui.unit.Dp
import robotran.hub.display.HubScreen
import robotran.hub.state.HubState
import robotran.ui.brick.front.LightMatrix
import robotran.ui.brick.front.MatrixLook
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.ui.texts.HubTexts
import robotran.uikit.*

/**
 * The lights of a hub, or its rows of text. On one without either the newest lines that its program has printed: they are
 * on the screen of the computer that it is connected with.
 *
 * @param unit of the plan.
 * @param printed how many lines there is room for.
 */
@Composable
internal fun HubDisplayView(state: HubState, unit: Dp, modifier: Modifier = Modifier, printed: Int = PRINTED) {
    val screen = state.screen
    val hasOwn = screen.lights.isNotEmpty() || screen.rows.isNotEmpty()
    val lines = if (hasOwn) emptyList() else screen.printed.takeLast(printed)
    val description = descriptionOf(screen, lines)
    val spokenModifier = modifier.testTag(RunTags.LCD).clearAndSetSemantics {
        contentDescription = description
        liveRegion = LiveRegionMode.Polite
    }
    when {
        screen.lights.isNotEmpty() -> LightMatrix(screen.lights.map { it / FULL }, MATRIX, spokenModifier)
        screen.rows.isNotEmpty() -> Rows(screen.rows, state.model.columns, spokenModifier)
        else -> Printed(lines, unit, spokenModifier)
    }
}

@Composable
private fun descriptionOf(screen: HubScreen, printed: List<String>): String {
    val words = (screen.lines + printed).filter { it.isNotBlank() }
    return when {
        screen.lights.isEmpty() && words.isEmpty() -> RunTexts.displayBlank(spoken)
        screen.lights.isEmpty() -> RunTexts.display(spoken, words.joinToString("\n"))
        words.isEmpty() -> HubTexts.lightsOff(spoken)
        else -> HubTexts.lights(spoken, words.joinToString(" "))
    }
}

/** Letters of one width, so large that [columns] of them and all [rows] fit. */
@Composable
private fun Rows(rows: List<String>, columns: Int, modifier: Modifier) =
    BoxWithConstraints(modifier.background(HubColours.GLASS)) {
        val line = minOf(maxHeight / rows.size, maxWidth / (columns + 1) / LETTER_WIDTH)
        Column(Modifier.padding(horizontal = maxWidth / (columns + 1) / 2)) {
            for (row in rows) {
                BasicText(
                    row,
                    style = TextStyles.scaled(line, LETTER, 1f).copy(fontFamily = FontFamily.Monospace),
                    color = { HubColours.INK },
                    maxLines = 1,
                    softWrap = false,
                )
            }
        }
    }

@Composable
private fun Printed(lines: List<String>, unit: Dp, modifier: Modifier) = Column(modifier) {
    for (line in lines) {
        BasicText(
            line,
            style = TextStyles.scaled(unit, PRINTED_SIZE),
            color = { HubColours.ON_BUTTON },
            maxLines = 1,
            softWrap = false,
        )
    }
}

private val MATRIX = MatrixLook(HubColours.LIGHT_EDGE, HubColours.LIGHT_OFF, HubColours.LIGHT_ON)
private const val FULL = 100f
private const val PRINTED = 4
private const val PRINTED_SIZE = 18f

/** The size of a letter and its width, as shares of the height of a row. */
private const val LETTER = 0.92f
private const val LETTER_WIDTH = 0.56f
