package robotran.build.wasm

/**
 * The [names] of the functions of the app: in each line an owner and its functions. A name holds for all functions that
 * differ in their parameters alone, and for later versions of the app, since Kotlin's linker distinguishes those by a
 * number that changes with each version.
 */
internal class CalledNames(val names: Set<String>) : CalledFunctions {
    /** The app reads its constants by their segments, which are where they are needed. */
    override val unread: Set<Int> get() = emptySet()

    private val packages =
        names.filterNot(UNNAMED::matches).map(::ownerOf).flatMap { listOf(it, ownerOf(it)) }.toSet()
    private val varyingOwners = names.filter { name -> VARYING.any(name::startsWith) }.map(::ownerOf).toSet()

    /**
     * Also lambdas in functions of the list: when Compose composes a function again depends on time, and it does so by a
     * lambda in it. Such a lambda may have no name but that of its type: all of these in a package of the list. All
     * functions of a class or file of [VARYING] of which one is in the list. And functions without a name, which binaryen
     * has made: it is not known what calls them.
     */
    override fun indicesIn(module: WasmModule, sha256: String): Set<Int> =
        namesIn(module).mapIndexedNotNull { index, name -> index.takeIf { isFirst(name) } }.toSet()

    private fun isFirst(name: String): Boolean =
        name.isEmpty() || name in names || isLambdaOfFirst(name) || ownerOf(name) in varyingOwners

    private fun isLambdaOfFirst(name: String): Boolean {
        val unnamed = UNNAMED.matchEntire(name)
        return if (unnamed != null) {
            unnamed.groupValues[1] in packages
        } else {
            LAMBDA in name && name.substringBefore(LAMBDA) in names
        }
    }

    override fun with(others: CalledFunctions): CalledNames {
        require(others is CalledNames) { "The functions are those of two modules." }
        return CalledNames(names + others.names)
    }

    override fun toString(): String {
        val written = names.filterNot(::isLambdaOfFirst).sorted()
        val byOwner =
            written.groupBy({ it.substringBeforeLast(SEPARATOR, NO_OWNER) }, { it.substringAfterLast(SEPARATOR) })
        val lines = byOwner.map { (owner, own) -> "$owner ${own.joinToString(" ")}" }
        return (listOf(CalledFunctions.COMMENT) + lines).joinToString("\n", postfix = "\n")
    }

    companion object {
        private const val NO_OWNER = "-"

        /** What follows the name of a function in the name of a lambda in it. */
        private const val LAMBDA = "\$lambda"
        private const val SEPARATOR = '.'

        /** The package of a lambda that the compiler calls after its type alone, and its function or constructor. */
        private val UNNAMED = Regex("""(.*)\.K?(?:Suspend)?Function\d+R?_bound\d+_\w+\.(?:invoke|<init>)""")

        /**
         * What frames, animations and coroutines do depends on time, and what the page does on its browser, so each
         * journey calls others of these functions.
         */
        private val VARYING = listOf(
            "androidx.compose.animation.",
            "androidx.compose.material.ripple.",
            "androidx.compose.runtime.",
            "kotlin.coroutines.",
            "kotlinx.coroutines.",
            "org.jetbrains.skiko.",
            "robotran.web.",
        )
        private val NUMBER = Regex("_\\d+$")

        /** The names of the functions that [module] defines, without the numbers that the linker adds. */
        fun namesIn(module: WasmModule): List<String> {
            val names = functionNames(module)
            val first = module.importedFunctions
            return module.entries(WasmModule.FUNCTIONS) { number() }.indices.map { index ->
                names[first + index].orEmpty().replace(NUMBER, "").replace(' ', '_')
            }
        }

        /** The class or file of the function that is called [name], or in which the lambda of that name stands. */
        private fun ownerOf(name: String): String =
            name.substringBefore(LAMBDA).substringBeforeLast(SEPARATOR, NO_OWNER)

        fun parse(lines: List<String>): CalledNames = CalledNames(
            lines.flatMap { line ->
                val words = line.split(" ")
                words.drop(1).map { if (words[0] == NO_OWNER) it else "${words[0]}$SEPARATOR$it" }
            }.toSet(),
        )
    }
}
