package robotran.programs

import robotran.javacompiler.diagnose.missingInNxj
import robotran.javacompiler.messages.JavaMessages
import robotran.language.source.Diagnostic
import robotran.nxjlibrary.NxjLibrary

/** Finds in class files from another compiler what leJOS NXJ lacks. */
internal class CompiledNxjGaps(private val library: NxjLibrary, private val messages: JavaMessages) {
    /** The mistakes in [classFiles], which must link; at most one per line. */
    fun find(classFiles: Map<String, ByteArray>): List<Diagnostic> = memberErrors(classFiles) { use ->
        library.differenceFor(use.owner, use.member)
            ?.let { missingInNxj(use.owner.substringAfterLast('/'), use.member, messages) }
    }
}
