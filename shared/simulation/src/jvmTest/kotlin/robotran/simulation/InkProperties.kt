package robotran.simulation

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.comparables.shouldBeGreaterThanOrEqualTo
import io.kotest.matchers.doubles.shouldBeLessThanOrEqual
import io.kotest.property.Arb
import io.kotest.property.arbitrary.bind
import io.kotest.property.arbitrary.boolean
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import robotran.simulation.ink.InkWriter
import robotran.world.Paper
import robotran.world.geometry.length

class InkProperties :
    StringSpec({
        data class Move(val x: Double, val y: Double, val down: Boolean)

        val coordinate = Arb.double(-5.0, 25.0, includeNaNs = false)
        val moves = Arb.list(Arb.bind(coordinate, coordinate, Arb.boolean(), ::Move), 0..60)

        "ink only grows, and no more is drawn than the pen has moved" {
            checkAll(moves) { way ->
                val writer = InkWriter(Paper(20.0, 20.0), robots = 1)
                var before = 0.0
                for (move in way) {
                    writer.move(0, move.x, move.y, move.down)
                    writer.ink.lengthCentimetres shouldBeGreaterThanOrEqualTo before
                    before = writer.ink.lengthCentimetres
                }
                before shouldBeLessThanOrEqual
                    way.zipWithNext { from, to -> length(to.x - from.x, to.y - from.y) }.sum() + 1e-9
            }
        }
    })
