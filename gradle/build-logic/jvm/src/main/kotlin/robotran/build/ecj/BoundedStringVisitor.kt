package robotran.build.ecj

import org.objectweb.asm.Label
import org.objectweb.asm.MethodVisitor
import org.objectweb.asm.Opcodes

/** Rejects strings over the class file limit, so that repeated doubling in a source cannot exhaust the memory. */
internal class BoundedStringVisitor(target: MethodVisitor) : MethodVisitor(Opcodes.ASM9, target) {
    override fun visitCode() {
        super.visitCode()
        val shortEnough = Label()
        visitVarInsn(Opcodes.ALOAD, 0)
        visitMethodInsn(Opcodes.INVOKEVIRTUAL, "java/lang/String", "length", "()I", false)
        visitLdcInsn(MAX_STRING_LENGTH)
        visitJumpInsn(Opcodes.IF_ICMPLE, shortEnough)
        visitTypeInsn(Opcodes.NEW, "java/lang/IllegalStateException")
        visitInsn(Opcodes.DUP)
        visitMethodInsn(Opcodes.INVOKESPECIAL, "java/lang/IllegalStateException", "<init>", "()V", false)
        visitInsn(Opcodes.ATHROW)
        visitLabel(shortEnough)
        visitFrame(Opcodes.F_SAME, 0, null, 0, null)
    }

    override fun visitMaxs(maxStack: Int, maxLocals: Int) = super.visitMaxs(maxOf(maxStack, 2), maxLocals)

    private companion object {
        /** A class file stores the length of a string in 16 bits. */
        const val MAX_STRING_LENGTH = 65_535
    }
}
