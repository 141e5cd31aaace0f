package robotran.blockediting

import io.kotest.common.ExperimentalKotest
import io.kotest.core.spec.style.StringSpec
import io.kotest.property.PropTestConfig
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.checkAll
import robotran.language.fuzz.Fuzzing
import robotran.robolang.fuzz.ProgramWriter
import robotran.robolang.fuzz.arbitraryBytes
import robotran.robolang.fuzz.piecesOfRobolang
import robotran.robolang.fuzz.spoiltProgram
import kotlin.random.Random

@OptIn(ExperimentalKotest::class)
class BlocksFuzzTest :
    StringSpec({
        fun config(iterations: Int) = PropTestConfig(iterations = Fuzzing.share(iterations))

        fun texts(text: (Random) -> String) = arbitrary { text(it.random) }

        "a text that once found a fault is its blocks byte for byte, and can be edited" {
            for ((name, text) in Fuzzing.corpusTexts(".robo")) {
                checkPieces(text, name)
                checkEdits(text, Random(text.length), EDITS)
            }
        }

        "arbitrary texts are their blocks byte for byte" {
            checkAll(config(40_000), texts(::arbitraryText)) { checkPieces(it, it) }
            checkAll(config(20_000), texts(::spoiltText)) { checkPieces(it, it) }
            checkAll(config(20_000), texts(::arbitraryBytes)) { checkPieces(it, it) }
            checkAll(config(10_000), texts(::piecesOfRobolang)) { checkPieces(it, it) }
            checkAll(config(10_000), texts(::spoiltProgram)) { checkPieces(it, it) }
        }

        "200 random edits of any program make the blocks that they should, and can all be undone" {
            checkAll(config(150), texts { ProgramWriter(it).write() }) { checkEdits(it, Random(it.length), EDITS) }
            checkAll(config(400), texts(::spoiltText)) { checkEdits(it, Random(it.length), EDITS) }
            checkAll(config(1_000), texts(::arbitraryText)) { checkEdits(it, Random(it.length), EDITS / 4) }
        }
    })

private const val EDITS = 200
