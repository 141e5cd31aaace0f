package robotran.build.ecj

import org.objectweb.asm.ClassReader
import org.objectweb.asm.ClassVisitor
import org.objectweb.asm.ClassWriter
import org.objectweb.asm.MethodVisitor
import org.objectweb.asm.Opcodes
import org.objectweb.asm.Type

/**
 * Adapts ECJ's class files to run in memory, on one thread, on untrusted sources and as WebAssembly. It removes
 * monitors, waits and methods that need reflection or files, limits constant strings to the class file maximum, makes
 * divisions and floating-point numbers the same on all platforms, adds large steps as a brick can, and counts the work
 * of compiling.
 */
internal class EcjRewriter {
    private val seen = mutableSetOf<String>()

    /** The methods that should have been rewritten but were not found. */
    val missing: Set<String> get() = EMPTIED_METHODS + TEXT_CONSTANT + FILE_READING + STEPS + PLACES - seen

    fun rewrite(classFile: ByteArray): ByteArray {
        val reader = ClassReader(classFile)
        val writer = ClassWriter(0)
        reader.accept(RewritingVisitor(reader.className, writer), 0)
        return writer.toByteArray()
    }

    private inner class RewritingVisitor(private val className: String, writer: ClassWriter) :
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
                in EMPTIED_METHODS -> {
                    EmptyMethodVisitor(
                        target,
                        Type.getArgumentsAndReturnSizes(descriptor) shr 2,
                        Type.getReturnType(descriptor),
                    )
                }

                TEXT_CONSTANT -> BoundedStringVisitor(target)
                FILE_READING -> ByteWiseReadVisitor(target)
                STEPS -> counted(ByteStepVisitor(PlatformCallVisitor(target)))

                else -> {
                    val safe = if (className == CONSTANTS) SafeDivisionVisitor(target) else target
                    val called = PlatformCallVisitor(safe)
                    if (name == CLASS_INITIALIZER) called else counted(called, isPlace = method in PLACES)
                }
            }
        }

        private fun counted(target: MethodVisitor, isPlace: Boolean = false) = WorkBudgetVisitor(target, isPlace)
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

        /** The class that folds constants. */
        const val CONSTANTS = "$COMPILER/impl/Constant"
        const val TEXT_CONSTANT = "$COMPILER/impl/StringConstant.fromValue"
        const val FILE_READING = "$COMPILER/util/Util.getInputStreamAsByteArray"
        const val STEPS = "$COMPILER/ast/SingleNameReference.generateCompoundAssignment"

        /** Runs once for all compilations. */
        const val CLASS_INITIALIZER = "<clinit>"

        /** What the compiler does with one method or class of a source. */
        val PLACES = setOf(
            "$COMPILER/ast/AbstractMethodDeclaration.resolve",
            "$COMPILER/ast/MethodDeclaration.analyseCode",
            "$COMPILER/ast/ConstructorDeclaration.analyseCode",
            "$COMPILER/ast/AbstractMethodDeclaration.generateCode",
            "$COMPILER/ast/ConstructorDeclaration.generateCode",
            "$COMPILER/ast/TypeDeclaration.resolve",
            "$COMPILER/ast/TypeDeclaration.analyseCode",
            "$COMPILER/ast/TypeDeclaration.generateCode",
        )
    }
}
