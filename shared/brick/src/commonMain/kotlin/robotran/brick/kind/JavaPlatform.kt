package robotran.brick.kind

/**
 * What runs programs in Java on a brick.
 *
 * @property mainPackage the package that a program begins with.
 * @property languageVersion the version of the language: 5 has `enum`.
 */
enum class JavaPlatform(val mainPackage: String, val languageVersion: Int) {
    /** leJOS for the RCX. */
    LEJOS("josx.platform.rcx", languageVersion = 3),

    /** leJOS NXJ. A page fetches its library when it needs it. */
    NXJ("lejos.nxt", languageVersion = 5),
    ;

    /** The package that all of its own packages are in, and no others. */
    val root: String = mainPackage.substringBefore('.')
}
