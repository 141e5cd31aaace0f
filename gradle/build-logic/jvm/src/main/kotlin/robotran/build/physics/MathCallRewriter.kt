package robotran.build.physics

import org.objectweb.asm.ClassReader
import org.objectweb.asm.ClassVisitor
import org.objectweb.asm.ClassWriter
import org.objectweb.asm.Handle
import org.objectweb.asm.MethodVisitor
import org.objectweb.asm.Opcodes

/**
 * Redirects calls of `java.lang.Math` and `StrictMath` in class files, and collects calls that are neither exact nor
 * replaced.
 */
internal class MathCallRewriter(
    private val exactFunctions: Set<String>,
    private val replacedFunctions: Set<String>,
    private val replacement: String,
) {
    private val unknown = sortedSetOf<String>()

    /** Each forbidden call found so far, as `function in class`. */
    val unknownCalls: Set<String> get() = unknown

    fun rewrite(classFile: ByteArray): ByteArray {
        val reader = ClassReader(classFile)
        val writer = ClassWriter(0)
        reader.accept(Redirection(reader.className, writer), 0)
        return writer.toByteArray()
    }

    private inner class Redirection(private val className: String, writer: ClassWriter) :
        ClassVisitor(Opcodes.ASM9, writer) {
        override fun visitMethod(
            access: Int,
            name: String,
            descriptor: String,
            signature: String?,
            exceptions: Array<String>?,
        ): MethodVisitor =
            MethodRedirection(className, super.visitMethod(access, name, descriptor, signature, exceptions))
    }

    private inner class MethodRedirection(private val className: String, target: MethodVisitor) :
        MethodVisitor(Opcodes.ASM9, target) {
        override fun visitMethodInsn(
            opcode: Int,
            owner: String,
            name: String,
            descriptor: String,
            isInterface: Boolean,
        ) {
            val newOwner = when {
                owner !in PLATFORM_CLASSES || name in exactFunctions -> owner
                name in replacedFunctions -> replacement
                else -> owner.also { unknown += "$name in $className" }
            }
            super.visitMethodInsn(opcode, newOwner, name, descriptor, isInterface)
        }

        override fun visitInvokeDynamicInsn(
            name: String,
            descriptor: String,
            bootstrap: Handle,
            vararg arguments: Any,
        ) {
            arguments.filterIsInstance<Handle>()
                .filter { it.owner in PLATFORM_CLASSES && it.name !in exactFunctions }
                .forEach { unknown += "${it.name} (as a method reference) in $className" }
            super.visitInvokeDynamicInsn(name, descriptor, bootstrap, *arguments)
        }
    }

    private companion object {
        val PLATFORM_CLASSES = setOf("java/lang/Math", "java/lang/StrictMath")
    }
}
