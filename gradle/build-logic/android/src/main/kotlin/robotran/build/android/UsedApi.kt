package robotran.build.android

/**
 * Classes with their members, and the references in code. Names are in class file format: `java/util/List`, `size()I`
 * for a method, `out` for a field.
 */
internal class UsedApi {
    private class Known(val supertypes: List<String>, val members: Set<String>)

    private val classes = mutableMapOf<String, Known>()
    private val uses = mutableListOf<Use>()

    /**
     * A reference in code.
     *
     * @property member null for the class itself.
     * @property from the class and method that contain the reference.
     */
    data class Use(val owner: String, val member: String?, val from: String) {
        override fun toString() = "${listOfNotNull(owner, member).joinToString(".")}, used by $from"
    }

    /** Adds a class that code may refer to. */
    fun declare(name: String, supertypes: List<String>, members: Set<String>) {
        classes[name] = Known(supertypes, members)
    }

    fun use(owner: String, member: String?, from: String) {
        // Arrays have only the members of Object.
        if (!owner.startsWith('[')) uses += Use(owner, member, from)
    }

    /**
     * References to missing classes and members, each with a method that contains it.
     *
     * @param isOutline whether R8 created the class to hold code moved from other classes. Its references then count
     * for its callers.
     */
    fun missing(isOutline: (String) -> Boolean = { false }): List<Use> {
        val callers = uses.filter {
            it.member != null && isOutline(it.owner)
        }.groupBy({ "${it.owner}.${it.member}" }, { it.from })
        val lacking = lacking().flatMap { use ->
            if (isOutline(use.from.substringBefore('.'))) {
                callers[use.from].orEmpty().map {
                    use.copy(from = it)
                }
            } else {
                listOf(use)
            }
        }
        return lacking.distinct().sortedBy { it.toString() }
    }

    private fun lacking(): List<Use> =
        uses.distinct().filterNot { if (it.member == null) it.owner in classes else has(it.owner, it.member) }

    private fun has(owner: String, member: String): Boolean {
        val known = classes[owner] ?: return false
        return member in known.members || known.supertypes.any { has(it, member) }
    }
}
