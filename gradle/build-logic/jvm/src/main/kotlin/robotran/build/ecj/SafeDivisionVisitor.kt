package robotran.build.ecj

import org.objectweb.asm.MethodVisitor
import org.objectweb.asm.Opcodes

/** Delegates divisions to `Division.java`. */
internal class SafeDivisionVisitor(target: MethodVisitor) : MethodVisitor(Opcodes.ASM9, target) {
    override fun visitInsn(opcode: Int) = when (opcode) {
        Opcodes.IDIV -> divide("quotient", "(II)I")
        Opcodes.LDIV -> divide("quotient", "(JJ)J")
        Opcodes.IREM -> divide("remainder", "(II)I")
        Opcodes.LREM -> divide("remainder", "(JJ)J")
        Opcodes.FREM -> divide("remainder", "(FF)F")
        Opcodes.DREM -> divide("remainder", "(DD)D")
        else -> super.visitInsn(opcode)
    }

    private fun divide(method: String, descriptor: String) =
        visitMethodInsn(Opcodes.INVOKESTATIC, "robotran/ecj/Division", method, descriptor, false)
}
