package robotran.lejoslibrary

import org.apache.bcel.classfile.JavaClass
import org.apache.bcel.classfile.Method
import robotran.tinyvm.link.SpecialNumbers
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Holds the library against what the firmware of a real brick expects of it. */
class FirmwareTest {
    private val natives: List<Pair<JavaClass, Method>> = libraryClassFiles.flatMap { type ->
        type.methods.filter { it.isNative }.map { type to it }
    }

    private val Method.text: String get() = name + signature

    private fun classNamed(name: String): JavaClass = libraryClassFiles.single { it.className == name }

    private fun fieldsOf(name: String): List<String> =
        classNamed(name).fields.filter { !it.isStatic }.map { it.signature }

    @Test
    fun `the firmware implements every native method`() {
        val unknown = natives.filter { (_, method) -> method.text !in FirmwareTables.NATIVE_METHODS }
        assertEquals(emptyList(), unknown.map { (type, method) -> "${type.className}.${method.text}" })
        assertTrue(natives.size > 40, "only ${natives.size} native methods were found")
    }

    @Test
    fun `native methods whose arguments the firmware reads from the beginning are static`() {
        val shifted = natives.filter { (_, method) ->
            method.text in FirmwareTables.ARGUMENTS_FROM_THE_BEGINNING && !method.isStatic
        }
        assertEquals(emptyList(), shifted.map { (type, method) -> "${type.className}.${method.text}" })
    }

    @Test
    fun `all classes with fixed numbers are there`() {
        val names = libraryClassFiles.map { it.className }.toSet()
        assertEquals(emptyList(), SpecialNumbers.CLASSES.map { it.replace('/', '.') }.filter { it !in names })
    }

    @Test
    fun `an object begins with the fields of its own class`() {
        assertEquals(emptyList(), fieldsOf("java.lang.Object"))
        for (name in listOf("java.lang.Thread", "java.lang.String", "josx.platform.rcx.Poll")) {
            assertEquals("java.lang.Object", classNamed(name).superclassName, name)
        }
    }

    @Test
    fun `a thread begins with the firmware's own data`() {
        val wanted = FirmwareTables.THREAD_FIELDS
        assertEquals(wanted, fieldsOf("java.lang.Thread").take(wanted.size))
        assertEquals(27, wanted.sumOf { if (it == "B") 1 else 4 })
    }

    @Test
    fun `a thread reads its state where the firmware keeps it`() {
        val thread = classNamed("java.lang.Thread")
        val state = thread.fields.filter { !it.isStatic }[FirmwareTables.THREAD_STATE]
        val code = thread.methods.single { it.name == "isAlive" }.code.toString(true)
        assertTrue("java.lang.Thread.${state.name} B" in code, code)
    }

    @Test
    fun `the firmware prepares the thread of main without any code of its class`() {
        assertEquals(emptyList(), classNamed("java.lang.Thread").methods.filter { it.name == "<clinit>" })
    }

    @Test
    fun `strings and the poller begin with what the firmware writes into`() {
        assertEquals("[C", fieldsOf("java.lang.String").first())
        assertEquals("S", fieldsOf("josx.platform.rcx.Poll").first())
    }
}
