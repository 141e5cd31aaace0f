package robotran.build.ecj

import org.objectweb.asm.ClassReader
import org.objectweb.asm.ClassVisitor
import org.objectweb.asm.ClassWriter
import org.objectweb.asm.Label
import org.objectweb.asm.MethodVisitor
import org.objectweb.asm.Opcodes
import org.objectweb.asm.Type

/**
 * Adapts ECJ's class files to run in memory, on one thread, on untrusted sources and as WebAssembly. It removes
 * monitors, waits and methods that need reflection or files, limits constant strings to the class file maximum, and
 * makes divisions and floating-point numbers the same on all platforms.
 */
internal class EcjRewriter {
    private val seen = mutableSetOf<String>()

    /** The methods that should have been rewritten but were not found. */
    val missing: Set<String> get() = EMPTIED_METHODS + TEXT_CONSTANT + FILE_READING - seen

    fun rewrite(classFile: ByteArray): ByteArray {
        val reader = ClassReader(classFile)
        val writer = ClassWriter(0)
        reader.accept(Fitting(reader.className, writer), 0)
        return writer.toByteArray()
    }

    private inner class Fitting(private val className: String, writer: ClassWriter) :
        ClassVisitor(Opcodes.ASM9, writer) {
        override fun visitMethod(
            access: Int,
            name: String,
            descriptor: String,
            signature: String?,
            exceptions: Array<String>?,
        ): MethodVisitor {
            val target = super.visitMethod(
                access and Opcodes.ACC_SYNCHRONIZED.inv(),
                name,
                descriptor,
                signature,
                exceptions,
            )
            val method = "$className.$name"
            seen += method
            return when (method) {
                in EMPTIED_METHODS -> Emptied(
                    target,
                    Type.getArgumentsAndReturnSizes(descriptor) shr 2,
                    Type.getReturnType(descriptor),
                )

                TEXT_CONSTANT -> BoundedText(target)

                FILE_READING -> ReadingByByte(target)

                else -> WithoutPlatform(if (className == CONSTANTS) SafeDivision(target) else target)
            }
        }
    }

    /** Empties a method; it returns null if it has a result. */
    private class Emptied(private val target: MethodVisitor, private val parameters: Int, private val result: Type) :
        MethodVisitor(Opcodes.ASM9) {
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

    /**
     * Reads a stream, the method's first parameter, byte by byte into a `ByteArrayOutputStream`. The stream of a TeaVM
     * resource loses bytes if it reads to an array offset other than 0.
     */
    private class ReadingByByte(private val target: MethodVisitor) : MethodVisitor(Opcodes.ASM9) {
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
    }

    /** Rejects strings over the class file limit, so that repeated doubling in a source cannot exhaust the memory. */
    private class BoundedText(target: MethodVisitor) : MethodVisitor(Opcodes.ASM9, target) {
        override fun visitCode() {
            super.visitCode()
            val shortEnough = Label()
            visitVarInsn(Opcodes.ALOAD, 0)
            visitMethodInsn(Opcodes.INVOKEVIRTUAL, "java/lang/String", "length", "()I", false)
            visitLdcInsn(LONGEST_TEXT)
            visitJumpInsn(Opcodes.IF_ICMPLE, shortEnough)
            visitTypeInsn(Opcodes.NEW, "java/lang/IllegalStateException")
            visitInsn(Opcodes.DUP)
            visitMethodInsn(Opcodes.INVOKESPECIAL, "java/lang/IllegalStateException", "<init>", "()V", false)
            visitInsn(Opcodes.ATHROW)
            visitLabel(shortEnough)
            visitFrame(Opcodes.F_SAME, 0, null, 0, null)
        }

        override fun visitMaxs(maxStack: Int, maxLocals: Int) = super.visitMaxs(maxOf(maxStack, 2), maxLocals)
    }

    /** Delegates divisions to `Division.java`. */
    private class SafeDivision(target: MethodVisitor) : MethodVisitor(Opcodes.ASM9, target) {
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

    /** Removes thread operations, and parses and formats floating-point numbers exactly. */
    private class WithoutPlatform(target: MethodVisitor) : MethodVisitor(Opcodes.ASM9, target) {
        override fun visitInsn(opcode: Int) {
            val monitor = opcode == Opcodes.MONITORENTER || opcode == Opcodes.MONITOREXIT
            super.visitInsn(if (monitor) Opcodes.POP else opcode)
        }

        override fun visitMethodInsn(
            opcode: Int,
            owner: String,
            name: String,
            descriptor: String,
            isInterface: Boolean,
        ) {
            val exact = EXACT_CALLS["$owner.$name$descriptor"]
            if (exact != null) {
                super.visitMethodInsn(Opcodes.INVOKESTATIC, exact.first, exact.second, descriptor, false)
            } else if ("$owner.$name" in THREAD_CALLS) {
                Type.getArgumentTypes(descriptor).forEach {
                    super.visitInsn(
                        if (it.size == 2) {
                            Opcodes.POP2
                        } else {
                            Opcodes.POP
                        },
                    )
                }
                if (opcode != Opcodes.INVOKESTATIC) super.visitInsn(Opcodes.POP)
            } else {
                super.visitMethodInsn(opcode, owner, name, descriptor, isInterface)
            }
        }
    }

    private companion object {
        const val COMPILER = "org/eclipse/jdt/internal/compiler"
        val EMPTIED_METHODS = setOf(
            "$COMPILER/lookup/ExternalAnnotationSuperimposer.apply",
            "$COMPILER/lookup/ProblemReferenceBinding.problemReasonString",
            // Binds messages of ECJ's command line by reflection; without it the fields of Messages stay null.
            "$COMPILER/util/Messages.bind",
            "$COMPILER/util/Messages.initializeMessages",
            "$COMPILER/util/Util.collectPlatformLibraries",
        )

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

        /** The class that folds constants. */
        const val CONSTANTS = "$COMPILER/impl/Constant"

        const val TEXT_CONSTANT = "$COMPILER/impl/StringConstant.fromValue"

        const val FILE_READING = "$COMPILER/util/Util.getInputStreamAsByteArray"
        const val BYTES = "java/io/ByteArrayOutputStream"

        /** The local variable after the method's two parameters. */
        const val READ_BYTES = 2

        /** A class file stores the length of a string in 16 bits. */
        const val LONGEST_TEXT = 65_535
    }
}
