package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import robotran.uikit.*
import kotlin.test.Test
import kotlin.test.assertEquals

class HatchingTest {
    private val right = Offset(1f, 0f)

    @Test
    fun `lines go from edge to edge at the same places whatever the polygon`() {
        val box = listOf(Offset(3f, 0f), Offset(23f, 0f), Offset(23f, 10f), Offset(3f, 10f))
        val ends = hatching(box, 10f, right, inset = 1f)
        assertEquals(listOf(10f, 10f, 20f, 20f), ends.map { it.x })
        assertEquals(listOf(1f, 9f, 1f, 9f), ends.map { it.y })
    }

    @Test
    fun `a dent is left free`() {
        val corners = listOf(0f to 0f, 20f to 0f, 20f to 30f, 0f to 30f, 0f to 20f, 15f to 20f, 15f to 10f, 0f to 10f)
        val notch = corners.map { (x, y) -> Offset(x, y) }
        assertEquals(
            listOf(0f, 10f, 20f, 30f),
            hatching(notch, 10f, right, inset = 0f).filter { it.x == 10f }.map { it.y },
        )
    }

    @Test
    fun `where a line would be shorter than its inset there is none`() {
        val box = listOf(Offset(0f, 0f), Offset(20f, 0f), Offset(20f, 3f), Offset(0f, 3f))
        assertEquals(emptyList(), hatching(box, 10f, right, inset = 2f))
    }
}
