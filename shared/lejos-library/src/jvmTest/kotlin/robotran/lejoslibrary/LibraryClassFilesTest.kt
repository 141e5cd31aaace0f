package robotran.lejoslibrary

import kotlin.test.Test
import kotlin.test.assertEquals

class LibraryClassFilesTest {
    private val classes = libraryClassFiles

    @Test
    fun `the library keeps to what a TinyVM accepts`() {
        assertEquals(
            emptyList(),
            classes.flatMap { javaClass ->
                refusedInstructions(javaClass).map { "${javaClass.className}: $it" }
            },
        )
    }

    @Test
    fun `the table of native methods names all of them`() {
        val natives = classes.flatMap { javaClass ->
            javaClass.methods.filter { it.isNative }.map { method ->
                val isStatic = if (method.isStatic) "yes" else "no"
                "| `${javaClass.className.replace('.', '/')}` | `${method.name}` | `${method.signature}` | $isStatic |"
            }
        }
        val documented = documentedNatives.values.single().lines().filter { it.startsWith("| `j") }.map {
            it.substringBeforeLast(" |").substringBeforeLast("|") +
                "|"
        }
        assertEquals(natives.toSet(), documented.toSet())
    }
}
