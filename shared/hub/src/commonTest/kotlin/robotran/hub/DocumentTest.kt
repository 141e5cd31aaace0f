package robotran.hub

import robotran.hub.program.HubNative
import kotlin.test.Test
import kotlin.test.assertEquals

/** `docs/hubs.md` agrees with the code. */
class DocumentTest {
    @Test
    fun `its table has every call with its id and group`() {
        val rows = documents.getValue("hubs.md").lines().filter { it.startsWith("| ") }
            .map { row -> row.trim('|').split('|').map { it.trim().trim('`') } }
        val written = rows.filter { it.size == 4 && it[0].toIntOrNull() != null }.map { it[0] to it[3] }
        assertEquals(HubNative.entries.map { "${it.id}" to it.group.name.lowercase() }, written)
    }
}
