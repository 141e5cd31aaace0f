package robotran.build.ecj

import org.objectweb.asm.Label
import org.objectweb.asm.MethodVisitor
import org.objectweb.asm.Opcodes

/**
 * Reads a stream, the method's first parameter, byte by byte into a `ByteArrayOutputStream`. The stream of a TeaVM
 * resource loses bytes if it reads to an array offset other than 0.
 */
internal class ByteWiseReadVisitor(private val target: MethodVisitor) : MethodVisitor(Opcodes.ASM9) {
    override fun visitCode() {
        val next = Label()
        val end = Label()
        target.visitCode()
        target.visitTypeInsn(Opcodes.NEW, BYTES)
        target.visitInsn(Opcodes.DUP)
        target.visitMethodInsn(Opcodes.INVOKESPECIAL, BYTES, "<init>", "()V", false)
        target.visitVarInsn(Opcodes.ASTORE, READ_BYTES)
        target.visitLabel(next)
        target.visitFrame(Opcodes.F_APPEND, 1, arrayOf(BYTES), 0, null)
        target.visitVarInsn(Opcodes.ALOAD, 0)
        target.visitMethodInsn(Opcodes.INVOKEVIRTUAL, "java/io/InputStream", "read", "()I", false)
        target.visitInsn(Opcodes.DUP)
        target.visitJumpInsn(Opcodes.IFLT, end)
        target.visitVarInsn(Opcodes.ALOAD, READ_BYTES)
        target.visitInsn(Opcodes.SWAP)
        target.visitMethodInsn(Opcodes.INVOKEVIRTUAL, BYTES, "write", "(I)V", false)
        target.visitJumpInsn(Opcodes.GOTO, next)
        target.visitLabel(end)
        target.visitFrame(Opcodes.F_SAME1, 0, null, 1, arrayOf<Any>(Opcodes.INTEGER))
        target.visitInsn(Opcodes.POP)
        target.visitVarInsn(Opcodes.ALOAD, READ_BYTES)
        target.visitMethodInsn(Opcodes.INVOKEVIRTUAL, BYTES, "toByteArray", "()[B", false)
        target.visitInsn(Opcodes.ARETURN)
        target.visitMaxs(2, READ_BYTES + 1)
        target.visitEnd()
    }

    private companion object {
        const val BYTES = "java/io/ByteArrayOutputStream"

        /** The local variable after the method's two parameters. */
        const val READ_BYTES = 2
    }
}
