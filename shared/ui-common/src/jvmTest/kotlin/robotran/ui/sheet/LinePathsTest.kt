package robotran.ui.sheet

import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import robotran.world.geometry.Point
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNotNull
import kotlin.test.assertNotSame
import kotlin.test.assertNull
import kotlin.test.assertSame
import kotlin.test.assertTrue

class LinePathsTest {
    private val transform = SheetTransform.fitting(100.0, 100.0, 0.0, Size(1000f, 1000f))
    private val points = List(1000) { Point(it / 10.0, (it % 7).toDouble()) }

    @Test
    fun `of a line that grows only the last piece is made anew`() {
        val line = LinePaths(transform).apply { show(points.take(450)) }
        val before = line.pieces
        assertEquals(3, before.size)
        assertTrue(line.continues(points.take(900)))
        line.show(points.take(900))
        assertEquals(5, line.pieces.size)
        assertSame(before[0].outline, line.pieces[0].outline)
        assertSame(before[1].outline, line.pieces[1].outline)
        assertNotSame(before[2].outline, line.pieces[2].outline)
    }

    @Test
    fun `a line is the same whether it grew or not`() {
        val grown = LinePaths(transform)
        for (count in 2..1000 step 3) grown.show(points.take(count))
        grown.show(points)
        val whole = LinePaths(transform).apply { show(points) }
        assertEquals(whole.pieces.map { it.outline.path.getBounds() }, grown.pieces.map { it.outline.path.getBounds() })
    }

    @Test
    fun `another line does not go on from the one before`() {
        val line = LinePaths(transform).apply { show(points.take(450)) }
        val other = points.map { it.copy() }
        assertFalse(line.continues(other))
        line.show(other.take(2))
        assertEquals(1, line.pieces.size)
    }

    @Test
    fun `a single point is a dot`() {
        val line = LinePaths(transform).apply { show(points.take(1)) }
        assertEquals(transform.toPixels(points.first()), assertNotNull(line.dot))
        line.show(points.take(2))
        assertNull(line.dot)
    }

    @Test
    fun `a piece that is out of sight is known`() {
        val piece = LinePaths(transform).apply { show(points.take(10)) }.pieces.single()
        assertTrue(piece.isIn(Rect(0f, 900f, 100f, 1000f), 3f))
        assertFalse(piece.isIn(Rect(500f, 0f, 600f, 100f), 3f))
    }
}
