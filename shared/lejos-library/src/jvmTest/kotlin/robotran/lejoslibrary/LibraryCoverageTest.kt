package robotran.lejoslibrary

import kotlin.test.Test
import kotlin.test.assertEquals

/** Nothing of the library is without a program that shows what it does. */
class LibraryCoverageTest {
    private val programs = testPrograms + examplePrograms.mapKeys { "examples/${it.key}" }
    private val publicClasses = libraryClassFiles.filter { it.isPublic && '$' !in it.className }

    @Test
    fun `every public method and constructor is called by a program`() {
        val used = LibraryUse(BrickCompiler.compile(programs).classes).members
        val callable = publicClasses.flatMap { type ->
            val methods = type.methods.filter { it.isPublic || (it.isProtected && !type.isFinal) }
            methods.map { "${type.className}.${it.name}${it.signature}" }
        }
        assertEquals("", (callable - used).sorted().joinToString("\n"))
    }

    @Test
    fun `every public class is named by a program`() {
        val words = programs.values.flatMap { Regex("""\w+""").findAll(it).map { word -> word.value } }.toSet()
        assertEquals(emptyList(), publicClasses.map { it.className.substringAfterLast('.') }.filter { it !in words })
    }
}
