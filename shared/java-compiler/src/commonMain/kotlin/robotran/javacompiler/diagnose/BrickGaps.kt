package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.BrickTarget
import robotran.javacompiler.messages.JavaMessages

/** What other programs use and a brick does not have, by name. */
internal interface BrickGaps {
    /** What to use instead of [name], a class, an import or a member of [owner]; null if nothing is known. */
    fun instead(name: String, owner: String? = null): String?

    /** What to use instead of [method], called without a class or an object; null if nothing is known. */
    fun insteadOfCall(method: String): String?

    companion object {
        fun of(target: BrickTarget, messages: JavaMessages): BrickGaps = when (target) {
            BrickTarget.LEJOS_RCX -> RcxGaps(messages)
            BrickTarget.LEJOS_NXJ -> NxjGaps(messages)
        }
    }
}

private class RcxGaps(private val messages: JavaMessages) : BrickGaps {
    override fun instead(name: String, owner: String?) = absent(name, owner)?.let(messages::absent)

    override fun insteadOfCall(method: String) = absentCall(method)?.let(messages::absent)
}

private class NxjGaps(private val messages: JavaMessages) : BrickGaps {
    override fun instead(name: String, owner: String?) = nxjRemedy(name, owner)?.let(messages::insteadInNxj)

    override fun insteadOfCall(method: String) = nxjRemedyOfCall(method)?.let(messages::insteadInNxj)
}
