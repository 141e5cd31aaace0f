package robotran.textediting.api

import robotran.lejoslibrary.LejosLibrary

/**
 * A field or a method of a class of leJOS.
 *
 * @property type the field's type or the method's return type, such as `int`.
 * @property parameters the text between the method's parentheses; null for a field.
 * @property help one sentence; empty if there is none.
 */
data class ApiMember(
    val name: String,
    val type: String,
    val parameters: String?,
    val isStatic: Boolean,
    val help: String,
)

/**
 * A class of leJOS, read from its source.
 *
 * @property parents the classes and interfaces that it extends and implements.
 */
data class ApiClass(
    val name: String,
    val path: String,
    val help: String,
    val parents: List<String>,
    val members: List<ApiMember>,
)

/** The library classes that a leJOS program can use. Each is read from the library's source on first use. */
object LejosApi {
    private val paths: Map<String, String> = LejosLibrary.classNames
        .filter { '$' !in it && it.substringBeforeLast('/') in PACKAGES }
        .associateBy { it.substringAfterLast('/') }

    private val known = mutableMapOf<String, ApiClass?>()

    /** The names of all classes without their packages. */
    val classNames: Set<String> get() = paths.keys

    /** The class [name], without its package; null if there is none. */
    fun classOf(name: String): ApiClass? = known.getOrPut(name) {
        val path = paths[name] ?: return@getOrPut null
        LejosLibrary.source(path)?.let { readApiClass(name, path, it) }
    }

    /** The members of the class [name] and its supertypes, without the overridden ones. */
    fun membersOf(name: String): List<ApiMember> {
        val found = LinkedHashMap<String, ApiMember>()
        val waiting = ArrayDeque(listOf(name))
        val seen = mutableSetOf<String>()
        while (waiting.isNotEmpty()) {
            val next = waiting.removeFirst()
            if (!seen.add(next)) continue
            val type = classOf(next) ?: continue
            for (member in type.members) found.getOrPut("${member.name}(${member.parameters}") { member }
            waiting += type.parents
        }
        return found.values.toList()
    }
}

private val PACKAGES = setOf("java/lang", "java/util", "josx/platform/rcx", "josx/robotics", "josx/util")
