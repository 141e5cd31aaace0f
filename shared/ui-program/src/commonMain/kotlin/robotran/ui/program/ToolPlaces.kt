package robotran.ui.program

import androidx.compose.runtime.Composable
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.text.rememberTextMeasurer
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.uikit.*

/** Where the button that sends is, from a wide row to a narrow one. */
internal enum class SendPlace { WORDS, SIGN, MENU }

/**
 * Which tools are in the row above the program; the others are in its menu.
 *
 * @property hasFind false only where even the smallest row of buttons is too wide.
 */
internal data class ToolPlaces(val send: SendPlace, val hasTranslation: Boolean, val hasFind: Boolean = true)

/**
 * The tools for which a row of [width] has room.
 *
 * @param hasViews whether there is a switch between text and blocks.
 * @param translationWords the name of the switch for another text; null if there is none.
 */
@Composable
internal fun toolPlaces(width: Dp, hasViews: Boolean, translationWords: Label?, sendWords: Label): ToolPlaces {
    val send = chipWidth(sendWords) + ToolSizes.SIGN
    val translation = if (translationWords != null) chipWidth(translationWords) + ToolSizes.GAP else 0.dp
    val view = if (hasViews) VIEW_WORDS.maxOf { chipWidth(it) } + ToolSizes.SIGN + ToolSizes.GAP else 0.dp
    return CHOICES.firstOrNull { places ->
        val sending = when (places.send) {
            SendPlace.WORDS -> send
            SendPlace.SIGN -> Dimensions.TARGET
            SendPlace.MENU -> 0.dp
        }
        val round = Dimensions.TARGET * if (places.hasFind) ROUND_BUTTONS else ROUND_BUTTONS - 1
        val chips = view + if (places.hasTranslation) translation else 0.dp
        width >= round + ToolSizes.EDGE * 2 + chips + sending
    }.let { it ?: CHOICES.last() }.let { if (translationWords != null) it else it.copy(hasTranslation = false) }
}

@Composable
private fun chipWidth(label: Label): Dp {
    val style = TextStyles.small.asWritten()
    val text = rememberTextMeasurer().measure(label(spoken), style, maxLines = 1).size.width
    return with(LocalDensity.current) { text.toDp() } + CHIP
}

/** The sizes of the row of tools. */
internal object ToolSizes {
    val EDGE = 4.dp
    val GAP = 8.dp

    /** What a picture adds to a chip. */
    val SIGN = 16.dp
}

/** From a wide row to a narrow one. */
private val CHOICES = listOf(
    ToolPlaces(SendPlace.WORDS, hasTranslation = true),
    ToolPlaces(SendPlace.SIGN, hasTranslation = true),
    ToolPlaces(SendPlace.MENU, hasTranslation = true),
    ToolPlaces(SendPlace.SIGN, hasTranslation = false),
    ToolPlaces(SendPlace.MENU, hasTranslation = false),
    ToolPlaces(SendPlace.MENU, hasTranslation = false, hasFind = false),
)

/** What a chip adds to its text. */
private val CHIP = 40.dp

/** Undo, redo, find and the menu. */
private const val ROUND_BUTTONS = 4
