package robotran.javacompiler.diagnose

/** The public classes and packages of the [library], from its class files by their internal names. */
internal class LibraryNames(library: Map<String, ByteArray>) {
    private val classes by lazy { library.filter { '$' !in it.key && isPublic(it.value) }.keys.sorted() }

    /** The names of all classes with their packages, separated by dots. */
    val qualifiedNames: List<String> by lazy { classes.map { it.replace('/', '.') } }

    /** The names of all classes without their packages. */
    val simpleNames: List<String> by lazy { qualifiedNames.map { it.substringAfterLast('.') } }

    /** The names of all packages, separated by dots. */
    val packages: List<String> by lazy {
        qualifiedNames.filter { '.' in it }.map { it.substringBeforeLast('.') }.distinct()
    }

    /** The packages with a class [simpleName], with dots. */
    fun homesOf(simpleName: String): List<String> =
        qualifiedNames.filter { it.endsWith(".$simpleName") }.map { it.substringBeforeLast('.') }

    /** Returns the package of the class [simpleName], with dots; null if there is none or it needs no import. */
    fun packageOf(simpleName: String): String? {
        val name = qualifiedNames.firstOrNull { it.substringAfterLast('.') == simpleName && '.' in it }
        return name?.substringBeforeLast('.')?.takeIf { it != "java.lang" }
    }
}

/** Whether programs can use the class of [classFile]; its flags follow the constants. */
private fun isPublic(classFile: ByteArray): Boolean {
    fun number(offset: Int) =
        (classFile[offset].toInt() and BYTE shl Byte.SIZE_BITS) or (classFile[offset + 1].toInt() and BYTE)

    var place = FIRST_CONSTANT
    var left = number(FIRST_CONSTANT - 2) - 1
    while (left > 0) {
        val kind = classFile[place].toInt()
        place += if (kind == TEXT) TEXT_HEAD + number(place + 1) else CONSTANT_SIZES[kind]
        left -= if (kind in TWO_PLACES) 2 else 1
    }
    return number(place) and PUBLIC != 0
}

private const val BYTE = 0xFF
private const val FIRST_CONSTANT = 10
private const val TEXT = 1
private const val TEXT_HEAD = 3
private const val PUBLIC = 1

/** The kinds of constants for long and double, which count twice. */
private val TWO_PLACES = 5..6

/** The bytes of a constant of each kind with the byte of the kind, as the JVM's specification has them. */
private val CONSTANT_SIZES = intArrayOf(0, 0, 0, 5, 5, 9, 9, 3, 3, 5, 5, 5, 5, 0, 0, 4, 3, 5, 5, 3, 3)
