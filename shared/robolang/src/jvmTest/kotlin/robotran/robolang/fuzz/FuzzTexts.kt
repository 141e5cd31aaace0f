package robotran.robolang.fuzz

import robotran.robolang.RobolangWords
import robotran.robolang.words.Vocabulary
import robotran.robolang.words.written
import kotlin.random.Random

/** Some words of each other language. */
private val OTHER_WORDS: List<String> = listOf("forward", "repeat", "4 times", "end", "until", "seconds", "if", "left")
    .flatMap { english -> Vocabulary.all.drop(1).map { it.written("$english 2").removeSuffix(" 2") } }

/** All words and signs of Robolang, and some that it does not have. */
private val PIECES: List<String> = RobolangWords.keywords + OTHER_WORDS + listOf(
    "A",
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

/** Random characters: mostly printable ASCII, otherwise any, including unpaired surrogates. */
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

/** Random bytes, decoded as UTF-8. */
fun arbitraryBytes(random: Random): String = random.nextBytes(random.nextInt(LONGEST)).decodeToString()

/** Words and signs of Robolang in random order. */
fun piecesOfRobolang(random: Random): String =
    buildString { repeat(random.nextInt(60)) { append(PIECES.random(random)) } }

/** A valid program with a random change at one position. */
fun spoiltProgram(random: Random): String {
    val program = ProgramWriter(random).write()
    val start = random.nextInt(program.length + 1)
    return program.replaceRange(start, minOf(start + random.nextInt(6), program.length), PIECES.random(random))
}

/** A text of one of the kinds above, with equal probability. */
fun anyText(random: Random): String = when (random.nextInt(4)) {
    0 -> arbitraryText(random)
    1 -> arbitraryBytes(random)
    2 -> piecesOfRobolang(random)
    else -> spoiltProgram(random)
}

private const val LONGEST = 200
