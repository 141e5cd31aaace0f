package robotran.blockediting

import robotran.robolang.RobolangWords
import kotlin.random.Random

/** Every program of the tree: examples, solutions, and the tests of the language with all their mistakes. */
internal val allPrograms: Map<String, String> = examplePrograms + tutorialPrograms + testPrograms

/** A text of words, signs, line breaks of all kinds and characters that no program has. */
internal fun arbitraryText(random: Random): String = buildString {
    repeat(random.nextInt(0, 40)) {
        append(PIECES.random(random))
        if (random.nextInt(3) > 0) append(' ')
    }
}

/** A program of [allPrograms] with some lines deleted, doubled, exchanged or damaged. */
internal fun spoiltText(random: Random): String {
    val lines = allPrograms.values.random(random).split('\n').toMutableList()
    repeat(random.nextInt(4)) {
        if (lines.isEmpty()) return@repeat
        val index = random.nextInt(lines.size)
        when (random.nextInt(5)) {
            0 -> lines.removeAt(index)
            1 -> lines.add(index, lines.random(random))
            2 -> lines[index] = lines[index].drop(random.nextInt(lines[index].length + 1))
            3 -> lines[index] = " ".repeat(random.nextInt(5)) + lines[index].trim()

            else -> lines[index] =
                lines[index].toCharArray().apply { if (isNotEmpty()) this[random.nextInt(size)] = 'q' }.concatToString()
        }
    }
    return lines.joinToString(listOf("\n", "\n", "\r\n", "\r").random(random))
}

private val PIECES = RobolangWords.keywords + RobolangWords.functions.keys + listOf(
    "\n",
    "\n",
    "\n",
    "\n",
    "\n",
    "\n",
    "\r\n",
    "\r",
    "\t",
    "  ",
    "end\n",
    "end\n",
    "end\n",
    "else\n",
    "repeat 4 times\n",
    "if left bumper\n",
    "beep\n",
    "forward 20\n",
    "repaet 4 times\n",
    "edn\n",
    "robot\n",
    "procedure p()\n",
    "x",
    "p()",
    "(",
    ")",
    "[",
    "]",
    "=",
    "==",
    "+",
    "-",
    ",",
    "\"",
    "\"HI\"",
    "// note",
    "5",
    "2.5",
    ".",
    "3000000000",
    ";",
    "}",
    "\u0000",
    "\uFEFF",
    "\u2028",
    "\u00A0",
    "ä",
    "\uD83E\uDD16",
    "\uD83E",
    "”",
)
