package robotran.nxt

import robotran.nxt.program.NxtNative
import kotlin.test.Test
import kotlin.test.assertEquals

/** `docs/nxt.md` agrees with the code. */
class DocumentTest {
    private val rows = documents.getValue("nxt.md").lines().filter { it.startsWith("| ") }
        .map { row -> row.trim('|').split('|').map { it.trim().trim('`') } }

    @Test
    fun `its table has every call with its id and group`() {
        val written = rows.filter { it.size == 4 && it[0].toIntOrNull() != null }.map { Triple(it[0], it[1], it[3]) }
        val known = NxtNative.entries.map { Triple("${it.id}", it.nativeName, it.group.name.lowercase()) }
        assertEquals(known, written)
    }

    @Test
    fun `its table names as many arguments as a call has`() {
        val counts = rows.filter { it.size == 4 && it[0].toIntOrNull() != null }
            .associate { row -> row[1] to row[2].split(';').count { it.isNotBlank() } }
        val compound = setOf(NxtNative.BIT_BLT)
        for (native in NxtNative.entries - compound) {
            val besideNumbers = if (native in WITH_TEXT_OR_BYTES) 1 else 0
            assertEquals(native.parameters + besideNumbers, counts[native.nativeName], native.nativeName)
        }
    }

    private companion object {
        val WITH_TEXT_OR_BYTES = setOf(
            NxtNative.I2C_START,
            NxtNative.DRAW_STRING,
            NxtNative.PLAY_QUEUED_SAMPLE,
            NxtNative.OPEN,
            NxtNative.OPEN_CABLE,
            NxtNative.WRITE,
            NxtNative.CONSOLE_LINE,
            NxtNative.FLASH_WRITE_PAGE,
        )
    }
}
