package robotran.lejoslibrary

import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Holds the tables of classes and the programs in docs/lejos.md against the library. */
class LejosDocumentTest {
    private val rows = lejosDocument.getValue(
        "lejos.md",
    ).substringAfter("\n## The classes\n").substringBefore("\n## ").lines()
        .filter { it.startsWith("| `") }
    private val superclasses = libraryClassFiles.associate {
        it.className.replace('.', '/') to
            it.superclassName.replace('.', '/')
    }

    @Test
    fun `the tables have every class with its help and its methods, and no other`() {
        val (exceptions, others) = libraryHelp.keys.partition(::isThrowable)
        val expected = others.map(::rowOfClass) + exceptions.map(::rowOfException)
        assertEquals("", (expected - rows.toSet()).joinToString("\n"))
        assertEquals(expected.sorted(), rows.sorted())
    }

    @Test
    fun `the documented programs compile`() {
        val programs = documentedPrograms.map { (place, text) -> fileOf(place, text) to text }.toMap()
        assertTrue(programs.size >= 8, "only ${programs.size} programs were found")
        assertEquals(emptyMap(), BrickCompiler.compile(programs).diagnostics)
    }

    private fun isThrowable(name: String): Boolean =
        name == "java/lang/Throwable" || (name != "java/lang/Object" && isThrowable(superclasses.getValue(name)))

    private fun rowOfException(name: String) =
        "| `${name.substringAfterLast('/')}` | ${libraryHelp.getValue(name).ofClass} |"

    private fun rowOfClass(name: String): String {
        val help = libraryHelp.getValue(name)
        val uses = if (help.uses.size > MAX_USES) listOf(help.uses.first(), "...", help.uses.last()) else help.uses
        return "| `${name.substringAfterLast('/')}` | ${help.ofClass} | " +
            "${uses.joinToString { if (it == "...") it else "`$it`" }} |"
    }

    /** Each program in a folder of its own, since the document has one after the other. */
    private fun fileOf(place: String, text: String) =
        "${place.substringAfterLast(':')}/${Regex("public class (\\w+)").find(text)?.groupValues?.get(1)}.java"

    private companion object {
        /** The list of the constants of LEGO's protocol would fill a page. */
        const val MAX_USES = 60
    }
}
