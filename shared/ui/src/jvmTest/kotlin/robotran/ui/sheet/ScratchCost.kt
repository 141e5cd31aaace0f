package robotran.ui.sheet

import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Canvas
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.drawscope.CanvasDrawScope
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.text.font.createFontFamilyResolver
import androidx.compose.ui.unit.Density
import androidx.compose.ui.unit.LayoutDirection
import robotran.world.InkStroke
import robotran.world.Point
import robotran.world.TrailPiece
import java.io.File
import kotlin.math.cos
import kotlin.math.sin
import kotlin.test.Test

class ScratchCost {
    @Test
    fun cost() {
        val world = SheetScenes.everything
        val points = List(20000) { Point(60 + 50 * cos(it * 0.013) * sin(it * 0.0011), 45 + 40 * sin(it * 0.017)) }
        val labels = TextMeasurer(createFontFamilyResolver(), Density(1f), LayoutDirection.Ltr)
        val out = StringBuilder()
        for (zoom in listOf(1.0, 6.0)) {
            for ((name, shown) in listOf("usual" to SheetLayer.USUAL, "all" to SheetLayer.entries.toSet(), "none" to emptySet())) {
                val size = Size(1000f, 800f)
                val image = ImageBitmap(1000, 800)
                val drawings = SheetZoom(world)
                val times = mutableListOf<Double>()
                for (frame in 0 until 120) {
                    val n = 19000 + frame
                    val state = SheetScenes.everythingLater.copy(
                        ink = robotran.world.Ink(listOf(InkStroke(points.subList(0, n))), 1.0), trail = listOf(TrailPiece(0, points.subList(0, n))),
                    )
                    val start = System.nanoTime()
                    val view = SheetCamera(zoom, Point(40.0 + frame * 0.1, 40.0)).transform(world.paper, Rect(0f, 0f, 1000f, 800f))
                    CanvasDrawScope().draw(Density(1f), LayoutDirection.Ltr, Canvas(image), size) {
                        drawSheet(drawings.at(view.pixelsPerCentimetre, true), state, SheetColours.LIGHT, labels, shown, view)
                    }
                    times += (System.nanoTime() - start) / 1e6
                }
                val late = times.drop(40).sorted()
                out.append("zoom $zoom $name: first ${times[0]} median ${late[late.size / 2]} p99 ${late[late.size * 99 / 100]}\n")
            }
        }
        File("build/cost.txt").writeText(out.toString())
    }
}
