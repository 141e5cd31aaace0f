package robotran.ui.program.editor

import robotran.languagesupport.TextLines
import robotran.textediting.rows.TextRows
import kotlin.test.Test
import kotlin.test.assertEquals

class EditorGeometryTest {
    private val hundred = TextRows(TextLines("\n".repeat(99)))
    private val plain = EditorGeometry(20f, hundred)
    private val noted =
        EditorGeometry(20f, hundred, listOf(NoteBounds(1, 48f), NoteBounds(1, 30f), NoteBounds(99, 48f)))

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

    @Test
    fun `a line in several rows is higher, and its note is below the last one`() {
        val broken = EditorGeometry(
            20f,
            TextRows(TextLines("beep\nforward 20 centimetres\nbeep"), columns = 16),
            listOf(NoteBounds(1, 48f)),
        )
        assertEquals(listOf(0f, 20f, 108f), (0..2).map(broken::top))
        assertEquals(40f, broken.heightOf(1))
        assertEquals(60f, broken.noteTop(0))
        assertEquals(128f, broken.height)
        assertEquals(listOf(1, 1, 1, 2), listOf(39f, 59f, 100f, 109f).map(broken::lineAt))
        assertEquals(listOf(0, 1, 1), listOf(30f, 45f, 100f).map { broken.rowAt(1, it) })
    }
}
