package robotran.ui.poster

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Canvas
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.drawscope.CanvasDrawScope
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.clipRect
import androidx.compose.ui.graphics.drawscope.translate
import androidx.compose.ui.text.AnnotatedString
import androidx.compose.ui.text.SpanStyle
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.buildAnnotatedString
import androidx.compose.ui.text.drawText
import androidx.compose.ui.text.font.FontFamily
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.withStyle
import androidx.compose.ui.unit.Density
import androidx.compose.ui.unit.LayoutDirection
import robotran.ui.pictures.pngOf
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.SheetFit
import robotran.ui.sheet.drawSheet
import robotran.uikit.*
import robotran.workshop.state.Poster
import kotlin.math.roundToInt

/** A poster that can be drawn at any size: on the screen, for a printer. */
class DrawnPoster(private val poster: Poster) {
    private val page = layPoster(poster)
    private val fit = SheetFit(poster.world, marginCentimetres = 0.0)

    /** Millimetres. */
    val width: Double get() = page.width

    /** Millimetres. */
    val height: Double get() = page.height

    val isLandscape: Boolean get() = page.isLandscape

    /** Fills the draw area, which should have the page's ratio, with the page. */
    fun DrawScope.draw(labels: TextMeasurer, code: FontFamily) {
        val scale = (size.width / page.width).toFloat()
        drawRect(RobotranColours.CASING)
        val corner = Offset(page.sheet.left.toFloat() * scale, page.sheet.top.toFloat() * scale)
        val area = Size(page.sheet.width.toFloat() * scale, page.sheet.height.toFloat() * scale)
        translate(corner.x, corner.y) {
            clipRect(0f, 0f, area.width, area.height) { drawPart(area, labels) }
            drawRect(RobotranColours.LIGHT.line, Offset.Zero, area, style = Stroke(EDGE.toFloat() * scale))
        }
        for (box in page.boxes) drawBox(box, scale)
        for (line in page.lines) drawLine(line, scale, labels, code)
    }

    /** The part of the sheet that is seen in [area]. */
    private fun DrawScope.drawPart(area: Size, labels: TextMeasurer) {
        val perCentimetre = area.width / page.crop.width.toFloat()
        val paper = poster.world.paper
        val whole = Size(paper.width.toFloat() * perCentimetre, paper.height.toFloat() * perCentimetre)
        translate(-page.crop.left.toFloat() * perCentimetre, -page.crop.top.toFloat() * perCentimetre) {
            CanvasDrawScope().draw(this, layoutDirection, drawContext.canvas, whole) {
                drawSheet(fit.into(whole), poster.session, SheetColours.LIGHT, labels)
            }
        }
    }

    /** The page with [pixelsPerMillimetre], for a printer or a file. */
    fun image(pixelsPerMillimetre: Double, fonts: FontFamily.Resolver): ImageBitmap {
        val wide = (page.width * pixelsPerMillimetre).roundToInt()
        val high = (page.height * pixelsPerMillimetre).roundToInt()
        val image = ImageBitmap(wide, high)
        val size = Size(wide.toFloat(), high.toFloat())
        CanvasDrawScope().draw(Density(1f), LayoutDirection.Ltr, Canvas(image), size) {
            draw(TextMeasurer(fonts, Density(1f), LayoutDirection.Ltr), FontFamily.Monospace)
        }
        return image
    }
}

/** The sharpness of a poster as a picture: 200 dots per inch, for screens and small prints. */
const val POSTER_PIXELS_PER_MILLIMETRE = 8.0

/** [poster] as a PNG file, drawn off the screen with [fonts]. */
fun posterPng(poster: Poster, fonts: FontFamily.Resolver): ByteArray =
    pngOf(DrawnPoster(poster).image(POSTER_PIXELS_PER_MILLIMETRE, fonts))

private fun DrawScope.drawBox(box: PosterBox, scale: Float) {
    val corner = Offset(box.area.left.toFloat() * scale, box.area.top.toFloat() * scale)
    val area = Size(box.area.width.toFloat() * scale, box.area.height.toFloat() * scale)
    val radius = CornerRadius(box.corner.toFloat() * scale)
    drawRoundRect(box.fill, corner, area, radius)
    box.edge?.let { drawRoundRect(it, corner, area, radius, Stroke(EDGE.toFloat() * scale)) }
}

private fun DrawScope.drawLine(line: PosterLine, scale: Float, labels: TextMeasurer, code: FontFamily) {
    val style = TextStyle(
        fontSize = (line.size.toFloat() * scale).toSp(),
        fontFamily = if (line.isCode) code else FontFamily.SansSerif,
        fontWeight = if (line.isBold) FontWeight.Bold else FontWeight.Normal,
        fontFeatureSettings = "liga 0, calt 0",
    )
    val layout = labels.measure(textOf(line), style, softWrap = false, maxLines = 1)
    val top = line.baseline.toFloat() * scale - layout.firstBaseline
    drawText(layout, topLeft = Offset(line.left.toFloat() * scale, top))
}

private fun textOf(line: PosterLine): AnnotatedString = buildAnnotatedString {
    for (run in line.runs) withStyle(SpanStyle(run.colour)) { append(run.words) }
}
