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

    @Test
    fun `queue and stack announce that they can be empty`() {
        val announced = listOf("java.util.Queue", "java.util.Stack").flatMap { name ->
            classes.single { it.className == name }.methods.mapNotNull { method ->
                method.exceptionTable?.let { "$name.${method.name}: ${it.exceptionNames.joinToString()}" }
            }
        }
        assertEquals(
            setOf(
                "java.util.Queue.pop: java.util.EmptyQueueException",
                "java.util.Queue.peek: java.util.EmptyQueueException",
                "java.util.Stack.pop: java.util.EmptyStackException",
                "java.util.Stack.peek: java.util.EmptyStackException",
            ),
            announced.toSet(),
        )
    }

    @Test
    fun `no method of the library locks where a brick would not`() {
        val unlocked = classes.flatMap { type ->
            type.methods.filter { it.isSynchronized && (it.isStatic || it.isPrivate || it.name == "<init>") }
                .map { "${type.className}.${it.name}" }
        }
        assertEquals(emptyList(), unlocked)
    }
}
