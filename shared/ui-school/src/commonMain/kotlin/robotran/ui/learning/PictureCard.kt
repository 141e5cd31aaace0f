package robotran.ui.learning

import androidx.compose.foundation.Image
import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ColumnScope
import androidx.compose.foundation.layout.aspectRatio
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.produceState
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.layout.ContentScale
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.ui.sheet.PictureBounds
import robotran.ui.sheet.SheetColours
import robotran.uikit.*

/** Provides the pictures of cards. */
internal interface CardPictures<T> {
    /** The picture of [subject] if it is already drawn. */
    fun ready(subject: T, colours: SheetColours, room: PictureBounds): ImageBitmap?

    /** The picture of [subject], drawn on first use. */
    suspend fun of(subject: T, colours: SheetColours, room: PictureBounds): ImageBitmap
}

/**
 * How the cards of a gallery look.
 *
 * @property aspect the ratio of the picture's width to its height.
 * @property padding around the words; half of it around the picture.
 */
internal class CardLook(val aspect: Float, val padding: Dp)

/**
 * A clickable card of a gallery: a picture of [subject] above [words]. The words describe the picture, so it needs no
 * accessibility text.
 *
 * @param isNext whether it is the one to press next.
 */
@Composable
internal fun <T : Any> PictureCard(
    subject: T,
    pictures: CardPictures<T>,
    tag: String,
    look: CardLook,
    onClick: () -> Unit,
    modifier: Modifier = Modifier,
    isNext: Boolean = false,
    words: @Composable ColumnScope.() -> Unit,
) {
    val colours = LocalRobotranColours.current
    CardButton(
        tag,
        onClick,
        modifier.fillMaxWidth(),
        color = if (isNext) RobotranColours.YELLOW else colours.pane,
        border = edge(if (isNext) RobotranColours.YELLOW_EDGE else colours.line),
    ) {
        Column {
            CardPicture(
                subject,
                pictures,
                Modifier.fillMaxWidth().aspectRatio(look.aspect).background(colours.desk).padding(look.padding / 2),
            )
            Column(Modifier.padding(look.padding), Arrangement.spacedBy(6.dp), content = words)
        }
    }
}

@Composable
private fun <T : Any> CardPicture(subject: T, pictures: CardPictures<T>, modifier: Modifier) {
    val colours = LocalRobotranColours.current
    val sheetColours = remember(colours) { SheetColours.of(colours) }
    BoxWithConstraints(modifier, Alignment.Center) {
        val room = PictureBounds.of(constraints.maxWidth, constraints.maxHeight, LocalDensity.current.density)
        val picture by produceState(pictures.ready(subject, sheetColours, room), subject, sheetColours, room) {
            value = pictures.of(subject, sheetColours, room)
        }
        picture?.let { Image(it, contentDescription = null, Modifier.fillMaxSize(), contentScale = ContentScale.Fit) }
    }
}
