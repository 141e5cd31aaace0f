package robotran.programs

import robotran.javacompiler.messages.LejosMessages
import robotran.language.source.Diagnostic
import robotran.lejoslibrary.LejosDifference
import robotran.lejoslibrary.LejosRemedy
import robotran.tinyvm.diagnostic.MemberUse

/** Finds in class files from another compiler what the brick that they are for does not have. */
internal class CompiledGaps(settings: JavaSettings, private val messages: LejosMessages) {
    // Who catches what is decided when a class is compiled, so a class file cannot get it wrong.
    private val missing: Map<Pair<String, String>, LejosDifference> = BrickLibrary.missingFor(settings)
        .filter { it.instead != LejosRemedy.CHECKED_EXCEPTION }
        .associateBy { it.owner to it.member }

    /** The mistakes in [classFiles], which must link; at most one per line. */
    fun find(classFiles: Map<String, ByteArray>): List<Diagnostic> {
        if (missing.isEmpty()) return emptyList()
        return memberErrors(classFiles) { use -> differenceOf(use)?.let(::messageOf) }
    }

    private fun differenceOf(use: MemberUse): LejosDifference? =
        missing[use.owner to ""] ?: missing[use.owner to use.member]

    private fun messageOf(difference: LejosDifference): String {
        val owner = difference.owner.substringAfterLast('/')
        val member = difference.member.substringBefore('(').substringBefore(':')
        val sentences = listOfNotNull(
            messages.missingInLejos(difference.instead, owner, member),
            messages.insteadInLejos(difference.instead, owner, member),
            messages.builderOfCompiler().takeIf { difference.instead == LejosRemedy.STRING_BUFFER },
        )
        return sentences.joinToString(" ")
    }
}
