package robotran.brick.kind

/**
 * What runs programs in Java on a brick.
 *
 * @property mainPackage the package that a program begins with.
 */
enum class JavaPlatform(val mainPackage: String) {
    /** leJOS for the RCX. */
    LEJOS("josx.platform.rcx"),

    /** leJOS NXJ. A page fetches its library when it needs it. */
    NXJ("lejos.nxt"),
    ;

    /** The package that all of its own packages are in, and no others. */
    val root: String = mainPackage.substringBefore('.')
}
