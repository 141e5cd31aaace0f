package robotran.ui.learning

import androidx.compose.ui.graphics.ImageBitmap
import robotran.learning.GalleryWorld
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.SheetPictures

/** Small pictures of the gallery's worlds. */
internal object WorldPictures {
    /** Enough for a card on a screen of two pixels a dp. */
    private val pictures = SheetPictures(pixels = 560)

    /** The picture of [world] if it has been drawn in these [colours]. */
    fun ready(world: GalleryWorld, colours: SheetColours): ImageBitmap? = pictures.ready(world.name, colours)

    /** The picture of [world], drawn if it was not. */
    suspend fun of(world: GalleryWorld, colours: SheetColours): ImageBitmap = pictures.of(world.name, world.plainWorld, colours)
}
