package robotran.robolang.python

import robotran.robolang.documentedPrograms
import robotran.robolang.documentedPython
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** The Python in a document is part of the translation of the program above it. */
class DocumentedPythonTest {
    @Test
    fun `documented Python is what the program above it becomes`() {
        assertTrue(documentedPython.size >= 5, "only ${documentedPython.size} pieces of Python were found")
        for ((place, python) in documentedPython) {
            val program = documentedPrograms.keys.filter { fileOf(it) == fileOf(place) && lineOf(it) < lineOf(place) }
                .maxBy(::lineOf)
            val lines = pythonLinesOf(documentedPrograms.getValue(program))
            val shown = python.trimEnd().lines()
            val first = lines.indexOf(shown.first()).coerceAtLeast(0)
            assertEquals(shown, lines.drop(first).take(shown.size), place)
        }
    }

    private fun fileOf(place: String): String = place.substringBeforeLast(':')

    private fun lineOf(place: String): Int = place.substringAfterLast(':').toInt()
}
