package robotran.ui.program.editor

import kotlin.test.Test
import kotlin.test.assertEquals

class EditorGeometryTest {
    private val plain = EditorGeometry(20f, 100)
    private val noted = EditorGeometry(20f, 100, listOf(NoteBounds(1, 48f), NoteBounds(1, 30f), NoteBounds(99, 48f)))

    @Test
    fun `lines without notes lie one below the other`() {
        assertEquals(2_000f, plain.height)
        assertEquals(40f, plain.top(2))
        assertEquals(2, plain.lineAt(41f))
    }

    @Test
    fun `notes push the lines below them down`() {
        assertEquals(2_126f, noted.height)
        assertEquals(20f, noted.top(1))
        assertEquals(118f, noted.top(2))
        assertEquals(listOf(40f, 88f, 2_078f), noted.notes.indices.map(noted::noteTop))
    }

    @Test
    fun `every place belongs to the line it is in, or to the line of its note`() {
        assertEquals(
            listOf(0, 1, 1, 1, 2, 99, 99),
            listOf(-5f, 25f, 41f, 117f, 119f, 2_060f, 9_999f).map(noted::lineAt),
        )
    }
}
