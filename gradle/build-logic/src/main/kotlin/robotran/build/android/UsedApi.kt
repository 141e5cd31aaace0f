package robotran.build.android

/**
 * Classes with their members, and what code uses of them. Names are those of class files: `java/util/List`, `size()I`
 * for a method, `out` for a field.
 */
internal class UsedApi {
    private class Known(val supertypes: List<String>, val members: Set<String>)

    private val classes = mutableMapOf<String, Known>()
    private val uses = mutableListOf<Use>()

    /**
     * Something that code refers to.
     *
     * @property member null for the class itself.
     * @property from the class and method that do so.
     */
    data class Use(val owner: String, val member: String?, val from: String) {
        override fun toString() = "${listOfNotNull(owner, member).joinToString(".")}, used by $from"
    }

    /** Adds a class that others may refer to. */
    fun declare(name: String, supertypes: List<String>, members: Set<String>) {
        classes[name] = Known(supertypes, members)
    }

    fun use(owner: String, member: String?, from: String) {
        // Arrays have nothing but what every object has.
        if (!owner.startsWith('[')) uses += Use(owner, member, from)
    }

    /**
     * What is referred to and is not there, each with a method that does so.
     *
     * @param isOutline whether a class holds nothing but what R8 has taken out of others: then those that call it count
     * as using what it uses.
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
