package robotran.world

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.string.shouldEndWith
import io.kotest.property.Arb
import io.kotest.property.arbitrary.choice
import io.kotest.property.arbitrary.constant
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.map
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll

class WorldFileProperties : StringSpec({
    val plain = BuiltInWorlds.texts.getValue("plain.world.json")

    fun readable(text: String) {
        val result = readWorld(text)
        if (result is WorldFileResult.Refused) result.message shouldEndWith "."
    }

    "any text at all gives a result" {
        checkAll(Arb.string(0..200)) { readable(it) }
    }

    "a world file with a piece cut out gives a result" {
        checkAll(Arb.int(plain.indices), Arb.int(0..60)) { from, length ->
            readable(plain.removeRange(from, minOf(plain.length, from + length)))
        }
    }

    "a world file with any character changed gives a result" {
        checkAll(Arb.int(plain.indices), Arb.string(1)) { place, character -> readable(plain.replaceRange(place, place + 1, character)) }
    }

    "a world file with any of its values replaced gives a result" {
        val values = Regex("-?[0-9.]+|\"[^\"]*\"(?!:)").findAll(plain).map { it.range }.toList()
        val others = Arb.choice(
            Arb.double().map { it.toString() },
            Arb.element("null", "[]", "{}", "true", "\"\"", "1e308", "-1e-400", "NaN", "[[[", "\"\\uD800\""),
            Arb.constant("9".repeat(1000)),
        )
        checkAll(Arb.element(values), others) { range, other -> readable(plain.replaceRange(range, other)) }
    }
})
