package robotran.build

/**
 * One row of the module map.
 *
 * @property folder the folder of the module, relative to the root.
 * @property packages the packages that contain all its code, each with those below it.
 * @property uses the folders of the modules it may import.
 * @property core whether it is plain common Kotlin, which must not depend on UI, threads, clocks or platforms.
 * @property presentation whether it publishes state to Compose, but must not depend on UI classes.
 */
data class MappedModule(
    val folder: String,
    val packages: List<String>,
    val uses: List<String>,
    val core: Boolean,
    val presentation: Boolean = false,
)

/**
 * A type whose constants only registries may name, so that a new one is one registration.
 *
 * @property type its simple name, such as `ProgramLanguage`.
 * @property registries the folders and files that may, relative to the root.
 */
data class RegisteredType(val type: String, val registries: List<String>) {
    private val constant = Regex("""\b$type\.[A-Z]""")

    /** The constant in [file] that should not be there, in a sentence; null if there is none. */
    fun violation(file: SourceFile): String? {
        val isRegistry = registries.any { file.path == it || file.path.startsWith("$it/") }
        if (file.isTest || isRegistry || !constant.containsMatchIn(file.text)) return null
        return "${file.path}: names a constant of $type, which is for the registries in the map alone"
    }
}

/** The packages of a room inside of a module: they import those of no other room of that module. */
data class Room(val name: String, val packages: List<String>)

/** The module map in `docs/modules.md`, and the tables of rooms and registries below it. The document is its only source. */
class ModuleMap(
    val modules: List<MappedModule>,
    private val registered: List<RegisteredType> = emptyList(),
    private val rooms: List<Room> = emptyList(),
) {
    private val byFolder = modules.associateBy { it.folder }

    /**
     * The imports of [file] in [module] that violate the map, one sentence each. Tests may import any module, since
     * they also test how modules work together.
     */
    fun violations(module: MappedModule, file: SourceFile): List<String> {
        val allowed = listOf(module) + module.uses.map { byFolder.getValue(it) }
        val wrongPackage = listOf(file.packageName).filterNot { file.isTest || owner(it) == module }.map {
            "${file.path}: package $it does not belong to ${module.folder}, whose code is in ${module.packages.joinToString()}"
        }
        val foreign = file.imports.filter { name ->
            !file.isTest && owner(name)?.let { it !in allowed } ?: false
        }.map { name ->
            "${file.path}: imports $name, but ${module.folder} may not use ${owner(name)!!.folder}"
        }
        val core = module.core && "/commonMain/" in file.path
        val impure = file.imports.filter { name -> core && IMPURE.any { name.startsWith(it) } }.map {
            "${file.path}: imports $it, which a core module must not know"
        }
        val drawn = file.imports.filter { name ->
            module.presentation && !file.isTest && DRAWING.any { name.startsWith(it) } &&
                !name.startsWith(STATE)
        }
            .map { "${file.path}: imports $it, which a presentation module must not know" }
        val room = roomOf(file.packageName)
        val neighbours = file.imports.filter { name ->
            room != null && !file.isTest && roomOf(name).let { it != null && it != room }
        }.map { "${file.path}: imports $it, which belongs to another room" }
        return wrongPackage + foreign + impure + drawn + neighbours + registered.mapNotNull { it.violation(file) }
    }

    private fun roomOf(name: String): Room? = rooms.find { room -> room.packages.any { inPackage(name, it) } }

    private fun owner(name: String): MappedModule? =
        modules.maxByOrNull { it.lengthOfPackage(name) }?.takeIf { it.lengthOfPackage(name) > 0 }

    /** The length of the package of this module that contains [name]; 0 if none does. */
    private fun MappedModule.lengthOfPackage(name: String): Int =
        packages.filter { inPackage(name, it) }.maxOfOrNull { it.length } ?: 0

    companion object {
        /**
         * APIs whose results depend on the machine: platforms, UI, threads, clocks, reflection, random numbers without
         * a seed, and functions of kotlin.math whose last bit differs between platforms.
         */
        private val IMPURE =
            listOf(
                "java.",
                "javax.",
                "android.",
                "androidx.",
                "org.jetbrains.",
                "kotlin.js.",
                "kotlin.reflect.",
                "kotlin.concurrent.",
                "kotlin.time.Clock",
                "kotlin.time.TimeSource",
                "kotlin.time.measureTime",
                "kotlin.random.Random.Default",
            ) +
                listOf(
                    "sin",
                    "cos",
                    "tan",
                    "asin",
                    "acos",
                    "atan",
                    "atan2",
                    "sinh",
                    "cosh",
                    "tanh",
                    "asinh",
                    "acosh",
                    "atanh",
                    "exp",
                    "expm1",
                    "ln",
                    "ln1p",
                    "log",
                    "log2",
                    "log10",
                    "pow",
                    "cbrt",
                    "hypot",
                ).map { "kotlin.math.$it" }

        /** Compose's UI packages. Presentation modules need only the package that publishes state. */
        private val DRAWING = listOf("androidx.", "org.jetbrains.compose.")
        private const val STATE = "androidx.compose.runtime."

        /**
         * Parses the table with the header `| module | package |`, each row of which is a module, the one with the header
         * `| room | packages |`, each row of which is a [Room], and the one with the header `| constants of | only in |`,
         * each row of which is a [RegisteredType].
         */
        fun parse(document: String): ModuleMap {
            val rows = rowsBelow("| module | package |", document)
            require(rows.isNotEmpty()) { "no module map: a table with the header | module | package | .. is missing" }
            val modules =
                rows.map { row ->
                    val cells = row.trim('|').split("|").map { it.trim() }
                    require(cells.size == 5) { "the module map's rows have five cells: $row" }
                    MappedModule(
                        folder = code(cells[0]).single(),
                        packages = code(cells[1]),
                        uses = code(cells[3]),
                        core = cells[4] == "core",
                        presentation = cells[4] == "presentation",
                    )
                }
            modules.flatMap { it.uses }.filter { used -> modules.none { it.folder == used } }.let { unknown ->
                require(unknown.isEmpty()) { "the module map names modules it has no row for: $unknown" }
            }
            val registered = rowsBelow("| constants of |", document).map { row ->
                val cells = row.trim('|').split("|")
                RegisteredType(code(cells[0]).single(), code(cells[1]))
            }
            val rooms = rowsBelow("| room |", document).map { row ->
                val cells = row.trim('|').split("|").map { it.trim() }
                Room(cells[0], code(cells[1]))
            }
            return ModuleMap(modules, registered, rooms)
        }

        private fun rowsBelow(header: String, document: String): List<String> =
            document.lines().dropWhile { !it.startsWith(header) }.drop(2).takeWhile { it.startsWith("|") }

        private fun code(cell: String): List<String> = Regex("`([^`]+)`").findAll(cell).map {
            it.groupValues[1]
        }.toList()

        private fun inPackage(name: String, packageName: String): Boolean =
            name == packageName || name.startsWith("$packageName.")
    }
}

/** The parts of a Kotlin or Java file that the check needs. */
class SourceFile(val path: String, val text: String) {
    /** Whether it belongs to a test source set. */
    val isTest: Boolean = Regex("/src/([a-z][A-Za-z]*)?[tT]est/").containsMatchIn(path)
    val packageName: String = PACKAGE.find(text)?.groupValues?.get(1) ?: ""
    val imports: List<String> = IMPORT.findAll(text).map { it.groupValues[1] }.toList()

    private companion object {
        val PACKAGE = Regex("""^package\s+([\w.]+)""", RegexOption.MULTILINE)
        val IMPORT = Regex("""^import\s+(?:static\s+)?([\w.]+(?:\.\*|\w))""", RegexOption.MULTILINE)
    }
}
