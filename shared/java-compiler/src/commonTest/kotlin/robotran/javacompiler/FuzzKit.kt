package robotran.javacompiler

import kotlin.random.Random
import kotlin.test.assertNotNull
import kotlin.test.assertTrue

private val WORD = Regex("""\w+|\s+|[^\w\s]""")
private val ODD_WORDS =
    listOf(
        "\"",
        "'",
        "/*",
        "//",
        "{",
        "}",
        "(",
        ")",
        ";",
        "\\u0022",
        "\\u",
        "class",
        "new",
        "0x",
        "1e",
        "\u0000",
        "enum",
        "->",
        "<",
        "@",
    )

/** Compiles [count] mutated programs. Each is an example with some words removed, doubled, moved or replaced. */
suspend fun compileMutations(count: Int, seed: Long = 0) {
    val originals = examplePrograms.values.toList()
    repeat(count) { number ->
        val random = Random(seed + number)
        val text = mutated(originals[number % originals.size], random)
        when (val result = compile(text)) {
            is CompilationResult.Success -> assertTrue(result.classes.isNotEmpty() || "class" !in text, text)
            is CompilationResult.Failure -> assertReported(result, text)
        }
    }
}

private fun assertReported(result: CompilationResult.Failure, text: String) {
    val lines = text.lines().size
    for (diagnostic in result.diagnostics) {
        assertTrue(diagnostic.message.isNotBlank(), text)
        val range = assertNotNull(diagnostic.range, text)
        assertTrue(range.line in 1..lines && range.column in 1..range.endColumn, text)
        diagnostic.fix?.let { withFix(text, it) }
    }
}

private fun mutated(text: String, random: Random): String {
    val words = WORD.findAll(text).map { it.value }.toMutableList()
    repeat(random.nextInt(1, MAX_MUTATIONS)) {
        val place = random.nextInt(words.size)
        when (random.nextInt(KINDS)) {
            0 -> words.removeAt(place)
            1 -> words.add(place, words[place])
            2 -> words.add(place, words[random.nextInt(words.size)])
            else -> words[place] = ODD_WORDS.random(random)
        }
    }
    return words.joinToString("")
}

private const val MAX_MUTATIONS = 6
private const val KINDS = 4
