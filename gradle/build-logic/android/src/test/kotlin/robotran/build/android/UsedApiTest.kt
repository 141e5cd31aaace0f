package robotran.build.android

import org.objectweb.asm.ClassWriter
import org.objectweb.asm.Opcodes
import kotlin.test.Test
import kotlin.test.assertEquals

class UsedApiTest {
    private val api = UsedApi().apply {
        declare(classFile("java/lang/Object", null, method = "hashCode"))
        declare(classFile("java/util/List", "java/lang/Object", method = "size"))
    }

    @Test
    fun `what a class or the framework has is there, inherited or not`() {
        api.declareAndRead(
            classFile(
                "Own",
                "java/util/List",
                "go",
                calls = listOf(
                    "Own" to "size",
                    "java/util/List" to "hashCode",
                    "[I" to "clone",
                ),
            ),
        )
        assertEquals(emptyList(), api.missing())
    }

    @Test
    fun `classes and methods that are not there are named with who uses them`() {
        api.declareAndRead(classFile("Own", "javax/tools/Tool", "go", calls = listOf("java/util/List" to "reversed")))
        val missing = api.missing().map { it.toString() }
        assertEquals(listOf("java/util/List.reversed()V, used by Own.go", "javax/tools/Tool, used by Own"), missing)
    }

    @Test
    fun `what R8 has taken out of a method counts as used by that method`() {
        api.declare("Outline", listOf("java/lang/Object"), setOf("m()V"))
        api.use("java/util/List", "getFirst()V", from = "Outline.m()V")
        api.use("Outline", "m()V", from = "Own.go()V")
        assertEquals(
            listOf("java/util/List.getFirst()V, used by Own.go()V"),
            api.missing { it == "Outline" }.map { it.toString() },
        )
    }

    private fun classFile(
        name: String,
        above: String?,
        method: String,
        calls: List<Pair<String, String>> = emptyList(),
    ): ByteArray {
        val writer = ClassWriter(0)
        writer.visit(Opcodes.V1_8, Opcodes.ACC_PUBLIC, name, null, above, null)
        val code = writer.visitMethod(Opcodes.ACC_PUBLIC, method, "()V", null, null)
        code.visitCode()
        calls.forEach { (owner, called) -> code.visitMethodInsn(Opcodes.INVOKESTATIC, owner, called, "()V", false) }
        code.visitInsn(Opcodes.RETURN)
        code.visitMaxs(0, 1)
        code.visitEnd()
        writer.visitEnd()
        return writer.toByteArray()
    }
}
