package robotran.build.ecj

import org.objectweb.asm.ClassReader
import org.objectweb.asm.ClassVisitor
import org.objectweb.asm.ClassWriter
import org.objectweb.asm.Label
import org.objectweb.asm.MethodVisitor
import org.objectweb.asm.Opcodes
import java.io.InputStream
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith

class EcjRewriterTest {
    private val rewriter = EcjRewriter()

    @Test
    fun `monitors and pauses leave only what takes their values away`() {
        val rewritten = rewriter.rewrite(
            classWith("Some", "work", "()V") {
                it.visitVarInsn(Opcodes.ALOAD, 0)
                it.visitInsn(Opcodes.MONITORENTER)
                it.visitLdcInsn(5L)
                it.visitMethodInsn(Opcodes.INVOKESTATIC, "java/lang/Thread", "sleep", "(J)V", false)
                it.visitVarInsn(Opcodes.ALOAD, 0)
                it.visitMethodInsn(Opcodes.INVOKEVIRTUAL, "java/lang/Object", "notifyAll", "()V", false)
                it.visitInsn(Opcodes.RETURN)
            },
        )
        assertEquals(listOf(Opcodes.POP, Opcodes.POP2, Opcodes.POP, Opcodes.RETURN), instructions(rewritten))
    }

    @Test
    fun `constants are divided with care`() {
        val rewritten = rewriter.rewrite(
            classWith("org/eclipse/jdt/internal/compiler/impl/Constant", "work", "()I") {
                it.visitInsn(Opcodes.ICONST_1)
                it.visitInsn(Opcodes.ICONST_0)
                it.visitInsn(Opcodes.IDIV)
                it.visitInsn(Opcodes.IRETURN)
            },
        )
        assertEquals(listOf(Opcodes.ICONST_1, Opcodes.ICONST_0, Opcodes.IRETURN), instructions(rewritten))
        assertContains(String(rewritten, Charsets.ISO_8859_1), "robotran/ecj/Division")
    }

    @Test
    fun `decimal numbers are read by the reader that is exact everywhere`() {
        val rewritten = rewriter.rewrite(
            classWith("Some", "work", "()V") {
                it.visitLdcInsn("0.1")
                it.visitMethodInsn(
                    Opcodes.INVOKESTATIC,
                    "java/lang/Float",
                    "valueOf",
                    "(Ljava/lang/String;)Ljava/lang/Float;",
                    false,
                )
                it.visitInsn(Opcodes.POP)
                it.visitInsn(Opcodes.RETURN)
            },
        )
        assertContains(String(rewritten, Charsets.ISO_8859_1), "robotran/ecj/DecimalReader")
    }

    @Test
    fun `a text constant beyond what a class file holds is refused`() {
        val owner = "org/eclipse/jdt/internal/compiler/impl/StringConstant"
        val descriptor = "(Ljava/lang/String;)Ljava/lang/String;"
        val rewritten = rewriter.rewrite(
            classWith(owner, "fromValue", descriptor, Opcodes.ACC_PUBLIC or Opcodes.ACC_STATIC) {
                it.visitVarInsn(Opcodes.ALOAD, 0)
                it.visitInsn(Opcodes.ARETURN)
            },
        )
        val method = loaded(owner, rewritten).getMethod("fromValue", String::class.java)
        assertEquals("short", method.invoke(null, "short"))
        assertFailsWith<ReflectiveOperationException> { method.invoke(null, "x".repeat(65_536)) }
    }

    @Test
    fun `files are read with nothing but the reading of single bytes`() {
        val owner = "org/eclipse/jdt/internal/compiler/util/Util"
        val access = Opcodes.ACC_PUBLIC or Opcodes.ACC_STATIC
        val rewritten = rewriter.rewrite(
            classWith(owner, "getInputStreamAsByteArray", "(Ljava/io/InputStream;I)[B", access) {
                it.visitInsn(Opcodes.ACONST_NULL)
                it.visitInsn(Opcodes.ARETURN)
            },
        )
        val bytes = ByteArray(20_000) { (it * it).toByte() }
        val stream = object : InputStream() {
            private var place = 0

            override fun read() = if (place < bytes.size) bytes[place++].toInt() and 0xFF else -1

            override fun read(target: ByteArray, first: Int, count: Int) = error("several bytes")
        }
        val method = loaded(
            owner,
            rewritten,
        ).getMethod("getInputStreamAsByteArray", InputStream::class.java, Int::class.java)
        assertContentEquals(bytes, method.invoke(null, stream, -1) as ByteArray)
    }

    @Test
    fun `a step of a local variable must fit a byte`() {
        val rewritten = rewriter.rewrite(
            classWith(
                "org/eclipse/jdt/internal/compiler/ast/SingleNameReference",
                "generateCompoundAssignment",
                "()I",
            ) {
                it.visitInsn(Opcodes.ICONST_1)
                it.visitInsn(Opcodes.I2S)
                it.visitInsn(Opcodes.IRETURN)
            },
        )
        assertEquals(listOf(Opcodes.ICONST_1, Opcodes.I2B, Opcodes.IRETURN), instructions(rewritten))
    }

    @Test
    fun `the calls, the rounds of a loop and what is copied are counted`() {
        val rewritten = rewriter.rewrite(
            classWith("Some", "work", "()V") {
                val round = Label()
                it.visitLabel(round)
                it.visitFrame(Opcodes.F_SAME, 0, null, 0, null)
                it.visitInsn(Opcodes.ICONST_2)
                it.visitIntInsn(Opcodes.NEWARRAY, Opcodes.T_INT)
                it.visitInsn(Opcodes.POP)
                it.visitJumpInsn(Opcodes.GOTO, round)
            },
        )
        assertEquals(listOf("step", "allocate", "step"), calls(rewritten))
    }

    @Test
    fun `the method that is compiled is noted`() {
        val rewritten = rewriter.rewrite(
            classWith("org/eclipse/jdt/internal/compiler/ast/TypeDeclaration", "resolve", "()V") {
                it.visitInsn(Opcodes.RETURN)
            },
        )
        assertEquals(listOf("step", "enter"), calls(rewritten))
    }

    @Test
    fun `methods that another version of ECJ no longer has are noticed`() {
        assertContains(rewriter.missing, "org/eclipse/jdt/internal/compiler/impl/StringConstant.fromValue")
    }

    private fun loaded(name: String, classFile: ByteArray): Class<*> = object : ClassLoader() {
        fun define() = defineClass(name.replace('/', '.'), classFile, 0, classFile.size)
    }.define()

    private fun classWith(
        owner: String,
        method: String,
        descriptor: String,
        access: Int = Opcodes.ACC_PUBLIC,
        body: (MethodVisitor) -> Unit,
    ): ByteArray {
        val writer = ClassWriter(0)
        writer.visit(Opcodes.V1_8, Opcodes.ACC_PUBLIC, owner, null, "java/lang/Object", null)
        val visitor = writer.visitMethod(access, method, descriptor, null, null)
        visitor.visitCode()
        body(visitor)
        visitor.visitMaxs(2, 2)
        visitor.visitEnd()
        writer.visitEnd()
        return writer.toByteArray()
    }

    private fun instructions(classFile: ByteArray): List<Int> {
        val found = mutableListOf<Int>()
        visitMethods(
            classFile,
            object : MethodVisitor(Opcodes.ASM9) {
                override fun visitInsn(opcode: Int) {
                    found += opcode
                }
            },
        )
        return found
    }

    /** The names of the methods that the methods of [classFile] call. */
    private fun calls(classFile: ByteArray): List<String> {
        val found = mutableListOf<String>()
        visitMethods(
            classFile,
            object : MethodVisitor(Opcodes.ASM9) {
                override fun visitMethodInsn(
                    opcode: Int,
                    owner: String,
                    name: String,
                    descriptor: String,
                    isInterface: Boolean,
                ) {
                    found += name
                }
            },
        )
        return found
    }

    private fun visitMethods(classFile: ByteArray, collector: MethodVisitor) {
        val visitor = object : ClassVisitor(Opcodes.ASM9) {
            override fun visitMethod(
                access: Int,
                name: String,
                descriptor: String,
                signature: String?,
                exceptions: Array<String>?,
            ) = collector
        }
        ClassReader(classFile).accept(visitor, 0)
    }
}
