package robotran.build.wasm

/**
 * Which functions of a module were called while the page was driven, and which of its [LargeData] were not read, as a text
 * file of the repository.
 */
internal sealed interface CalledFunctions {
    /** The blocks of [LargeData] that were not read, by their address. */
    val unread: Set<Int>

    /**
     * The functions that were called, by their index among those that [module] defines; null if the file belongs to
     * another version of it.
     *
     * @param sha256 of the module's file.
     */
    fun indicesIn(module: WasmModule, sha256: String): Set<Int>?

    /** These functions and [others], of the same module as it is for another page. */
    fun with(others: CalledFunctions): CalledFunctions

    companion object {
        /**
         * What is called in [module]: by names, if it has names.
         *
         * @param marks the addresses of the bytes that are set in the memory of [withCallMarks].
         */
        fun of(marks: Set<Int>, module: WasmModule, sha256: String): CalledFunctions {
            val names = CalledNames.namesIn(module)
            val functions = marks.filter { it < names.size }.toSet()
            return if (names.all { it.isEmpty() }) {
                val blocks = LargeData.of(module).flatMap { it.blocks }
                val unread = blocks.filterIndexed { number, _ -> names.size + number !in marks }
                CalledIndices(sha256, functions, unread.toSet())
            } else {
                CalledNames(functions.map { names[it] }.filter { it.isNotEmpty() }.toSet())
            }
        }

        const val COMMENT = "# Written by ./gradlew :webApp:recordFirstPart, see docs/hosting.md."

        /** Reads what [CalledNames] or [CalledIndices] have written. */
        fun parse(text: String): CalledFunctions {
            val lines = text.lines().filterNot { it.isEmpty() || it.startsWith("#") }
            return if (lines.firstOrNull().orEmpty().startsWith(CalledIndices.SHA_256)) {
                CalledIndices.parse(lines)
            } else {
                CalledNames.parse(lines)
            }
        }
    }
}

/**
 * The functions of a module without names, which a library brings: the [sha256] of this version, and ranges of
 * [functions], by their index among the functions that the module defines.
 */
internal class CalledIndices(val sha256: String, val functions: Set<Int>, override val unread: Set<Int> = emptySet()) :
    CalledFunctions {
    override fun indicesIn(module: WasmModule, sha256: String): Set<Int>? = functions.takeIf { sha256 == this.sha256 }

    override fun with(others: CalledFunctions): CalledIndices {
        require(others is CalledIndices && others.sha256 == sha256) { "The functions are those of two modules." }
        return CalledIndices(sha256, functions + others.functions, unread intersect others.unread)
    }

    override fun toString(): String = buildString {
        appendLine(CalledFunctions.COMMENT)
        appendLine("$SHA_256 $sha256")
        val data = LargeData.sequences(unread.sorted())
        if (data.isNotEmpty()) appendLine("$UNREAD ${data.joinToString(" ") { "${it.first}-${it.last}" }}")
        ranges().chunked(RANGES_PER_LINE).forEach { appendLine(it.joinToString(" ")) }
    }

    private fun ranges(): List<String> {
        val sorted = functions.sorted()
        val starts = sorted.filter { it - 1 !in functions }
        val ends = sorted.filter { it + 1 !in functions }
        return starts.zip(ends) { start, end -> if (start == end) "$start" else "$start-$end" }
    }

    companion object {
        const val SHA_256 = "sha256"
        private const val UNREAD = "unread data"
        private const val RANGES_PER_LINE = 16

        fun parse(lines: List<String>): CalledIndices {
            val (ofData, ofFunctions) = lines.drop(1).partition { it.startsWith(UNREAD) }
            val functions = ofFunctions.flatMap { rangesIn(it) }.flatten()
            val unread = ofData.flatMap {
                rangesIn(it.removePrefix(UNREAD).trim())
            }.flatMap { it.step(LargeData.BLOCK) }
            return CalledIndices(lines.first().substringAfter(" "), functions.toSet(), unread.toSet())
        }

        private fun rangesIn(line: String): List<IntRange> = line.split(" ").map { range ->
            val ends = range.split("-").map { it.toInt() }
            ends.first()..ends.last()
        }
    }
}
