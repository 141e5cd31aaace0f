package robotran.javacompiler.diagnose

import robotran.lejoslibrary.LejosDifference
import robotran.lejoslibrary.LejosRemedy

/** What a real brick lacks of the class library, by the keys that ECJ reports. */
internal class MissingMembers(missing: List<LejosDifference>) {
    private val byKey = missing.filter { it.instead != LejosRemedy.CHECKED_EXCEPTION }.associateBy { keyOf(it) }

    private val checked = missing.filter { it.instead == LejosRemedy.CHECKED_EXCEPTION }
        .mapTo(mutableSetOf()) { it.owner.substringAfterLast('/') }

    /** The keys of the classes and members that a program must not use, see `EcjCompiler.addGap`. */
    val keys: Set<String> get() = byKey.keys

    fun find(key: String): LejosDifference? = byKey[key]

    /** Whether the exception [simpleName] is a checked exception on a brick but not in Java. */
    fun isCheckedOnlyThere(simpleName: String): Boolean = simpleName in checked

    private fun keyOf(difference: LejosDifference) =
        if (difference.member.isEmpty()) difference.owner else "${difference.owner}.${difference.member}"
}
