package robotran.programs

import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.tinyvm.diagnostic.MemberUse
import robotran.tinyvm.memberUsesOf

/** The uses of members in [classFiles], which must link, of which [messageOf] says something; at most one per line. */
internal fun memberErrors(classFiles: Map<String, ByteArray>, messageOf: (MemberUse) -> String?): List<Diagnostic> =
    memberUsesOf(classFiles).mapNotNull { use -> messageOf(use)?.let { use to it } }
        .distinctBy { (use, _) -> Triple(use.className, use.methodName, use.sourceLine) }
        .map { (use, message) ->
            val file = listOfNotNull(use.className.replace('/', '.'), use.methodName).joinToString(".")
            Diagnostic(Severity.ERROR, file, rangeOf(use.sourceLine), message)
        }
