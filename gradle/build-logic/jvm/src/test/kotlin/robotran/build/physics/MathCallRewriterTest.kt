package robotran.build.physics

import org.objectweb.asm.ClassReader
import org.objectweb.asm.ClassVisitor
import org.objectweb.asm.ClassWriter
import org.objectweb.asm.Handle
import org.objectweb.asm.MethodVisitor
import org.objectweb.asm.Opcodes
import kotlin.test.Test
import kotlin.test.assertEquals

class MathCallRewriterTest {
    private val rewriter = MathCallRewriter(setOf("sqrt"), setOf("sin"), "better/Mathematics")

    @Test
    fun `a replaced function is called elsewhere and an exact one stays`() {
        val rewritten = rewriter.rewrite(
            classCalling("java/lang/Math.sin", "java/lang/Math.sqrt", "java/lang/StrictMath.sin"),
        )
        assertEquals(
            listOf("better/Mathematics.sin", "java/lang/Math.sqrt", "better/Mathematics.sin"),
            calls(rewritten),
        )
        assertEquals(emptySet(), rewriter.unknownCalls)
    }

    @Test
    fun `functions of other classes are left alone`() {
        assertEquals(listOf("some/Where.sin"), calls(rewriter.rewrite(classCalling("some/Where.sin"))))
    }

    @Test
    fun `a function that is neither exact nor replaced is noticed`() {
        rewriter.rewrite(classCalling("java/lang/Math.sinh"))
        assertEquals(setOf("sinh in Caller"), rewriter.unknownCalls)
    }

    @Test
    fun `a function that is handed on as a reference is noticed`() {
        val reference = Handle(Opcodes.H_INVOKESTATIC, "java/lang/Math", "sin", "(D)D", false)
        val bootstrap = Handle(Opcodes.H_INVOKESTATIC, "some/Where", "link", "()V", false)
        rewriter.rewrite(callerOf { it.visitInvokeDynamicInsn("apply", "()Lsome/Function;", bootstrap, reference) })
        assertEquals(setOf("sin (as a method reference) in Caller"), rewriter.unknownCalls)
    }

    private fun classCalling(vararg functions: String): ByteArray = callerOf { method ->
        functions.forEach {
            method.visitMethodInsn(
                Opcodes.INVOKESTATIC,
                it.substringBefore('.'),
                it.substringAfter('.'),
                "(D)D",
                false,
            )
        }
    }

    private fun callerOf(body: (MethodVisitor) -> Unit): ByteArray {
        val writer = ClassWriter(0)
        writer.visit(Opcodes.V1_8, Opcodes.ACC_PUBLIC, "Caller", null, "java/lang/Object", null)
        val method = writer.visitMethod(Opcodes.ACC_STATIC, "call", "()V", null, null)
        method.visitCode()
        body(method)
        method.visitInsn(Opcodes.RETURN)
        method.visitMaxs(2, 0)
        method.visitEnd()
        writer.visitEnd()
        return writer.toByteArray()
    }

    private fun calls(classFile: ByteArray): List<String> {
        val calls = mutableListOf<String>()
        val collector =
            object : MethodVisitor(Opcodes.ASM9) {
                override fun visitMethodInsn(
                    opcode: Int,
                    owner: String,
                    name: String,
                    descriptor: String,
                    isInterface: Boolean,
                ) {
                    calls += "$owner.$name"
                }
            }
        val visitor =
            object : ClassVisitor(Opcodes.ASM9) {
                override fun visitMethod(
                    access: Int,
                    name: String,
                    descriptor: String,
                    signature: String?,
                    exceptions: Array<String>?,
                ) = collector
            }
        ClassReader(classFile).accept(visitor, 0)
        return calls
    }
}
