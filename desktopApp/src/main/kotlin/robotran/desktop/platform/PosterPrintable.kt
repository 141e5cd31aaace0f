package robotran.desktop.platform

import androidx.compose.ui.graphics.toAwtImage
import androidx.compose.ui.text.font.createFontFamilyResolver
import robotran.ui.poster.DrawnPoster
import java.awt.Graphics
import java.awt.Graphics2D
import java.awt.geom.AffineTransform
import java.awt.image.BufferedImage
import java.awt.print.PageFormat
import java.awt.print.Printable

/** The one page of a poster, as an image of [DOTS_PER_INCH]: Java's printing cannot take what Compose draws. */
internal class PosterPrintable(private val drawn: DrawnPoster) : Printable {
    private val image: BufferedImage by lazy {
        drawn.image(DOTS_PER_INCH / MILLIMETRES_PER_INCH, createFontFamilyResolver()).toAwtImage()
    }

    override fun print(graphics: Graphics, format: PageFormat, page: Int): Int {
        if (page > 0) return Printable.NO_SUCH_PAGE
        // Smaller paper than A4 shows all of the page, too.
        val scale = minOf(format.width / image.width, format.height / image.height)
        (graphics as Graphics2D).drawImage(image, AffineTransform.getScaleInstance(scale, scale), null)
        return Printable.PAGE_EXISTS
    }

    private companion object {
        /** What most printers have at least. */
        const val DOTS_PER_INCH = 300.0
    }
}
