package robotran.world.file

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.choice
import io.kotest.property.arbitrary.constant
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.map
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll
import robotran.json.writeCompactJson
import robotran.language.Language

class WorldFileProperties :
    StringSpec({
        val files = BuiltInWorlds.texts.values + FULL_WORLD

        "a world is read as it was written" {
            checkAll(arbitraryWorlds()) { world ->
                readWorld(writeWorld(world), Language.ENGLISH) shouldBe WorldFileResult.Success(world)
                readWorld(writeCompactJson(elementOf(world)), Language.ENGLISH) shouldBe WorldFileResult.Success(world)
            }
        }

        "any text and any bytes at all give a result" {
            checkAll(Arb.string(0..200)) { holds(readWorld(it, Language.ENGLISH)) }
            checkAll(Arb.byteArray(Arb.int(0..200), Arb.byte())) { holds(readWorld(it, Language.ENGLISH)) }
        }

        "a world file with a piece cut out gives a result" {
            checkAll(Arb.element(files), Arb.int(0..100_000), Arb.int(0..60)) { file, place, length ->
                val from = place % file.length
                holds(readWorld(file.removeRange(from, minOf(file.length, from + length)), Language.ENGLISH))
            }
        }

        "a world file with any character changed gives a result" {
            checkAll(Arb.element(files), Arb.int(0..100_000), Arb.string(1)) { file, place, character ->
                val from = place % file.length
                holds(readWorld(file.replaceRange(from, from + 1, character), Language.ENGLISH))
            }
        }

        "a world file with any of its values replaced gives a result" {
            val values = valuesIn(FULL_WORLD)
            val others = Arb.choice(
                Arb.double().map { it.toString() },
                Arb.element("null", "[]", "{}", "true", "\"\"", "1e308", "-1e-400", "NaN", "[[["),
                Arb.element("\"\\uD800\"", "-0", "359.99999999999999", "[0,1]"),
                Arb.constant("9".repeat(1000)),
            )
            checkAll(Arb.element(values), others) { range, other ->
                holds(readWorld(FULL_WORLD.replaceRange(range, other), Language.ENGLISH))
            }
        }
    })
