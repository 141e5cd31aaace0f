package robotran.robolang

import io.kotest.common.ExperimentalKotest
import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.PropTestConfig
import io.kotest.property.arbitrary.Codepoint
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll
import robotran.language.Language
import robotran.language.fuzz.Fuzzing
import robotran.robolang.format.FormatResult
import robotran.robolang.format.checkFormatting
import robotran.robolang.format.formatRobolang
import robotran.robolang.format.treeOf
import robotran.robolang.fuzz.ProgramWriter
import robotran.robolang.fuzz.anyText
import robotran.robolang.fuzz.arbitraryBytes
import robotran.robolang.fuzz.arbitraryText
import robotran.robolang.fuzz.checkHarmless
import robotran.robolang.fuzz.piecesOfRobolang
import robotran.robolang.fuzz.runFor
import robotran.robolang.fuzz.spoiltProgram
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.syntax.NumberReading
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.RobolangLimits
import robotran.robolang.syntax.readNumber
import robotran.robolang.wording.ChangedWords
import robotran.robolang.wording.changeWords
import robotran.robolang.words.Vocabulary
import robotran.robolang.words.vocabularyOf
import kotlin.random.Random

@OptIn(ExperimentalKotest::class)
class RobolangFuzzTest :
    StringSpec({
        fun config(iterations: Int) = PropTestConfig(iterations = Fuzzing.share(iterations))

        fun texts(text: (Random) -> String): Arb<String> = arbitrary { text(it.random) }
        val programs = texts { ProgramWriter(it).write() }

        "a text that once found a fault is read without harm" {
            Fuzzing.corpusTexts(".robo").values.forEach(::checkHarmless)
        }

        "arbitrary text is read without harm" {
            checkAll(config(30_000), texts(::arbitraryText)) { checkHarmless(it) }
        }

        "arbitrary bytes are read without harm" {
            checkAll(config(30_000), texts(::arbitraryBytes)) { checkHarmless(it) }
        }

        "pieces of the language in any order are read without harm" {
            checkAll(config(30_000), texts(::piecesOfRobolang)) { checkHarmless(it) }
        }

        "a program with something changed is read without harm" {
            checkAll(config(10_000), texts(::spoiltProgram)) { checkHarmless(it) }
        }

        "any text goes into the words of each language without harm, and a program without slips comes back as it was" {
            checkAll(config(100_000), texts(::anyText)) { source ->
                val english = RobolangMessages.of(Language.ENGLISH)
                val isProgram = vocabularyOf(source) === Vocabulary.ENGLISH &&
                    formatRobolang(source, english) is FormatResult.Success
                for (vocabulary in Vocabulary.all) {
                    val there = changeWords(source, vocabulary) as? ChangedWords.Success ?: continue
                    val back = changeWords(there.text, vocabularyOf(source))
                    // A keyword that mixed capitals and small letters comes back in small ones.
                    if (back is ChangedWords.Success && isProgram && vocabularyOf(there.text) === vocabulary) {
                        back.text.lowercase() shouldBe source.lowercase()
                    }
                }
            }
        }

        "a generated program has no mistakes, and formatted it is the same tree" {
            checkAll(config(2_000), programs) { source ->
                errorsOf(source).shouldBeEmpty()
                (
                    formatRobolang(
                        source,
                        messages = RobolangMessages.of(Language.ENGLISH),
                    ) is FormatResult.Success
                ) shouldBe
                    true
                checkFormatting(source)
            }
        }

        "generated programs have everything there is in the language" {
            val seen = FormsOfTrees()
            val random = Random(2005)
            repeat(1_000) { seen.add(treeOf(ProgramWriter(random).write())) }
            repeat(300) { seen.add(treeOf(ProgramWriter(random, isForNxt = true).write())) }
            seen.missing().shouldBeEmpty()
        }

        "a generated program runs as far as it may, twice in the same way" {
            checkAll(config(1_000), programs) { source ->
                val program = (read(source) as RobolangResult.Success).rcxProgram
                runFor(program, 2_000) shouldBe runFor(program, 2_000)
            }
        }

        "a decimal number is the one that Java reads" {
            val digits = Arb.element(('0'..'9').map { Codepoint(it.code) })
            checkAll(config(30_000), Arb.int(0..999_999_999), Arb.string(1..6, digits)) { whole, fraction ->
                val text = "$whole.$fraction"
                readNumber(text, negative = false) shouldBe NumberReading.Read(NumberValue.Decimal(text.toFloat()))
            }
        }

        "ten thousand wrong lines are all told" {
            val wrongLines = List(10_000) { "repaet $it tmes quikly if" }.joinToString("\n")
            errorsOf(wrongLines).map { it.range?.line } shouldBe (1..10_000).toList()
        }

        "the longest programs are read without harm" {
            val half = RobolangLimits.SOURCE_CHARACTERS / 2
            longestPrograms(Fuzzing.share(half, atLeast = half / 8)).forEach(::checkHarmless)
        }
    })
