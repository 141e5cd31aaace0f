package robotran.robolang.python.microbit

import robotran.robolang.documentedBoardPrograms
import robotran.robolang.documentedBoardPython
import robotran.robolang.documentedPrograms
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** The Python for a micro:bit in a document is part of the translation of the program above it for a Cutebot. */
class DocumentedBoardPythonTest {
    private val programs = documentedPrograms + documentedBoardPrograms

    @Test
    fun `documented Python for a micro-bit is what the program above it becomes`() {
        assertTrue(documentedBoardPython.size >= 5, "only ${documentedBoardPython.size} pieces of Python were found")
        for ((place, python) in documentedBoardPython) {
            val program = programs.keys.filter { fileOf(it) == fileOf(place) && lineOf(it) < lineOf(place) }
                .maxBy(::lineOf)
            val lines = boardPythonOf(programs.getValue(program)).python.lines()
            val shown = python.trimEnd().lines()
            val first = lines.indexOf(shown.first()).coerceAtLeast(0)
            assertEquals(shown, lines.drop(first).take(shown.size), place)
        }
    }

    private fun fileOf(place: String): String = place.substringBeforeLast(':')

    private fun lineOf(place: String): Int = place.substringAfterLast(':').toInt()
}
