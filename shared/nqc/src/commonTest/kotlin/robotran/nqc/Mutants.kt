package robotran.nqc

import robotran.language.Language
import robotran.legofirmware.image.FirmwareLimits
import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.image.toBytes
import robotran.nqc.messages.NqcMessages
import kotlin.random.Random
import kotlin.test.assertTrue

/** Compiles changed copies of the programs of the vectors. */
internal class Mutants(private val random: Random) {
    /** Compiles one copy; returns whether it has no mistake. */
    fun compileNext(): Boolean {
        val text = StringBuilder(sources.random(random))
        // Most copies change little, so that many still compile.
        repeat(if (random.nextInt(3) == 0) random.nextInt(1, MOST_CHANGES) else 1) { change(text) }
        val options = NqcOptions(FirmwareTarget.entries.random(random), isOld = random.nextInt(OLD) == 0)
        return compileWithoutHarm(text.toString(), options)
    }

    private fun change(text: StringBuilder) {
        val start = random.nextInt(text.length + 1)
        val end = minOf(text.length, start + random.nextInt(1, LONGEST))
        when (random.nextInt(CHANGES)) {
            in EXCHANGES -> exchange(text)
            0 -> text.deleteRange(start, end)
            1 -> text.insert(start, text.substring(start, end))
            2 -> text.insert(start, WORDS.random(random))
            3 -> text.insert(start, " ${WORDS.random(random)} ")
            4 -> text.insert(start, random.nextInt(' '.code, DELETE).toChar())
            5 -> text.insert(start, spliceOf(sources.random(random)))

            6 -> text.insert(
                random.nextInt(text.length + 1),
                text.substring(start, end).repeat(random.nextInt(1, TIMES)),
            )

            else -> if (start < text.length) text[start] = random.nextInt(' '.code, DELETE).toChar()
        }
    }

    /** Puts a word or number of the same kind in place of another. */
    private fun exchange(text: StringBuilder) {
        val kind = KINDS.random(random)
        val found = kind.findAll(text).toList().randomOrNull(random) ?: return
        val other = kind.findAll(sources.random(random)).toList().randomOrNull(random) ?: return
        text.setRange(found.range.first, found.range.last + 1, other.value)
    }

    private fun spliceOf(source: String): String {
        val start = random.nextInt(source.length)
        return source.substring(start, minOf(source.length, start + random.nextInt(1, LONGEST)))
    }

    companion object {
        private val sources by lazy { Vectors.programs.values.toList() + ErrorCase.all.map { it.source } }

        /** Whether [text] has no mistake. */
        fun compileWithoutHarm(text: String, options: NqcOptions): Boolean =
            when (val result = compileNqc("m.nqc", text, options, messages = NqcMessages.of(Language.ENGLISH))) {
                is NqcResult.Failure -> {
                    assertTrue(result.diagnostics.isNotEmpty() && result.diagnostics.size <= MOST_DIAGNOSTICS)
                    false
                }

                is NqcResult.Success -> {
                    assertTrue(result.program.image.toBytes().size < FirmwareLimits.IMAGE_BYTES * 2)
                    true
                }
            }

        private const val MOST_CHANGES = 6
        private const val MOST_DIAGNOSTICS = 200
        private const val LONGEST = 40
        private const val TIMES = 30
        private const val CHANGES = 24
        private val EXCHANGES = 8 until CHANGES
        private val KINDS = listOf(
            "[0-9]+",
            "[+*/%&|^<>=!-]+",
            "[A-Z_]{3,}[0-9A-Z_]*",
            "\\b[a-z]+\\b",
            "[^;{}]+;",
        ).map(::Regex)
        private const val OLD = 20
        private const val DELETE = 127

        private val WORDS = (
            "{ } ( ) [ ] ; , : ? = += ||= +-= << >> ++ -- && || ! ~ ^ % @ @@ & * # ## $ \\ \" /* */ // 0 1 32768 " +
                "65536 0xFFFFFFFF 9999999999 abs acquire asm break case catch const continue default do else for " +
                "goto if int monitor repeat return sign start stop sub switch task while void true __sensor __type " +
                "__event_src __taskid __nolist __res main a b x SENSOR_1 Timer(0) Random(3) Wait until #define #if " +
                "#else #endif #include #pragma #undef defined OUT_A EVENT_MASK(1) Set Indirect(0)"
        ).split(' ') + listOf("\n", "\n#define A A A\n", "\n#define F(x) x x\n", "é", "\uFEFF", "\u0000")
    }
}
