package robotran.nxjlibrary

/**
 * A member of the class library that leJOS NXJ lacks.
 *
 * @property owner the class that declares it, with slashes, such as `java/util/LinkedList`.
 * @property member a method or constructor as name and descriptor, such as `getFirst()Ljava/lang/Object;`; a field as
 * name, colon and descriptor, such as `title:Ljava/lang/String;`.
 */
data class NxjDifference(val owner: String, val member: String) {
    /** The name of the field or method; `<init>` for a constructor. */
    val name: String get() = member.substringBefore('(').substringBefore(':')
}
