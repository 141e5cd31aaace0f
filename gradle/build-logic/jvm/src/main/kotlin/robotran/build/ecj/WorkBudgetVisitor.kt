package robotran.build.ecj

import org.objectweb.asm.Label
import org.objectweb.asm.MethodVisitor
import org.objectweb.asm.Opcodes

/**
 * Counts the work of a method with `WorkBudget.java`: each call, each round of a loop, and what it copies or allocates.
 * The count ends a compilation that would take too long, after the same work on every platform.
 *
 * @param isPlace whether the method compiles the method or class that it belongs to, which then is where the work is.
 */
internal class WorkBudgetVisitor(target: MethodVisitor, private val isPlace: Boolean) :
    MethodVisitor(Opcodes.ASM9, target) {
    private val passed = mutableSetOf<Label>()

    override fun visitCode() {
        super.visitCode()
        count("step", "()V")
        if (isPlace) {
            super.visitVarInsn(Opcodes.ALOAD, 0)
            count("enter", "(Ljava/lang/Object;)V")
        }
    }

    override fun visitLabel(label: Label) {
        passed += label
        super.visitLabel(label)
    }

    override fun visitJumpInsn(opcode: Int, label: Label) {
        if (label in passed) count("step", "()V")
        super.visitJumpInsn(opcode, label)
    }

    override fun visitIntInsn(opcode: Int, operand: Int) {
        if (opcode == Opcodes.NEWARRAY) countTop("allocate", "(I)V")
        super.visitIntInsn(opcode, operand)
    }

    override fun visitTypeInsn(opcode: Int, type: String) {
        if (opcode == Opcodes.ANEWARRAY) countTop("allocate", "(I)V")
        super.visitTypeInsn(opcode, type)
    }

    override fun visitMethodInsn(opcode: Int, owner: String, name: String, descriptor: String, isInterface: Boolean) {
        val builds = owner in BUILDERS
        when {
            owner == "java/lang/System" && name == "arraycopy" -> count(name, descriptor)

            builds && name == "append" && descriptor.substringBefore(')') in TEXTS -> {
                countTop("text", descriptor.substringBefore(')') + ")V")
                super.visitMethodInsn(opcode, owner, name, descriptor, isInterface)
            }

            builds && name == "toString" -> {
                super.visitMethodInsn(opcode, owner, name, descriptor, isInterface)
                countTop("text", "(Ljava/lang/String;)V")
            }

            else -> super.visitMethodInsn(opcode, owner, name, descriptor, isInterface)
        }
    }

    override fun visitMaxs(maxStack: Int, maxLocals: Int) = super.visitMaxs(maxStack + 1, maxLocals)

    private fun count(method: String, descriptor: String) =
        super.visitMethodInsn(Opcodes.INVOKESTATIC, "robotran/ecj/WorkBudget", method, descriptor, false)

    /** Counts by the value on top of the stack, which stays there. */
    private fun countTop(method: String, descriptor: String) {
        super.visitInsn(Opcodes.DUP)
        count(method, descriptor)
    }

    private companion object {
        val BUILDERS = setOf("java/lang/StringBuilder", "java/lang/StringBuffer")

        /** The parameters of `append` that may be long. */
        val TEXTS = setOf("(Ljava/lang/String;", "([C")
    }
}
