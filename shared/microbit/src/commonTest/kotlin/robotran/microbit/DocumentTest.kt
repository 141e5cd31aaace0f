package robotran.microbit

import robotran.microbit.program.MicrobitNative
import kotlin.test.Test
import kotlin.test.assertEquals

class DocumentTest {
    @Test
    fun `the page lists all calls`() {
        val rows = documents.getValue("microbit.md").lines().mapNotNull { line ->
            ROW.matchEntire(line)?.let { "${it.groupValues[1]} ${it.groupValues[2]}" }
        }
        assertEquals(MicrobitNative.entries.map { "${it.id} ${it.name}" }, rows)
    }

    private companion object {
        val ROW = Regex("""\| ([0-9]+) \| `([A-Z0-9_]+)` \|.*""")
    }
}
