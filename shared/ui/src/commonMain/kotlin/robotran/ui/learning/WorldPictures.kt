package robotran.ui.learning

import androidx.compose.ui.graphics.ImageBitmap
import robotran.learning.GalleryWorld
import robotran.ui.sheet.PictureRoom
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.SheetPictures

/** Small pictures of the gallery's worlds. */
internal object WorldPictures {
    private val pictures = SheetPictures()

    /** See [SheetPictures.ready]. */
    fun ready(world: GalleryWorld, colours: SheetColours, room: PictureRoom): ImageBitmap? = pictures.ready(world.name, colours, room)

    /** See [SheetPictures.of]. */
    suspend fun of(world: GalleryWorld, colours: SheetColours, room: PictureRoom): ImageBitmap =
        pictures.of(world.name, world.plainWorld, colours, room)
}
