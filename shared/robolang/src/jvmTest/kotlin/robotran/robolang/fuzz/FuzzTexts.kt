package robotran.robolang.fuzz

import kotlin.random.Random

/** Everything that means something to Robolang, and a little that does not. */
private val PIECES: List<String> = listOf(
    "forward",
    "backward",
    "turn",
    "pen",
    "repeat",
    "wait",
    "beep",
    "show",
    "end",
    "left",
    "right",
    "down",
    "up",
    "times",
    "cm",
    "degrees",
    "seconds",
    "milliseconds",
    "if",
    "else",
    "for",
    "each",
    "in",
    "from",
    "to",
    "step",
    "while",
    "until",
    "forever",
    "break",
    "continue",
    "var",
    "const",
    "procedure",
    "function",
    "return",
    "whenever",
    "halt",
    "robot",
    "light",
    "sensor",
    "on",
    "facing",
    "start",
    "turning",
    "stop",
    "power",
    "motor",
    "A",
    "play",
    "buzz",
    "clear",
    "screen",
    "reset",
    "timer",
    "battery",
    "button",
    "run",
    "bumper",
    "true",
    "false",
    "and",
    "or",
    "not",
    "mod",
    "x",
    "x",
    "p",
    "p()",
    "(",
    ")",
    "[",
    "]",
    "=",
    "==",
    "!=",
    "<",
    "<=",
    ">",
    ">=",
    "+",
    "++",
    "*",
    "/",
    "\"HI\"",
    "\"",
    "“",
    "'",
    "{",
    "}",
    ":",
    "random",
    "length",
    "foward",
    "endif",
    "2x",
    " ",
    " ",
    " ",
    " ",
    "\n",
    "\n",
    "\n",
    "\r\n",
    "\r",
    "\t",
    "//",
    "-",
    ",",
    ".",
    "0",
    "4",
    "2.5",
    "99999999999",
    "\uFEFF",
    "\uD83E\uDD16",
    "\uD83E",
    "\u0000",
    ";",
    "°",
    "é",
    "２",
)

/** Characters of any kind, half pairs of surrogates included, plain ones more often than not. */
fun arbitraryText(random: Random): String = buildString {
    repeat(random.nextInt(LONGEST)) {
        append(
            if (random.nextInt(4) == 0) {
                random.nextInt(0x10000).toChar()
            } else {
                random.nextInt(32, 127).toChar()
            },
        )
    }
}

/** What bytes of any kind are as UTF-8. */
fun arbitraryBytes(random: Random): String = random.nextBytes(random.nextInt(LONGEST)).decodeToString()

/** Pieces of the language in any order. */
fun piecesOfRobolang(random: Random): String =
    buildString { repeat(random.nextInt(60)) { append(PIECES.random(random)) } }

/** A program in which one place is spoilt. */
fun spoiltProgram(random: Random): String {
    val program = ProgramWriter(random).write()
    val start = random.nextInt(program.length + 1)
    return program.replaceRange(start, minOf(start + random.nextInt(6), program.length), PIECES.random(random))
}

/** One of the kinds above, each as often as the others. */
fun anyText(random: Random): String = when (random.nextInt(4)) {
    0 -> arbitraryText(random)
    1 -> arbitraryBytes(random)
    2 -> piecesOfRobolang(random)
    else -> spoiltProgram(random)
}

private const val LONGEST = 200
