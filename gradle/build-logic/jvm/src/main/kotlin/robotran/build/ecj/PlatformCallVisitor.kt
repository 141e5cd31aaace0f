package robotran.build.ecj

import org.objectweb.asm.MethodVisitor
import org.objectweb.asm.Opcodes
import org.objectweb.asm.Type

/** Removes thread operations, and parses and formats floating-point numbers exactly. */
internal class PlatformCallVisitor(target: MethodVisitor) : MethodVisitor(Opcodes.ASM9, target) {
    override fun visitInsn(opcode: Int) {
        val monitor = opcode == Opcodes.MONITORENTER || opcode == Opcodes.MONITOREXIT
        super.visitInsn(if (monitor) Opcodes.POP else opcode)
    }

    override fun visitMethodInsn(opcode: Int, owner: String, name: String, descriptor: String, isInterface: Boolean) {
        val exact = EXACT_CALLS["$owner.$name$descriptor"]
        if (exact != null) {
            super.visitMethodInsn(Opcodes.INVOKESTATIC, exact.first, exact.second, descriptor, false)
        } else if ("$owner.$name" in THREAD_CALLS) {
            Type.getArgumentTypes(descriptor).forEach {
                super.visitInsn(if (it.size == 2) Opcodes.POP2 else Opcodes.POP)
            }
            if (opcode != Opcodes.INVOKESTATIC) super.visitInsn(Opcodes.POP)
        } else {
            super.visitMethodInsn(opcode, owner, name, descriptor, isInterface)
        }
    }

    private companion object {
        /**
         * None of them returns a value, and none is reached while the compiler runs on one thread. If a single one
         * remained, TeaVM would compile everything as coroutines, which exported functions cannot be.
         */
        val THREAD_CALLS = setOf(
            "java/lang/Object.wait",
            "java/lang/Object.notify",
            "java/lang/Object.notifyAll",
            "java/lang/Thread.sleep",
            "java/lang/Thread.start",
            "java/lang/Thread.yield",
            "java/lang/Thread.join",
        )

        /** Platform-independent replacements of platform-dependent functions. */
        val EXACT_CALLS = mapOf(
            "java/lang/Float.valueOf(Ljava/lang/String;)Ljava/lang/Float;" to
                ("robotran/ecj/DecimalReader" to "floatOf"),
            "java/lang/Double.valueOf(Ljava/lang/String;)Ljava/lang/Double;" to
                ("robotran/ecj/DecimalReader" to "doubleOf"),
            "java/lang/String.valueOf(F)Ljava/lang/String;" to ("robotran/ecj/DecimalText" to "of"),
            "java/lang/String.valueOf(D)Ljava/lang/String;" to ("robotran/ecj/DecimalText" to "of"),
        )
    }
}
