package robotran.ui.empty

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.unit.dp
import robotran.uikit.*

/**
 * What a place shows while it has no content: a picture, and [label] that say how to get some. The picture is above the
 * words, beside them where the place is low, and missing where both would not fit.
 *
 * @param tag the test tag of the words.
 */
@Composable
fun EmptyState(picture: EmptyPicture, label: String, tag: String, modifier: Modifier = Modifier) {
    BoxWithConstraints(modifier.padding(Space.LARGE), Alignment.Center) {
        val scale = LocalDensity.current.fontScale
        val hasPicture = maxWidth >= BESIDE_WIDTH * scale && maxHeight >= PICTURE_HEIGHT
        val larger = if (constraints.hasBoundedHeight && maxHeight >= LARGE_HEIGHT * scale) LARGE else 1f
        if (maxHeight >= ABOVE_HEIGHT * scale) {
            Column(
                Modifier.widthIn(max = MAX_WIDTH),
                Arrangement.spacedBy(Space.MEDIUM),
                Alignment.CenterHorizontally,
            ) {
                EmptyPictureView(picture, larger = larger)
                EmptyWords(label, tag, TextAlign.Center)
            }
        } else {
            Row(
                Modifier.widthIn(max = MAX_WIDTH),
                Arrangement.spacedBy(Space.LARGE),
                Alignment.CenterVertically,
            ) {
                if (hasPicture) EmptyPictureView(picture)
                EmptyWords(label, tag, TextAlign.Start, Modifier.weight(1f, fill = false))
            }
        }
    }
}

@Composable
private fun EmptyWords(label: String, tag: String, align: TextAlign, modifier: Modifier = Modifier) = Text(
    label,
    modifier.testTag(tag),
    TextStyles.sentence,
    textAlign = align,
)

private val MAX_WIDTH = 440.dp

/** From this height on, at default font size, the picture is above the words. */
private val ABOVE_HEIGHT = 170.dp
private val BESIDE_WIDTH = 260.dp

/** From this height on, at default font size, the picture is larger. */
private val LARGE_HEIGHT = 280.dp
private const val LARGE = 1.75f
private val PICTURE_HEIGHT = 70.dp
