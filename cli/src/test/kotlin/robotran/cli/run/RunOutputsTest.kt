package robotran.cli.run

import robotran.cli.CommandTest
import kotlin.io.path.readText
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertNotEquals
import kotlin.test.assertTrue

class RunOutputsTest : CommandTest() {
    private fun run(vararg arguments: String) = commandLine.execute(listOf("run", square) + arguments)

    @Test
    fun `the ROM log can be cut down to groups`() {
        assertEquals(0, run("--rom-log", "-", "--rom-log-only", "sound,motors"))
        val lines = console.said.single().lines()
        assertTrue(lines.any { "motor A forward 3" in it } && lines.any { "queue system sound" in it })
        assertTrue(lines.none { "LCD" in it })
    }

    @Test
    fun `a group that there is none of is refused with those there are`() {
        assertEquals(2, run("--rom-log", "-", "--rom-log-only", "music"))
        assertContains(console.complaints.single(), "music")
    }

    @Test
    fun `a ROM log in a csv file is a table`() {
        val file = folder.resolve("log.csv")
        assertEquals(0, run("--rom-log", "$file", "--rom-log-only", "motors"))
        val rows = file.readText().trimEnd().lines()
        assertEquals("milliseconds,group,address,arguments,meaning,line,outcome", rows.first().trim())
        assertTrue(rows.drop(1).all { it.split(',')[1] == "motors" })
        assertNotEquals(1, rows.size)
    }

    @Test
    fun `the memory is listed region by region without its empty rows`() {
        assertEquals(0, run("--memory", "-"))
        val lines = console.said.single().lines()
        assertEquals("0000-7fff rom", lines.first())
        assertContains(lines, "ef3e-ef4f display")
        assertContains(lines, "f000-f000 motor latch")
        assertTrue(lines.size < 200, "${lines.size} lines")
        assertTrue(lines.any { it.startsWith("  ef40 ") })
        assertTrue(lines.zipWithNext().none { (one, next) -> one == "  *" && next == "  *" })
    }
}
