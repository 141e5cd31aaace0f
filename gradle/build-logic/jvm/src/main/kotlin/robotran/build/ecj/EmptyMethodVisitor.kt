package robotran.build.ecj

import org.objectweb.asm.MethodVisitor
import org.objectweb.asm.Opcodes
import org.objectweb.asm.Type

/** Empties a method; it returns null if it has a result. */
internal class EmptyMethodVisitor(
    private val target: MethodVisitor,
    private val parameters: Int,
    private val result: Type,
) : MethodVisitor(Opcodes.ASM9) {
    override fun visitCode() {
        target.visitCode()
        if (result == Type.VOID_TYPE) {
            target.visitInsn(Opcodes.RETURN)
        } else {
            target.visitInsn(Opcodes.ACONST_NULL)
            target.visitInsn(Opcodes.ARETURN)
        }
        target.visitMaxs(1, parameters)
        target.visitEnd()
    }
}
