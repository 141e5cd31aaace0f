package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import io.kotest.property.Arb
import io.kotest.property.arbitrary.numericDouble
import io.kotest.property.checkAll
import kotlinx.coroutines.runBlocking
import robotran.workshop.state.SheetCamera
import robotran.world.Paper
import robotran.world.geometry.Point
import kotlin.math.abs
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class SheetCameraTest {
    private val paper = Paper(100.0, 80.0)
    private val window = Rect(64f, 0f, 864f, 700f)

    @Test
    fun `without zoom all of the paper is in the window with its margin`() {
        val view = SheetCamera.FITTING.transform(paper, window)
        assertTrue(view.paper.left >= window.left && view.paper.right <= window.right)
        assertTrue((window.center - view.paper.center).getDistance() < 0.01f)
    }

    @Test
    fun `every place is found again from its pixel, however the sheet is looked at`() = property { zoom, x, y ->
        val view = SheetCamera(zoom, Point(x, y)).transform(paper, window)
        val back = view.toCentimetres(view.toPixels(x, y))
        near(x, back.x, 1e-2)
        near(y, back.y, 1e-2)
        near(view.toCentimetres(view.toPixels(7.5)), 7.5, 1e-4)
    }

    @Test
    fun `zooming keeps what is under the fingers there, unless the paper ends`() = property { zoom, x, y ->
        val camera = SheetCamera(zoom, Point(50.0, 40.0)).within(paper, window)
        val about = window.center + Offset(x.toFloat() - 50f, y.toFloat() - 40f)
        val before = camera.transform(paper, window).toCentimetres(about)
        val nearer = camera.zoomedBy(1.5, about, paper, window)
        val after = nearer.transform(paper, window).toCentimetres(about)
        if (zoom > 3 && nearer.zoom < SheetCamera.MAX_ZOOM) {
            near(before.x, after.x, 0.05)
            near(before.y, after.y, 0.05)
        }
        assertTrue(nearer.zoom in SheetCamera.MIN_ZOOM..SheetCamera.MAX_ZOOM)
    }

    @Test
    fun `pushing to and fro comes back to the same place, and never further than the margin`() = property {
        zoom,
        x,
        y,
        ->
        val camera = SheetCamera(zoom, Point(x, y)).within(paper, window)
        val there = camera.pushedBy(Offset(31f, -17f), paper, window)
        val view = there.transform(paper, window)
        val margin = view.toPixels(marginOf(paper)) + 1f
        assertTrue(view.paper.left <= window.left + margin || view.paper.width <= window.width)
        assertTrue(view.paper.bottom >= window.bottom - margin || view.paper.height <= window.height)
        if (x in 30.0..70.0 && y in 30.0..50.0 && zoom > 5) {
            val back = there.pushedBy(Offset(-31f, 17f), paper, window).transform(paper, window)
            near(camera.transform(paper, window).paper.left.toDouble(), back.paper.left.toDouble(), 0.5)
        }
    }

    @Test
    fun `a window without any size does no harm`() {
        val camera = SheetCamera(3.0, Point(1.0, 1.0))
        assertEquals(0f, camera.transform(paper, Rect.Zero).pixelsPerCentimetre)
        assertEquals(Point(0.0, 0.0), camera.transform(paper, Rect.Zero).toCentimetres(Offset(5f, 5f)))
        assertEquals(3.0, camera.zoomedBy(1.0, Offset.Zero, paper, Rect.Zero).zoom)
    }

    private fun property(check: (Double, Double, Double) -> Unit) = runBlocking {
        val zooms = Arb.numericDouble(1.0, 40.0)
        checkAll(300, zooms, Arb.numericDouble(-20.0, 120.0), Arb.numericDouble(-20.0, 100.0)) { zoom, x, y ->
            check(zoom, x, y)
        }
        Unit
    }

    private fun near(expected: Double, actual: Double, tolerance: Double) =
        assertTrue(abs(expected - actual) <= tolerance, "$actual is not $expected")
}
