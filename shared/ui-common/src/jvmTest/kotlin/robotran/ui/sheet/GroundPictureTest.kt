package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Canvas
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.drawscope.CanvasDrawScope
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.translate
import androidx.compose.ui.graphics.toPixelMap
import androidx.compose.ui.unit.Density
import androidx.compose.ui.unit.LayoutDirection
import robotran.uikit.*
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.Paper
import robotran.world.RobotPlacement
import robotran.world.Template
import robotran.world.Wall
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import kotlin.math.abs
import kotlin.test.Test
import kotlin.test.assertFalse
import kotlin.test.assertTrue

/** What is kept between frames shows exactly what would be drawn in each of them. */
class GroundPictureTest {
    @Test
    fun `the picture shows what drawing it would`() {
        for (theme in listOf(RobotranColours.LIGHT, RobotranColours.DARK)) {
            for (scale in listOf(3.3f, 9.71f, 24f)) compare(theme, scale, Offset(31f, 17f), density = 1f)
        }
        compare(RobotranColours.LIGHT, 8.2f, Offset(-140f, -60f), density = 2.6f)
    }

    @Test
    fun `the picture of a part shows what drawing it would, wherever the window is`() {
        val drawing = drawingAt(70f)
        assertTrue(drawing.transform.paper.run { width * height } > 7_000_000)
        for (place in listOf(Offset(20f, 20f), Offset(-900f, -700f), Offset(-930f, -720f), Offset(-2_600f, -1_900f))) {
            compare(RobotranColours.LIGHT, drawing, place, density = 1f)
        }
    }

    @Test
    fun `a change of the theme changes the picture`() {
        val drawing = drawingAt(9f)
        val (light, dark) = listOf(RobotranColours.LIGHT, RobotranColours.DARK).map { pixels(kept(drawing, it)) }
        assertFalse(light.contentEquals(dark))
    }

    private fun compare(theme: RobotranColours, scale: Float, position: Offset, density: Float) =
        compare(theme, drawingAt(scale), position, density)

    private fun compare(theme: RobotranColours, drawing: SheetDrawing, position: Offset, density: Float) {
        val colours = SheetColours.of(theme)
        val grain = paperGrain(theme.paper)
        val drawn = window(position, density) { visible ->
            drawRect(colours.desk, visible.topLeft, visible.size)
            drawGround(drawing, colours, grain, visible)
        }
        repeat(2) {
            val shown = pixels(kept(drawing, theme, position, density, grain))
            val wrong = pixels(drawn).zip(shown).withIndex()
                .filter { (_, colours) -> differs(colours.first, colours.second) }
                .map { (pixel, _) -> "${pixel % WIDTH},${pixel / WIDTH}" }
            assertTrue(wrong.isEmpty(), "${wrong.size} pixels differ at $position: ${wrong.take(9)}")
        }
    }

    private fun kept(
        drawing: SheetDrawing,
        theme: RobotranColours,
        position: Offset = Offset.Zero,
        density: Float = 1f,
        grain: ImageBitmap = paperGrain(theme.paper),
    ): ImageBitmap = window(position, density) { visible ->
        val colours = SheetColours.of(theme)
        drawRect(colours.desk, visible.topLeft, visible.size)
        drawing.ground.draw(this, colours, grain, visible, isStretched = false)
    }

    /** A window of the sheet whose paper begins at [position]. */
    private fun window(position: Offset, density: Float, draw: DrawScope.(Rect) -> Unit): ImageBitmap {
        val image = ImageBitmap(WIDTH, HEIGHT)
        val size = Size(WIDTH.toFloat(), HEIGHT.toFloat())
        CanvasDrawScope().draw(Density(density), LayoutDirection.Ltr, Canvas(image), size) {
            translate(position.x, position.y) { draw(Rect(-position, size)) }
        }
        return image
    }

    /** More than smoothed edges are rounded differently at another place of a bitmap. */
    private fun differs(one: Int, other: Int): Boolean = (0..24 step 8).any { shift ->
        abs((one ushr shift and 0xFF) - (other ushr shift and 0xFF)) > ROUNDING
    }

    private fun pixels(image: ImageBitmap): IntArray = image.toPixelMap().buffer

    private fun drawingAt(scale: Float): SheetDrawing {
        val paper = Size(WORLD.paper.width.toFloat() * scale, WORLD.paper.height.toFloat() * scale)
        return SheetDrawing(WORLD, SheetTransform(scale, Rect(Offset.Zero, paper)))
    }

    private companion object {
        const val WIDTH = 640
        const val HEIGHT = 480

        /** Of 255. */
        const val ROUNDING = 4

        /** With walls at the lower and right edges, whose shadows fall on the desk. */
        val WORLD = World(
            "Ground",
            Paper(47.0, 33.0),
            listOf(RobotPlacement(Pose(20.0, 20.0, 0.0))),
            walls = listOf(
                Wall(Point(0.0, 0.0), Point(47.0, 0.0), 2.0),
                Wall(Point(47.0, 0.0), Point(47.0, 33.0), 2.0),
                Wall(Point(10.0, 10.0), Point(20.0, 26.0), 1.0),
            ),
            marks = listOf(Mark(MarkFigure.Area(Shape.Circle(Point(30.0, 20.0), 4.0)))),
            template = Template(listOf(listOf(Point(5.0, 5.0), Point(25.0, 5.0), Point(25.0, 25.0)))),
        )
    }
}
