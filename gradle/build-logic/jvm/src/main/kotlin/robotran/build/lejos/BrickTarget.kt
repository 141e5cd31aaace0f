package robotran.build.lejos

/**
 * The system on a brick that Java is compiled for; the compiler of pupils' programs has the same.
 *
 * @property language the version of Java, for ECJ's `-source`.
 * @property classFiles the version of the class files, for ECJ's `-target`.
 * @property library the module of the class library.
 */
enum class BrickTarget(val language: String, val classFiles: String, val library: String) {
    LEJOS_RCX("1.3", "1.1", ":shared:lejos-library"),
    LEJOS_NXJ("1.6", "1.6", ":shared:nxj-library"),
}
