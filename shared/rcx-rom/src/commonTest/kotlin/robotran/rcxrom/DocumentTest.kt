package robotran.rcxrom

import robotran.rcxrom.call.RomCallText
import robotran.rcxrom.call.RomGap
import robotran.rcxrom.call.RomTable
import robotran.rcxrom.memory.MemoryRegion
import robotran.rcxrom.sensors.RomAssumptions
import kotlin.test.Test
import kotlin.test.assertEquals

/** `docs/rcx.md` agrees with the code. */
class DocumentTest {
    private val rows = documents.getValue("rcx.md").lines().filter { it.startsWith("| ") }
        .map { row -> row.trim('|').split('|').map { it.trim().trim('`') } }

    private fun tableOf(columns: Int, isRow: (List<String>) -> Boolean) = rows.filter {
        it.size == columns && isRow(it)
    }

    @Test
    fun `its table has every routine by its name and whether it is there`() {
        val written = tableOf(columns = 5) { it[0].startsWith("0x") }.map { Triple(it[0], it[1], it[3]) }
        val known = RomTable.signatures.map {
            Triple(
                RomCallText.hexadecimal(it.address),
                it.name,
                it.gap?.let { gap -> "not modelled: ${gap.reason}" } ?: "modelled",
            )
        }
        assertEquals(known.sortedBy { it.first }, written)
    }

    @Test
    fun `it names every gap with its reason`() {
        val written = tableOf(columns = 3) { row -> RomGap.entries.any { it.name == row[0] } }.map { it[0] to it[2] }
        assertEquals(RomGap.entries.map { it.name to it.reason }, written)
    }

    @Test
    fun `it names every region of the memory`() {
        val written = tableOf(columns = 2) { ".." in it[1] }.map { it[0] to it[1] }
        val known = MemoryRegion.entries.map {
            it.name to "${RomCallText.hexadecimal(it.addresses.first)}..${RomCallText.hexadecimal(it.addresses.last)}"
        }
        assertEquals(known, written)
    }

    @Test
    fun `it has the constants that were decided`() {
        val decided = mapOf(
            "EDGE_DEBOUNCE_READINGS" to RomAssumptions.EDGE_DEBOUNCE_READINGS.toString(),
            "FALSE_FROM" to RomAssumptions.FALSE_FROM.toString(),
            "ANGLE_STATES" to RomCallText.hexadecimal(RomAssumptions.ANGLE_STATES),
        )
        val written = tableOf(columns = 4) { it[0].matches(Regex("[A-Z_]+")) }.associate { it[0] to it[1] }
        assertEquals(decided, written)
    }
}
