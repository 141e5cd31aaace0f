package robotran.nqc

import robotran.legofirmware.image.FirmwareTarget

/**
 * A small program and what the original compiler says about it.
 *
 * @property errors its errors and warnings, each with its line; 0 if it names none.
 */
internal class ErrorCase(
    val name: String,
    val target: FirmwareTarget,
    val source: String,
    val errors: List<Pair<String, Int>>,
) {
    companion object {
        private const val INDENT = "    "
        private val LINE = Regex("""File ".*" ; line (\d+)""")
        private val MISTAKE = Regex("""# (?:Error|Warning): (.*)""")

        /** All cases of `errors.txt`: a line with name and target, the indented source, then what the original prints. */
        val all: List<ErrorCase> = vectorFiles.getValue("errors.txt").split("--- ").drop(1).map(::read)

        private fun read(block: String): ErrorCase {
            val lines = block.trimEnd().lines()
            val (name, target) = lines.first().split(' ')
            val source = lines.drop(1).takeWhile { it.startsWith(INDENT) }
            val printed = lines.drop(1 + source.size)
            val errors = printed.mapIndexedNotNull { index, line ->
                val text = MISTAKE.matchEntire(line)?.groupValues?.get(1)
                val place = printed.getOrNull(index + 1)?.let { LINE.matchEntire(it) }
                text?.let { it to (place?.groupValues?.get(1)?.toInt() ?: 0) }
            }
            val firmware = FirmwareTarget.entries.first { "[${it.word}]" == target }
            return ErrorCase(name, firmware, source.joinToString("") { it.removePrefix(INDENT) + "\n" }, errors)
        }
    }
}
