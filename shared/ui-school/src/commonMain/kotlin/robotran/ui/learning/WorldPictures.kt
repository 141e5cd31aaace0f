package robotran.ui.learning

import androidx.compose.ui.graphics.ImageBitmap
import robotran.learning.GalleryWorld
import robotran.ui.sheet.PictureBounds
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.SheetPictures

/** Thumbnails of the gallery's worlds. */
internal object WorldPictures : CardPictures<GalleryWorld> {
    private val pictures = SheetPictures()

    override fun ready(subject: GalleryWorld, colours: SheetColours, room: PictureBounds): ImageBitmap? =
        pictures.ready(subject.name, colours, room)

    override suspend fun of(subject: GalleryWorld, colours: SheetColours, room: PictureBounds): ImageBitmap =
        pictures.of(subject.name, subject.plainWorld, colours, room)
}
