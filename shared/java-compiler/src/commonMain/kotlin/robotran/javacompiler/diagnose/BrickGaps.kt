package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.BrickTarget
import robotran.javacompiler.messages.JavaMessages

/** What other programs use and a brick does not have, by name. */
internal interface BrickGaps {
    /** What to use instead of [name], a class, an import or a member of [owner]; null if nothing is known. */
    fun instead(name: String, owner: String? = null): String?

    /** What to use instead of [method], called without a class or an object; null if nothing is known. */
    fun insteadOfCall(method: String): String?

    /** The names of the constants that stand for parts of the brick, and their classes. */
    val constants: Map<String, String>

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

    override val constants = RCX_CONSTANTS
}

private val RCX_CONSTANTS = constants("Sensor" to "S1 S2 S3", "Motor" to "A B C", "Button" to "RUN VIEW PRGM")

private val NXT_CONSTANTS =
    constants("SensorPort" to "S1 S2 S3 S4", "Motor" to "A B C", "Button" to "ENTER LEFT RIGHT ESCAPE")

/** The classes of constants, by their names. */
private fun constants(vararg classes: Pair<String, String>): Map<String, String> =
    classes.flatMap { (owner, names) -> names.split(' ').map { it to owner } }.toMap()

internal class NxjGaps(private val messages: JavaMessages) : BrickGaps {
    override fun instead(name: String, owner: String?) =
        nxjRemedy(name, owner)?.let(messages::insteadInNxj) ?: owner?.let { nxjCode(name, it, messages) }

    override fun insteadOfCall(method: String) = nxjRemedyOfCall(method)?.let(messages::insteadInNxj)

    override val constants = NXT_CONSTANTS
}
