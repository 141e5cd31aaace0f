package robotran.javacompiler.edit

import robotran.brick.kind.BrickKind
import robotran.brick.kind.JavaPlatform
import robotran.lejoslibrary.LejosLibrary
import robotran.nxjlibrary.NxjSources

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

/**
 * The library classes that a Java program for one kind of brick can use. Each is read from the library's source on
 * first use.
 *
 * @param allNames the classes of the library, with slashes.
 * @param packages those whose classes are offered.
 */
class BrickApi private constructor(
    allNames: Set<String>,
    packages: Set<String>,
    private val source: (path: String) -> String?,
) {
    private val paths: Map<String, String> = allNames
        .filter { '$' !in it && it.substringBeforeLast('/') in packages }
        .sortedByDescending { packages.indexOf(it.substringBeforeLast('/')) }
        .associateBy { it.substringAfterLast('/') }

    private val known = mutableMapOf<String, ApiClass?>()

    /** The names of all classes without their packages. */
    val classNames: Set<String> get() = paths.keys

    /** The class [name], without its package; null if there is none. */
    fun classOf(name: String): ApiClass? = known.getOrPut(name) {
        val path = paths[name] ?: return@getOrPut null
        source(path)?.let { readApiClass(name, path, it) }
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

    companion object {
        private val lejos by lazy { BrickApi(LejosLibrary.classNames.toSet(), LEJOS_PACKAGES, LejosLibrary::source) }

        private var nxj: BrickApi? = null

        private val none = BrickApi(emptySet(), emptySet()) { null }

        /** The library of a [brick]; that of an NXT has no classes until [NxjSources.load] has returned. */
        fun of(brick: BrickKind): BrickApi = when (brick.java) {
            JavaPlatform.LEJOS -> lejos

            JavaPlatform.NXJ -> nxj ?: NxjSources.known?.let { sources ->
                BrickApi(sources.classNames, NXJ_PACKAGES, sources::source).also { nxj = it }
            } ?: none

            null -> none
        }
    }
}

private val LEJOS_PACKAGES = setOf("java/lang", "java/util", "josx/platform/rcx", "josx/robotics", "josx/util")

/** Of classes with the same name, the first counts. */
private val NXJ_PACKAGES = linkedSetOf(
    "lejos/nxt",
    "lejos/robotics",
    "lejos/robotics/navigation",
    "lejos/robotics/subsumption",
    "lejos/robotics/objectdetection",
    "lejos/robotics/localization",
    "lejos/robotics/pathfinding",
    "lejos/util",
    "lejos/geom",
    "lejos/nxt/addon",
    "lejos/nxt/comm",
    "java/lang",
    "java/util",
    "java/io",
)
