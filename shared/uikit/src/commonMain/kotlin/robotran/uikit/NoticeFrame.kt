package robotran.uikit

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp

/**
 * What a [NoticeFrame] says.
 *
 * @property text may be empty if there is an action: then this stands alone and hides as little as it can.
 * @property isError screen readers say it at once, not after what they are saying.
 * @property closeLabel what screen readers say of the button that closes it.
 */
class NoticeWords(val text: String, val isError: Boolean, val closeLabel: String)

/** The tags of a [NoticeFrame] and of what is in it. */
class NoticeTags(val frame: String, val text: String, val close: String)

/**
 * A notice with a button that closes it: screen readers announce it.
 *
 * @param action a link button: beside the text where there is room, else below it.
 */
@Composable
fun NoticeFrame(
    words: NoticeWords,
    tags: NoticeTags,
    onClose: () -> Unit,
    modifier: Modifier = Modifier,
    action: (@Composable () -> Unit)? = null,
) {
    val colours = LocalRobotranColours.current
    if (words.text.isEmpty() && action != null) {
        Box(modifier.framed(colours.pane, colours).testTag(tags.frame)) { action() }
        return
    }
    val ground = if (words.isError) colours.errorPane else colours.pane
    // An empty pointer input keeps touches from what is below.
    BoxWithConstraints(
        modifier.fillMaxWidth().framed(ground, colours).pointerInput(Unit) { }.testTag(tags.frame),
    ) {
        val isBeside = maxWidth >= BESIDE * LocalDensity.current.fontScale
        Column {
            Row(
                Modifier.defaultMinSize(minHeight = Dimensions.TARGET).padding(start = 16.dp),
                verticalAlignment = Alignment.CenterVertically,
            ) {
                Text(
                    words.text,
                    Modifier.weight(1f).padding(vertical = 8.dp).testTag(tags.text).semantics {
                        liveRegion = if (words.isError) LiveRegionMode.Assertive else LiveRegionMode.Polite
                    },
                    TextStyles.body,
                    color = if (words.isError) colours.error else colours.onPane,
                )
                if (isBeside) action?.invoke()
                val kind = if (words.isError) IconButtonKind.ERROR else IconButtonKind.PLAIN
                IconButton(Icon.CLOSE, words.closeLabel, tags.close, kind, onClick = onClose)
            }
            if (!isBeside) action?.invoke()
        }
    }
}

private fun Modifier.framed(ground: Color, colours: RobotranColours) =
    background(ground, Shapes.MEDIUM).border(1.dp, colours.line, Shapes.MEDIUM)

/** At the usual font size, a narrower notice has its action below the text. */
private val BESIDE = 440.dp
