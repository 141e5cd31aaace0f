package robotran.ui.program

import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.unit.dp
import robotran.projects.ProgramView
import robotran.ui.parts.ScreenLayout
import robotran.uikit.*

/**
 * What [view] shows of a program.
 *
 * @param isEditing whether a sheet is open over the blocks. Where the text is below them, they need its room then.
 * @param isVeryLow whether they need it also where the text is beside them.
 */
@Composable
internal fun BlocksAndText(
    view: ProgramView,
    isEditing: Boolean,
    isVeryLow: Boolean,
    blocks: @Composable (Modifier) -> Unit,
    text: @Composable (Modifier) -> Unit,
) = when (view) {
    ProgramView.TEXT -> text(Modifier.fillMaxSize())
    ProgramView.BLOCKS -> blocks(Modifier.fillMaxSize())

    ProgramView.BOTH -> SideBySideOrStacked(
        both = !isEditing || !isVeryLow,
        isEditing,
        Modifier.fillMaxSize(),
        blocks,
        text,
        BLOCKS_SHARE,
    )
}

/**
 * [second] next to [first] if there is room, otherwise below it.
 *
 * @param isFirstAlone whether [second] is not shown now if it would be below.
 * @param share the part of the room that [first] has.
 */
@Composable
internal fun SideBySideOrStacked(
    both: Boolean,
    isFirstAlone: Boolean,
    modifier: Modifier,
    first: @Composable (Modifier) -> Unit,
    second: @Composable (Modifier) -> Unit,
    share: Float = 0.5f,
) {
    BoxWithConstraints(modifier) {
        val colour = LocalRobotranColours.current.line
        if (both && maxWidth >= MIN_FOR_TWO * ScreenLayout.widthScale(LocalDensity.current.fontScale)) {
            Row(Modifier.fillMaxSize()) {
                first(Modifier.weight(share).fillMaxHeight())
                VerticalDivider(color = colour)
                second(Modifier.weight(1 - share).fillMaxHeight())
            }
        } else {
            Column(Modifier.fillMaxSize()) {
                first(Modifier.weight(share).fillMaxWidth())
                if (both && !isFirstAlone) {
                    HorizontalDivider(color = colour)
                    second(Modifier.weight(1 - share).fillMaxWidth())
                }
            }
        }
    }
}

/** At the default font size. */
private val MIN_FOR_TWO = 640.dp

/** Blocks are wider and higher than their text. */
private const val BLOCKS_SHARE = 0.55f
