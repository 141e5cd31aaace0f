package robotran.build.ecj

import org.objectweb.asm.MethodVisitor
import org.objectweb.asm.Opcodes

/**
 * Compiles `number += 200` and `number = number + 200` of a local variable to an addition: ECJ uses `iinc` for steps of
 * 16 bits, but leJOS's firmware has only that of 8 bits.
 */
internal class ByteStepVisitor(target: MethodVisitor) : MethodVisitor(Opcodes.ASM9, target) {
    /** The only casts to short in the method test whether a step fits. */
    override fun visitInsn(opcode: Int) = super.visitInsn(if (opcode == Opcodes.I2S) Opcodes.I2B else opcode)
}
