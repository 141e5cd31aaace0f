package robotran.ui.sheet3d

import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import robotran.simulation.state.Ink
import robotran.simulation.state.InkStroke
import robotran.ui.sheet.SheetTransform
import robotran.world.geometry.Point
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class TiledInkTest {
    private val transform = SheetTransform.fitting(100.0, 100.0, 0.0, Size(1000f, 1000f))
    private val ink = TiledInk(transform)
    private val points = List(200) { Point(it / 10.0, 10.0) }

    private fun show(vararg strokes: InkStroke): List<Rect> =
        ink.update(Ink(strokes.toList(), 0.0), hasTrail = false, emptyList())

    @Test
    fun `a little new ink needs no new tiles, and much of it those that it is on`() {
        assertEquals(emptyList(), show(InkStroke(points.take(10))))
        val area = show(InkStroke(points)).single()
        assertTrue(area.contains(transform.toPixels(points.last())))
        assertTrue(area.height < 10, "$area is higher than a line")
    }

    @Test
    fun `new ink is on its tiles after a while, also without more of it`() {
        val stroke = InkStroke(points.take(10))
        val shown = Ink(listOf(stroke), 0.0)
        val areas = (0 until 60).flatMap { ink.update(shown, hasTrail = false, emptyList()) }
        assertTrue(areas.single().contains(transform.toPixels(points[5])))
    }

    @Test
    fun `only what is new leads to new tiles`() {
        show(InkStroke(points.take(100)))
        val whole = InkStroke(points)
        assertTrue(show(whole).single().left > transform.toPixels(points[90]).x)
        val other = InkStroke(List(100) { Point(50.0, it / 10.0) })
        assertTrue(show(whole, other).all { it.left > transform.toPixels(points.last()).x })
    }

    @Test
    fun `back in time, the tiles of what was not yet drawn are drawn again`() {
        val other = InkStroke(List(100) { Point(50.0, it / 10.0) })
        show(InkStroke(points), other)
        val areas = show(InkStroke(points))
        assertTrue(areas.any { it.contains(transform.toPixels(other.points[50])) })
        assertTrue(show().any { it.contains(transform.toPixels(points[50])) })
    }
}
