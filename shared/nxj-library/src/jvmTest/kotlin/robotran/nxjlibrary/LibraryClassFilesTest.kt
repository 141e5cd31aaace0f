package robotran.nxjlibrary

import kotlin.test.Test
import kotlin.test.assertEquals

class LibraryClassFilesTest {
    @Test
    fun `the table of native methods names all of them`() {
        val natives = libraryClasses.flatMap { type ->
            type.methods.filter { it.isNative }.map { method ->
                val isStatic = if (method.isStatic) "yes" else "no"
                "| `${type.className.replace('.', '/')}` | `${method.name}` | `${method.signature}` | $isStatic |"
            }
        }
        val documented = documentedNatives.values.single().lines().mapNotNull { ROW.find(it)?.value }
        assertEquals(natives.sorted(), documented.sorted())
    }

    @Test
    fun `the machine finds the fields that it knows where it looks for them`() {
        val expected = mapOf(
            "java.lang.String" to listOf("[C"),
            "java.lang.Class" to listOf("I"),
            "java.lang.Throwable" to listOf("Ljava/lang/String;", "Ljava/lang/Throwable;", "[I"),
            "lejos.nxt.NXTEvent" to listOf("Ljava/lang/Object;", "I", "I", "I", "I"),
        )
        val found = expected.mapValues { (name, wanted) ->
            fields(name).filterNot { it.isStatic }.map { it.signature }.take(wanted.size)
        }
        assertEquals(expected, found)
        assertEquals(1, fields("java.lang.String").count { !it.isStatic })
        val ofThread = fields("java.lang.Thread").filterNot { it.isStatic }.map { it.signature }.take(12)
        assertEquals(List(4) { "I" } + List(7) { "B" }, ofThread.drop(1))
    }

    @Test
    fun `threads, texts and natives of motors need no initialiser`() {
        for (name in listOf("java.lang.Thread", "lejos.nxt.MotorRegulation")) {
            assertEquals(
                0,
                libraryClasses.single { it.className == name }.methods.count { it.name == "<clinit>" },
                name,
            )
        }
    }

    private fun fields(name: String) = libraryClasses.single { it.className == name }.fields

    private companion object {
        val ROW = Regex("""^\| `[jl][\w/]*` \| `\w+` \| `\(\S*` \| (?:yes|no) \|""")
    }
}
