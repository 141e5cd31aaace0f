package robotran.tinyvm.diagnostic

/**
 * A place in a class file that names a class of the library or one of its members. Class names have slashes.
 *
 * @property className the class whose code it is in.
 * @property methodName null if it is the superclass or an interface of the class.
 * @property sourceLine from 1; 0 if unknown.
 * @property sourceFile the source file of the class; null if the class file does not contain it.
 * @property owner the class that is named.
 * @property member a method or constructor as name and descriptor, such as `search(Ljava/lang/Object;)I`; a field as
 * name, colon and descriptor; empty for the class itself.
 */
data class MemberUse(
    val className: String,
    val methodName: String?,
    val sourceLine: Int,
    val sourceFile: String?,
    val owner: String,
    val member: String,
)
