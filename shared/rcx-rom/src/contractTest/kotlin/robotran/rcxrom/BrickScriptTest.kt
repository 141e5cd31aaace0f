package robotran.rcxrom

import robotran.rcxrom.call.RomTable
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class BrickScriptTest {
    private val calls = Regex("""^call (0x[0-9a-f]+)(?: (0x[0-9a-f]+))?""", RegexOption.MULTILINE)
        .findAll(brickScripts.values.joinToString("\n")).map { it.destructured.toList() }.toList()

    @Test
    fun `the brick does what every script says`() {
        assertTrue(brickScripts.size >= 20, "only ${brickScripts.size} scripts were found")
        assertEquals(
            "",
            brickScripts.flatMap { (path, text) ->
                BrickScript(path, text).differences()
            }.joinToString("\n"),
        )
    }

    @Test
    fun `every routine of the table is called by a script`() {
        val called = calls.map { it.first().drop(2).toInt(radix = 16) }.toSet()
        assertEquals(emptyList(), RomTable.signatures.filter { it.address !in called }.map { it.name })
    }

    @Test
    fun `every segment code is shown and hidden by a script`() {
        val codes = (0x3006..0x301D).toSet() - 0x3017 + 0x3020
        for (routine in listOf("0x1b62", "0x1e4a")) {
            val called = calls.filter { it[0] == routine }.map { it[1].drop(2).toInt(radix = 16) }.toSet()
            assertEquals(emptySet(), codes - called, routine)
        }
    }
}
