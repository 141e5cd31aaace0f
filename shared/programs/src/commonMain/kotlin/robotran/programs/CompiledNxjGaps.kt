package robotran.programs

import robotran.javacompiler.diagnose.missingInNxj
import robotran.javacompiler.messages.JavaMessages
import robotran.nxjlibrary.NxjLibrary
import robotran.tinyvm.diagnostic.MemberUse
import robotran.tinyvm.memberUsesOf

/** Finds in class files from another compiler what leJOS NXJ lacks. */
internal class CompiledNxjGaps(private val library: NxjLibrary, private val messages: JavaMessages) {
    /** The mistakes in [classFiles], which must link; at most one per line. */
    fun find(classFiles: Map<String, ByteArray>): List<ProgramDiagnostic> = memberUsesOf(classFiles)
        .filter { library.differenceFor(it.owner, it.member) != null }
        .distinctBy { Triple(it.className, it.methodName, it.sourceLine) }
        .map(::diagnosticOf)

    private fun diagnosticOf(use: MemberUse) = ProgramDiagnostic(
        file = listOfNotNull(use.className.replace('/', '.'), use.methodName).joinToString("."),
        range = rangeOf(use.sourceLine),
        message = missingInNxj(use.owner.substringAfterLast('/'), use.member, messages),
    )
}
