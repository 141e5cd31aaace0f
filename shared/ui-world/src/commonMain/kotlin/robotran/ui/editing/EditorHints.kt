package robotran.ui.editing

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import robotran.editing.WorldEditorTexts
import robotran.ui.texts.CommonTexts
import robotran.uikit.*

/**
 * Sentences over the canvas, which does not move, until they are closed or replaced.
 *
 * @param show shows what the first mistake is about; null if there is nothing to show.
 */
@Composable
internal fun EditorHints(
    tag: String,
    sentences: List<String>,
    pane: Color,
    show: HintAction?,
    onClose: () -> Unit,
    modifier: Modifier,
) {
    val colours = LocalRobotranColours.current
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
                .testTag(tag)
                .semantics { liveRegion = LiveRegionMode.Polite }
                .scrollHint(scroll, ground = pane)
                .verticalScroll(scroll)
                .padding(start = 16.dp, top = 12.dp, bottom = 12.dp),
            Arrangement.spacedBy(4.dp),
        ) {
            for (sentence in sentences) Text(sentence, style = TextStyles.compact)
            if (show != null) {
                Button(WorldEditorTexts.showErrors(spoken), show.tag, ButtonKind.EDITOR, onClick = show.onClick)
            }
        }
        IconButton(Icon.CLOSE, CommonTexts.noticeClose(spoken), KitTags.close(tag), onClick = onClose)
    }
}

/** What a button below hints does. */
internal class HintAction(val tag: String, val onClick: () -> Unit)

/** The most mistakes that are told at once. */
internal const val MAX_HINTS = 2

private val MAX_WIDTH = 560.dp
