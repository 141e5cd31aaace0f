package robotran.nqc

import robotran.legofirmware.image.FirmwareTarget
import robotran.nqc.api.NqcApi
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.syntax.Keyword
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class DocumentTest {
    private val text = documents.getValue("nqc.md")

    @Test
    fun `programs of the page have no mistakes`() {
        assertTrue(documentedPrograms.size > 8)
        for ((place, program) in documentedPrograms) {
            assertEquals(emptyList(), diagnosticsOf(program), place)
        }
    }

    @Test
    fun `the page lists every name with its firmware`() {
        val rows = text.lines().filter { it.startsWith("| `") }.flatMap { row ->
            val cells = row.split(" | ")
            Regex("`([^`]*)`").findAll(cells.first()).map { it.groupValues[1] to cells.getOrNull(1) }
        }.toMap()
        val first = NqcApi.of(FirmwareTarget.RCX)
        for (entry in NqcApi.of(FirmwareTarget.RCX2).values) {
            assertEquals(if (entry.name in first) "1, 2" else "2", rows[entry.signature], entry.signature)
        }
    }

    @Test
    fun `the page lists every message`() {
        for (code in NqcDiagnosticCode.entries) {
            val kind = code.severity.name.lowercase()
            val original = code.original?.replace("%s", "x") ?: "-"
            assertTrue("| `${code.id}` | $kind | $original | " in text, code.id)
        }
    }

    @Test
    fun `the page lists every word`() {
        val words = text.substringAfter("These words are no names:").substringBefore("###").replace('\n', ' ')
        for (keyword in Keyword.entries) {
            assertTrue(
                Regex("[` ]${keyword.text}[` ]").containsMatchIn(words),
                keyword.text,
            )
        }
    }
}
