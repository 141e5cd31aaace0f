package robotran.robolang.translate

import robotran.robolang.documentedPrograms
import robotran.robolang.documentedTranslations
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** The Java in a document is part of the translation of the program above it. */
class DocumentedTranslationTest {
    @Test
    fun `documented Java is what the program above it becomes`() {
        assertTrue(documentedTranslations.size >= 3, "only ${documentedTranslations.size} pieces of Java were found")
        for ((place, java) in documentedTranslations) {
            val program = documentedPrograms.keys.filter {
                fileOf(it) == fileOf(place) && lineOf(it) < lineOf(place)
            }.maxBy(::lineOf)
            val lines = javaLinesOf(documentedPrograms.getValue(program))
            val shown = java.trimEnd().lines().map { it.trim() }
            val first = lines.indexOf(shown.first()).coerceAtLeast(0)
            assertEquals(shown, lines.drop(first).take(shown.size), place)
        }
    }

    private fun fileOf(place: String): String = place.substringBeforeLast(':')

    private fun lineOf(place: String): Int = place.substringAfterLast(':').toInt()
}
