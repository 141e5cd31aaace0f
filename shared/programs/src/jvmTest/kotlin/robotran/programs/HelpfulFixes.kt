package robotran.programs

import robotran.language.source.Diagnostic
import kotlin.random.Random

/** Programs of a language with mistakes, and how many of the fixes that it offers for them do harm. */
internal class HelpfulFixes(programs: Map<String, String>, seed: Long) {
    private val programs = programs.filterValues { it.isNotBlank() }
    private val random = Random(seed)

    /** Those that leave a program with as many mistakes, or with a new one. */
    val harmful = mutableListOf<String>()
    var offered = 0
        private set

    /** Tries out all fixes of [count] programs with mistakes. */
    fun check(
        count: Int,
        sourceOf: (name: String, text: String) -> ProgramSource,
        compile: (ProgramSource) -> ProgramResult,
    ) {
        repeat(count) {
            val (name, text) = programs.entries.random(random)
            val source = sourceOf(name.substringAfterLast('/'), changed(text))
            val result = compile(source)
            for (diagnostic in errorsIn(result)) {
                val fix = diagnostic.fix ?: continue
                offered++
                val after = compile(checkNotNull(source.withFix(diagnostic.file, fix)))
                val isFit = after is ProgramResult.Success || result is ProgramResult.Failure
                if (isFit && isBetter(errorsIn(result), sameKindIn(result, after), diagnostic.file, fix)) continue
                harmful += "$name: $diagnostic\n${source.files.first().text}\nthen ${errorsIn(after)}"
            }
        }
    }

    private fun errorsIn(result: ProgramResult): List<Diagnostic> = when (result) {
        is ProgramResult.Failure -> result.diagnostics
        is ProgramResult.Success -> result.warnings
    }

    /** A program without errors may have warnings that nobody has seen before. */
    private fun sameKindIn(before: ProgramResult, after: ProgramResult): List<Diagnostic> =
        if (before is ProgramResult.Failure && after is ProgramResult.Success) emptyList() else errorsIn(after)

    private fun changed(text: String): String {
        val words = WORD.findAll(text).map { it.value }.toMutableList()
        repeat(random.nextInt(1, MAX_CHANGES + 1)) {
            if (words.isEmpty()) return ""
            val index = random.nextInt(words.size)
            when (random.nextInt(CHANGES)) {
                0 -> words.removeAt(index)
                1 -> words.add(index, words[index])
                2 -> words[index] = words.random(random)
                3 -> words[index] = misspelt(words[index])
                4 -> words[index] = words[index].map { PASTED[it] ?: it }.joinToString("")
                5 -> words.add(index, ODD.random(random))
                else -> words[index] = ODD.random(random)
            }
        }
        return words.joinToString("")
    }

    private fun misspelt(word: String): String {
        if (word.isEmpty()) return word
        val index = random.nextInt(word.length)
        return when (random.nextInt(3)) {
            0 -> word.removeRange(index, index + 1)
            1 -> word.substring(0, index) + word[index] + word.substring(index)
            else -> word.substring(0, index) + ('a' + random.nextInt(LETTERS)) + word.substring(index + 1)
        }
    }

    private companion object {
        const val MAX_CHANGES = 3
        const val CHANGES = 7
        const val LETTERS = 26
        val WORD = Regex("""\w+|\s+|[^\w\s]""")
        val PASTED = mapOf(' ' to '\u00A0', '-' to '\u2013', '"' to '\u201C', ';' to '\uFF1B', '*' to '\u00D7')
        const val SIGNS = "; : { } ( ) = == + - , . \" \u201C \u2013 \u2264 \u2009 \u200B"
        const val WORDS = "0.5 7 int void if else end elif start my"
        val ODD = "$SIGNS $WORDS".split(' ')
    }
}
